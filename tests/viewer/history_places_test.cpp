// Moving through a history: by commands, by phases, and at a chosen speed.

#include <gtest/gtest.h>

#include "tests/support/session_helpers.h"

namespace aomd::scene::history_places_test {
namespace {

using test::drive;

std::size_t cursor(const Session& s) { return s.document().journal().cursor(); }

TEST(HistoryPlaces, CommandsBothWays) {
  Session s;
  drive(s, {"sample sphere 12", "step 3", "step 4", "step 2", "seek 5", "seek next"});
  EXPECT_EQ(cursor(s), 7u);
  drive(s, {"seek next"});
  EXPECT_EQ(cursor(s), 9u);
  drive(s, {"seek next", "seek previous"});
  EXPECT_EQ(cursor(s), 7u);
  drive(s, {"seek previous", "seek previous", "seek previous"});
  EXPECT_EQ(cursor(s), 0u);
}

TEST(HistoryPlaces, PhasesAreOperationsOfOneKindInARow) {
  Session s;
  drive(s, {"sample sphere 12", "factor 3", "run"});
  const Journal& journal = s.document().journal();
  ASSERT_EQ(s.document().marks().size(), 1u);
  std::vector<std::size_t> begins = {0};
  for (std::size_t i = 1; i < journal.size(); ++i)
    if (journal.step(i).kind != journal.step(i - 1).kind) begins.push_back(i);
  ASSERT_GT(begins.size(), 3u);
  begins.push_back(journal.size());
  drive(s, {"seek 0"});
  for (std::size_t i = 1; i < begins.size(); ++i) {
    drive(s, {"seek next-phase"});
    EXPECT_EQ(cursor(s), begins[i]);
  }
  for (std::size_t i = begins.size() - 1; i-- > 0;) {
    drive(s, {"seek previous-phase"});
    EXPECT_EQ(cursor(s), begins[i]);
  }
}

TEST(HistoryPlaces, ForwardGoesThroughWhatIsKnownAndMakesNothingNewBeforeItsEnd) {
  Session s;
  drive(s, {"sample sphere 12", "step 5", "seek 1", "forward"});
  EXPECT_EQ(cursor(s), 2u);
  EXPECT_EQ(s.document().focus(), 1u);
  drive(s, {"forward 100"});
  EXPECT_EQ(cursor(s), 5u);
  EXPECT_EQ(s.document().marks().size(), 1u);
  drive(s, {"forward 2"});
  EXPECT_EQ(cursor(s), 7u);
  EXPECT_EQ(s.document().marks().size(), 2u);
}

TEST(PlaySpeed, IsChosenAndGoesByTheLadder) {
  Session s;
  drive(s, {"sample sphere 12", "step 50", "play-speed 10", "seek 0"});
  execute(s, "play on");
  s.tick(std::chrono::microseconds(1), 1.25);
  EXPECT_EQ(cursor(s), 12u);
  execute(s, "play-speed faster");
  EXPECT_EQ(s.view.play_speed.per_s, 20);
  execute(s, "play-speed slower");
  execute(s, "play-speed slower");
  EXPECT_EQ(s.view.play_speed.per_s, 5);
  execute(s, "play-speed whole 5");
  s.tick(std::chrono::microseconds(1), 1);
  EXPECT_EQ(cursor(s), 22u);
  execute(s, "play-speed 0.5");
  execute(s, "play-speed slower");
  EXPECT_EQ(s.view.play_speed.per_s, 0.5);
  for (const char* line :
       {"play-speed", "play-speed 0", "play-speed quick", "play-speed whole 0", "seek on"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
}

}  // namespace
}  // namespace aomd::scene::history_places_test
