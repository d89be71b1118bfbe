// What tetrahedra have in common, and where points lie in them.

#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/fields/tet_tree.h"
#include "core/mesh/tet_geometry.h"
#include "core/samples/samples.h"

namespace aomd::fields::overlap_test {
namespace {

double volume(const Tet& t) { return std::abs(six_volumes(t[0], t[1], t[2], t[3])) / 6; }

double common(const Tet& a, const Tet& b) { return share_inside(TetCoordinates(a), b) * volume(b); }

const Tet corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Tet moved(Tet tet, const glm::dvec3& by, double scale = 1) {
  for (glm::dvec3& p : tet) p = scale * p + by;
  return tet;
}

TEST(Overlap, OfItselfAndOfParts) {
  EXPECT_DOUBLE_EQ(common(corner, corner), 1.0 / 6);
  EXPECT_DOUBLE_EQ(common(corner, moved(corner, {0.1, 0.1, 0.1}, 0.25)), 1.0 / 6 / 64);
  EXPECT_NEAR(common(moved(corner, {0.1, 0.1, 0.1}, 0.25), corner), 1.0 / 6 / 64, 1e-17);
  EXPECT_EQ(common(corner, moved(corner, {2, 0, 0})), 0);
  EXPECT_NEAR(common(corner, moved(corner, {1, 0, 0})), 0, 1e-18) << "they share a vertex";
}

// A plane cuts off one corner, an edge, or all but a corner of the tetrahedron.
TEST(Overlap, OfOneCornerTwoAndThree) {
  const double all = 1.0 / 6;
  EXPECT_NEAR(common(corner, moved(corner, {0.5, 0, 0})), all / 8, 1e-15);
  EXPECT_NEAR(common(corner, moved(corner, {-0.5, 0, 0})), all / 8, 1e-15);
  const Tet upper{{{0.5, -9, -9}, {0.5, 30, -9}, {0.5, -9, 30}, {30, -9, -9}}};  // x > 1/2
  EXPECT_NEAR(common(upper, corner), all / 8, 1e-15) << "one corner is inside";
  const Tet lower{{{0.5, -9, -9}, {0.5, 30, -9}, {0.5, -9, 30}, {-30, -9, -9}}};
  EXPECT_NEAR(common(lower, corner), all * 7 / 8, 1e-15) << "three are";
  const Tet beyond{{{30, -29.5, -50}, {-29.5, 30, -50}, {0.25, 0.25, 60}, {60, 60, 0}}};
  EXPECT_NEAR(common(beyond, corner), all / 2, 1e-15) << "two are, beyond x + y = 1/2";
}

TEST(Overlap, IsTheSameBothWaysAndAddsUp) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const MeshData cube = make_sample("tet-box", 2);
  const Cells cells(cube, 3);
  std::vector<std::uint32_t> all(cells.size());
  std::iota(all.begin(), all.end(), 0u);
  const TetTree tree(cells, all);
  for (int i = 0; i < 500; ++i) {
    Tet tet;
    for (glm::dvec3& p : tet) p = {unit(random), unit(random), unit(random)};
    double sum = 0;
    tree.each_overlap(
        tet, [](std::uint32_t) { return true; },
        [&](std::uint32_t r, double part) {
          EXPECT_NEAR(part, common(cells.tet(r), tet), 1e-12);
          sum += part;
        });
    EXPECT_NEAR(sum, volume(tet), 1e-14);
  }
}

TEST(Overlap, FlatOnesHaveNone) {
  const Tet flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  EXPECT_TRUE(TetCoordinates(flat).flat());
  EXPECT_EQ(common(corner, flat), 0);
}

// In a sliver a weight is only as good as its height; the point that the weights name is better.
TEST(Place, WeightsNameThePointInSliversToo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 o = any(), u = any(), v = any(), up = 1e-8 * any();
    const Tet sliver{{o, o + u + up, o + u + v, o + v + up}};
    const glm::dvec3 p = o + 0.4 * u + 0.3 * v + 0.5 * up;
    const Weights w = TetCoordinates(sliver).refined(p);
    glm::dvec3 named(0);
    for (std::size_t k = 0; k < 4; ++k) named += w[k] * sliver[k];
    EXPECT_LT(glm::length(named - p), 1e-14) << i;
  }
}

// Beside a well shaped tetrahedron lies a sliver that is nearer to the point outside.
TEST(Place, OutsideTheOneThatIsCarriedOnLeast) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 1, 1e-6}};
  mesh.regions.add(Shape::Tetrahedron, {1, 2, 4, 0});
  mesh.regions.add(Shape::Tetrahedron, {0, 2, 1, 3});
  const Cells cells(mesh, 3);
  const TetTree tree(cells, {0, 1});
  EXPECT_EQ(tree.region_at({0.3, 0.3, -0.2}), 1u);
  EXPECT_EQ(tree.region_at({0.3, 0.3, 0.05}), 1u) << "0.05 is 50,000 heights of the sliver";
  EXPECT_EQ(tree.region_at({-50, 3, 70}), 1u);
  EXPECT_EQ(TetTree(cells, {}).region_at({0, 0, 0}), no_index);
}

}  // namespace
}  // namespace aomd::fields::overlap_test
