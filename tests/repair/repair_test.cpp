// Repair: one tiny mesh for each defect with its exact result.

#include <set>

#include "tests/support/repair_helpers.h"

namespace aomd::test::repair_test {
namespace {

using zoo::make;

TEST(RepairTest, OfRepeatedFacesTheFirstStays) {
  MeshData data = zoo::square();
  data.faces.add(Shape::Triangle, {2, 0, 1});
  data.faces.add(Shape::Triangle, {3, 0, 2});
  data.faces.add(Shape::Triangle, {1, 2, 0});
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  ASSERT_EQ(names(report.done), Names{"repeated faces"});
  EXPECT_EQ(report.done[0].text, "3 repeated faces removed");
  EXPECT_EQ(std::set(report.done[0].first.begin(), report.done[0].first.end()),
            (std::set<std::uint32_t>{2, 3, 4}));
}

//  3--2
//  | /|      a pocket 0 1 4 hangs on the border of the square
//  |/ |
//  0--1
//   \/
//    4
TEST(RepairTest, APocketGoesAndTheSurfaceStays) {
  MeshData data = zoo::square();
  data.positions.emplace_back(0.5, -1, 0);
  data.faces.add(Shape::Triangle, {0, 1, 4});
  data.faces.add(Shape::Triangle, {1, 0, 4});
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(data.positions.size(), 5u);
  ASSERT_EQ(names(report.done), Names{"opposite faces"});
  EXPECT_EQ(report.done[0].text, "2 faces in coincident pairs of opposite orientation removed");
  EXPECT_EQ(report.done[0].count, 2u);
}

TEST(RepairTest, PairsCancelBeforeRepeatedFacesGo) {
  MeshData data = zoo::tetrahedron();
  data.faces.add(Shape::Triangle, {2, 1, 0});
  data.faces.add(Shape::Triangle, {0, 1, 2});  // the other way round
  mend(data);
  EXPECT_EQ(triangles(data), triangles(zoo::tetrahedron()));
}

// Each from the last on goes with the nearest before it that looks the other way.
TEST(RepairTest, WhichOfSeveralCancelEachOther) {
  MeshData data = zoo::tetrahedron();  // with 0 2 1 first
  data.faces.add(Shape::Triangle, {1, 2, 0});
  data.faces.add(Shape::Triangle, {2, 0, 1});
  RepairOptions options;
  options.orient = false;
  const RepairReport report = mend(data, options);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 2, 0}}));
  EXPECT_EQ(report.done[0].first, (std::vector<std::uint32_t>{0, 5}));
}

// In turn, and all of one direction before those of the other.
TEST(RepairTest, AHundredThousandCopiesOfOneFace) {
  for (const bool in_turn : {true, false}) {
    MeshData data = zoo::tetrahedron();
    for (int i = 0; i < 100000; ++i)
      if (in_turn ? i % 2 == 0 : i < 50000)
        data.faces.add(Shape::Triangle, {0, 2, 1});
      else
        data.faces.add(Shape::Triangle, {0, 1, 2});
    const RepairReport report = repair(data);
    EXPECT_EQ(triangles(data).size(), 4u);
    EXPECT_EQ(report.done[0].count, 100000u);
  }
}

TEST(RepairTest, ASheetListedFromBothSidesKeepsItsFirstSide) {
  MeshData data = zoo::square();
  data.faces.add(Shape::Triangle, {2, 1, 0});
  data.faces.add(Shape::Triangle, {3, 2, 0});
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), triangles(zoo::square()));
  EXPECT_EQ(names(report.done), Names{"sheets"});
}

//   4--5        two boxes without lids stand on each other: the wall between them belongs to both
TEST(RepairTest, AWallBetweenTwoModelFacesStays) {
  MeshData data = make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {2, 1, 0}, {1, 4, 0}, {2, 4, 1}, {0, 4, 2}});
  for (Shape& s : data.faces.shapes) s = Shape::Triangle;
  data.faces.classes.assign(4, ModelRef(2, 1));
  data.faces.classes.resize(8, ModelRef(2, 2));
  const RepairReport report = mend(data);
  EXPECT_EQ(data.faces.size(), 8u);
  EXPECT_EQ(data.positions.size(), 8u);  // the second body has got its own corners of the wall
  expect_manifold(data);
  EXPECT_EQ(facts_of(data).boundary, 0u);
  EXPECT_EQ(facts_of(data).euler, 4);
}

