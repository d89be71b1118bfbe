// Volumes in parts: what one thread makes of them, others make too, and it is as good as what one
// part comes to.

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "core/decimate/decimation.h"
#include "core/mesh/journal.h"
#include "core/mesh/shared_edits.h"
#include "core/samples/samples.h"
#include "tests/support/thread_runs.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::volume_threads_test {
namespace {

using test::in_parts;
using test::Levels;
using test::RunResult;
using test::VolumeBench;

RunResult run(const MeshData& data, const DecimationOptions& options,
              Levels levels = Levels::Listed) {
  VolumeBench b(data, levels);
  Decimation decimation(b.mesh, options);
  EXPECT_EQ(SharedEdits::possible(b.mesh), levels == Levels::Listed);
  decimation.run();
  EXPECT_EQ(b.finding(), "");
  return {zoo::fingerprint(b.mesh), decimation.sweeps()};
}

void expect_the_same(const MeshData& data, DecimationOptions options) {
  const RunResult one = run(data, options);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    EXPECT_EQ(run(data, options), one)
        << "to " << options.target_faces << ", " << threads << " threads, " << options.parts
        << " parts, regularity " << options.regularity;
  }
}

TEST(VolumePartsThreadsTest, SameBytesOnSamples) {
  for (const auto& [name, size] :
       {std::pair{"ball-in-box", 3}, {"tet-ball", 7}, {"tet-bracket", 3}}) {
    const MeshData data = make_sample(name, size);
    const auto regions = static_cast<std::uint32_t>(data.regions.size());
    expect_the_same(data, in_parts(regions / 2, 2, 1, 0));
    expect_the_same(data, in_parts(regions / 8, 5, 1));
    expect_the_same(data, in_parts(0, 3, 1, 1));
  }
}

TEST(VolumePartsThreadsTest, SameBytesInMorePartsThanThereAreVertices) {
  const MeshData data = test::shaken("tet-box", 4, 0.05, 5);
  expect_the_same(data, in_parts(static_cast<std::uint32_t>(data.regions.size() / 3), 500, 1));
}

