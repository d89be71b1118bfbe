// The paper's strategy in parts: what one thread makes of them, others make too, and it is as good
// as what one part comes to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/decimate/decimation.h"
#include "core/measure/distance.h"
#include "core/measure/statistics.h"
#include "core/mesh/journal.h"
#include "core/model/discrete_model.h"
#include "core/parts/partition.h"
#include "core/samples/samples.h"
#include "tests/support/thread_runs.h"

namespace aomd::paper_parts_test {
namespace {

using test::classified;
using test::Edges;
using test::expect_the_same;
using test::run;
using test::RunResult;
using test::samples_for_parts;

DecimationOptions coarsest(int parts, int threads, std::uint32_t target = 0) {
  return {.coarsest = true, .target_faces = target, .threads = threads, .parts = parts};
}

DecimationOptions by_factor(double factor, int parts, std::uint32_t target = 0) {
  return {.factor = factor, .target_faces = target, .parts = parts};
}

TEST(PaperPartsThreadsTest, SameBytesOnSamples) {
  for (const zoo::Animal& sample : samples_for_parts()) {
    const auto faces = static_cast<std::uint32_t>(sample.data.faces.size());
    expect_the_same(sample, coarsest(2, 1));
    expect_the_same(sample, coarsest(5, 1, faces / 3));
    expect_the_same(sample, by_factor(3, 9));
    expect_the_same(sample, by_factor(4, 4, faces / 10));
    DecimationOptions options = coarsest(7, 1);
    options.min_angle_deg = 20, options.topology = TopologyRule::Paper;
    expect_the_same(sample, options);
  }
}

// Large enough to be cut by themselves.
TEST(LargePaperPartsTest, SameBytesForAnyNumberOfThreads) {
  for (const auto& [name, size] : {std::pair{"scan", 260'000}, {"terrain", 360}}) {
    const zoo::Animal animal{name, make_sample(name, size)};
    ASSERT_GE(animal.data.faces.size(), 250'000u) << name;
    expect_the_same(animal, coarsest(0, 1));
  }
}

TEST(PaperPartsThreadsTest, SameBytesInTheZooAndInMorePartsThanItHasVertices) {
  for (const zoo::Animal& animal : zoo::all())
    for (const int parts : {3, 500}) {
      expect_the_same(animal, coarsest(parts, 1));
      expect_the_same(animal, by_factor(2, parts, 20));
    }
}

// A part that has made a step leaves the rest to threads, and the other way round.
TEST(PaperPartsThreadsTest, SameBytesWhereStepsAndThreadsTakeTurns) {
  const MeshData data = make_sample("scan", 9000);
  for (const std::uint32_t target : {0u, 1500u}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Decimation decimation(mesh, coarsest(4, 3, target));
    for (int i = 0; !decimation.done(); ++i) {
      for (int k = 0; k < 50 + i % 7; ++k) decimation.step();
      (void)decimation.run(std::chrono::microseconds(0));
    }
    EXPECT_EQ((RunResult{zoo::fingerprint(mesh), decimation.sweeps()}),
              run(data, coarsest(4, 1, target)));
  }
}

TEST(PaperPartsThreadsTest, ACancelledRunGoesOnToTheSameMesh) {
  const MeshData data = make_sample("scan", 9000);
  std::optional<std::string> whole;
  std::vector<SweepStatistics> sweeps;
  for (const int every : {1'000'000, 3, 2}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Decimation decimation(mesh, coarsest(4, 3));
    int asked = 0, pauses = 0;
    const auto cancelled = [&] { return ++asked % every == 0; };
    while (decimation.run({}, cancelled) == Decimation::Stop::Cancelled)
      ASSERT_EQ(++pauses % 5 == 0 ? test::finding(mesh) : "", "");
    EXPECT_EQ(pauses > 0, every < 100);
    EXPECT_EQ(test::without_edges(mesh), whole.value_or(test::without_edges(mesh))) << every;
    EXPECT_EQ(decimation.sweeps(), whole ? sweeps : decimation.sweeps());
    whole = test::without_edges(mesh);
    sweeps = decimation.sweeps();
  }
}

// Passes from outside change what the parts were cut by.
TEST(PaperPartsThreadsTest, SameBytesWithPassesInBetween) {
  const MeshData data = make_sample("scan", 9000);
  for (const Phase when : {Phase::Collapse, Phase::Swap, Phase::Smooth}) {
    std::optional<std::string> one;
    for (const int threads : {1, 2, 7}) {
      Mesh mesh = classified(data, Edges::OnModelEdges);
      Decimation decimation(mesh, coarsest(4, threads));
      while (decimation.phase() != when) decimation.step();
      for (int i = 0; i < 20; ++i) decimation.step();
      EXPECT_GT(decimation.smooth_pass(), 0u);
      for (int i = 0; i < 20; ++i) decimation.step();
      (void)decimation.swap_pass();
      decimation.run();
      EXPECT_EQ(zoo::fingerprint(mesh), one.value_or(zoo::fingerprint(mesh)))
          << phase_name(when) << ", " << threads << " threads";
      one = zoo::fingerprint(mesh);
    }
  }
}

// Three edges go with each collapse; two of them may have been refused before.
void expect_a_turn_for_each(std::uint32_t edges, const SweepStatistics& sweep) {
  std::uint32_t refused = 0;
  for (const std::uint32_t n : sweep.refused) refused += n;
  EXPECT_GE(refused + 3 * sweep.collapses, edges);
  EXPECT_LE(refused + sweep.collapses, edges);
}

TEST(PaperPartsTest, EachEdgeHasOneTurnInASweep) {
  const MeshData data = zoo::torus(90, 60);
  for (const bool pass : {false, true}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    const std::uint32_t edges = mesh.count(2) / 2 * 3;
    Decimation decimation(mesh, coarsest(4, 2));
    for (int i = 0; i < 500; ++i) decimation.step();
    if (pass) (void)decimation.smooth_pass();  // the rest of the sweep goes on alone
    while (decimation.phase() == Phase::Collapse) decimation.step();
    expect_a_turn_for_each(edges, decimation.sweeps().front());
  }
}

TEST(PaperPartsTest, SameBytesStepByStepWithAJournalAndAllEdges) {
  const MeshData data = make_sample("scan", 9000);
  DecimationOptions options = coarsest(4, 2);
  Mesh fast = classified(data, Edges::OnModelEdges);
  Decimation whole(fast, options);
  whole.run();
  for (const bool exchange : {false, true})
    for (const Edges edges : {Edges::OnModelEdges, Edges::All}) {
      Mesh mesh = classified(data, edges);
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      options.exchange = exchange;
      Decimation decimation(mesh, options);
      while (decimation.step()) {
      }
      EXPECT_EQ(decimation.sweeps(), whole.sweeps());
      EXPECT_EQ(test::without_edges(mesh), test::without_edges(fast));
      const std::string end = zoo::fingerprint(mesh);
      journal.seek(mesh, 0);
      if (!exchange) {
        EXPECT_EQ(zoo::fingerprint(mesh), start);
      }
      journal.seek(mesh, journal.size());
      EXPECT_EQ(zoo::fingerprint(mesh), end);
    }
}

TEST(PaperPartsTest, GuardsModelsAndKeptVerticesHoldInPartsToo) {
  const zoo::Animal scan{"scan", make_sample("scan", 3000)};
  DecimationOptions options = coarsest(4, 1);
  options.max_distance = 0.02, options.no_intersections = true;
  expect_the_same(scan, options);
  const auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(scan.data.positions.size(), 0);
  for (std::uint32_t v = 0; v < keep->size(); v += 9) (*keep)[Vertex(v)] = 1;
  options = coarsest(4, 2);
  options.keep = keep;
  Mesh mesh = classified(scan.data, Edges::OnModelEdges);
  Decimation(mesh, options).run();
  for (std::uint32_t v = 0; v < keep->size(); v += 9) {
    ASSERT_TRUE(mesh.alive(Vertex(v)));
    ASSERT_EQ(mesh.position(Vertex(v)), scan.data.positions[v]);
  }
  const zoo::Animal part{"bracket", make_sample("bracket", 6)};
  Mesh original = classified(part.data, Edges::All);
  const DiscreteModel model(original);
  options = coarsest(4, 1);
  options.model = &model;
  expect_the_same(part, options);
}

TEST(PaperPartsTest, TheTargetIsMet) {
  for (const zoo::Animal& sample : {zoo::Animal{"scan", make_sample("scan", 9000)},
                                    zoo::Animal{"torus", make_sample("torus", 90)}})
    for (const std::uint32_t target : {5000u, 3001u, 1500u}) {
      Mesh mesh = classified(sample.data, Edges::OnModelEdges);
      Decimation(mesh, by_factor(4, 7, target)).run();
      EXPECT_LE(mesh.count(2), target) << sample.name;
      EXPECT_GE(mesh.count(2), target - 1) << sample.name;
    }
}

// As many as the paper's dragon, whose tables are those of one part.
TEST(LargePaperPartsTest, ThePapersOwnModelsAreOnePart) {
  const MeshData data = make_sample("scan", 202'520);
  ASSERT_GE(data.faces.size(), 202'520u);
  EXPECT_EQ(run(data, coarsest(0, 2)), run(data, coarsest(1, 1)));
}

// Each part gives its share of the faces that go.
TEST(PaperPartsTest, ATargetIsMetAllOverTheSurface) {
  const MeshData data = zoo::torus(180, 120);
  Mesh mesh = classified(data, Edges::OnModelEdges);
  const Partition parts(mesh, 6);
  Decimation(mesh, coarsest(6, 1, mesh.count(2) * 3 / 4)).run();
  std::vector<std::uint32_t> before(6, 0), after(6, 0);
  for (std::uint32_t v = 0; v < data.positions.size(); ++v) {
    const std::size_t part = parts.part_of(Vertex(v));
    ++before[part];
    after[part] += mesh.alive(Vertex(v));
  }
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(double(after[i]) / before[i], 0.75, 0.1) << i;
}

TEST(PaperPartsTest, AsGoodAsOnePart) {
  const MeshData data = make_sample("scan", 40'000);
  const Mesh original = classified(data, Edges::OnModelEdges);
  const measure::Surface reference(original);
  std::array<double, 2> faces{}, rms{}, angle{};
  for (const std::size_t i : {0u, 1u}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Decimation(mesh, by_factor(4, i == 0 ? 1 : 8)).run();
    faces.at(i) = mesh.count(2);
    rms.at(i) = measure::mutual_distance(reference, measure::Surface(mesh), 100'000).rms();
    angle.at(i) = measure::measure_quality(mesh).min_angle_mean_deg;
  }
  EXPECT_NEAR(faces[1], faces[0], 0.02 * faces[0]);
  EXPECT_NEAR(rms[1], rms[0], 0.02 * rms[0]);
  EXPECT_NEAR(angle[1], angle[0], 0.02 * angle[0]);
}

}  // namespace
}  // namespace aomd::paper_parts_test