TEST(RepairTest, QuadsOnTheSameVerticesCoincideOnlyInTheSameRound) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  data.faces.add(Shape::Quad, {0, 1, 2, 3});
  data.faces.add(Shape::Quad, {2, 3, 0, 1});
  const MeshData crossed = [&] {
    MeshData d = data;
    d.faces.add(Shape::Quad, {0, 2, 1, 3});
    return d;
  }();
  mend(data);
  EXPECT_EQ(data.faces.vertices, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  MeshData other = crossed;
  RepairOptions only_faces;
  only_faces.split = only_faces.orient = false;
  mend(other, only_faces);
  EXPECT_EQ(other.faces.size(), 2u);
}

TEST(RepairTest, FacesThatNameAVertexTwice) {
  MeshData data = zoo::square();
  data.faces.add(Shape::Triangle, {1, 1, 2});
  data.faces.add(Shape::Triangle, {1, 2, 1});
  data.faces.add(Shape::Quad, {3, 2, 2, 0});  // a triangle, and the back of face 1
  data.faces.add(Shape::Quad, {1, 0, 1, 2});  // forth and back
  data.attributes.push_back({"number", 2, 1, true, {0, 1, 2, 3, 4, 5}});
  RepairOptions options;
  options.opposite_faces = options.repeated_faces = options.orient = options.split = false;
  const RepairReport report = mend(data, options);
  EXPECT_EQ(data.faces.shapes, std::vector<Shape>(3, Shape::Triangle));
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {0, 2, 3}, {3, 2, 0}}));
  EXPECT_EQ(data.attributes[0].values, (std::vector<double>{0, 1, 4}));
  ASSERT_EQ(names(report.done), (Names{"repeated vertices", "repeated corners"}));
  EXPECT_EQ(report.done[0].first, (std::vector<std::uint32_t>{2, 3, 5}));
}

//      3
//     / \        0 1 2 has no area: 1 lies on the side from 0 to 2
//    /   \       .
//   0--1--2
//    \ | /
//      4
MeshData needle() {
  return make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}},
              {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}});
}

TEST(RepairTest, ALongestSideIsSwappedWithTheNeighbour) {
  MeshData data = needle();
  data.faces.classes = {ModelRef(2, 1), ModelRef(2, 2), ModelRef(2, 1), ModelRef(2, 1)};
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 3}, {1, 2, 3}, {0, 4, 1}, {1, 4, 2}}));
  EXPECT_EQ(data.faces.classes[0], ModelRef(2, 2));
  EXPECT_EQ(names(report.done), Names{"zero area, swapped"});
  EXPECT_DOUBLE_EQ(area(data), 2);
}

TEST(RepairTest, AModelEdgeIsNotSwappedButLeftAndTold) {
  MeshData data = needle();
  data.edges.add(Shape::Line, {0, 2}, ModelRef(1, 7));
  const MeshData before = data;
  const RepairReport report = mend(data);
  EXPECT_TRUE(data == before);
  ASSERT_EQ(names(report.left), Names{"zero area"});
  EXPECT_EQ(report.left[0].first, std::vector<std::uint32_t>{0});
}

TEST(RepairTest, AtTheBorderAFaceWithoutAreaGoes) {
  MeshData data = needle();
  data.faces.shapes.erase(data.faces.shapes.begin() + 1);
  data.faces.vertices.erase(data.faces.vertices.begin() + 3, data.faces.vertices.begin() + 6);
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 4, 1}, {1, 4, 2}}));
  EXPECT_EQ(names(report.done), Names{"zero area, removed"});
}

