// Unsaved work outlives the program: what is kept, who is offered it, and that it comes back
// exactly.

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "core/io/error.h"
#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "tests/support/child.h"
#include "tests/support/io_helpers.h"
#include "tests/support/message.h"
#include "tests/support/session_helpers.h"
#include "viewer/commands/arguments.h"

namespace aomd::scene {
namespace {

namespace fs = std::filesystem;
using aomd::test::TemporaryFolder;
using test::drive;
using test::labels;

/// A program that did some work and died: its session is gone, its files are there.
void work_and_die(const fs::path& folder, std::initializer_list<std::string_view> lines) {
  Session s;
  s.keep_work(folder);
  drive(s, lines);
  s.recovery->write_now(s.document());
}

void expect_same(const Document& a, const Document& b) {
  EXPECT_EQ(io::fingerprint(a.mesh()), io::fingerprint(b.mesh()));
  EXPECT_EQ(a.journal().cursor(), b.journal().cursor());
  EXPECT_EQ(a.journal().size(), b.journal().size());
  EXPECT_EQ(labels(a), labels(b));
}

TEST(Recovery, BringsBackMeshHistoryAndOptions) {
  const TemporaryFolder folder;
  const std::initializer_list<std::string_view> lines = {
      "sample bracket 6", "factor 2.5",   "angle 33", "feature-angle 35", "sweep", "swap",
      "step -7",          "spacing 3 * h"};
  work_and_die(folder / "", lines);
  Session expected, s;
  drive(expected, lines);
  s.keep_work(folder / "");
  ASSERT_EQ(s.found_work.works.size(), 1u);
  EXPECT_EQ(s.found_work.works[0]->name(), "bracket");
  drive(s, {"recover"});
  expect_same(s.document(), expected.document());
  EXPECT_TRUE(verify(s.document().mesh()).empty());
  EXPECT_TRUE(s.document().unsaved());
  EXPECT_EQ(s.document().options().factor, expected.document().options().factor);
  EXPECT_EQ(s.document().options().angle_deg, 33);
  EXPECT_EQ(s.document().spacing_source(), "3 * h");
  EXPECT_EQ(s.document().classify_options().feature_angle_deg, 35);
  EXPECT_EQ(s.sheet().loaded_facts(), expected.sheet().loaded_facts());
  drive(s, {"redo", "sweep"});
  drive(expected, {"redo", "sweep"});
  expect_same(s.document(), expected.document());
}

TEST(Recovery, FromAFileWhereverTheProgramIsStartedNext) {
  const TemporaryFolder folder;
  Session made;
  drive(made, {"sample sphere 10", "save " + (folder / "ball.obj").string()});
  const fs::path here = fs::current_path();
  fs::current_path(folder / "");
  work_and_die(folder / "kept", {"open ball.obj", "step 20"});
  fs::current_path(here);
  Session s;
  s.keep_work(folder / "kept");
  drive(s, {"recover"});
  EXPECT_EQ(s.document().journal().cursor(), 20u);
  EXPECT_EQ(s.document().content().name, "ball.obj");
}

TEST(Recovery, ACleanEndLeavesNothing) {
  const TemporaryFolder folder;
  Session s;
  s.keep_work(folder / "");
  drive(s, {"sample sphere 12", "step 3"});
  s.recovery->write_now(s.document());
  EXPECT_EQ(folder.entries(), 3u);  // the lock, the work and its journal
  s.recovery->finish();
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Recovery, WhatIsSavedOrTakenBackIsNotKept) {
  const TemporaryFolder folder;
  Session s;
  s.keep_work(folder / "kept");
  const auto kept = [&] {
    s.recovery->write_now(s.document());
    return !fs::exists(folder / "kept")
               ? 0
               : std::distance(fs::directory_iterator(folder / "kept"), {});
  };
  drive(s, {"sample sphere 12"});
  EXPECT_EQ(kept(), 0);
  drive(s, {"step 3"});
  EXPECT_EQ(kept(), 3);
  drive(s, {"save " + (folder / "a.ply").string()});
  EXPECT_EQ(kept(), 1);
  drive(s, {"step 3"});
  EXPECT_EQ(kept(), 3);
  drive(s, {"reset"});
  EXPECT_EQ(kept(), 1);
}

TEST(Recovery, WorkOfALivingProgramIsNotOffered) {
  const TemporaryFolder folder;
  Session alive;
  alive.keep_work(folder / "");
  drive(alive, {"sample sphere 12", "step 3"});
  alive.recovery->write_now(alive.document());
  Session other;
  other.keep_work(folder / "");
  EXPECT_TRUE(other.found_work.works.empty());
  drive(other, {"sample sphere 10", "step 2"});  // under a name of its own
  other.recovery->write_now(other.document());
  EXPECT_EQ(folder.entries(), 6u);
  alive.recovery->finish();
  EXPECT_EQ(folder.entries(), 3u);
}

TEST(Recovery, WhatOneStartIsOfferedNoOtherIsUntilItIsLetGo) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  {
    Session first, second;
    first.keep_work(folder / "");
    second.keep_work(folder / "");
    EXPECT_EQ(first.found_work.works.size(), 1u);
    EXPECT_TRUE(second.found_work.works.empty());
  }
  Session third;
  third.keep_work(folder / "");
  EXPECT_EQ(third.found_work.works.size(), 1u);
}

TEST(Recovery, RestoredWorkIsKeptAgainBeforeTheOldFilesGo) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  work_and_die(folder / "", {"sample sphere 12", "step 3"});  // found by nobody: there are two
  {
    Session s;
    s.keep_work(folder / "");
    ASSERT_EQ(s.found_work.works.size(), 2u);
    drive(s, {"recover", "step"});
    EXPECT_EQ(s.found_work.works.size(), 1u);
    s.recovery->write_now(s.document());
  }
  Session s;
  s.keep_work(folder / "");
  ASSERT_EQ(s.found_work.works.size(), 2u);
  drive(s, {"recover discard all"});
  EXPECT_TRUE(s.found_work.works.empty());
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Recovery, DiscardForgetsOne) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  Session s;
  s.keep_work(folder / "");
  EXPECT_THROW(execute(s, "recover discard 2"), CommandError);
  EXPECT_THROW(execute(s, "recover 0"), CommandError);
  drive(s, {"recover discard"});
  EXPECT_EQ(folder.entries(), 0u);
  EXPECT_THROW(execute(s, "recover"), CommandError);
  Session without;
  EXPECT_THROW(execute(without, "recover"), CommandError);
}

