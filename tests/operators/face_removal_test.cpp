// Face removal: two tetrahedra become three, exact on drawn meshes, and what is refused.

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/edge_removal.h"
#include "core/operators/face_removal.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::face_removal_test {
namespace {

using namespace test;

// Two flat tetrahedra above and below the triangle 0 1 2, whose apexes 3 and 4 are near.
MeshData two_flat(double height = 0.3) {
  MeshData data;
  for (int i = 0; i < 3; ++i)
    data.positions.emplace_back(std::cos(2 * M_PI * i / 3), std::sin(2 * M_PI * i / 3), 0);
  data.positions.emplace_back(0, 0, height);
  data.positions.emplace_back(0, 0, -height);
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, ModelRef(3, 1));
  data.regions.add(Shape::Tetrahedron, {2, 1, 0, 4}, ModelRef(3, 1));
  return data;
}

FaceRemoval judged(const Mesh& mesh, std::uint32_t region, std::uint32_t slot,
                   double least_dihedral_deg = 0) {
  FaceRemoval plan;
  (void)judge(mesh, Region(region), slot, {.least_dihedral = LeastAngle(least_dihedral_deg)}, plan);
  return plan;
}

TEST(FaceRemovalTest, TwoBecomeThree) {
  for (const Levels levels : both_levels)
    for (const std::uint32_t first : {0u, 1u}) {
      VolumeBench b(two_flat(), levels);
      const VolumeOracle before = volume_oracle(to_data(b.mesh));
      const std::string start = zoo::fingerprint(b.mesh);
      Journal journal;
      b.mesh.attach(&journal);
      const FaceRemoval plan = judged(b.mesh, first, 3);
      ASSERT_TRUE(plan.verdict.accepted()) << reason_name(plan.verdict.reason);
      EXPECT_NEAR(plan.before, std::sqrt(2) * 1.5 * std::sqrt(3) * 0.3 / std::pow(2.045, 1.5),
                  1e-15);
      EXPECT_NEAR(plan.after, std::sqrt(2) * std::sqrt(0.75) * 0.6 / std::pow(7.72 / 6, 1.5),
                  1e-15);
      apply(b.mesh, plan);
      EXPECT_EQ(b.finding(), "");
      EXPECT_EQ(b.mesh.count(3), 3u);
      expect_kept(before, volume_oracle(to_data(b.mesh)), 1e-15);
      for (const Region r : b.mesh.regions()) {
        const auto t = b.mesh.tetrahedron(r);
        EXPECT_NE(std::find(t.begin(), t.end(), Vertex(3)), t.end());
        EXPECT_NE(std::find(t.begin(), t.end(), Vertex(4)), t.end());
      }
      EXPECT_EQ(journal.size(), 1u);
      const std::string end = zoo::fingerprint(b.mesh);
      journal.undo(b.mesh);
      EXPECT_EQ(zoo::fingerprint(b.mesh), start);
      journal.redo(b.mesh);
      EXPECT_EQ(zoo::fingerprint(b.mesh), end);
      b.mesh.attach(nullptr);
      EXPECT_EQ(b.finding(), "");
      EdgeRemoval back;  // and the edge between the apexes is no better without
      EXPECT_EQ(judge(b.mesh, Vertex(3), Vertex(4), {}, back).reason, Reason::Quality);
      EXPECT_NEAR(back.after, plan.before, 1e-15);
    }
}

// The apexes stand off the axis: better shapes may have smaller dihedral angles.
TEST(FaceRemovalTest, NoDihedralAngleBelowTheLeastUnlessOneOfTheTwoWasAsBad) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.6, 0.6), height(0.1, 1.2);
  int worse = 0, better = 0;
  for (int i = 0; i < 2000; ++i) {
    MeshData data = two_flat();
    data.positions[3] = {off(random), off(random), height(random)};
    data.positions[4] = {off(random), off(random), -height(random)};
    VolumeBench b(data, Levels::Listed), made(data, Levels::Listed);
    const FaceRemoval plan = judged(made.mesh, 0, 3);
    if (!plan.verdict.accepted()) continue;
    const double before = smallest_dihedral(b.mesh);
    apply(made.mesh, plan);
    const double after = smallest_dihedral(made.mesh);
    ASSERT_TRUE(judged(b.mesh, 0, 3, after - 1e-7).verdict.accepted()) << i;
    ASSERT_EQ(judged(b.mesh, 0, 3, after + 1e-7).verdict.accepted(), after > before) << i;
    const Verdict above = judged(b.mesh, 0, 3, 70).verdict;
    ASSERT_EQ(above.accepted(), after > before) << i;
    (after > before ? better : worse) += 1;
    if (above.accepted()) continue;
    ASSERT_EQ(above.reason, Reason::Shape);
    ASSERT_EQ(above.entity, EntityRef(Region(0)));
    ASSERT_NEAR(above.number(), after, 1e-7);
  }
  EXPECT_GT(worse, 20);
  EXPECT_GT(better, 100);
}

