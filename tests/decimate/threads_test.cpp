// The quality strategy on several threads: the same bytes for any number of them.

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <random>

#include "core/decimate/decimation.h"
#include "core/io/io.h"
#include "core/mesh/journal.h"
#include "core/model/discrete_model.h"
#include "core/operators/swap.h"
#include "core/samples/samples.h"
#include "tests/support/thread_runs.h"

namespace aomd::threads_test {
namespace {

using test::classified;
using test::Edges;
using test::run;
using test::RunResult;

DecimationOptions quality(std::uint32_t target, int threads, double regularity = 0.5) {
  DecimationOptions options = test::quality(target, regularity);
  options.threads = threads;
  return options;
}

void expect_the_same(const zoo::Animal& animal, const DecimationOptions& options, Edges edges) {
  test::expect_the_same(animal, options, {2, 3, 7}, edges);
}

// Large enough that every loop is shared out: pieces have up to 2048 items.
std::vector<zoo::Animal> samples() {
  return test::samples(
      {{"scan", 9000}, {"torus", 90}, {"terrain", 70}, {"nonmanifold", 24}, {"bracket", 6}});
}

TEST(ThreadsTest, SameBytesOnSamples) {
  for (const zoo::Animal& sample : samples())
    for (const double regularity : {0.0, 0.5, 1.0}) {
      const auto faces = static_cast<std::uint32_t>(sample.data.faces.size());
      expect_the_same(sample, quality(faces / 3, 1, regularity), Edges::OnModelEdges);
      expect_the_same(sample, quality(faces / 8, 1, regularity), Edges::All);
    }
}

TEST(ThreadsTest, SameBytesInTheZoo) {
  for (const zoo::Animal& animal : zoo::all())
    for (const Edges edges : {Edges::All, Edges::OnModelEdges})
      expect_the_same(animal, quality(static_cast<std::uint32_t>(animal.data.faces.size() / 2), 1),
                      edges);
}

TEST(ThreadsTest, SameBytesWithGuardsAndKeptVertices) {
  const zoo::Animal scan{"scan", make_sample("scan", 3000)};
  DecimationOptions options = quality(static_cast<std::uint32_t>(scan.data.faces.size() / 4), 1);
  options.max_distance = 0.02, options.no_intersections = true;
  expect_the_same(scan, options, Edges::OnModelEdges);
  const auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(scan.data.positions.size(), 0);
  for (std::uint32_t v = 0; v < keep->size(); v += 9) (*keep)[Vertex(v)] = 1;
  options.keep = keep;
  expect_the_same(scan, options, Edges::All);
}

TEST(ThreadsTest, SameBytesOnAModel) {
  const zoo::Animal part{"bracket", make_sample("bracket", 4)};
  Mesh original = classified(part.data, Edges::All);
  const DiscreteModel model(original);
  DecimationOptions options = quality(static_cast<std::uint32_t>(part.data.faces.size() / 4), 1);
  options.model = &model;
  expect_the_same(part, options, Edges::All);
}

TEST(ThreadsTest, SameBytesWithAJournalAndStepByStep) {
  const MeshData data = make_sample("scan", 6000);
  const auto target = static_cast<std::uint32_t>(data.faces.size() / 3);
  const RunResult whole = run(data, quality(target, 1), Edges::All);
  std::optional<std::size_t> records;
  for (const int threads : {1, 2, 7}) {
    Mesh mesh = classified(data, Edges::All);
    const std::string start = zoo::fingerprint(mesh);
    Journal journal;
    mesh.attach(&journal);
    Decimation decimation(mesh, quality(target, threads));
    while (decimation.step()) {
    }
    EXPECT_EQ((RunResult{zoo::fingerprint(mesh), decimation.sweeps()}), whole) << threads;
    EXPECT_EQ(journal.size(), records.value_or(journal.size())) << threads;
    records = journal.size();
    journal.seek(mesh, 0);
    EXPECT_EQ(zoo::fingerprint(mesh), start) << threads;
    journal.seek(mesh, journal.size());
    EXPECT_EQ(zoo::fingerprint(mesh), whole.mesh) << threads;
  }
}

// A pass from outside makes what was judged ahead out of date, whatever the phase.
TEST(ThreadsTest, SameBytesWithPassesInBetween) {
  const MeshData data = make_sample("scan", 6000);
  const auto target = static_cast<std::uint32_t>(data.faces.size() / 3);
  for (const Phase when : {Phase::Collapse, Phase::Swap, Phase::Smooth}) {
    std::optional<std::string> one;
    for (const int threads : {1, 2, 7}) {
      Mesh mesh = classified(data, Edges::OnModelEdges);
      Decimation decimation(mesh, quality(target, threads));
      while (decimation.phase() != when) decimation.step();
      for (int i = 0; i < 20; ++i) decimation.step();
      ASSERT_EQ(decimation.phase(), when);
      EXPECT_GT(decimation.smooth_pass(), 0u);
      for (int i = 0; i < 20; ++i) decimation.step();
      EXPECT_GT(decimation.swap_pass(), 0u);
      decimation.run();
      EXPECT_EQ(zoo::fingerprint(mesh), one.value_or(zoo::fingerprint(mesh)))
          << phase_name(when) << ", " << threads << " threads";
      one = zoo::fingerprint(mesh);
    }
  }
}

TEST(ThreadsTest, SameBytesFromAnUndoneHalf) {
  const MeshData data = make_sample("scan", 6000);
  std::optional<std::string> one;
  for (const int threads : {1, 2, 7}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Journal journal;
    mesh.attach(&journal);
    Decimation decimation(mesh, quality(mesh.count(2) / 4, threads));
    decimation.run();
    journal.seek(mesh, journal.size() / 2);
    decimation.invalidate();
    decimation.run();
    EXPECT_EQ(zoo::fingerprint(mesh), one.value_or(zoo::fingerprint(mesh))) << threads;
    one = zoo::fingerprint(mesh);
  }
}

// Random diagonals leave vertices with three neighbours, around which a swap waits until another
// one has made room for its diagonal.
MeshData tangled(unsigned seed) {
  Mesh mesh = classified(zoo::torus(12, 9), Edges::OnModelEdges);
  mesh.set(0, 2);
  std::mt19937 random(seed);
  for (int i = 0; i < 600; ++i) {
    const auto t = mesh.triangle(Face(random() % mesh.capacity(2)));
    EdgePair pair;
    if (find_pair(mesh, t[0], t[1], pair).accepted() && !joined(mesh, pair.c, pair.d))
      apply_swap(mesh, pair);
  }
  return to_data(mesh);
}

TEST(ThreadsTest, SameBytesWhereSwapsWaitForEachOther) {
  std::uint32_t swaps = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const MeshData data = tangled(seed);
    std::optional<std::string> one;
    for (const int threads : {1, 2}) {
      Mesh mesh = classified(data, Edges::All);
      DecimationOptions options = quality(1000, threads, 1);
      options.angle_deg = 170;
      Decimation decimation(mesh, options);
      swaps += decimation.swap_pass();
      EXPECT_EQ(zoo::fingerprint(mesh), one.value_or(zoo::fingerprint(mesh))) << seed;
      one = zoo::fingerprint(mesh);
    }
  }
  EXPECT_GT(swaps, 2000u);
}

TEST(ThreadsTest, SameBytesOnTheBunny) {
  const std::filesystem::path file = AOMD_SHARED_DATA "/bunny.ply";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const zoo::Animal bunny{"bunny", io::read(file).mesh};
  expect_the_same(bunny, quality(3069, 1), Edges::OnModelEdges);
}

}  // namespace
}  // namespace aomd::threads_test