// Large enough to be cut by itself.
TEST(LargeVolumeParts, SameBytesForAnyNumberOfThreads) {
  const MeshData data = make_sample("ball-in-box", 7);
  ASSERT_GE(data.regions.size(), 200'000u);
  expect_the_same(data, in_parts(50'000, 0, 1));
}

// A part that has made a step leaves the rest to threads, and the other way round.
TEST(VolumePartsThreadsTest, SameBytesWhereStepsAndThreadsTakeTurns) {
  const MeshData data = make_sample("ball-in-box", 3);
  VolumeBench b(data, Levels::Listed);
  Decimation decimation(b.mesh, in_parts(2000, 4, 3));
  for (int i = 0; !decimation.done(); ++i) {
    for (int k = 0; k < 50 + i % 7; ++k) decimation.step();
    (void)decimation.run(std::chrono::microseconds(0));
  }
  EXPECT_EQ((RunResult{zoo::fingerprint(b.mesh), decimation.sweeps()}),
            run(data, in_parts(2000, 4, 1)));
}

TEST(VolumePartsThreadsTest, ACancelledRunGoesOnToTheSameMesh) {
  const MeshData data = make_sample("ball-in-box", 3);
  std::optional<std::string> whole;
  for (const int every : {1'000'000, 3, 2}) {
    VolumeBench b(data, Levels::Listed);
    Decimation decimation(b.mesh, in_parts(2000, 4, 3));
    int asked = 0, pauses = 0;
    const auto cancelled = [&] { return ++asked % every == 0; };
    while (decimation.run({}, cancelled) == Decimation::Stop::Cancelled)
      ASSERT_EQ(++pauses % 20 == 0 ? b.finding() : "", "");
    EXPECT_EQ(pauses > 0, every < 100);
    EXPECT_EQ(zoo::fingerprint(b.mesh), whole.value_or(zoo::fingerprint(b.mesh))) << every;
    whole = zoo::fingerprint(b.mesh);
  }
}

// Passes from outside change what the parts were cut by.
TEST(VolumePartsThreadsTest, SameBytesWithPassesInBetween) {
  const MeshData data = make_sample("ball-in-box", 3);
  for (const Phase when : {Phase::Collapse, Phase::Swap, Phase::Smooth}) {
    std::optional<std::string> one;
    for (const int threads : {1, 2, 7}) {
      VolumeBench b(data, Levels::Listed);
      Decimation decimation(b.mesh, in_parts(2000, 4, threads));
      while (decimation.phase() != when) decimation.step();
      for (int i = 0; i < 20; ++i) decimation.step();
      EXPECT_GT(decimation.smooth_pass(), 0u);
      for (int i = 0; i < 20; ++i) decimation.step();
      (void)decimation.swap_pass();
      decimation.run();
      EXPECT_EQ(zoo::fingerprint(b.mesh), one.value_or(zoo::fingerprint(b.mesh)))
          << phase_name(when) << ", " << threads << " threads";
      one = zoo::fingerprint(b.mesh);
    }
  }
}

TEST(VolumeParts, SameBytesWithAJournalAndStepByStep) {
  const MeshData data = make_sample("ball-in-box", 3);
  const RunResult fast = run(data, in_parts(2000, 4, 2));
  for (const int threads : {1, 2}) {
    VolumeBench b(data, Levels::Listed);
    const std::string start = zoo::fingerprint(b.mesh);
    Journal journal;
    b.mesh.attach(&journal);
    Decimation decimation(b.mesh, in_parts(2000, 4, threads));
    while (threads == 1 && decimation.step()) {
    }
    decimation.run();
    const std::string end = zoo::fingerprint(b.mesh);
    EXPECT_EQ((RunResult{end, decimation.sweeps()}), fast);
    journal.seek(b.mesh, 0);
    EXPECT_EQ(zoo::fingerprint(b.mesh), start);
    journal.seek(b.mesh, journal.size());
    EXPECT_EQ(zoo::fingerprint(b.mesh), end);
  }
}

// Faces and edges inside regions have to follow each operation at once; regions stay the same.
TEST(VolumeParts, WhereAllFacesAreEntitiesPartsTakeTheirTurnsOneByOne) {
  const MeshData data = make_sample("tet-ball", 8);
  std::array<std::uint32_t, 2> regions{};
  for (const Levels levels : test::both_levels) {
    VolumeBench b(data, levels);
    Decimation(b.mesh, in_parts(1000, 3, 2)).run();
    EXPECT_EQ(b.finding(), "");
    regions.at(levels == Levels::Listed ? 0 : 1) = b.mesh.count(3);
  }
  EXPECT_EQ(regions[0], regions[1]);
}

TEST(VolumeParts, TheTargetIsMetAndTheModelStays) {
  const MeshData data = make_sample("ball-in-box", 3);
  VolumeBench original(data, Levels::Listed);
  const test::VolumeOracle before = test::volume_oracle(to_data(original.mesh));
  for (const auto& [target, parts] : {std::pair{17'000u, 2}, {8000u, 7}, {3001u, 4}, {1500u, 7}}) {
    VolumeBench b(data, Levels::Listed);
    Decimation(b.mesh, in_parts(target, parts, 2)).run();
    EXPECT_LE(b.mesh.count(3), target);
    EXPECT_GE(b.mesh.count(3), target - target / 50);
    test::expect_kept(before, test::volume_oracle(to_data(b.mesh)), 1e-9);
  }
}

double mean_shape(const Mesh& mesh) {
  double sum = 0;
  for (const Region r : mesh.regions()) sum += tet_shape(mesh, r);
  return sum / mesh.count(3);
}

TEST(VolumeParts, AsGoodAsOnePart) {
  const MeshData data = make_sample("ball-in-box", 5);
  std::array<double, 2> shape{};
  for (const std::size_t i : {0u, 1u}) {
    VolumeBench b(data, Levels::Listed);
    Decimation(b.mesh, in_parts(12'000, i == 0 ? 1 : 8, 2)).run();
    shape.at(i) = mean_shape(b.mesh);
    EXPECT_GT(test::smallest_dihedral(b.mesh), 20);
  }
  EXPECT_GT(shape[1], 0.99 * shape[0]);
}

}  // namespace
}  // namespace aomd::volume_threads_test
