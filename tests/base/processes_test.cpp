// Work shared among processes: who does which piece, and what ends them.

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <set>

#include "core/base/processes.h"

namespace aomd::test::processes_test {
namespace {

std::string own_id(std::size_t /*piece*/) { return std::to_string(::getpid()); }

std::set<std::string> answers(const std::vector<Piece>& pieces) {
  std::set<std::string> all;
  for (const Piece& each : pieces) all.insert(each.answer);
  return all;
}

TEST(Processes, GoFromOnePieceToTheNextUnlessEachIsToHaveItsOwn) {
  Sharing how;
  how.jobs = 2;
  const std::set<std::string> shared = answers(share_among_processes(8, how, own_id));
  EXPECT_LE(shared.size(), 2u);
  EXPECT_EQ(shared.count(own_id(0)), 0u);
  how.fresh = true;
  EXPECT_EQ(answers(share_among_processes(8, how, own_id)).size(), 8u);
}

TEST(Processes, ThatDieCostTheirPieceAlone) {
  for (const bool fresh : {false, true}) {
    Sharing how;
    how.jobs = 2;
    how.fresh = fresh;
    std::vector<std::string> told(5);
    how.tell = [&](std::size_t i, const Piece& piece) { told[i] = piece.answer + piece.death; };
    const auto pieces = share_among_processes(5, how, [](std::size_t i) {
      if (i == 1) ::raise(SIGKILL);
      if (i == 3) ::_exit(7);
      return std::string(i * 100000, 'x');
    });
    for (const std::size_t i : {0, 2, 4})
      EXPECT_TRUE(pieces[i].answer == std::string(i * 100000, 'x') && pieces[i].death.empty()) << i;
    EXPECT_EQ(pieces[1].death, "signal 9");
    EXPECT_EQ(pieces[3].death, "exit code 7");
    for (std::size_t i = 0; i < told.size(); ++i)
      EXPECT_EQ(told[i], pieces[i].answer + pieces[i].death) << i;
  }
}

TEST(Processes, AreLetGoOnceTheyAreToStop) {
  std::array<int, 2> stop{};
  ASSERT_EQ(::pipe(stop.data()), 0);
  Sharing how;
  how.stop = stop[0];
  how.let_go = [] { ::_exit(9); };
  how.tell = [&](std::size_t i, const Piece& /*piece*/) {
    EXPECT_EQ(i, 0u);
    EXPECT_EQ(::write(stop[1], "x", 1), 1);
  };
  const auto pieces = share_among_processes(4, how, [](std::size_t i) {
    while (i == 1) ::pause();
    return std::string("done");
  });
  EXPECT_EQ(pieces[0].answer, "done");
  EXPECT_EQ(pieces[1].death, "stopped");
  for (const std::size_t i : {2, 3}) EXPECT_EQ(pieces[i].death, "not begun");
  for (const int end : stop) ::close(end);
}

}  // namespace
}  // namespace aomd::test::processes_test