//   4-----3      1 and 2 lie at the same place, so that 0 1 2 and 1 3 2 have no area
//   |\   /|
//   | 1=2 |
//   |/   \|
//   5-----0
TEST(RepairTest, ASideWithoutLengthIsCollapsed) {
  MeshData data = make({{1, -1, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}},
                       {{0, 2, 1}, {1, 2, 3}, {0, 3, 2}, {3, 4, 1}, {4, 5, 1}, {5, 0, 1}});
  const int euler = zoo::euler(Mesh(data));
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 3, 2}, {3, 4, 2}, {4, 5, 2}, {5, 0, 2}}));
  EXPECT_EQ(zoo::euler(Mesh(data)), euler);
  EXPECT_EQ(names(report.done), Names{"zero area, collapsed"});
}

TEST(RepairTest, ModelVerticesAtOnePlaceAreNotJoined) {
  MeshData data = make({{1, -1, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}},
                       {{0, 2, 1}, {1, 2, 3}, {0, 3, 2}, {3, 4, 1}, {4, 5, 1}, {5, 0, 1}});
  data.vertex_classes.assign(6, ModelRef(2, 1));
  data.vertex_classes[1] = ModelRef(0, 1);
  data.vertex_classes[2] = ModelRef(0, 2);
  const RepairReport report = mend(data);
  EXPECT_EQ(data.faces.size(), 6u);
  EXPECT_EQ(names(report.left), Names{"zero area"});
  data.vertex_classes[2] = ModelRef(2, 1);
  EXPECT_EQ(names(mend(data).done), Names{"zero area, collapsed"});
  EXPECT_EQ(data.faces.vertices[5], 1u);  // the model vertex stays
}

// All points on one line, many of them, divided by needles that lie on each other: swaps must find
// their way out.
TEST(RepairTest, ChainsOfNeedles) {
  MeshData data;
  constexpr std::uint32_t n = 12;
  for (std::uint32_t i = 0; i <= n; ++i) data.positions.emplace_back(i, 0, 0);
  data.positions.emplace_back(n / 2., 3, 0);
  data.positions.emplace_back(n / 2., -3, 0);
  for (std::uint32_t i = 1; i < n; ++i) data.faces.add(Shape::Triangle, {0, i, i + 1});
  data.faces.add(Shape::Triangle, {0, n, n + 1});
  for (std::uint32_t i = 0; i < n; ++i) data.faces.add(Shape::Triangle, {i + 1, i, n + 2});
  const double before = area(data);
  const RepairReport report = mend(data);
  EXPECT_EQ(report.left.size(), 0u);
  EXPECT_EQ(data.faces.size(), 2u * n);
  EXPECT_NEAR(area(data), before, 1e-12);
  EXPECT_GT(facts_of(data).least_area, 0);
  expect_manifold(data);
}

TEST(RepairTest, TetrahedraOnOneEdgeComeApart) {
  // Seen along the edge 0-1:  2   4
  //                           |\ /|
  //                           | 0 |
  //                           |/ \|
  //                           3   5
  MeshData data = make(
      {{0, 0, 0}, {0, 0, 1}, {-1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {1, -1, 0}},
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}});
  ASSERT_EQ(facts_of(data).nonmanifold, 1u);
  const RepairReport report = mend(data);
  expect_manifold(data);
  EXPECT_EQ(
      triangles(data),
      (Triangles{
          {0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {6, 7, 4}, {6, 4, 5}, {6, 5, 7}, {7, 5, 4}}));
  EXPECT_EQ(data.positions[6], data.positions[0]);
  EXPECT_EQ(data.positions[7], data.positions[1]);
  ASSERT_EQ(names(report.done), (Names{"non-manifold edges", "split vertices"}));
  EXPECT_EQ(report.done[1].text, "2 vertices of several fans split: 2 vertices added");
  EXPECT_EQ(report.done[1].first, (std::vector<std::uint32_t>{0, 1}));
}

