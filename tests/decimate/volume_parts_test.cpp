// What the quality strategy for volumes is made of: conditions, debts, places, relaxation.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/decimate/volume/region_balance.h"
#include "core/decimate/volume/vertex_relaxation.h"
#include "core/decimate/volume/volume_placement.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/region_collapse.h"
#include "tests/support/volume_bench.h"

namespace aomd::volume_parts_test {
namespace {

using namespace test;

std::map<int, double> six_volumes_by_region(const Mesh& mesh) {
  std::map<int, double> sums;
  for (const Region r : mesh.regions()) {
    const auto t = mesh.tetrahedron(r);
    sums[mesh.classification(r).tag()] += six_volumes(mesh.position(t[0]), mesh.position(t[1]),
                                                      mesh.position(t[2]), mesh.position(t[3]));
  }
  return sums;
}

Vertex on_the_sphere(const Mesh& mesh) {
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 2 && glm::length(mesh.position(v)) < 0.9) return v;
  return {};
}

TEST(RegionBalanceTest, MovesChangeVolumesAsItSays) {
  VolumeBench b(make_sample("ball-in-box"), Levels::Listed);
  const Vertex v = on_the_sphere(b.mesh);
  ASSERT_TRUE(v.valid());
  Ball ball;
  gather(b.mesh, v, ball);
  RegionBalance balance;
  balance.begin(b.mesh.position(v));
  balance.add(b.mesh, v, ball);
  ASSERT_EQ(balance.conditions().size(), 2u);
  const auto before = six_volumes_by_region(b.mesh);
  const glm::dvec3 by(0.01, -0.02, 0.015);
  b.mesh.move(v, b.mesh.position(v) + by);
  const auto after = six_volumes_by_region(b.mesh);
  for (const VolumeCondition& c : balance.conditions())
    EXPECT_NEAR(after.at(c.region.tag()) - before.at(c.region.tag()), c.change(by), 1e-12);
}

TEST(RegionBalanceTest, ContractionsUnderItsConditionsKeepEachVolume) {
  VolumeBench b(make_sample("ball-in-box"), Levels::Listed);
  const auto before = six_volumes_by_region(b.mesh);
  RegionCollapser collapser(b.mesh);
  VolumeRules rules;
  rules.faces.max_turn = TurnLimit(60);
  std::mt19937 random(5);
  int made = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Face f(random() % b.mesh.capacity(2));
    if (!b.mesh.alive(f)) continue;
    const auto t = b.mesh.triangle(f);
    const Vertex v = t[0], w = t[1];
    if (b.mesh.classification(v).dimension() != 2 || b.mesh.classification(w).dimension() != 2)
      continue;
    std::array<Ball, 2> balls;
    gather(b.mesh, v, balls[0]);
    gather(b.mesh, w, balls[1]);
    RegionBalance balance;
    balance.begin(b.mesh.position(w));
    balance.add(b.mesh, v, balls[0], w, balls[1]);
    const glm::dvec3 along = b.mesh.position(v) - b.mesh.position(w);
    const PlacementLimits limits{0.5 * along, glm::length(along), 0};
    const glm::dvec3 x = nearest_under({}, balance.conditions(), limits, 0.5 * along);
    VolumeCollapsePlan plan;
    if (!collapser.judge(b.mesh, {v, w, b.mesh.position(w) + x}, rules, plan).accepted()) continue;
    collapser.apply(b.mesh, plan);
    ++made;
  }
  EXPECT_GT(made, 50);
  for (const auto& [region, volume] : six_volumes_by_region(b.mesh))
    EXPECT_NEAR(volume, before.at(region), 1e-12 * before.at(region)) << region;
}

TEST(VolumeDebtsTest, AreKeptByVertexAndRegionAndChangeHands) {
  const ModelRef a(3, 1), b(3, 2);
  VolumeDebts debts;
  debts.reset(3);
  debts.add(Vertex(0), a, 1);
  debts.add(Vertex(0), b, -1);
  debts.add(Vertex(1), a, 0.5);
  debts.hand_over(Vertex(0), Vertex(1));
  EXPECT_EQ(debts.of(Vertex(0), a), 0);
  EXPECT_EQ(debts.of(Vertex(1), a), 1.5);
  EXPECT_EQ(debts.of(Vertex(1), b), -1);
  EXPECT_EQ(debts.total(a), 1.5);
  std::array<VolumeCondition, 1> conditions{{{.region = a, .normal = {0, 0, 2}}}};
  debts.charge(Vertex(1), conditions);
  EXPECT_EQ(conditions[0].debt, 1.5);
  debts.settle(Vertex(1), {0, 0, -0.5}, conditions);
  EXPECT_EQ(debts.of(Vertex(1), a), 0.5);
  EXPECT_EQ(debts.of(Vertex(1), b), -1);
  debts.add(Vertex(2), b, 3);
  EXPECT_EQ(debts.total(b), 2);
}

