// Edge removal: exact answers on drawn rings, Klincsek's table against all ways to cut a ring into
// triangles, what is refused; the same whether sides inside regions are entities or not.

#include <gtest/gtest.h>

#include <functional>

#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/edge_removal.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::edge_removal_test {
namespace {

using namespace test;

const RemovalRules rules;

std::vector<std::vector<std::uint32_t>> tets(const Mesh& mesh) {
  std::vector<std::vector<std::uint32_t>> all;
  for (const Region r : mesh.regions()) {
    std::vector<std::uint32_t> one;
    for (const Vertex v : mesh.tetrahedron(r)) one.push_back(v.index);
    std::sort(one.begin(), one.end());
    all.push_back(one);
  }
  std::sort(all.begin(), all.end());
  return all;
}

using Tets = std::vector<std::vector<std::uint32_t>>;

EdgeRemoval judged(const Mesh& mesh, std::uint32_t a, std::uint32_t b,
                   const RemovalRules& with = rules) {
  EdgeRemoval plan;
  (void)judge(mesh, Vertex(a), Vertex(b), with, plan);
  return plan;
}

// Applies what was accepted, and holds the result against the start and the way back.
void make(VolumeBench& bench, const EdgeRemoval& plan, double volume_share = 1e-14) {
  const MeshData before = to_data(bench.mesh);
  const std::string start = zoo::fingerprint(bench.mesh);
  ASSERT_TRUE(plan.verdict.accepted()) << reason_name(plan.verdict.reason);
  Journal journal;
  bench.mesh.attach(&journal);
  apply(bench.mesh, plan);
  EXPECT_EQ(bench.finding(), "");
  EXPECT_EQ(journal.size(), 1u);
  EXPECT_EQ(journal.step(0).kind, StepKind::Swap);
  expect_kept(volume_oracle(before), volume_oracle(to_data(bench.mesh)), volume_share);
  const std::string end = zoo::fingerprint(bench.mesh);
  journal.undo(bench.mesh);
  EXPECT_EQ(zoo::fingerprint(bench.mesh), start);
  EXPECT_EQ(bench.finding(), "");
  journal.redo(bench.mesh);
  EXPECT_EQ(zoo::fingerprint(bench.mesh), end);
  bench.mesh.attach(nullptr);
}

std::vector<glm::dvec3> circle(std::uint32_t n) {
  std::vector<glm::dvec3> ring;
  for (std::uint32_t i = 0; i < n; ++i)
    ring.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0);
  return ring;
}

TEST(EdgeRemovalTest, ThreeBecomeTwo) {
  for (const Levels levels : both_levels) {
    VolumeBench b(ring_around_an_edge(circle(3), {0, 0, -1}, {0, 0, 1}), levels);
    const EdgeRemoval plan = judged(b.mesh, 1, 0);
    EXPECT_NEAR(plan.before, std::sqrt(2.0) * std::sqrt(3.0) / std::pow(2.5, 1.5), 1e-15);
    EXPECT_NEAR(plan.after, std::sqrt(2.0) * 1.5 * std::sqrt(3.0) / std::pow(2.5, 1.5), 1e-15);
    make(b, plan);
    EXPECT_EQ(tets(b.mesh), (Tets{{0, 2, 3, 4}, {1, 2, 3, 4}})) << name(levels);
    EXPECT_TRUE(b.mesh.alive(Region(0)) && b.mesh.alive(Region(1)));
    EXPECT_DOUBLE_EQ(worst_shape(b.mesh), plan.after);
  }
}