TEST(Recovery, AChangedSourceIsAnErrorThatKeepsMeshAndWork) {
  const TemporaryFolder folder;
  const std::string file = (folder / "ball.ply").string();
  Session made;
  drive(made, {"sample sphere 10", "save " + file});
  work_and_die(folder / "kept", {"open " + file, "step 20"});
  drive(made, {"step", "save " + file});
  Session s;
  s.keep_work(folder / "kept");
  drive(s, {"sample torus 8"});
  EXPECT_THROW(drive(s, {"recover"}), io::ReadError);
  EXPECT_EQ(s.document().content().name, "torus");
  EXPECT_EQ(s.found_work.works.size(), 1u);
}

TEST(Recovery, DamagedFilesAreNotOfferedOrAreErrors) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  fs::path work, journal;
  for (const auto& each : fs::directory_iterator(folder / "")) {
    if (each.path().extension() == ".json") work = each.path();
    if (each.path().extension() == ".journal") journal = each.path();
  }
  const std::string bytes = aomd::test::bytes_of(journal);
  std::ofstream(journal, std::ios::binary) << bytes.substr(0, bytes.size() - 4);
  {
    Session s;
    s.keep_work(folder / "");
    ASSERT_EQ(s.found_work.works.size(), 1u);
    EXPECT_THROW(drive(s, {"recover"}), io::ReadError);
  }
  for (const char* text : {"", "{", "[]", "{\"schema\": 99}", "{\"schema\": 1, \"source\": 3}"}) {
    std::ofstream(work) << text;
    Session s;
    s.keep_work(folder / "");
    EXPECT_TRUE(s.found_work.works.empty()) << text;
    ASSERT_EQ(s.warnings.size(), 1u) << text;
    EXPECT_NE(s.warnings[0].find(work.string()), std::string::npos) << s.warnings[0];
    EXPECT_EQ(std::count(s.warnings[0].begin(), s.warnings[0].end(), '\n'), 0) << s.warnings[0];
    EXPECT_EQ(folder.entries(), 3u) << text;
  }
}

