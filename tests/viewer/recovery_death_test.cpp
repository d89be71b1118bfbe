// The viewer is killed at any moment, and the next one finds its work.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "tests/support/child.h"
#include "tests/support/io_helpers.h"
#include "tests/support/recovery_helpers.h"

namespace aomd::scene::recovery_death_test {
namespace {

namespace fs = std::filesystem;
using aomd::test::TemporaryFolder;
using test::drive;

bool holds_work(const fs::path& kept) {
  std::error_code none;
  for (fs::directory_iterator it(kept, none); !none && it != fs::directory_iterator();
       it.increment(none))
    if (it->path().extension() == ".json") return true;
  return false;
}

TEST(RecoveryAfterDeath, AProgramKilledInTheMiddleOfARunLosesNextToNothing) {
  const TemporaryFolder folder;
  // What follows the run keeps the program there on a machine that is fast enough to finish it.
  std::ofstream(folder / "script.aomd") << "sample scan\nfactor 6\nrun\nexport turntable "
                                        << (folder / "pictures").string() << " 100000 16x16\n";
  aomd::test::Child program(
      {AOMD_VIEW, "--headless", "--script", folder / "script.aomd", "--recovery", folder / "kept"},
      {}, folder / "said.txt");
  ASSERT_TRUE(program.waits_for([&] { return holds_work(folder / "kept"); }));
  program.send_signal(SIGKILL);
  ASSERT_EQ(program.wait(), -SIGKILL) << "it ended by itself";

  Session s;
  s.keep_work(folder / "kept");
  ASSERT_EQ(s.found_work.works.size(), 1u);
  const std::size_t cursor = s.found_work.works[0]->cursor;
  ASSERT_GT(cursor, 0u);
  drive(s, {"recover"});

  Session expected;
  drive(expected, {"sample scan", "factor 6", "run"});
  ASSERT_GE(expected.document().journal().size(), cursor);
  RecordProperty("operations", static_cast<int>(expected.document().journal().size()));
  RecordProperty("kept", static_cast<int>(cursor));
  drive(expected, {"seek " + std::to_string(cursor)});
  EXPECT_EQ(io::fingerprint(s.document().mesh()), io::fingerprint(expected.document().mesh()));
  EXPECT_TRUE(verify(s.document().mesh()).empty());
}

/// Steps and options without end, so that at any moment something is being written.
std::string endless_script(const fs::path& pictures) {
  std::string text = "sample scan 2000\n";
  for (int i = 0; i < 60; ++i)
    text += "step 7\nbookmark Place " + std::to_string(i) + "\nundo\nredo\nstep -3\nstep 3\n";
  return text + "export turntable " + pictures.string() + " 100000 16x16\n";
}

TEST(RecoveryAfterDeath, WhateverTheMomentOfDeathTheWorkOpens) {
  std::mt19937 random(5);
  int kept = 0;
  for (int i = 0; i < 20; ++i) {
    const TemporaryFolder folder;
    std::ofstream(folder / "script.aomd") << endless_script(folder / "pictures");
    aomd::test::Child program({AOMD_VIEW, "--headless", "--size", "64x64", "--script",
                               folder / "script.aomd", "--recovery", folder / "kept"},
                              {}, folder / "said.txt");
    // Half of them die before or while the first work appears.
    if (i % 2 == 0) {
      ASSERT_TRUE(program.waits_for([&] { return holds_work(folder / "kept"); }));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 400));
    program.send_signal(SIGKILL);
    ASSERT_EQ(program.wait(), -SIGKILL) << "it ended by itself";
    Session s;
    s.keep_work(folder / "kept");
    ASSERT_TRUE(s.warnings.empty()) << s.warnings[0];
    if (s.found_work.works.empty()) continue;
    ++kept;
    const std::size_t cursor = s.found_work.works[0]->cursor;
    const std::size_t steps = s.found_work.works[0]->steps;
    drive(s, {"recover"});
    EXPECT_EQ(s.document().journal().cursor(), cursor);
    EXPECT_EQ(s.document().journal().size(), steps);
    EXPECT_TRUE(verify(s.document().mesh()).empty());
  }
  EXPECT_GE(kept, 10);
}

}  // namespace
}  // namespace aomd::scene::recovery_death_test
