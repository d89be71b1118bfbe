// Moves of the vertices of tetrahedra: exact targets on drawn balls, volumes kept on model faces,
// what may not move.

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "core/model/analytic_model.h"
#include "core/operators/region_move.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::region_move_test {
namespace {

using namespace test;

RegionMove judged(const Mesh& mesh, std::uint32_t v, const MoveRules& rules = {}) {
  RegionMover mover(mesh);
  RegionMove plan;
  (void)mover.judge(mesh, Vertex(v), rules, plan);
  return plan;
}

// Vertex 0 among the six corners 1 to 6 of an octahedron, stretched.
MeshData octahedron_around(const glm::dvec3& centre, const glm::dvec3& stretch = {1, 1, 1}) {
  MeshData data;
  data.positions = {centre};
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 p(0.0);
      p[axis] = sign * stretch[axis];
      data.positions.push_back(p);
    }
  for (const std::uint32_t x : {1u, 2u})
    for (const std::uint32_t y : {3u, 4u})
      for (const std::uint32_t z : {5u, 6u})
        if ((x + y + z) % 2 == 1)
          data.regions.add(Shape::Tetrahedron, {0, x, y, z}, ModelRef(3, 1));
        else
          data.regions.add(Shape::Tetrahedron, {0, y, x, z}, ModelRef(3, 1));
  return data;
}

TEST(RegionMoveTest, InsideARegionTheAverageOfTheNeighbours) {
  for (const Levels levels : both_levels) {
    VolumeBench b(octahedron_around({0.3, 0.2, -0.1}), levels);
    ASSERT_EQ(volume_oracle(to_data(b.mesh)).inverted, 0);
    const RegionMove plan = judged(b.mesh, 0);
    ASSERT_TRUE(plan.verdict.accepted());
    EXPECT_EQ(plan.target, glm::dvec3(0.0));
    EXPECT_NEAR(plan.after, std::sqrt(2) / std::pow(1.5, 1.5), 1e-15);
    Journal journal;
    const std::string start = zoo::fingerprint(b.mesh);
    b.mesh.attach(&journal);
    RegionMover::apply(b.mesh, plan);
    EXPECT_EQ(b.mesh.position(Vertex(0)), glm::dvec3(0.0));
    EXPECT_EQ(journal.step(0).kind, StepKind::Smooth);
    const RegionMove again = judged(b.mesh, 0);
    EXPECT_EQ(again.verdict.reason, Reason::Quality);
    EXPECT_NEAR(again.verdict.number(), std::atan(std::sqrt(2)) * 180 / M_PI, 1e-12);
    journal.undo(b.mesh);
    EXPECT_EQ(zoo::fingerprint(b.mesh), start);
    b.mesh.attach(nullptr);
  }
}

double worst_at(const Mesh& mesh, const RegionMove& plan, const glm::dvec3& at) {
  double worst = 1;
  for (const BallRegion& r : plan.ball)
    worst = std::min(worst, tet_shape(at, mesh.position(r.others[0]), mesh.position(r.others[1]),
                                      mesh.position(r.others[2])));
  return worst;
}

double best_on_a_grid(const Mesh& mesh, const RegionMove& plan) {
  double best = -1;
  constexpr int n = 20;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      for (int k = -n; k <= n; ++k)
        best = std::max(best, worst_at(mesh, plan, glm::dvec3(i, j, k) * (1.2 / n)));
  return best;
}

void shake(MeshData& data, std::mt19937& random) {
  for (std::size_t v = 1; v < 7; ++v) {
    data.positions[v] *= 0.15 + double(random() % 1000) / 600;
    for (int k = 0; k < 3; ++k) data.positions[v][k] += 0.3 * (double(random() % 1000) / 500 - 1);
  }
}

// Corners at random distances: the average may be no good place, and the worst is still found good
// enough, or as good as there is.
TEST(RegionMoveTest, ThePoorClimb) {
  int climbed = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    MeshData data = octahedron_around({0, 0, 0});
    shake(data, random);
    VolumeBench b(data, Levels::Listed, smooth_skin);
    const RegionMove plan = judged(b.mesh, 0);
    ASSERT_NEAR(plan.before, worst_at(b.mesh, plan, {0, 0, 0}), 1e-14);
    ASSERT_NEAR(plan.after, worst_at(b.mesh, plan, plan.target), 1e-14);
    if (plan.before < 0 || plan.before >= 0.3) continue;
    ++climbed;
    const double best = best_on_a_grid(b.mesh, plan);
    EXPECT_GE(plan.after, std::min(0.3, 0.9 * best)) << seed;
    EXPECT_GE(judged(b.mesh, 0, {.poor = 1}).after, 0.97 * best) << seed;
  }
  EXPECT_GT(climbed, 10);
}