//        4
//      / | \        the short diagonal 3-5 comes, along y
//    5   e   3
//      \ | /
//        2
TEST(EdgeRemovalTest, FourBecomeFourOverTheBetterDiagonal) {
  for (const bool wide : {true, false})
    for (const Levels levels : both_levels) {
      auto ring = circle(4);
      ring[wide ? 1 : 0] *= 0.5, ring[wide ? 3 : 2] *= 0.5;
      VolumeBench b(ring_around_an_edge(ring, {0, 0, -1}, {0, 0, 1}), levels);
      make(b, judged(b.mesh, 0, 1));
      EXPECT_EQ(tets(b.mesh), wide
                                  ? (Tets{{0, 2, 3, 5}, {0, 3, 4, 5}, {1, 2, 3, 5}, {1, 3, 4, 5}})
                                  : (Tets{{0, 2, 3, 4}, {0, 2, 4, 5}, {1, 2, 3, 4}, {1, 2, 4, 5}}));
      EXPECT_EQ(b.mesh.capacity(3), 4u) << "all keep their ids";
      EXPECT_EQ(b.mesh.ids(3).size(), 4u);
    }
}

double best_by_trying_all(const MeshData& data, std::uint32_t n, RemovalGoal goal) {
  const bool sums = goal == RemovalGoal::Sum;
  const auto at = [&](std::uint32_t i) { return data.positions[2 + i]; };
  const auto both = [&](std::uint32_t i, std::uint32_t k, std::uint32_t j) {
    const double up = tet_shape(at(i), at(k), at(j), data.positions[1]),
                 down = tet_shape(at(j), at(k), at(i), data.positions[0]);
    if (!sums) return std::min(up, down);
    return up > 0 && down > 0 ? -std::pow(up, -2) - std::pow(down, -2) : -HUGE_VAL;
  };
  // All values of the triangulations of the polygon i..j.
  const std::function<std::vector<double>(std::uint32_t, std::uint32_t)> all =
      [&](std::uint32_t i, std::uint32_t j) {
        if (j == i + 1) return std::vector<double>{sums ? 0.0 : 1.0};
        std::vector<double> values;
        for (std::uint32_t k = i + 1; k < j; ++k)
          for (const double left : all(i, k))
            for (const double right : all(k, j)) {
              const double middle = both(i, k, j);
              values.push_back(sums ? left + right + middle : std::min({left, right, middle}));
            }
        return values;
      };
  const auto values = all(0, n - 1);
  const std::size_t catalan[] = {1, 1, 2, 5, 14, 42, 132, 429};
  EXPECT_EQ(values.size(), catalan[n - 2]);
  return *std::max_element(values.begin(), values.end());
}

TEST(EdgeRemovalTest, TheTableFindsTheBestOfAllTriangulations) {
  int accepted = 0;
  for (std::uint32_t n = 3; n <= 9; ++n)
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
      const MeshData data = random_ring(n, 100 * n + seed);
      VolumeBench listed(data, Levels::Listed, smooth_skin),
          complete(data, Levels::Complete, smooth_skin);
      const EdgeRemoval plan = judged(listed.mesh, 0, 1), same = judged(complete.mesh, 1, 0);
      ASSERT_EQ(plan.verdict.reason, same.verdict.reason);
      const double best = best_by_trying_all(data, n, RemovalGoal::Worst);
      ASSERT_EQ(plan.before, worst_shape(listed.mesh));
      ASSERT_DOUBLE_EQ(plan.after, best) << n << ' ' << seed;
      ASSERT_EQ(plan.verdict.accepted(), best > std::max(plan.before, 0.0) + 1e-6);
      if (!plan.verdict.accepted()) continue;
      ++accepted;
      make(listed, plan);
      make(complete, same);
      EXPECT_EQ(to_data(listed.mesh), to_data(complete.mesh)) << n << ' ' << seed;
      EXPECT_EQ(listed.mesh.count(3), 2 * (n - 2));
      EXPECT_NEAR(worst_shape(listed.mesh), best, 1e-14);
      for (std::uint32_t r = 0; r < std::min(n, 2 * (n - 2)); ++r)
        EXPECT_TRUE(listed.mesh.alive(Region(r)));
    }
  EXPECT_GT(accepted, 60);
}