/// The work in a folder, with one value of its JSON changed.
void change(const fs::path& folder, const std::string& from, const std::string& to) {
  for (const auto& each : fs::directory_iterator(folder)) {
    if (each.path().extension() != ".json") continue;
    std::string text = aomd::test::bytes_of(each.path());
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(each.path()) << text.replace(at, from.size(), to);
  }
}

TEST(Recovery, NoValueIsTakenThatNoCommandWouldTake) {
  const std::pair<const char*, const char*> changes[] = {
      {"\"factor\": 4.0", "\"factor\": 0"},
      {"\"factor\": 4.0", "\"factor\": -4.0"},
      {"\"factor\": 4.0", "\"factor\": 1e999"},
      {"\"angle\": 10.0", "\"angle\": 181"},
      {"\"min_angle\": 0.0", "\"min_angle\": -1"},
      {"\"regularity\": 0.5", "\"regularity\": 1.5"},
      {"\"target_faces\": 0", "\"target_faces\": -5"},
      {"\"target_faces\": 0", "\"target_faces\": 0.5"},
      {"\"improve_passes\": 4", "\"improve_passes\": 4000000000"},
      {"\"max_distance\": 0.0", "\"max_distance\": -1"},
      {"\"without\": 0", "\"without\": 64"},
      {"\"corner_angle\": 60.0", "\"corner_angle\": 1e9"},
      {"\"cursor\": 3", "\"cursor\": -1"},
      {"\"cursor\": 3", "\"cursor\": 4"},
      {"\"size\": 12", "\"size\": -12"},
      {"\"schema\": 1", "\"schema\": 2"},
      {"\"schema\": 1", "\"schema\": 0"},
  };
  for (const auto& [from, to] : changes) {
    const TemporaryFolder folder;
    work_and_die(folder / "", {"sample sphere 12", "step 3"});
    change(folder / "", from, to);
    Session s;
    s.keep_work(folder / "");
    EXPECT_TRUE(s.found_work.works.empty()) << to;
    EXPECT_EQ(s.warnings.size(), 1u) << to;
    EXPECT_EQ(folder.entries(), 3u) << to;
    EXPECT_NE(aomd::test::message([&] { execute(s, "recover"); }).find("cannot be read: "),
              std::string::npos);
  }
}

TEST(Recovery, AJournalWithoutANameDeletesNothing) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  const std::string journal = std::to_string(::getpid()) + "-1.journal";
  for (const char* other : {"", ".", "..", "/", "x.journal", "sub/1.journal"}) {
    change(folder / "", "\"journal\": \"" + journal + "\"",
           "\"journal\": \"" + std::string(other) + "\"");
    Session s;
    s.keep_work(folder / "");
    EXPECT_TRUE(s.found_work.works.empty()) << other;
    EXPECT_EQ(folder.entries(), 3u) << other;
    change(folder / "", "\"journal\": \"" + std::string(other) + "\"",
           "\"journal\": \"" + journal + "\"");
  }
  Session s;
  s.keep_work(folder / "");
  EXPECT_EQ(s.found_work.works.size(), 1u);
}

TEST(Recovery, FilesOfOthersStay) {
  const TemporaryFolder folder;
  for (const char* name : {"yarn.lock", "yarn-error.log", "12.lock", "12-notes.txt", "12-a.journal",
                           "12-3.journals", "3.json"})
    std::ofstream(folder / name) << "mine";
  std::ofstream(folder / "12-3.journal") << "stray";
  std::ofstream(folder / "12.json.tmp-12-4") << "stray";
  Session s;
  s.keep_work(folder / "");
  EXPECT_TRUE(s.warnings.empty());
  EXPECT_FALSE(fs::exists(folder / "12-3.journal"));
  EXPECT_FALSE(fs::exists(folder / "12.json.tmp-12-4"));
  EXPECT_EQ(folder.entries(), 6u);  // without 12.lock, whose program had nothing to lose
}

TEST(Recovery, NamesNeedNotBeUtf8) {
  const TemporaryFolder folder;
  const std::string file = (folder / "b\xe9 #1 \"x\".off").string();
  const std::string lengths = (folder / "l\xe4ngen.txt").string();
  Session made;
  drive(made, {"sample sphere 10", "save " + in_quotes(file)});
  std::ofstream out(lengths);
  for (std::int64_t i = 0; i < made.document().mesh().count(0); ++i) out << "0.5\n";
  out.close();
  work_and_die(folder / "kept", {"open " + in_quotes(file), "spacing " + in_quotes(lengths),
                                 "step 8", "bookmark caf\xe9"});
  Session s;
  s.keep_work(folder / "kept");
  ASSERT_EQ(s.found_work.works.size(), 1u);
  drive(s, {"recover"});
  EXPECT_EQ(s.document().content().file, file);
  EXPECT_EQ(s.document().journal().cursor(), 8u);
  EXPECT_EQ(s.document().spacing_source(), lengths);
  EXPECT_NE(s.document().tree().find_bookmark("caf\xe9"), nullptr);
}

