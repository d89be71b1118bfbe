// Passes over tetrahedra: the worst never gets worse, everything else stays, whoever watches has a
// say.

#include <gtest/gtest.h>

#include "core/decimate/volume/improvement.h"
#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::volume_improvement_test {
namespace {

using namespace test;

std::uint32_t count_below(const Mesh& mesh, double limit) {
  std::uint32_t count = 0;
  for (const Region r : mesh.regions()) count += tet_shape(mesh, r) < limit;
  return count;
}

// Counts, and may refuse everything.
struct Counter : ImprovementWatch {
  bool open = true;
  std::uint32_t asked = 0, edges = 0, faces = 0, moves = 0;
  bool allows(const EdgeRemoval&) override { return ++asked, open; }
  bool allows(const FaceRemoval&) override { return ++asked, open; }
  bool allows(const RegionMove&) override { return ++asked, open; }
  void made(const EdgeRemoval&) override { ++edges; }
  void made(const FaceRemoval&) override { ++faces; }
  void made(const RegionMove&) override { ++moves; }
};

MeshData shaken_box() { return shaken("tet-box", 5, 0.05, 11); }

TEST(VolumeImprovementTest, PassesMakeTheWorstBetterAndKeepTheRest) {
  VolumeBench listed(shaken_box(), Levels::Listed), complete(shaken_box(), Levels::Complete);
  const VolumeOracle before = volume_oracle(to_data(listed.mesh));
  const double worst = worst_shape(listed.mesh);
  const std::uint32_t poor = count_below(listed.mesh, 0.4);
  ASSERT_GT(worst, 0);
  Counter some, all;
  VolumeImprovement with(listed.mesh, {}, some), without(complete.mesh, {}, all);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(with.swap_pass(), without.swap_pass());
    EXPECT_EQ(with.smooth_pass(), without.smooth_pass());
    EXPECT_EQ(listed.finding(), "");
    EXPECT_EQ(complete.finding(), "");
    EXPECT_EQ(to_data(listed.mesh), to_data(complete.mesh));
  }
  EXPECT_EQ(with.mend(0.3), without.mend(0.3));
  EXPECT_EQ(to_data(listed.mesh), to_data(complete.mesh));
  expect_kept(before, volume_oracle(to_data(listed.mesh)), 1e-12);
  EXPECT_GT(worst_shape(listed.mesh), 1.5 * worst);
  EXPECT_LT(count_below(listed.mesh, 0.4), poor / 4);
  EXPECT_GT(some.edges, 0u);
  EXPECT_GT(some.moves, 0u);
}

TEST(VolumeImprovementTest, WhoWatchesHasASay) {
  VolumeBench b(shaken_box(), Levels::Listed);
  const std::string start = zoo::fingerprint(b.mesh);
  Counter closed;
  closed.open = false;
  VolumeImprovement improvement(b.mesh, {}, closed);
  EXPECT_EQ(improvement.swap_pass() + improvement.smooth_pass() + improvement.mend(0.3), 0u);
  EXPECT_GT(closed.asked, 0u);
  EXPECT_EQ(zoo::fingerprint(b.mesh), start);
}

TEST(VolumeImprovementTest, OneAtATimeIsTheSameAsAPass) {
  VolumeBench whole(shaken_box(), Levels::Listed), single(shaken_box(), Levels::Listed);
  Counter counter;
  VolumeImprovement passes(whole.mesh, {}, counter), steps(single.mesh, {}, counter);
  Journal journal;
  single.mesh.attach(&journal);
  const std::string start = zoo::fingerprint(single.mesh);
  std::uint32_t count = 0;
  steps.begin_pass();
  for (bool made = false; steps.next_swap(made);) {
    count += made;
    ASSERT_EQ(journal.size(), count) << "one step each";
  }
  steps.begin_pass();
  for (bool made = false; steps.next_move(made);) count += made;
  EXPECT_EQ(passes.swap_pass() + passes.smooth_pass(), count);
  EXPECT_EQ(zoo::fingerprint(whole.mesh), zoo::fingerprint(single.mesh));
  journal.seek(single.mesh, 0);
  EXPECT_EQ(zoo::fingerprint(single.mesh), start);
  single.mesh.attach(nullptr);
}

TEST(VolumeImprovementTest, MendingGoesOnUntilNothingBelowCanBeMended) {
  for (const std::uint32_t seed : {5u, 6u, 7u}) {
    VolumeBench b(shaken("tet-ball", 4, 0.12, seed), Levels::Listed, smooth_skin);
    Counter counter;
    VolumeImprovement improvement(b.mesh, {}, counter);
    const std::uint32_t below = count_below(b.mesh, 0.5);
    const std::uint32_t made = improvement.mend(0.5);
    EXPECT_EQ(made, counter.edges + counter.faces + counter.moves);
    EXPECT_LT(count_below(b.mesh, 0.5), below / 2);
    EXPECT_EQ(improvement.mend(0.5), 0u) << seed;
    EXPECT_EQ(b.finding(), "");
  }
}

TEST(VolumeImprovementTest, OtherShapesAndTheirVerticesStay) {
  VolumeBench b(zoo::hybrid(), Levels::Complete);
  const MeshData start = to_data(b.mesh);
  ImprovementWatch nobody;
  ImprovementRules rules;
  rules.poor = 1;
  VolumeImprovement improvement(b.mesh, rules, nobody);
  EXPECT_EQ(improvement.swap_pass(), 0u);
  (void)improvement.smooth_pass();
  (void)improvement.mend(1);
  const MeshData end = to_data(b.mesh);
  EXPECT_EQ(end.regions, start.regions);
  for (std::size_t v = 0; v < 11; ++v) EXPECT_EQ(end.positions[v], start.positions[v]) << v;
}

}  // namespace
}  // namespace aomd::volume_improvement_test