double energy_of(const Mesh& mesh) {
  double sum = 0;
  for (const Region r : mesh.regions()) {
    const double shape = tet_shape(mesh, r);
    sum += shape > 0 ? std::pow(shape, -2) : HUGE_VAL;
  }
  return sum;
}

// The worst tetrahedron may become worse for it.
TEST(EdgeRemovalTest, TheSumOfEnergiesIsLeastOfAllTriangulationsAndFalls) {
  int accepted = 0, poorer = 0;
  for (std::uint32_t n = 3; n <= 9; ++n)
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
      const MeshData data = random_ring(n, 100 * n + seed);
      VolumeBench b(data, Levels::Listed, smooth_skin);
      const double before = energy_of(b.mesh), worst = worst_shape(b.mesh);
      const double least = -best_by_trying_all(data, n, RemovalGoal::Sum);
      const EdgeRemoval plan = judged(b.mesh, 0, 1, {.goal = RemovalGoal::Sum});
      if (worst > 0)
        ASSERT_NEAR(-plan.before / before, 1, 1e-12);
      else
        ASSERT_EQ(-plan.before, HUGE_VAL);
      ASSERT_EQ(plan.verdict.accepted(), least < (1 - 1e-6) * before) << n << ' ' << seed;
      if (!plan.verdict.accepted()) continue;
      ++accepted;
      ASSERT_NEAR(-plan.after / least, 1, 1e-12) << n << ' ' << seed;
      make(b, plan);
      EXPECT_NEAR(energy_of(b.mesh) / least, 1, 1e-12);
      poorer += worst_shape(b.mesh) < worst;
    }
  EXPECT_GT(accepted, 40);
  EXPECT_GT(poorer, 0);
}

// Better shapes may have smaller dihedral angles: where they do, the limit lies at the smallest.
TEST(EdgeRemovalTest, NoDihedralAngleBelowTheLeastUnlessOneAsBadWasInTheRing) {
  int worse = 0, better = 0;
  for (std::uint32_t n = 3; n <= 9; ++n)
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
      VolumeBench b(random_ring(n, 100 * n + seed), Levels::Listed, smooth_skin);
      const EdgeRemoval free = judged(b.mesh, 0, 1);
      if (!free.verdict.accepted()) continue;
      const auto with = [&](double deg) {
        return judged(b.mesh, 0, 1, {.least_dihedral = LeastAngle(deg)}).verdict;
      };
      const double before = smallest_dihedral(b.mesh);
      const Verdict above = with(70);
      std::array<Verdict, 2> near;
      VolumeBench made(to_data(b.mesh), Levels::Listed, smooth_skin);
      apply(made.mesh, judged(made.mesh, 0, 1));
      const double after = smallest_dihedral(made.mesh);
      for (const int side : {0, 1}) near[side] = with(after + (side == 0 ? -1e-7 : 1e-7));
      ASSERT_TRUE(near[0].accepted()) << n << ' ' << seed;
      ASSERT_EQ(near[1].accepted(), after > before) << n << ' ' << seed;
      ASSERT_EQ(above.accepted(), after > before);
      (after > before ? better : worse) += 1;
      if (after > before) continue;
      ASSERT_EQ(above.reason, Reason::Shape);
      ASSERT_EQ(above.entity, EntityRef(Region(0)));
      ASSERT_NEAR(above.number(), after, 1e-7);
    }
  EXPECT_GT(worse, 5);
  EXPECT_GT(better, 100);
}

// One side of the plane y = 0: the edge 0-1 lies on it, with ring vertices 2 and 3 at its ends.
MeshData half_ring(const std::vector<glm::dvec3>& inner, double height = 1.2) {
  std::vector<glm::dvec3> ring{{1, 0, 0}};
  ring.insert(ring.end(), inner.begin(), inner.end());
  ring.push_back({-1, 0, 0});
  MeshData data = ring_around_an_edge(ring, {0, 0, -height}, {0, 0, height});
  for (int k = 0; k < 4; ++k) data.regions.vertices.pop_back();
  data.regions.shapes.pop_back();
  return data;
}