TEST(VolumeDebtsTest, ARegionBearsWhatItsLimitAllowsAndWhatLeadsBack) {
  const ModelRef a(3, 1), b(3, 2);
  VolumeDebts debts;
  debts.reset(2);
  debts.limit(a, 2);
  EXPECT_TRUE(debts.bears(a, -2));
  EXPECT_FALSE(debts.bears(a, 2.5));
  EXPECT_TRUE(debts.bears(b, 1e9));
  debts.add(Vertex(0), a, 3);
  EXPECT_TRUE(debts.bears(a, -6));
  EXPECT_FALSE(debts.bears(a, -6.5));
  EXPECT_FALSE(debts.bears(a, 0.5));
  debts.hand_over(Vertex(0), Vertex(1));
  EXPECT_EQ(debts.total(a), 3);
  EXPECT_EQ(debts.in_limits(a, 1), 2);
  EXPECT_EQ(debts.in_limits(a, -6), -1.5);
  EXPECT_EQ(debts.in_limits(b, 1e9), 0);
}

TEST(PlacementTest, PaysDebtsAsFarAsItMay) {
  std::array<VolumeCondition, 1> conditions{
      {{.region = ModelRef(3, 1), .normal = {0, 0, 2}, .outside = 2, .debt = 0.1}}};
  const PlacementLimits limits{{0.5, 0, 0}, 1, 0.2};
  EXPECT_EQ(nearest_under({}, conditions, limits, limits.middle), glm::dvec3(0.5, 0, -0.05));
  conditions[0].debt = -10;
  EXPECT_EQ(nearest_under({}, conditions, limits, limits.middle), glm::dvec3(0.5, 0, 0.2));
}

TEST(PlacementTest, IsTheLeastPlaceThatMeetsTheCondition) {
  Quadric q;
  q.add_point({1, 2, 3}, 1);
  const std::array<VolumeCondition, 1> conditions{
      {{.region = ModelRef(3, 1), .normal = {0, 0, 1}, .offset = -1, .outside = 1}}};
  const glm::dvec3 x = least_under(q, {}, conditions, {{0, 0, 0}, 1, 0});
  EXPECT_NEAR(x.x, 1, 0.01);
  EXPECT_NEAR(x.y, 2, 0.02);
  EXPECT_EQ(x.z, 1);
}

TEST(VertexRelaxationTest, LeadsToTheMiddleOfACubeAndNotAcrossWhatIsClosed) {
  VolumeBench b(make_sample("tet-box", 2), Levels::Listed);
  Vertex inner;
  for (const Vertex v : b.mesh.vertices())
    if (b.mesh.classification(v).dimension() == 3) inner = v;
  ASSERT_TRUE(inner.valid());
  const glm::dvec3 middle = b.mesh.position(inner);
  b.mesh.move(inner, middle + glm::dvec3(0.1, 0.05, -0.08));
  VertexRelaxation relaxation;
  Ball ball;
  gather(b.mesh, inner, ball);
  relaxation.begin(b.mesh, inner, ball);
  relaxation.close({1, 0, 0});
  glm::dvec3 x(0.0);
  ASSERT_TRUE(relaxation.step(0, glm::dvec3(0.0), x));
  EXPECT_EQ(x.x, 0);
  for (int step = 0; step < 20; ++step) {
    gather(b.mesh, inner, ball);
    relaxation.begin(b.mesh, inner, ball);
    if (!relaxation.step(0, glm::dvec3(0.0), x)) break;
    const double before = relaxation.worst_shape(glm::dvec3(0.0));
    EXPECT_TRUE(step > 0 || relaxation.worst_shape(x) > before);
    b.mesh.move(inner, b.mesh.position(inner) + x);
  }
  EXPECT_LT(glm::length(b.mesh.position(inner) - middle), 0.05);
}

// Around the inner vertex of shaken boxes: no step leaves a smaller dihedral angle than all were,
// where the limit is above them all.
TEST(VertexRelaxationTest, StepsKeepTheLeastDihedralAngle) {
  const MeshData box = make_sample("tet-box", 2);
  const auto inner = std::find_if(box.vertex_classes.begin(), box.vertex_classes.end(),
                                  [](ModelRef on) { return on.dimension() == 3; });
  const Vertex v(static_cast<std::uint32_t>(inner - box.vertex_classes.begin()));
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-0.15, 0.15);
  int worse = 0, held = 0;
  for (int trial = 0; trial < 500; ++trial) {
    MeshData data = box;
    for (glm::dvec3& p : data.positions)
      p += glm::dvec3(place(random), place(random), place(random));
    const auto smallest_at = [&](const glm::dvec3& x) {
      Mesh mesh(data);
      mesh.move(v, mesh.position(v) + x);
      return smallest_dihedral(mesh);
    };
    VolumeBench b(data, Levels::Listed);
    Ball ball;
    gather(b.mesh, v, ball);
    VertexRelaxation relaxation;
    relaxation.begin(b.mesh, v, ball);
    if (!(relaxation.worst_shape(glm::dvec3(0.0)) > 0)) continue;
    const double before = smallest_at(glm::dvec3(0.0));
    glm::dvec3 x(0.0);
    worse += relaxation.step(0, glm::dvec3(0.0), x) && smallest_at(x) < before - 1e-6;
    relaxation.limit_dihedrals(LeastAngle(70));
    EXPECT_TRUE(relaxation.keeps_dihedrals(glm::dvec3(0.0)));
    if (!relaxation.step(0, glm::dvec3(0.0), x)) continue;
    ++held;
    EXPECT_GE(smallest_at(x), before - 1e-9);
  }
  EXPECT_GT(worse, 5);
  EXPECT_GT(held, 100);
}

}  // namespace
}  // namespace aomd::volume_parts_test
