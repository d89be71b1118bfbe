// Welding within a tolerance: what becomes one, what stays two, and what moves.

#include <random>

#include "tests/support/repair_helpers.h"

namespace aomd::test::weld_test {
namespace {

using zoo::make;

RepairOptions within(double tolerance) {
  RepairOptions options;
  options.weld = true;
  options.weld_tolerance = tolerance;
  return options;
}

//  2--1 5
//  | / /|      the halves of a square, `gap` apart
//  |/ / |
//  0 3--4
MeshData halves(double gap) {
  return make({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {gap, 0, 0}, {1 + gap, 0, 0}, {1 + gap, 1, 0}},
              {{0, 1, 2}, {3, 4, 5}});
}

TEST(WeldTest, WithinTheToleranceTheFirstVertexStays) {
  MeshData data = halves(0.125);
  const RepairReport report = mend(data, within(0.125));
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {0, 4, 1}}));
  EXPECT_EQ(data.positions, halves(0.125).positions);
  ASSERT_EQ(names(report.done), Names{"welded vertices"});
  EXPECT_EQ(report.done[0].text, "2 vertices welded to others within the tolerance");
  EXPECT_EQ(report.done[0].first, (std::vector<std::uint32_t>{3, 5}));
}

TEST(WeldTest, BeyondTheToleranceNothingIsDone) {
  MeshData data = halves(0.125);
  EXPECT_EQ(names(mend(data, within(0.1249)).done), Names());
  EXPECT_TRUE(data == halves(0.125));
  EXPECT_EQ(names(mend(data, within(0)).done), Names());
}

// The edges 0 1, 3 5 and 4 6 are 0.1 apart: the second goes to the first, and the third is too far
// from that.
TEST(WeldTest, NothingIsPassedOn) {
  MeshData data = make({{0, 0, 0},
                        {0, 1, 0},
                        {-1, 0, 0},
                        {0.1, 0, 0},
                        {0.2, 0, 0},
                        {0.1, 1, 0},
                        {0.2, 1, 0},
                        {1, 0, 0},
                        {0.1, 0.5, 1}},
                       {{0, 1, 2}, {5, 3, 8}, {4, 7, 6}});
  EXPECT_EQ(names(mend(data, within(0.15)).done), Names{"welded vertices"});
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {1, 0, 8}, {4, 7, 6}}));
}

TEST(WeldTest, OfSeveralTheNearestIsTaken) {
  // 6 and 7 are 0.08 from 0 and 2, and 0.02 from 1 and 3
  MeshData data = make({{0, 0, 0},
                        {0.1, 0, 0},
                        {0, -1, 0},
                        {0.1, -1, 0},
                        {-1, 0, 0},
                        {1, 0, 0},
                        {0.08, 0, 0},
                        {0.08, -1, 0},
                        {0.08, 0, 1}},
                       {{0, 2, 4}, {1, 5, 3}, {6, 7, 8}});
  mend(data, within(0.09));
  EXPECT_EQ(triangles(data)[2], (std::array<std::uint32_t, 3>{1, 3, 8}));
}