//   4---5                 4---5
//  /  e  \       --->    /     \          on the boundary; d-c is the new diagonal of the model
//  face
// d---a---c             d-------c
TEST(EdgeRemovalTest, OnTheBoundaryTheDiagonalIsSwapped) {
  for (const Levels levels : both_levels) {
    VolumeBench b(half_ring({{0, 1, 0}}), levels);
    const EdgeRemoval plan = judged(b.mesh, 0, 1);
    ASSERT_TRUE(plan.ring.on_model_face());
    EXPECT_EQ(plan.ring.side_count, 1u);
    make(b, plan);
    EXPECT_EQ(tets(b.mesh), (Tets{{0, 2, 3, 4}, {1, 2, 3, 4}}));
    for (const std::uint32_t end : {0u, 1u})
      EXPECT_EQ(b.mesh.classification(b.mesh.find_face(vertices({2, 4, end}))).dimension(), 2);
  }
}

TEST(EdgeRemovalTest, ThreeOnTheBoundaryBecomeFour) {
  for (const Levels levels : both_levels) {
    VolumeBench b(half_ring({{0.7, 0.9, 0}, {-0.7, 0.9, 0}}, 3), levels);
    make(b, judged(b.mesh, 0, 1));
    EXPECT_EQ(b.mesh.count(3), 4u);
    for (std::uint32_t r = 0; r < 3; ++r) EXPECT_TRUE(b.mesh.alive(Region(r)));
    EXPECT_EQ(b.mesh.capacity(3), 4u);
  }
}

// The plane y = 0 is the interface of two model regions, four tetrahedra around the edge 0-1 on it.
MeshData interface_ring() {
  MeshData data = ring_around_an_edge({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {0, 0, -1.2},
                                      {0, 0, 1.2});
  data.regions.classes = {ModelRef(3, 1), ModelRef(3, 1), ModelRef(3, 2), ModelRef(3, 2)};
  return data;
}

TEST(EdgeRemovalTest, OnAnInterfaceBothSidesKeepTheirModelRegion) {
  for (const Levels levels : both_levels) {
    VolumeBench b(interface_ring(), levels);
    const EdgeRemoval plan = judged(b.mesh, 0, 1);
    EXPECT_EQ(plan.ring.side_count, 2u);
    make(b, plan);
    EXPECT_EQ(tets(b.mesh), (Tets{{0, 2, 3, 4}, {0, 2, 4, 5}, {1, 2, 3, 4}, {1, 2, 4, 5}}));
    for (const Region r : b.mesh.regions()) {
      const auto t = b.mesh.tetrahedron(r);
      const bool left = std::find(t.begin(), t.end(), Vertex(3)) != t.end();
      EXPECT_EQ(b.mesh.classification(r), ModelRef(3, left ? 1 : 2));
    }
  }
}

TEST(EdgeRemovalTest, AModelFaceTurnsByNoMoreThanTheLimit) {
  MeshData data = interface_ring();
  data.positions[2].y = data.positions[4].y = 0.1;  // a ridge of 11 degrees
  const double turn =
      std::acos(1 / std::hypot(1, 0.1) / std::hypot(1, 0.1 / 1.2)) * 180 / M_PI;  // across
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    const EdgeRemoval refused = judged(b.mesh, 0, 1, {.max_turn = TurnLimit(turn - 0.01)});
    EXPECT_EQ(refused.verdict.reason, Reason::Angle);
    EXPECT_NEAR(refused.verdict.number(), turn, 1e-9);
    EXPECT_EQ(refused.verdict.entity.dimension, 2);
    EXPECT_TRUE(judged(b.mesh, 0, 1, {.max_turn = TurnLimit(turn + 0.01)}).verdict.accepted());
  }
}

