// The quality strategy in parts: what one thread makes of them, others make too, and it is as good
// as what one part comes to.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "core/decimate/decimation.h"
#include "core/measure/distance.h"
#include "core/measure/statistics.h"
#include "core/mesh/journal.h"
#include "core/model/discrete_model.h"
#include "core/parts/pass_turns.h"
#include "core/samples/samples.h"
#include "tests/support/thread_runs.h"

namespace aomd::parts_test {
namespace {

using test::classified;
using test::Edges;
using test::expect_the_same;
using test::in_parts;
using test::run;
using test::RunResult;
using test::samples_for_parts;

TEST(PartsThreadsTest, SameBytesOnSamples) {
  for (const zoo::Animal& sample : samples_for_parts()) {
    const auto faces = static_cast<std::uint32_t>(sample.data.faces.size());
    expect_the_same(sample, in_parts(faces / 3, 2, 1, 0));
    expect_the_same(sample, in_parts(faces / 20, 5, 1));
    expect_the_same(sample, in_parts(0, 9, 1));
  }
}

// Large enough to be cut by themselves.
TEST(LargePartsTest, SameBytesForAnyNumberOfThreads) {
  struct Large {
    const char* name;
    int size;
    std::uint32_t target;
  };
  for (const Large& large : {Large{"scan", 210'000, 150'000}, Large{"torus", 600, 50'000},
                             Large{"terrain", 320, 6'000}}) {
    const zoo::Animal animal{large.name, make_sample(large.name, large.size)};
    ASSERT_GE(animal.data.faces.size(), 200'000u) << large.name;
    expect_the_same(animal, in_parts(large.target, 0, 1));
  }
}

TEST(PartsThreadsTest, SameBytesInTheZooAndInMorePartsThanItHasVertices) {
  for (const zoo::Animal& animal : zoo::all())
    for (const int parts : {3, 500})
      expect_the_same(animal,
                      in_parts(static_cast<std::uint32_t>(animal.data.faces.size() / 2), parts, 1));
}

// A part that has made a step leaves the rest to threads, and the other way round.
TEST(PartsThreadsTest, SameBytesWhereStepsAndThreadsTakeTurns) {
  const MeshData data = make_sample("scan", 9000);
  const DecimationOptions options = in_parts(1500, 4, 3);
  Mesh mesh = classified(data, Edges::OnModelEdges);
  Decimation decimation(mesh, options);
  for (int i = 0; !decimation.done(); ++i) {
    for (int k = 0; k < 50 + i % 7; ++k) decimation.step();
    (void)decimation.run(std::chrono::microseconds(0));
  }
  EXPECT_EQ((RunResult{zoo::fingerprint(mesh), decimation.sweeps()}),
            run(data, in_parts(1500, 4, 1)));
}

// Only the stack of ids tells in which order parts ended what they did.
TEST(PartsThreadsTest, ACancelledRunGoesOnToTheSameMesh) {
  const MeshData data = make_sample("scan", 9000);
  std::optional<std::string> whole;
  for (const int every : {1'000'000, 3, 2}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Decimation decimation(mesh, in_parts(1500, 4, 3));
    int asked = 0, pauses = 0;
    const auto cancelled = [&] { return ++asked % every == 0; };
    while (decimation.run({}, cancelled) == Decimation::Stop::Cancelled)
      ASSERT_EQ(++pauses % 5 == 0 ? test::finding(mesh) : "", "");
    EXPECT_EQ(pauses > 0, every < 100);
    EXPECT_EQ(test::without_edges(mesh), whole.value_or(test::without_edges(mesh))) << every;
    whole = test::without_edges(mesh);
  }
}

// Passes from outside change what the parts were cut by.
TEST(PartsThreadsTest, SameBytesWithPassesInBetween) {
  const MeshData data = make_sample("scan", 9000);
  for (const Phase when : {Phase::Collapse, Phase::Swap, Phase::Smooth}) {
    std::optional<std::string> one;
    for (const int threads : {1, 2, 7}) {
      Mesh mesh = classified(data, Edges::OnModelEdges);
      Decimation decimation(mesh, in_parts(2000, 4, threads));
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

TEST(PartsTest, SameBytesStepByStepWithAJournalAndAllEdges) {
  const MeshData data = make_sample("scan", 9000);
  const DecimationOptions options = in_parts(1500, 4, 2);
  Mesh fast = classified(data, Edges::OnModelEdges);
  Decimation(fast, options).run();
  for (const Edges edges : {Edges::OnModelEdges, Edges::All}) {
    Mesh mesh = classified(data, edges);
    const std::string start = zoo::fingerprint(mesh);
    Journal journal;
    mesh.attach(&journal);
    Decimation decimation(mesh, options);
    while (decimation.step()) {
    }
    EXPECT_EQ(test::without_edges(mesh), test::without_edges(fast));
    const std::string end = zoo::fingerprint(mesh);
    journal.seek(mesh, 0);
    EXPECT_EQ(zoo::fingerprint(mesh), start);
    journal.seek(mesh, journal.size());
    EXPECT_EQ(zoo::fingerprint(mesh), end);
  }
}

TEST(PartsTest, GuardsModelsAndKeptVerticesHoldInPartsToo) {
  const zoo::Animal scan{"scan", make_sample("scan", 3000)};
  DecimationOptions options = in_parts(800, 4, 1);
  options.max_distance = 0.02, options.no_intersections = true;
  expect_the_same(scan, options);
  const auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(scan.data.positions.size(), 0);
  for (std::uint32_t v = 0; v < keep->size(); v += 9) (*keep)[Vertex(v)] = 1;
  options = in_parts(800, 4, 2);
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
  options = in_parts(static_cast<std::uint32_t>(part.data.faces.size() / 4), 4, 1);
  options.model = &model;
  expect_the_same(part, options);
}

TEST(PartsTest, TheTargetIsMet) {
  for (const zoo::Animal& sample : {zoo::Animal{"scan", make_sample("scan", 9000)},
                                    zoo::Animal{"torus", make_sample("torus", 90)}})
    for (const std::uint32_t target : {5000u, 1001u, 300u}) {
      Mesh mesh = classified(sample.data, Edges::OnModelEdges);
      Decimation(mesh, in_parts(target, 7, 2)).run();
      EXPECT_LE(mesh.count(2), target) << sample.name;
      EXPECT_GE(mesh.count(2), target - 1) << sample.name;
    }
}

/// How often the next of the first collapses is in the other one of two parts.
int turns_taken(const MeshData& data, std::uint32_t target) {
  constexpr int collapses = 1000;
  Mesh mesh = classified(data, Edges::OnModelEdges);
  const Partition parts(mesh, 2);
  Decimation decimation(mesh, in_parts(target, 2, 1));
  int turns = 0;
  for (std::size_t i = 0, last = 0; i < collapses; ++i) {
    const std::size_t part = parts.part_of(Vertex(decimation.step()->entity.index));
    turns += part != last;
    last = part;
  }
  return turns;
}

// Many buckets of costs at once, and only one near the target.
TEST(PartsTest, EachWorksForLongFarAboveTheTarget) {
  const MeshData data = make_sample("scan", 9000);
  EXPECT_LT(turns_taken(data, 1000), 10);
  EXPECT_GT(turns_taken(data, 5000), 50);
}

TEST(PartsTest, AsGoodAsOnePart) {
  const MeshData data = make_sample("scan", 40'000);
  const Mesh original = classified(data, Edges::OnModelEdges);
  const measure::Surface reference(original);
  std::array<double, 2> rms{}, angle{};
  for (const std::size_t i : {0u, 1u}) {
    Mesh mesh = classified(data, Edges::OnModelEdges);
    Decimation(mesh, in_parts(4000, i == 0 ? 1 : 8, 2)).run();
    rms.at(i) = measure::mutual_distance(reference, measure::Surface(mesh), 100'000).rms();
    angle.at(i) = measure::measure_quality(mesh).min_angle_mean_deg;
  }
  EXPECT_NEAR(rms[1], rms[0], 0.01 * rms[0]);
  EXPECT_NEAR(angle[1], angle[0], 0.01 * angle[0]);
}

TEST(PassTurnsTest, EachFaceHasATurnAndWhatIsLeftAnotherOne) {
  const Mesh mesh = classified(zoo::torus(90, 60), Edges::OnModelEdges);
  std::vector<int> seen(mesh.capacity(2), 0);
  PassTurns turns;
  turns.begin(mesh, 2, 4, 1);
  int in_parts = 0;
  for (std::uint32_t id; (id = turns.next(mesh, 1)) != no_index;) {
    ++seen[id];
    in_parts += turns.in_part();
    if (id % 5 == 0 && turns.in_part()) turns.leave(turns.part(), id);
  }
  EXPECT_GT(in_parts, int(mesh.count(2)));
  for (std::uint32_t id = 0; id < seen.size(); ++id)
    EXPECT_TRUE(id % 5 == 0 ? seen[id] >= 1 : seen[id] == 1) << id;
  EXPECT_GT(std::count_if(seen.begin(), seen.end(), [](int n) { return n > 1; }), 2000);
}

}  // namespace
}  // namespace aomd::parts_test
