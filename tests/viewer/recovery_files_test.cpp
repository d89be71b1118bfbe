// Files of unsaved work that are damaged, changed by hand, or somebody else's.

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "core/io/error.h"
#include "tests/support/io_helpers.h"
#include "tests/support/message.h"
#include "tests/support/recovery_helpers.h"

namespace aomd::scene::recovery_files_test {
namespace {

namespace fs = std::filesystem;
using aomd::test::TemporaryFolder;
using test::drive;
using test::work_and_die;

TEST(RecoveryFiles, DamagedFilesAreNotOfferedOrAreErrors) {
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

TEST(RecoveryFiles, NoValueIsTakenThatNoCommandWouldTake) {
  const std::pair<const char*, const char*> changes[] = {
      {"\"factor\": 4.0", "\"factor\": 0"},
      {"\"factor\": 4.0", "\"factor\": -4.0"},
      {"\"factor\": 4.0", "\"factor\": 1e999"},
      {"\"angle\": 10.0", "\"angle\": 181"},
      {"\"min_angle\": 0.0", "\"min_angle\": -1"},
      {"\"min_dihedral\": 0.0", "\"min_dihedral\": 71"},
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

TEST(RecoveryFiles, AJournalWithoutANameDeletesNothing) {
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

TEST(RecoveryFiles, FilesOfOthersStay) {
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

TEST(RecoveryFiles, AJournalElsewhereIsNotRead) {
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

}  // namespace
}  // namespace aomd::scene::recovery_files_test