TEST(EdgeRemovalTest, WhatIsRefused) {
  for (const Levels levels : both_levels) {
    VolumeBench b(ring_around_an_edge(circle(4), {0, 0, -1}, {0, 0, 1}), levels);
    EXPECT_EQ(judged(b.mesh, 2, 4).verdict.reason, Reason::Topology) << "no edge";
    EXPECT_EQ(judged(b.mesh, 2, 3).verdict.reason, Reason::Classification) << "a model edge";
    VolumeBench flat(ring_around_an_edge(circle(5), {0, 0, -0.3}, {0, 0, 0.3}), levels);
    const EdgeRemoval worse = judged(flat.mesh, 0, 1);
    EXPECT_EQ(worse.verdict.reason, Reason::Quality);
    EXPECT_EQ(worse.verdict.entity.dimension, 3);
    VolumeBench many(ring_around_an_edge(circle(10), {0, 0, -3}, {0, 0, 3}), levels);
    EXPECT_EQ(judged(many.mesh, 0, 1).verdict.reason, Reason::Topology) << "ten around it";
  }
}

TEST(EdgeRemovalTest, QualityNamesTheAngleThatWouldResult) {
  VolumeBench b(ring_around_an_edge(circle(3), {0, 0, -0.1}, {0, 0, 0.1}), Levels::Listed);
  const EdgeRemoval plan = judged(b.mesh, 0, 1);
  ASSERT_EQ(plan.verdict.reason, Reason::Quality);
  // The faces of the flat tetrahedron stand on the triangle of inradius 1/2, 0.1 high.
  EXPECT_NEAR(plan.verdict.number(), std::atan(0.1 / 0.5) * 180 / M_PI, 1e-9);
}

TEST(EdgeRemovalTest, TwoModelFacesThatMeetAreAModelEdge) {
  MeshData data = half_ring({{0, 1, 0}});
  data.positions[4] = {-1, -0.4, 0};  // a ridge of 22 degrees at the edge 0-1
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    const EdgeRemoval plan = judged(b.mesh, 0, 1);
    EXPECT_EQ(plan.verdict.reason, Reason::Classification);
    EXPECT_EQ(plan.verdict.entity, EntityRef(b.mesh.find_edge(Vertex(0), Vertex(1))));
  }
}

TEST(EdgeRemovalTest, AnEdgeOfTwoModelRegionsWithoutAFaceBetweenIsNone) {
  VolumeBench b(interface_ring(), Levels::Listed);
  for (const std::uint32_t end : {2u, 4u}) {
    const Face f = b.mesh.find_face(vertices({0, 1, end}));
    b.mesh.destroy_unused(f);
  }
  EXPECT_EQ(judged(b.mesh, 0, 1).verdict.reason, Reason::Classification);
}

TEST(EdgeRemovalTest, AnEdgeWhereAModelFaceEndsIsNone) {
  VolumeBench b(interface_ring(), Levels::Listed);
  const Face stays = b.mesh.find_face(vertices({0, 1, 2}));
  b.mesh.destroy_unused(b.mesh.find_face(vertices({0, 1, 4})));
  const EdgeRemoval plan = judged(b.mesh, 0, 1);
  EXPECT_EQ(plan.verdict.reason, Reason::Classification);
  EXPECT_EQ(plan.verdict.entity, EntityRef(stays));
}

// A second ring goes around the edge outside the first one, and through it.
TEST(EdgeRemovalTest, AnEdgeOfTwoRingsIsNone) {
  MeshData data = ring_around_an_edge(circle(3), {0, 0, -1}, {0, 0, 1});
  for (const glm::dvec3& p : circle(3)) data.positions.push_back(2.0 * p);
  for (const std::uint32_t i : {0u, 1u, 2u})
    data.regions.add(Shape::Tetrahedron, {0, 1, 5 + i, 5 + (i + 1) % 3});
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    EXPECT_EQ(judged(b.mesh, 0, 1).verdict.reason, Reason::Topology) << name(levels);
  }
}