// Moves that make the worst shape better, and a dihedral angle smaller than all were before. Where
// all angles are below the limit, those that were so bad before may stay so.
TEST(RegionMoveTest, NoDihedralAngleBelowTheLeastUnlessOneAsBadWasAround) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.5, 0.5), stretch(0.3, 4);
  int worse = 0, refused = 0, below = 0;
  for (int i = 0; i < 2000; ++i) {
    MeshData data = octahedron_around({place(random), place(random), place(random)},
                                      {stretch(random), stretch(random), stretch(random)});
    for (std::size_t k = 1; k < data.positions.size(); ++k)
      data.positions[k] += glm::dvec3(place(random), place(random), place(random));
    VolumeBench b(data, Levels::Listed);
    if (volume_oracle(data).inverted > 0) continue;
    const auto after = [&](const RegionMove& plan) {
      VolumeBench moved(data, Levels::Listed);
      moved.mesh.move(Vertex(0), plan.target);
      return smallest_dihedral(moved.mesh);
    };
    const double before = smallest_dihedral(b.mesh), least = before + 1e-6;
    const RegionMove free = judged(b.mesh, 0);
    worse += free.verdict.accepted() && after(free) < before - 1e-6;
    const RegionMove held = judged(b.mesh, 0, {.least_dihedral = LeastAngle(least)});
    EXPECT_GE(after(held), before - 1e-9) << i;
    below += judged(b.mesh, 0, {.least_dihedral = LeastAngle(70)}).verdict.accepted();
    if (held.verdict.reason != Reason::Shape) continue;
    ++refused;
    EXPECT_EQ(held.verdict.entity.dimension, 3);
    EXPECT_LT(held.verdict.number(), before);
  }
  EXPECT_GT(worse, 20);
  EXPECT_GT(refused, 5);
  EXPECT_GT(below, 100);
}

// The worst of good ones may not get better at the cost of all together.
TEST(RegionMoveTest, WhereNoneIsPoorTheSumDoesNotFall) {
  int moved = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    MeshData data = octahedron_around({0, 0, 0});
    shake(data, random);
    VolumeBench b(data, Levels::Listed, smooth_skin);
    const RegionMove plan = judged(b.mesh, 0, {.poor = 0});
    if (!plan.verdict.accepted() || plan.before < 0) continue;
    ++moved;
    double gain = 0;
    for (const BallRegion& r : plan.ball) {
      const glm::dvec3 p = b.mesh.position(r.others[0]), q = b.mesh.position(r.others[1]),
                       s = b.mesh.position(r.others[2]);
      gain += tet_shape(plan.target, p, q, s) - tet_shape({0, 0, 0}, p, q, s);
    }
    EXPECT_GE(gain, -1e-14) << seed;
  }
  EXPECT_GT(moved, 20);
}

// Half of it: vertex 0 on the face z = 0 with corners 1 to 4, the apex 6 below.
MeshData half_octahedron(const glm::dvec3& centre) {
  MeshData data = octahedron_around(centre);
  MeshData half;
  half.positions = data.positions;
  half.positions.erase(half.positions.begin() + 5);
  for (std::size_t r = 0; r < data.regions.size(); ++r) {
    const std::uint32_t* t = &data.regions.vertices[4 * r];
    if (t[3] == 6) half.regions.add(Shape::Tetrahedron, {t[0], t[1], t[2], 5}, ModelRef(3, 1));
  }
  return half;
}

TEST(RegionMoveTest, OnAFlatModelFaceItStaysOnIt) {
  for (const Levels levels : both_levels) {
    VolumeBench b(half_octahedron({0.4, 0.3, 0}), levels);
    const RegionMove plan = judged(b.mesh, 0);
    ASSERT_TRUE(plan.verdict.accepted()) << reason_name(plan.verdict.reason);
    EXPECT_NEAR(plan.target.x, 0, 1e-15);
    EXPECT_NEAR(plan.target.y, 0, 1e-15);
    EXPECT_EQ(plan.target.z, 0);
  }
}

TEST(RegionMoveTest, AtTheEndOfAModelFaceItStays) {
  VolumeBench b(half_octahedron({0.4, 0.3, 0}), Levels::Listed);
  b.mesh.destroy_unused(b.mesh.find_face(vertices({0, 1, 3})));
  const RegionMove plan = judged(b.mesh, 0);
  EXPECT_EQ(plan.verdict.reason, Reason::Classification);
  EXPECT_EQ(plan.verdict.entity, EntityRef(Vertex(0)));
}

