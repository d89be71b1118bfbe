// Why a run stopped, and that what sweeps counted belongs to the place where they counted it.

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "core/decimate/explain/stop_words.h"
#include "tests/support/session_helpers.h"
#include "viewer/explain/edge_verdicts.h"

namespace aomd::scene::stop_test {
namespace {

using test::drive;

TEST(StopWords, NameTheNumbersAndWhatDecided) {
  EdgesByReason edges{};
  edges[static_cast<std::size_t>(Reason::Spacing)] = 7030;
  edges[static_cast<std::size_t>(Reason::Angle)] = 1950;
  edges[static_cast<std::size_t>(Reason::Kept)] = 1;
  EXPECT_EQ(stop_words(edges, {}, 6000),
            "Stopped, mostly by length: of 8,981 edges left, 7,030 are long enough for the "
            "spacing, 1,950 "
            "would turn a face by "
            "more than 10 degrees and 1 is to stay.");
  edges[static_cast<std::size_t>(Reason::Angle)] = 9000;
  DecimationOptions options;
  options.target_faces = 2000;
  options.angle_deg = 12.5;
  EXPECT_EQ(
      stop_words(edges, options, 6000),
      "Stopped above the aim of 2,000 faces, mostly by the angle: of 16,031 edges left, 9,000 "
      "would turn "
      "a face by more than 12.5 degrees, 7,030 are long enough for the spacing and 1 is to stay.");
  EXPECT_EQ(stop_words(edges, options, 2000), "Stopped at the aim of 2,000 faces.");
  EXPECT_EQ(stop_words({}, {}, 1), "Stopped: no edge is left.");
}

TEST(StopWords, NobodyDecidesWhereNoneHasMostOfThem) {
  EdgesByReason edges{};
  for (const Reason r : {Reason::Spacing, Reason::Angle, Reason::Topology})
    edges[static_cast<std::size_t>(r)] = 10;
  EXPECT_EQ(stop_words(edges, {}, 6000).substr(0, 30), "Stopped: of 30 edges left, 10 ");
}

/// What the colours of verdicts count is what the sentence is made of.
TEST(StopWords, OfARunCountTheEdgesThatAreLeft) {
  for (const std::string_view strategy : {"strategy paper", "strategy quality"}) {
    Session s;
    drive(s, {"sample torus 20", strategy, "run", "color verdict"});
    const EdgesByReason left = s.document().build_decimation_to_judge()->edges_left();
    EXPECT_EQ(std::accumulate(left.begin(), left.end(), std::int64_t{0}),
              s.document().mesh().count(1));
    for (std::size_t r = 0; r < left.size(); ++r)
      EXPECT_EQ(left[r], s.sheet().verdicts()->counts()[r]) << strategy;
    EXPECT_EQ(s.document().stop(),
              stop_words(left, s.document().options(), s.document().mesh().count(2)));
  }
}

TEST(Stop, BelongsToTheEndOfItsRun) {
  Session s;
  drive(s, {"sample bracket 4", "strategy paper", "sweep"});
  EXPECT_EQ(s.document().stop(), "");
  drive(s, {"run"});
  const std::string first(s.document().stop());
  ASSERT_EQ(first.substr(0, 7), "Stopped");
  drive(s, {"step -1"});
  EXPECT_EQ(s.document().stop(), "");
  drive(s, {"seek end"});
  EXPECT_EQ(s.document().stop(), first);
  drive(s, {"seek 20", "angle 30", "run"});
  const std::string second(s.document().stop());
  EXPECT_NE(second, first);
  drive(s, {"branch switch 1"});
  EXPECT_EQ(s.document().stop(), first);
  drive(s, {"runs go 2"});
  EXPECT_EQ(s.document().stop(), second);
}

/// The command of the first run is cut in its middle: neither its end nor its last sweeps are on
/// this branch.
TEST(Stop, OfARunThatWasCutIsNotShownWhereAnotherEndsAfterAsManyOperations) {
  Session s;
  drive(s, {"sample bracket 4", "strategy paper", "run"});
  const std::size_t end = s.document().journal().cursor();
  drive(s, {"seek 20", "angle 40", "step " + std::to_string(end - 20)});
  ASSERT_EQ(s.document().journal().cursor(), end);
  EXPECT_EQ(s.document().stop(), "");
}

class LastSweep : public testing::TestWithParam<const char*> {};

TEST_P(LastSweep, IsTheOneBeforeThePresentPlace) {
  Session s;
  drive(s, {"sample torus 20", GetParam()});
  std::vector<std::pair<std::size_t, SweepStatistics>>
      seen;  // the operations of each sweep, one by one
  drive(s, {"run"});
  std::size_t operations = 0;
  for (const SweepStatistics& each : s.document().decimation()->sweeps())
    operations += std::size_t{each.collapses} + each.swaps + each.smooths;
  ASSERT_EQ(operations, s.document().journal().size()) << "each is a step";
  std::size_t end = 0;
  for (const SweepStatistics& each : s.document().decimation()->sweeps()) {
    end += std::size_t{each.collapses} + each.swaps + each.smooths;
    if (each.collapses > 0) seen.emplace_back(end, each);
  }
  ASSERT_FALSE(seen.empty());
  for (const auto& [place, statistics] : seen) {
    if (place == end) continue;
    drive(s, {"seek " + std::to_string(place)});
    ASSERT_NE(s.document().last_sweep(), nullptr);
    EXPECT_EQ(s.document().last_sweep()->collapses, statistics.collapses) << place;
    drive(s, {"seek " + std::to_string(place - 1)});
    const SweepStatistics* before = s.document().last_sweep();
    EXPECT_TRUE(before == nullptr || *before != statistics) << place;
  }
  drive(s, {"seek 0"});
  EXPECT_EQ(s.document().last_sweep(), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Strategies, LastSweep,
                         testing::Values("strategy paper", "strategy quality"),
                         [](const auto& which) { return std::string(which.param + 9); });

TEST(LastSweep, ThatChangedNothingCountsToo) {
  Session s;
  drive(s, {"sample bracket 4", "strategy paper", "run"});
  const auto refused = [&] { return s.document().last_sweep()->refused; };
  const auto before = refused();
  drive(s, {"factor 1", "sweep"});
  EXPECT_NE(refused(), before);
  drive(s, {"step -1", "seek end"});
  EXPECT_EQ(s.document().last_sweep()->refused.size(), before.size());
}

}  // namespace
}  // namespace aomd::scene::stop_test
