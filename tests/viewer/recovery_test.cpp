// Unsaved work outlives the program: what is kept, who is offered it, and that it comes back
// exactly.

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "core/io/error.h"
#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "tests/support/io_helpers.h"
#include "tests/support/recovery_helpers.h"
#include "viewer/commands/arguments.h"

namespace aomd::scene::recovery_test {
namespace {

namespace fs = std::filesystem;
using aomd::test::TemporaryFolder;
using test::drive;
using test::labels;
using test::work_and_die;

void expect_same(const Document& a, const Document& b) {
  EXPECT_EQ(io::fingerprint(a.mesh()), io::fingerprint(b.mesh()));
  EXPECT_EQ(a.journal().cursor(), b.journal().cursor());
  EXPECT_EQ(a.journal().size(), b.journal().size());
  EXPECT_EQ(labels(a), labels(b));
}

TEST(Recovery, BringsBackMeshHistoryAndOptions) {
  const TemporaryFolder folder;
  const std::initializer_list<std::string_view> lines = {
      "sample bracket 6", "factor 2.5", "angle 33", "min-dihedral 12",
      "feature-angle 35", "sweep",      "swap",     "step -7",
      "spacing 3 * h"};
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
  EXPECT_EQ(s.document().options().min_dihedral_deg, 12);
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

}  // namespace
}  // namespace aomd::scene::recovery_test