TEST(RegionMoveTest, OnACurvedModelFaceTheVolumesStay) {
  MeshData data = half_octahedron({0.4, 0.3, 0.1});
  data.positions[1].z = 0.05, data.positions[4].z = -0.04;
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels, smooth_skin);
    ASSERT_EQ(b.mesh.classification(Vertex(0)).dimension(), 2);
    const VolumeOracle before = volume_oracle(to_data(b.mesh));
    const RegionMove plan = judged(b.mesh, 0, {.max_turn = TurnLimit(60)});
    ASSERT_TRUE(plan.verdict.accepted()) << reason_name(plan.verdict.reason);
    EXPECT_GT(glm::length(plan.target - b.mesh.position(Vertex(0))), 0.3);
    RegionMover::apply(b.mesh, plan);
    expect_kept(before, volume_oracle(to_data(b.mesh)), 1e-14);
    EXPECT_EQ(b.finding(), "");
  }
}

TEST(RegionMoveTest, NormalsTurnByNoMoreThanTheLimit) {
  VolumeBench b(half_octahedron({0.4, 0.3, 0.15}), Levels::Listed, smooth_skin);
  const RegionMove plan = judged(b.mesh, 0, {.max_turn = TurnLimit(0.01)});
  EXPECT_EQ(plan.verdict.reason, Reason::Angle);
  EXPECT_EQ(plan.verdict.entity.dimension, 2);
  EXPECT_GT(plan.verdict.number(), 0.01);
}

// The middle of the edge 1-2 of a wedge of four tetrahedra around the axis x.
//   1---0---2 along x, 3 and 4 off it
MeshData on_a_model_edge(const glm::dvec3& centre) {
  MeshData data;
  data.positions = {centre, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data.regions.add(Shape::Tetrahedron, {1, 0, 3, 4}, ModelRef(3, 1));
  data.regions.add(Shape::Tetrahedron, {0, 2, 3, 4}, ModelRef(3, 1));
  return data;
}

TEST(RegionMoveTest, OnAStraightModelEdgeAlongIt) {
  for (const Levels levels : both_levels) {
    VolumeBench b(on_a_model_edge({0.5, 0, 0}), levels);
    ASSERT_EQ(b.mesh.classification(Vertex(0)).dimension(), 1);
    const RegionMove plan = judged(b.mesh, 0);
    ASSERT_TRUE(plan.verdict.accepted()) << reason_name(plan.verdict.reason);
    EXPECT_EQ(plan.target, glm::dvec3(0.0));
  }
}

// Along no axis, so that numbers are rounded.
MeshData turned(MeshData data) {
  const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 3)),
                   y = glm::normalize(glm::cross(x, glm::dvec3(0, 0, 1))), z = glm::cross(x, y);
  for (glm::dvec3& p : data.positions) p = p.x * x + p.y * y + p.z * z;
  return data;
}

double distance_to_line(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(glm::cross(p - a, glm::normalize(b - a)));
}

// Where the slopes along the edge, or the face, cancel there is nowhere to go.
TEST(RegionMoveTest, ClimbingLeavesNeitherEdgeNorFace) {
  int on_edge = 0, on_face = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) {
      return low + (high - low) * double(random() % 10'000) / 1e4;
    };
    MeshData wedge = on_a_model_edge({number(-0.9, 0.9), 0, 0});
    wedge.positions[3] = {number(-0.5, 0.5), number(0.02, 0.3), 0};
    wedge.positions[4] = {number(-0.5, 0.5), 0, number(0.02, 0.3)};
    MeshData half = half_octahedron({number(-0.3, 0.3), number(-0.3, 0.3), 0});
    for (std::size_t v = 1; v < 5; ++v) half.positions[v] *= number(0.2, 1.5);
    half.positions[5].z = -number(0.05, 0.2);
    VolumeBench edge(turned(wedge), Levels::Listed), face(turned(half), Levels::Listed);
    const RegionMove along = judged(edge.mesh, 0), across = judged(face.mesh, 0);
    on_edge += along.verdict.accepted();
    on_face += across.verdict.accepted();
    EXPECT_LE(distance_to_line(along.target, edge.mesh.position(Vertex(1)),
                               edge.mesh.position(Vertex(2))),
              1e-12)
        << seed;
    const glm::dvec3 a = face.mesh.position(Vertex(1)), b = face.mesh.position(Vertex(2)),
                     c = face.mesh.position(Vertex(3));
    EXPECT_LE(std::abs(six_volumes(a, b, c, across.target)), 1e-12) << seed;
  }
  EXPECT_GT(on_edge, 100);
  EXPECT_GT(on_face, 50);
}

TEST(RegionMoveTest, BeyondTheEndOfItsModelEdgeItStays) {
  VolumeBench b(on_a_model_edge({0.5, 0, 0}), Levels::Listed);
  b.mesh.move(Vertex(0), {1.5, 0, 0});
  const RegionMove plan = judged(b.mesh, 0);
  EXPECT_EQ(plan.verdict.reason, Reason::Angle);
  EXPECT_EQ(plan.verdict.entity.dimension, 1);
  EXPECT_NEAR(plan.verdict.number(), 180, 1e-9);
}