// Two flat sheets that touch along a fold stay sheets, where enclosing the inside would fold both
// back.
//    2       4
//     \     /       seen along the edge 0-1, nearly flat
//       0-1
//     /     \       .
//    3       5
TEST(RepairTest, SheetsThatTouchStaySheets) {
  MeshData data =
      make({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0.1}, {-1, 0, -0.1}, {1, 0, 0.1}, {1, 0, -0.1}},
           {{0, 1, 2}, {1, 0, 4}, {0, 1, 5}, {1, 0, 3}});
  mend(data);
  const Triangles result = triangles(data);
  EXPECT_EQ(result[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(result[1], (std::array<std::uint32_t, 3>{1, 0, 4}));
  EXPECT_EQ(result[2], (std::array<std::uint32_t, 3>{6, 7, 5}));
  EXPECT_EQ(result[3], (std::array<std::uint32_t, 3>{7, 6, 3}));
}

//       3
//       | I      seen along the edge 0-1: the inside is at I and at J, and all bends are right
//   4--0-1--2    angles
//    J  |
//       5
TEST(RepairTest, OfEqualBendsThoseThatEncloseTheInside) {
  MeshData data = make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {0, 1, 0.5}, {-1, 0, 0.5}, {0, -1, 0.5}},
                       {{1, 0, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}});
  mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{1, 0, 2}, {0, 1, 3}, {6, 7, 4}, {7, 6, 5}}));
}

TEST(RepairTest, PagesThatRunTheSameWayAllComeApart) {
  MeshData data = zoo::book();
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {5, 6, 3}, {7, 8, 4}}));
  EXPECT_EQ(names(report.done), (Names{"non-manifold edges", "split vertices"}));
}

TEST(RepairTest, ABowTieIsCut) {
  MeshData data = zoo::bow_tie();
  data.vertex_classes.assign(6, ModelRef(1, 3));
  data.attributes.push_back({"height", 0, 2, false, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 2, 1}, {6, 3, 4}}));
  EXPECT_EQ(data.vertex_classes.size(), 7u);
  EXPECT_EQ(data.attributes[0].values.size(), 14u);
  EXPECT_EQ(data.attributes[0].values[13], 1);
  EXPECT_EQ(names(report.done), Names{"split vertices"});
}

TEST(RepairTest, WhereTheModelHasThreeFacesTheyStayTogether) {
  MeshData data = zoo::book();
  data.edges.add(Shape::Line, {1, 0}, ModelRef(1, 4));
  const MeshData before = data;
  const RepairReport report = mend(data);
  EXPECT_TRUE(data == before);
  EXPECT_EQ(names(report.left), Names{"non-manifold edges"});
  MeshData tie = zoo::bow_tie();
  tie.vertex_classes.assign(6, ModelRef(0, 3));
  EXPECT_EQ(names(mend(tie).done), Names());
}

TEST(RepairTest, AListedEdgeIsListedForEachPart) {
  MeshData data = zoo::book();
  data.edges.add(Shape::Line, {0, 1});
  data.edges.add(Shape::Line, {0, 2});
  data.edges.add(Shape::Line, {3, 4});
  data.attributes.push_back({"width", 1, 1, false, {0.5, 0.25, 0.125}});
  mend(data);
  EXPECT_EQ(data.edges.vertices, (std::vector<std::uint32_t>{0, 1, 0, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(data.attributes[0].values, (std::vector<double>{0.5, 0.25, 0.125, 0.5, 0.5}));
}

// An edge on vertices that a weld has replaced goes to a part that is not listed yet.
TEST(RepairTest, AListedEdgeMovesToAFreePart) {
  MeshData data = zoo::book();
  for (const std::uint32_t v : {0, 1}) data.positions.push_back(glm::dvec3(data.positions[v]));
  data.edges.add(Shape::Line, {0, 1});
  data.edges.add(Shape::Line, {5, 6});
  RepairOptions options;
  options.weld = true;
  repair(data, options);
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {7, 8, 3}, {9, 10, 4}}));
  EXPECT_EQ(data.edges.vertices, (std::vector<std::uint32_t>{0, 1, 7, 8, 9, 10}));
}

