// States that are kept: what they say, the way back to them, and what is compared with them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/io/journal_file.h"
#include "core/measure/distance.h"
#include "core/measure/statistics.h"
#include "tests/support/session_helpers.h"
#include "viewer/commands/tables.h"

namespace aomd::scene::runs_test {
namespace {

using test::drive;

std::uint64_t hash(const Session& s) { return io::fingerprint(s.document().mesh()).hash; }

/// Two runs from the mesh as loaded with other angles; hashes of both.
std::array<std::uint64_t, 2> two_runs(Session& s) {
  drive(s, {"sample bracket 4", "strategy paper", "angle 5", "run"});
  const std::uint64_t first = hash(s);
  drive(s, {"undo", "angle 30", "run"});
  return {first, hash(s)};
}

TEST(Runs, ThatEndAreKeptWithWhatTheyCameTo) {
  Session s;
  two_runs(s);
  ASSERT_EQ(s.sheet().runs.rows().size(), 2u);
  const KeptRun& now = s.sheet().runs.rows()[1];
  EXPECT_EQ(now.name, "Run 2");
  EXPECT_EQ(now.strategy, "paper");
  EXPECT_EQ(now.aim, "factor 4");
  EXPECT_EQ(now.angle_deg, 30);
  EXPECT_EQ(now.cells, s.document().mesh().count(2));
  EXPECT_EQ(now.mean_angle_deg, measure::measure_quality(s.document().mesh()).min_angle_mean_deg);
  EXPECT_TRUE(now.seconds.has_value());
  EXPECT_EQ(s.sheet().runs.rows()[0].angle_deg, 5);
  EXPECT_GT(s.sheet().runs.rows()[0].cells, now.cells);
}

TEST(Runs, SayWhereTheyBegan) {
  Session s;
  two_runs(s);
  EXPECT_EQ(s.sheet().runs.find(1)->from, "");
  EXPECT_EQ(s.sheet().runs.find(2)->from, "");
  drive(s, {"angle 60", "run"});
  EXPECT_EQ(s.sheet().runs.find(3)->from, "Run 2");
  drive(s, {"seek 7", "angle 50", "run", "runs go 3"});
  EXPECT_EQ(s.sheet().runs.find(4)->from, "operation 7");
}

TEST(Runs, LeadBackToTheSameBits) {
  Session s;
  const auto hashes = two_runs(s);
  EXPECT_EQ(s.sheet().runs.shown(s.document())->number, 2u);
  drive(s, {"runs go 1"});
  EXPECT_EQ(hash(s), hashes[0]);
  EXPECT_EQ(s.sheet().runs.shown(s.document())->number, 1u);
  drive(s, {"runs go 2"});
  EXPECT_EQ(hash(s), hashes[1]);
  drive(s, {"step -1"});
  EXPECT_EQ(s.sheet().runs.shown(s.document()), nullptr);
}

TEST(Runs, OfABranchThatIsGoneStayAsNumbers) {
  Session s;
  two_runs(s);
  drive(s, {"branch remove 1"});
  EXPECT_NE(s.sheet().runs.find(1), nullptr);
  EXPECT_THROW(execute(s, "runs go 1"), CommandError);
}

TEST(Runs, OneStateIsOneRow) {
  Session s;
  two_runs(s);
  drive(s, {"runs keep coarse", "runs keep"});
  ASSERT_EQ(s.sheet().runs.rows().size(), 2u);
  EXPECT_EQ(s.sheet().runs.rows()[1].name, "coarse");
  drive(s, {"seek 5", "runs keep"});
  EXPECT_EQ(s.sheet().runs.rows()[2].name, "Run 3");
  EXPECT_FALSE(s.sheet().runs.rows()[2].seconds.has_value());
}

TEST(Runs, AreForgottenWithTheMeshAndTheOldestBeyondABound) {
  Session s;
  drive(s, {"sample bracket 4", "strategy paper", "step 40"});
  for (std::size_t i = 0; i <= KeptRuns::most; ++i)
    drive(s, {"seek " + std::to_string(i + 1), "runs keep"});
  EXPECT_EQ(s.sheet().runs.size(), KeptRuns::most);
  EXPECT_EQ(s.sheet().runs.find(1), nullptr);
  drive(s, {"compare with 3", "sample sphere 8"});
  EXPECT_EQ(s.sheet().runs.size(), 0u);
  EXPECT_EQ(s.sheet().runs.reference(), nullptr);
}

TEST(Runs, ACancelledRunIsNoRow) {
  Session s;
  drive(s, {"sample sphere 24", "strategy quality"});
  execute(s, "run");
  s.tick(std::chrono::microseconds(1), 0.01);
  drive(s, {"cancel"});
  EXPECT_GT(s.document().journal().size(), 0u);
  EXPECT_EQ(s.sheet().runs.size(), 0u);
}

TEST(Runs, AreMeasuredAsTheirMeshesWouldBe) {
  Session s;
  two_runs(s);
  drive(s, {"runs measure"});
  const Mesh original(to_data(s.document().copy_mesh_as_loaded().mesh())),
      result(*s.sheet().runs.find(2)->data);
  const auto expected =
      measure::mutual_distance(measure::Surface(original), measure::Surface(result), run_samples);
  const double percent = 100 / s.document().content().bounds.diagonal();
  ASSERT_TRUE(s.sheet().runs.find(2)->distance.has_value());
  EXPECT_DOUBLE_EQ(s.sheet().runs.find(2)->distance->max_pct, percent * expected.max());
  EXPECT_DOUBLE_EQ(s.sheet().runs.find(2)->distance->rms_pct, percent * expected.rms());
  EXPECT_LT(s.sheet().runs.find(1)->distance->max_pct, s.sheet().runs.find(2)->distance->max_pct);
}

TEST(Runs, StandInThePlaceOfTheMeshAsLoaded) {
  Session s;
  two_runs(s);
  drive(s, {"panel histograms on", "compare with 1", "compare side"});
  EXPECT_EQ(s.sheet().reference_name(), "Run 1");
  ASSERT_NE(s.sheet().reference_drawing(), nullptr);
  const auto count = [&] {
    return s.sheet().reference_drawing()->drawable().corners.values().size() / 3;
  };
  EXPECT_EQ(count(), static_cast<std::size_t>(s.sheet().runs.find(1)->cells));
  const measure::Histogram kept = s.sheet().histograms()->of(HistogramKind::Angle).before;
  const measure::Histogram lengths = s.sheet().histograms()->of(HistogramKind::Length).before;
  drive(s, {"compare with original"});
  EXPECT_EQ(count(), static_cast<std::size_t>(s.sheet().loaded_facts().faces));
  EXPECT_NE(s.sheet().histograms()->of(HistogramKind::Angle).before.counts, kept.counts);
  drive(s, {"runs go 1"});
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Angle).now.counts, kept.counts);
  // Summed up in the order of the copy's edges there, of the document's here.
  EXPECT_NEAR(s.sheet().histograms()->of(HistogramKind::Length).now.mean, lengths.mean, 1e-12);
  drive(s, {"compare with 2", "runs remove 2"});
  EXPECT_EQ(s.sheet().runs.reference(), nullptr);
  EXPECT_EQ(count(), static_cast<std::size_t>(s.sheet().loaded_facts().faces));
}

/// Whatever numbers colour the present mesh, the one beside it has them too.
TEST(Runs, HaveTheColoursOfThePresentMesh) {
  Session s;
  two_runs(s);
  drive(s, {"runs go 1", "compare with 1", "compare side"});
  for (const std::string_view coloring :
       {"color quality", "color distance", "color spacing", "color curvature"}) {
    drive(s, {coloring});
    const auto now = s.sheet().drawing().drawable().corners.values();
    const auto beside = s.sheet().reference_drawing()->drawable().corners.values();
    std::size_t n = 0;
    for (const Face f : s.document().mesh().faces())
      for (std::size_t k = 0; k < 3; ++k, ++n)
        ASSERT_EQ(now[3 * f.index + k].color, beside[n].color) << coloring << " " << f.index;
    EXPECT_EQ(n, beside.size());
  }
}

TEST(Runs, AsATable) {
  Session s;
  two_runs(s);
  const std::string text = table_text(s, "runs");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("Run 1\tthe mesh as loaded\tpaper\tfactor 4\t5."), std::string::npos) << text;
}

}  // namespace
}  // namespace aomd::scene::runs_test