TEST(RegionMoveTest, ABentModelEdgeStays) {
  for (const Levels levels : both_levels) {
    VolumeBench b(on_a_model_edge({0.5, -0.01, -0.01}), levels, {.corner_angle_deg = 60});
    ASSERT_EQ(b.mesh.classification(Vertex(0)).dimension(), 1);
    const RegionMove plan = judged(b.mesh, 0);
    EXPECT_EQ(plan.verdict.reason, Reason::Angle);
    EXPECT_EQ(plan.verdict.entity.dimension, 1);
  }
}

// The edge is straight, the model face z = 0 beside it is not: its border would slide off it.
TEST(RegionMoveTest, AModelEdgeBesideACurvedModelFaceStays) {
  MeshData data;
  data.positions = {{0.5, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0.2, 1, 0.1}, {0, 0.5, 1}};
  data.regions.add(Shape::Tetrahedron, {1, 0, 3, 4}, ModelRef(3, 1));
  data.regions.add(Shape::Tetrahedron, {0, 2, 3, 4}, ModelRef(3, 1));
  data.positions.push_back({1, 0.9, 0.4});  // the face bends between 0 2 5 and 0 5 3
  data.regions.vertices[6] = 5;
  data.regions.add(Shape::Tetrahedron, {0, 5, 3, 4}, ModelRef(3, 1));
  VolumeBench b(data, Levels::Listed, {.feature_angle_deg = 40});
  ASSERT_EQ(b.mesh.classification(Vertex(0)).dimension(), 1);
  const RegionMove plan = judged(b.mesh, 0);
  EXPECT_EQ(plan.verdict.reason, Reason::Angle);
  EXPECT_EQ(plan.verdict.entity.dimension, 2);
}

// Two model faces meet in the edge, each bent so that moving along it would change the volume
// beside it, though not that of both.
TEST(RegionMoveTest, EachModelFaceBesideTheEdgeHasItsSay) {
  MeshData data;
  data.positions = {{0, 0, 0},     {-1, 0, 0},  {1, 0, 0},     {-0.3, 1, 0},
                    {0.3, 1, 0.2}, {0.3, 0, 1}, {-0.3, 0.2, 1}};
  for (const auto& [x, y, z] : {std::array{1u, 3u, 6u}, std::array{3u, 5u, 6u},
                                std::array{3u, 4u, 5u}, std::array{4u, 2u, 5u}})
    data.regions.add(Shape::Tetrahedron, {0, x, z, y}, ModelRef(3, 1));
  VolumeBench b(data, Levels::Listed, {.feature_angle_deg = 40});
  ASSERT_EQ(volume_oracle(to_data(b.mesh)).inverted, 0);
  ASSERT_EQ(b.mesh.classification(Vertex(0)).dimension(), 1);
  const RegionMove plan = judged(b.mesh, 0);
  EXPECT_EQ(plan.verdict.reason, Reason::Angle);
  EXPECT_EQ(plan.verdict.entity.dimension, 2);
}

TEST(RegionMoveTest, WhatNeverMoves) {
  for (const Levels levels : both_levels) {
    VolumeBench b(octahedron_around({0.3, 0.2, -0.1}), levels);
    EXPECT_EQ(judged(b.mesh, 1).verdict.reason, Reason::Classification) << "a model vertex";
    Mesh loose(octahedron_around({0.3, 0.2, -0.1}));
    set_all(loose);
    EXPECT_EQ(judged(loose, 0).verdict.reason, Reason::Classification) << "unclassified";
  }
  VolumeBench mixed(zoo::hybrid(), Levels::Complete);
  const RegionMove plan = judged(mixed.mesh, 5);
  EXPECT_EQ(plan.verdict.reason, Reason::Kept);
  EXPECT_EQ(plan.verdict.entity, EntityRef(Region(0))) << "a hexahedron";
}

TEST(RegionMoveTest, WithAModelTheTargetLiesOnIt) {
  const AnalyticModel sphere = sphere_model(1);
  VolumeBench b(make_sample("tet-ball", 3), Levels::Listed, smooth_skin);
  RegionMover mover(b.mesh);
  RegionMove plan;
  std::uint32_t moved = 0;
  for (const Vertex v : b.mesh.vertices()) {
    if (b.mesh.classification(v).dimension() != 2) continue;
    if (!mover.judge(b.mesh, v, {.max_turn = TurnLimit(30), .model = &sphere}, plan).accepted())
      continue;
    EXPECT_NEAR(glm::length(plan.target), 1, 1e-12);
    ++moved;
  }
  EXPECT_GT(moved, 0u);
}

}  // namespace
}  // namespace aomd::region_move_test