TEST(Recovery, AFileOfLengthsIsFoundFromWhereverTheProgramIsStartedNext) {
  const TemporaryFolder folder;
  std::ofstream out(folder / "lengths.txt");
  Session made;
  drive(made, {"sample sphere 10"});
  for (std::int64_t i = 0; i < made.document().mesh().count(0); ++i) out << "0.5\n";
  out.close();
  const fs::path here = fs::current_path();
  fs::current_path(folder / "");
  work_and_die(folder / "kept", {"sample sphere 10", "spacing lengths.txt", "step 2"});
  fs::current_path(here);
  Session s;
  s.keep_work(folder / "kept");
  drive(s, {"recover"});
  EXPECT_EQ(s.document().spacing_source(), (folder / "lengths.txt").string());
}

TEST(Recovery, AJournalElsewhereIsNotRead) {
  const TemporaryFolder folder;
  work_and_die(folder / "", {"sample sphere 12", "step 3"});
  for (const auto& each : fs::directory_iterator(folder / "")) {
    if (each.path().extension() != ".json") continue;
    std::string text = aomd::test::bytes_of(each.path());
    const std::size_t at = text.find("\"journal\": \"") + 12;
    text.insert(at, "../");
    EXPECT_NO_THROW(static_cast<void>(read_saved_work(each.path())));
    std::ofstream(folder / "other.json") << text;
    EXPECT_THROW(static_cast<void>(read_saved_work(folder / "other.json")), io::ReadError);
  }
}

TEST(Recovery, ThatWorkIsNotKeptIsSaidOnce) {
  Session s;
  s.keep_work("/proc/nowhere");
  drive(s, {"sample sphere 12", "step 3", "step", "step"});
  const std::vector<std::string> expected = {
      "Unsaved work is not kept: /proc/nowhere: cannot be written"};
  EXPECT_EQ(s.warnings, expected);
  s.recovery->finish();
  EXPECT_EQ(s.document().journal().cursor(), 5u);
}

TEST(Recovery, AWritingThatFailsIsSaidUntilOneSucceeds) {
  const TemporaryFolder folder;
  const std::string name = std::to_string(::getpid());
  fs::create_directories(folder / "" / (name + "-1.journal/full"));  // nothing is renamed over it
  Session s;
  s.keep_work(folder / "");
  drive(s, {"sample sphere 12", "step 3"});
  s.recovery->write_now(s.document());
  s.keep();
  ASSERT_EQ(s.warnings.size(), 1u);
  EXPECT_EQ(s.warnings[0].rfind("Unsaved work is not kept: " + (folder / "").string(), 0), 0u)
      << s.warnings[0];
  drive(s, {"step"});
  s.recovery->write_now(s.document());
  s.keep();
  EXPECT_EQ(s.warnings.size(), 1u);
  EXPECT_TRUE(fs::exists(folder / "" / (name + "-2.journal")));
}

TEST(Recovery, IsThePlatformsStateFolder) {
  ::setenv("XDG_STATE_HOME", "/somewhere", 1);
  EXPECT_EQ(recovery_folder(), "/somewhere/aomd");
  ::unsetenv("XDG_STATE_HOME");
  ::setenv("HOME", "/home/ada", 1);
  EXPECT_EQ(recovery_folder(), "/home/ada/.local/state/aomd");
}

#ifdef AOMD_VIEW
bool holds_work(const fs::path& kept) {
  std::error_code none;
  for (fs::directory_iterator it(kept, none); !none && it != fs::directory_iterator();
       it.increment(none))
    if (it->path().extension() == ".json") return true;
  return false;
}

TEST(Recovery, AProgramKilledInTheMiddleOfARunLosesNextToNothing) {
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

TEST(Recovery, WhateverTheMomentOfDeathTheWorkOpens) {
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
#endif

}  // namespace
}  // namespace aomd::scene