// By the sum three tetrahedra cost more than two of the same shape.
TEST(FaceRemovalTest, TheSumOfEnergiesFallsWhereItIsTheGoal) {
  int falls = 0, rises = 0;
  for (double height = 0.05; height < 1.2; height += 0.01) {
    VolumeBench b(two_flat(height), Levels::Listed), made(two_flat(height), Levels::Listed);
    const auto energy = [](const Mesh& mesh) {
      double sum = 0;
      for (const Region r : mesh.regions()) sum += std::pow(tet_shape(mesh, r), -2);
      return sum;
    };
    FaceRemoval plan;
    (void)judge(b.mesh, Region(0), 3, {.goal = RemovalGoal::Sum}, plan);
    const double before = energy(b.mesh);
    EXPECT_NEAR(-plan.before / before, 1, 1e-12);
    if (const FaceRemoval free = judged(made.mesh, 0, 3); free.verdict.accepted()) {
      apply(made.mesh, free);
      EXPECT_EQ(plan.verdict.accepted(), energy(made.mesh) < before) << height;
    }
    (plan.verdict.accepted() ? falls : rises) += 1;
    if (!plan.verdict.accepted()) continue;
    apply(b.mesh, plan);
    EXPECT_NEAR(-plan.after / energy(b.mesh), 1, 1e-12);
    EXPECT_LT(energy(b.mesh), before);
  }
  EXPECT_GT(falls, 10);
  EXPECT_GT(rises, 10);
}

TEST(FaceRemovalTest, WhatIsRefused) {
  for (const Levels levels : both_levels) {
    VolumeBench b(two_flat(), levels);
    EXPECT_EQ(judged(b.mesh, 0, 0).verdict.reason, Reason::Topology) << "the outside";
    VolumeBench tall(two_flat(1.2), levels);
    const FaceRemoval worse = judged(tall.mesh, 0, 3);
    EXPECT_EQ(worse.verdict.reason, Reason::Quality);
    MeshData two = two_flat();
    two.regions.classes[1] = ModelRef(3, 2);
    VolumeBench interface(two, levels);
    EXPECT_EQ(judged(interface.mesh, 0, 3).verdict.reason, Reason::Classification);
    MeshData concave = two_flat();
    concave.positions[3].x = concave.positions[4].x = 0.6;  // between 0 and the middle of 1-2: in
    concave.positions[3].y = concave.positions[4].y = 0.6;  // past the edge 0-1
    VolumeBench outside(concave, levels);
    EXPECT_EQ(judged(outside.mesh, 0, 3).verdict.reason, Reason::Quality);
    EXPECT_LT(judged(outside.mesh, 0, 3).after, 0);
  }
}

TEST(FaceRemovalTest, TwoModelRegionsWithoutAFaceBetweenStay) {
  MeshData two = two_flat();
  two.regions.classes[1] = ModelRef(3, 2);
  VolumeBench b(two, Levels::Listed);
  b.mesh.destroy_unused(b.mesh.find_face(vertices({0, 1, 2})));
  const FaceRemoval plan = judged(b.mesh, 0, 3);
  EXPECT_EQ(plan.verdict.reason, Reason::Classification);
  EXPECT_EQ(plan.verdict.entity, EntityRef(Region(1)));
}

TEST(FaceRemovalTest, TheApexesMustNotBeJoined) {
  MeshData data = two_flat();
  data.positions.insert(data.positions.end(), {{0, 9, 0}, {1, 9, 0}});
  data.regions.add(Shape::Tetrahedron, {4, 3, 5, 6}, ModelRef(3, 1));
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    EXPECT_EQ(judged(b.mesh, 0, 3).verdict.reason, Reason::Topology);
  }
}

TEST(FaceRemovalTest, ASheetInsideARegionStays) {
  MeshData data = two_flat();
  data.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 50));
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    const FaceRemoval plan = judged(b.mesh, 0, 3);
    EXPECT_EQ(plan.verdict.reason, Reason::Classification);
    EXPECT_EQ(plan.verdict.entity, EntityRef(b.mesh.find_face(vertices({0, 1, 2}))));
  }
}

}  // namespace
}  // namespace aomd::face_removal_test