// Both corners of a short side are within the tolerance of each other, and of nothing else.
TEST(WeldTest, NoFaceLosesACorner) {
  MeshData data = make({{0, 0, 0}, {0.01, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const RepairReport report = mend(data, within(0.1));
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(names(report.done), Names());
  ASSERT_EQ(names(report.left), Names{"welded vertices"});
  EXPECT_EQ(report.left[0].text, "1 vertex left within the tolerance of another: a face has both");
}

// Within a tolerance wider than the mesh faces fall onto each other, which is told, but keep their
// corners.
TEST(WeldTest, AToleranceThatIsTooWide) {
  MeshData data = halves(0.01);
  const RepairReport report = repair(data, within(100));
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(names(report.done), Names{"repeated faces"});
}

// The two sides of a wall are closed: their vertices are at no border.
TEST(WeldTest, SheetsOfAClosedWallStayTwo) {
  MeshData data = zoo::tetrahedron();
  const MeshData given = data;
  for (const glm::dvec3& p : given.positions) data.positions.push_back(p + glm::dvec3(0.01, 0, 0));
  for (std::size_t f = 0; f < 4; ++f) {
    const std::uint32_t* v = &given.faces.vertices[3 * f];
    data.faces.add(Shape::Triangle, {v[0] + 4, v[1] + 4, v[2] + 4});
  }
  const MeshData before = data;
  EXPECT_EQ(names(mend(data, within(0.1)).done), Names());
  EXPECT_TRUE(data == before);
}

// Two faces that only come to touch at a corner stay as they are, to the bit.
TEST(WeldTest, ACornerAloneIsNotJoined) {
  MeshData data = make({{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0.01, 0, 0}, {1, -1, 0}, {1, 1, 0}},
                       {{0, 1, 2}, {3, 4, 5}});
  const MeshData before = data;
  EXPECT_EQ(names(mend(data, within(0.1)).done), Names());
  EXPECT_TRUE(data == before);
}

// The face that is listed first has the vertex that goes: what is one lies where the other stands.
TEST(WeldTest, TheJoinedVertexLiesWhereTheFirstStands) {
  const MeshData given = halves(0.125);
  MeshData data = make(given.positions, {{3, 4, 5}, {0, 1, 2}});
  mend(data, within(0.125));
  EXPECT_EQ(triangles(data), (Triangles{{3, 4, 5}, {3, 5, 2}}));
  EXPECT_EQ(data.positions[3], given.positions[0]);
  EXPECT_EQ(data.positions[5], given.positions[1]);
  EXPECT_EQ(data.positions[4], given.positions[4]);
}

// 3 is a bow-tie near 0: its two fans come apart where they are.
TEST(WeldTest, ABowTieNearAnotherVertexIsCutInPlace) {
  MeshData data = make({{0, 0, 0},
                        {-1, 1, 0},
                        {-1, -1, 0},
                        {0.01, 0, 0},
                        {1, -1, 0},
                        {1, 1, 0},
                        {1, -1, 1},
                        {1, 1, 1}},
                       {{0, 1, 2}, {3, 4, 5}, {3, 6, 7}});
  const glm::dvec3 place = data.positions[3];
  EXPECT_EQ(names(mend(data, within(0.1)).done), Names{"split vertices"});
  EXPECT_EQ(triangles(data), (Triangles{{0, 1, 2}, {3, 4, 5}, {8, 6, 7}}));
  EXPECT_EQ(data.positions[3], place);
  EXPECT_EQ(data.positions[8], place);
}

TEST(WeldTest, TheClassOfTheLowestDimensionHolds) {
  MeshData data = halves(0.125);
  data.vertex_classes.assign(6, ModelRef(2, 1));
  data.vertex_classes[3] = ModelRef(0, 7);
  mend(data, within(0.125));
  EXPECT_EQ(data.vertex_classes[0], ModelRef(0, 7));
}

// A torus as a soup with every corner moved at random: it closes again, no corner moves further
// than the tolerance, and the order of the faces changes nothing but numbers.
TEST(WeldTest, ASoupWithNoiseCloses) {
  const MeshData torus = zoo::torus(20, 12);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  MeshData soup;
  for (std::uint32_t f = 0; f < torus.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k)
      soup.positions.push_back(torus.positions[torus.faces.vertices[3 * f + k]] +
                               glm::dvec3(noise(random), noise(random), noise(random)));
    soup.faces.add(Shape::Triangle, {3 * f, 3 * f + 1, 3 * f + 2});
  }
  const MeshData before = soup;
  RepairOptions options = within(4e-4);
  options.drop_unused = true;
  MeshData mended = before;
  repair(mended, options);
  EXPECT_EQ(mended.positions.size(), 240u);
  expect_manifold(mended);
  EXPECT_EQ(facts_of(mended).boundary, 0u);
  for (std::size_t c = 0; c < mended.faces.vertices.size(); ++c)
    EXPECT_LE(glm::distance(mended.positions[mended.faces.vertices[c]],
                            before.positions[before.faces.vertices[c]]),
              4e-4);
}

}  // namespace
}  // namespace aomd::test::weld_test
