// What is dirty in a surface: one tiny mesh for each kind.

#include "core/repair/survey.h"

#include "tests/support/message.h"
#include "tests/support/repair_helpers.h"

namespace aomd::test::survey_test {
namespace {

using zoo::make;

Names names(const std::vector<SurfaceFinding>& findings) {
  Names result;
  for (const SurfaceFinding& finding : findings) result.push_back(finding.dirt.name);
  return result;
}

SurfaceFinding only(const MeshData& data, const std::string& name) {
  for (const SurfaceFinding& finding : survey(data))
    if (finding.dirt.name == name) return finding;
  ADD_FAILURE() << "nothing about " << name;
  return {};
}

using Ids = std::vector<std::uint32_t>;

TEST(SurveyTest, AClosedSurfaceIsClean) {
  for (const MeshData& data : {zoo::tetrahedron(), zoo::octahedron(), zoo::torus(12, 9)})
    EXPECT_EQ(names(survey(data)), Names());
  EXPECT_EQ(names(survey(MeshData())), Names());
  EXPECT_EQ(names(survey(zoo::one_tet())), Names());
}

TEST(SurveyTest, NothingIsChanged) {
  const MeshData before = zoo::dirty();
  MeshData data = before;
  EXPECT_FALSE(survey(data).empty());
  EXPECT_TRUE(data == before);
}

TEST(SurveyTest, ABorderIsTold) {
  const auto findings = survey(zoo::square());
  ASSERT_EQ(names(findings), Names{"border edges"});
  EXPECT_EQ(findings[0].dirt.count, 4u);
  EXPECT_EQ(findings[0].dirt.text, "4 edges of one face");
  EXPECT_EQ(findings[0].breaks, SurfaceProperty::Closed);
  EXPECT_EQ(findings[0].remedy, Remedy::None);
}

//  2--1 5
//  | / /|      the square as two triangles with corners of their own: the diagonal closes
//  |/ / |
//  0 3--4
TEST(SurveyTest, BordersAtTheSamePlaceAndTheGain) {
  const MeshData data = make({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                             {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(names(survey(data)), (Names{"border edges", "unwelded borders"}));
  const SurfaceFinding found = only(data, "unwelded borders");
  EXPECT_EQ(found.dirt.count, 2u);
  EXPECT_EQ(found.dirt.text, "2 of 6 border edges lie on others");
  EXPECT_EQ(found.dirt.first, (Ids{0, 1}));
  EXPECT_EQ(found.breaks, SurfaceProperty::Welded);
  EXPECT_EQ(found.remedy, Remedy::Weld);
  EXPECT_EQ(found.tolerance, 0);
}

// The same with the second triangle 0.003 to the right: the tolerance is the distance rounded up.
TEST(SurveyTest, AGapAndTheToleranceThatClosesIt) {
  const MeshData data =
      make({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.003, 0, 0}, {1.003, 0, 0}, {1.003, 1, 0}},
           {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(names(survey(data)), (Names{"border edges", "gaps"}));
  const SurfaceFinding found = only(data, "gaps");
  EXPECT_EQ(found.dirt.text, "2 of 6 border edges lie within 0.0031 of others");
  EXPECT_DOUBLE_EQ(found.tolerance, 0.0031);
  MeshData mended = data;
  RepairOptions options;
  options.weld = true;
  options.weld_tolerance = found.tolerance;
  mend(mended, options);
  EXPECT_EQ(names(survey(mended)), (Names{"isolated vertices", "border edges"}));
  EXPECT_EQ(facts_of(mended).boundary, 4u);
}

// Of gaps of 0.003 and 0.004 the larger counts, of 0.003 and 0.02 the smaller: nothing is between.
TEST(SurveyTest, TheToleranceReachesToTheNextEmptyPartOfTheHistogram) {
  const auto tolerance = [](double below, double above) {
    return only(make({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {below, 0, 0}, {1, 0, 0}, {1 + above, 1, 0}},
                     {{0, 1, 2}, {3, 4, 5}}),
                "gaps")
        .tolerance;
  };
  EXPECT_DOUBLE_EQ(tolerance(0.003, 0.004), 0.0041);
  MeshData two = make({{0, 0, 0},
                       {1, 1, 0},
                       {0, 1, 0},
                       {0.003, 0, 0},
                       {1, 0, 0},
                       {1.003, 1, 0},
                       {-0.02, 1, 0},
                       {-0.02, 0, 0},
                       {-1, 0, 0}},
                      {{0, 1, 2}, {3, 4, 5}, {6, 8, 7}});
  EXPECT_DOUBLE_EQ(only(two, "gaps").tolerance, 0.0031);
}

TEST(SurveyTest, AWideGapIsMeant) {
  const MeshData data =
      make({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.2, 0, 0}, {1.2, 0, 0}, {1.2, 1, 0}},
           {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(names(survey(data)), Names{"border edges"});
}

TEST(SurveyTest, RepeatedFacesHideNothingElse) {
  MeshData data = zoo::octahedron();
  for (const auto& [a, b, c] : triangles(zoo::octahedron()))
    data.faces.add(Shape::Triangle, {b, c, a});
  const auto findings = survey(data);
  ASSERT_EQ(names(findings), (Names{"repeated faces", "non-manifold edges"}));
  EXPECT_EQ(findings[0].dirt.text, "8 faces on the vertices of others, the same way round");
  EXPECT_EQ(findings[0].breaks, SurfaceProperty::Distinct);
  EXPECT_EQ(findings[1].dirt.text, "12 edges of three or more faces, 0 without the repeated ones");
}

TEST(SurveyTest, PocketsAndBackFaces) {
  MeshData pocket = zoo::tetrahedron();
  pocket.positions.emplace_back(0, 0, -1);
  pocket.faces.add(Shape::Triangle, {0, 1, 4});
  pocket.faces.add(Shape::Triangle, {1, 0, 4});
  EXPECT_EQ(only(pocket, "opposite faces").dirt.text,
            "2 faces in pairs back to back on the same vertices");
  MeshData sheet = zoo::square();
  sheet.faces.add(Shape::Triangle, {2, 1, 0});
  sheet.faces.add(Shape::Triangle, {3, 2, 0});
  EXPECT_EQ(only(sheet, "back faces").dirt.text, "2 back faces of sheets listed from both sides");
}

TEST(SurveyTest, MixedOrientation) {
  MeshData data = zoo::octahedron();
  std::swap(data.faces.vertices[3], data.faces.vertices[4]);
  const auto findings = survey(data);
  ASSERT_EQ(names(findings), Names{"mixed orientation"});
  EXPECT_EQ(findings[0].dirt.text, "1 face turned against the neighbours");
  EXPECT_EQ(findings[0].dirt.first, Ids{1});
  EXPECT_EQ(findings[0].breaks, SurfaceProperty::Oriented);
}

//   0--2--4--1     a band of which the ends are joined with a twist
//   | /| /| /|
//   |/ |/ |/ |
//   1--3--5--0
TEST(SurveyTest, APieceWithOneSide) {
  const MeshData data = make({{0, 0, 1}, {0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {2, 1, 1}, {2, 1, 0}},
                             {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 1}, {5, 0, 1}});
  const SurfaceFinding found = only(data, "one-sided pieces");
  EXPECT_EQ(found.dirt.text, "1 piece that cannot be oriented");
  EXPECT_EQ(found.remedy, Remedy::None);
}

TEST(SurveyTest, ABowTieAndAVertexThatNothingUses) {
  const MeshData data = zoo::bow_tie();
  EXPECT_EQ(names(survey(data)), (Names{"isolated vertices", "border edges", "bow-ties"}));
  EXPECT_EQ(only(data, "bow-ties").dirt.text, "1 vertex joins several fans of faces");
  EXPECT_EQ(only(data, "bow-ties").dirt.first, Ids{0});
  EXPECT_EQ(only(data, "bow-ties").breaks, SurfaceProperty::Manifold);
  EXPECT_EQ(only(data, "isolated vertices").dirt.first, Ids{5});
  MeshData listed = data;
  listed.edges.add(Shape::Line, {0, 5});
  EXPECT_EQ(names(survey(listed)), (Names{"border edges", "bow-ties"}));
}

TEST(SurveyTest, ABookIsNoBowTie) {
  EXPECT_EQ(names(survey(zoo::book())), (Names{"border edges", "non-manifold edges"}));
  EXPECT_EQ(only(zoo::book(), "non-manifold edges").dirt.text, "1 edge of three or more faces");
}

TEST(SurveyTest, FacesWithoutArea) {
  MeshData data =
      make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(only(data, "zero area").dirt.text, "1 face without area");
  EXPECT_EQ(only(data, "zero area").dirt.first, Ids{0});
  // a quad on one line, and one with a corner beside it
  data.faces.add(Shape::Quad, {0, 1, 2, 4});
  EXPECT_EQ(only(data, "zero area").dirt.count, 2u);
  data.faces.vertices.back() = 3;
  EXPECT_EQ(only(data, "zero area").dirt.count, 1u);
}

/// What a repair leaves since the surface would change has no command that mends it.
TEST(SurveyTest, FacesWithoutAreaThatAreToStay) {
  const MeshData data =
      make({{1, 1, 0}, {0, 0, 0}, {2, 0, 1}, {2, 0, 1}}, {{0, 3, 2}, {0, 2, 1}, {0, 1, 3}});
  const SurfaceFinding flat = only(data, "zero area");
  EXPECT_EQ(flat.dirt.text, "1 face without area, 1 of them to stay");
  EXPECT_EQ(flat.remedy, Remedy::None);
  const MeshData sound = make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(only(sound, "zero area").remedy, Remedy::Repair);
}

/// A flap along an edge of a closed surface: welding would bring it there, and splitting the edge
/// of three faces would take it off again.
TEST(SurveyTest, AFlapThatComesApartAgainIsNoBorderToWeld) {
  MeshData data = zoo::tetrahedron();
  const std::uint32_t n = static_cast<std::uint32_t>(data.positions.size());
  for (const glm::dvec3& p : {data.positions[0], data.positions[1], glm::dvec3(2, 2, 2)})
    data.positions.push_back(p);
  data.faces.add(Shape::Triangle, {n, n + 1, n + 2});
  EXPECT_EQ(names(survey(data)), Names{"border edges"});
  MeshData soup = make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}},
                       {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(only(soup, "unwelded borders").dirt.count, 2u);
}

TEST(SurveyTest, TwoModelFacesMayLieOnEachOther) {
  MeshData data = zoo::square();
  data.faces.add(Shape::Triangle, {2, 1, 0});
  data.faces.add(Shape::Triangle, {3, 2, 0});
  data.faces.classes = {ModelRef(2, 1), ModelRef(2, 1), ModelRef(2, 2), ModelRef(2, 2)};
  for (const std::string& name : names(survey(data))) EXPECT_NE(name, "back faces");
}

TEST(SurveyTest, ArraysThatContradictEachOtherAreRefused) {
  MeshData missing = zoo::square();
  missing.edges.add(Shape::Line, {0, 17});
  const auto look = [&] { static_cast<void>(survey(missing)); };
  EXPECT_NE(message(look).find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace aomd::test::survey_test