// Each part is listed once, however often the edge is.
TEST(RepairTest, AnEdgeThatIsListedAgainAndAgain) {
  MeshData data = zoo::book();
  for (int i = 0; i < 4; ++i) data.edges.add(Shape::Line, {0, 1});
  mend(data);
  EXPECT_EQ(data.edges.vertices, (std::vector<std::uint32_t>{0, 1, 0, 1, 0, 1, 0, 1, 5, 6, 7, 8}));
  MeshData pages = zoo::book();
  for (std::uint32_t i = 0; i < 30000; ++i) {
    pages.positions.emplace_back(1, i, 0.5);
    pages.faces.add(Shape::Triangle, {0, 1, 5 + i});
    pages.edges.add(Shape::Line, {0, 1});
  }
  repair(pages);
  EXPECT_EQ(pages.edges.size(), 30000u + 30002u);
}

// A torus of two rings has two sides between the same vertices; as one list of faces they are edges
// of four.
TEST(RepairTest, WhereTwoEdgesWouldLieOnTheSameVerticesThePassageCloses) {
  MeshData data = zoo::torus(2, 5);
  ASSERT_EQ(facts_of(data).nonmanifold, 5u);
  const RepairReport report = mend(data);
  EXPECT_EQ(data.faces.size(), 20u);
  expect_manifold(data);
  EXPECT_EQ(facts_of(data).boundary, 0u);
  ASSERT_FALSE(report.done.empty());
  EXPECT_EQ(report.done[0].text, "5 edges of three or more faces split");
}

// More faces around one vertex than are looked at for each change there: it waits until its
// neighbours have become one.
TEST(RepairTest, ACrowdOfFacesInOnePlace) {
  MeshData data;
  data.positions.assign(2001, glm::dvec3(1));
  for (std::uint32_t i = 0; i < 2000; ++i)
    data.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % 2000});
  const RepairReport report = mend(data);
  EXPECT_EQ(data.faces.size(), 0u);
  EXPECT_EQ(report.done[0].count, 1998u);
}

// When nothing else is left to do, the faces around a crowded vertex come up again.
TEST(RepairTest, ACrowdOfFacesOnALine) {
  MeshData data;
  for (std::uint32_t i = 0; i <= 2000; ++i) data.positions.emplace_back(i, 0, 0);
  for (std::uint32_t i = 0; i < 2000; ++i)
    data.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % 2000});
  repair(data);
  EXPECT_EQ(data.faces.size(), 449u);
}

TEST(RepairTest, TheFewerFacesTurn) {
  MeshData data = zoo::grid(2);
  const Triangles given = triangles(data);
  std::swap(data.faces.vertices[1], data.faces.vertices[2]);
  std::swap(data.faces.vertices[10], data.faces.vertices[11]);
  const RepairReport report = mend(data);
  EXPECT_EQ(triangles(data), given);
  ASSERT_EQ(names(report.done), Names{"orientation"});
  EXPECT_EQ(report.done[0].first, (std::vector<std::uint32_t>{0, 3}));
}

TEST(RepairTest, ATieGoesToTheFirstFace) {
  MeshData data = make(zoo::square().positions, {{0, 2, 1}, {0, 2, 3}});
  mend(data);
  EXPECT_EQ(triangles(data), (Triangles{{0, 2, 1}, {0, 3, 2}}));
}

//   0--2--4--1     a band of which the ends are joined with a twist
//   | /| /| /|
//   |/ |/ |/ |
//   1--3--5--0
TEST(RepairTest, ATwistedBandIsLeftAsItIs) {
  MeshData data = make({{0, 0, 1}, {0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {2, 1, 1}, {2, 1, 0}},
                       {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 1}, {5, 0, 1}});
  const MeshData before = data;
  const RepairReport report = mend(data);
  EXPECT_TRUE(data == before);
  EXPECT_EQ(names(report.left), Names{"orientation"});
}

}  // namespace
}  // namespace aomd::test::repair_test