TEST(EdgeRemovalTest, AFaceThatHangsOnTheEdgeHoldsIt) {
  VolumeBench b(ring_around_an_edge(circle(3), {0, 0, -1}, {0, 0, 1}), Levels::Complete);
  const Vertex far = b.mesh.create_vertex({9, 9, 0});
  const ModelRef inside = b.mesh.classification(Region(0));
  const Face hanging = b.mesh.create_face(std::array{Vertex(0), Vertex(1), far}, inside);
  const EdgeRemoval plan = judged(b.mesh, 0, 1);
  EXPECT_EQ(plan.verdict.reason, Reason::Topology);
  EXPECT_EQ(plan.verdict.entity, EntityRef(hanging));
}

// A tetrahedron joins the ends of what would be the new diagonal of a model face.
TEST(EdgeRemovalTest, NoEdgeOfAModelFaceComesTwice) {
  MeshData data = half_ring({{0, 1, 0}});
  data.positions.insert(data.positions.end(), {{0, -9, 0}, {0, -9, 1}});
  data.regions.add(Shape::Tetrahedron, {2, 4, 5, 6});
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    const EdgeRemoval plan = judged(b.mesh, 0, 1);
    ASSERT_TRUE(plan.ring.on_model_face());
    EXPECT_EQ(plan.verdict.reason, Reason::Topology) << name(levels);
    EXPECT_EQ(plan.verdict.entity, EntityRef(plan.ring.apexes[0]));
  }
}

// A tetrahedron far off that joins the ring's 2 and 4, which the new diagonal would do again.
TEST(EdgeRemovalTest, NothingIsJoinedTwice) {
  for (const Levels levels : both_levels) {
    auto ring = circle(4);
    ring[0] *= 0.5, ring[2] *= 0.5;
    MeshData data = ring_around_an_edge(ring, {0, 0, -1}, {0, 0, 1});
    data.positions.insert(data.positions.end(), {{0, 9, 0}, {0, 9, 1}});
    data.regions.add(Shape::Tetrahedron, {2, 4, 6, 7});
    VolumeBench b(data, levels);
    const EdgeRemoval plan = judged(b.mesh, 0, 1);
    EXPECT_EQ(plan.verdict.reason, Reason::Topology) << name(levels);
    EXPECT_EQ(plan.verdict.entity, EntityRef(Vertex(2)));
  }
}

TEST(EdgeRemovalTest, NoFaceOfThreeRegionsComes) {
  for (const Levels levels : both_levels) {
    MeshData data = ring_around_an_edge(circle(3), {0, 0, -1}, {0, 0, 1});
    data.positions.push_back({9, 0, 0});
    data.regions.add(Shape::Tetrahedron, {2, 3, 4, 5});
    VolumeBench b(data, levels);
    EXPECT_EQ(judged(b.mesh, 0, 1).verdict.reason, Reason::Topology) << name(levels);
  }
}

// What was inside out is replaced by what is upright, or stays.
TEST(EdgeRemovalTest, InsideOutIsMendedWhollyOrNotAtAll) {
  auto ring = circle(4);
  ring[0] = {-0.2, 0, 0};  // behind the edge: the two regions at 2 are inside out
  ring[2] = {-1.5, 0, 0};
  const MeshData data = ring_around_an_edge(ring, {0, 0, -1}, {0, 0, 1});
  VolumeBench b(data, Levels::Listed);
  const EdgeRemoval plan = judged(b.mesh, 0, 1);
  EXPECT_LT(plan.before, 0);
  ASSERT_TRUE(plan.verdict.accepted());
  apply(b.mesh, plan);
  EXPECT_GT(worst_shape(b.mesh), 0);
  MeshData turned = data;
  for (std::size_t r = 0; r < 4; ++r)
    std::swap(turned.regions.vertices[4 * r], turned.regions.vertices[4 * r + 1]);
  VolumeBench all_out(turned, Levels::Listed);
  EXPECT_EQ(judged(all_out.mesh, 0, 1).verdict.reason, Reason::Quality);
}

}  // namespace
}  // namespace aomd::edge_removal_test
