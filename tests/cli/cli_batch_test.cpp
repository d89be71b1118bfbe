// Several files in one call of the program aomd: each as if it were alone, in their order.

#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include "tests/support/child.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_batch_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What depends on the moment is left out of what a file comes to.
Json lasting(Json json) {
  for (const char* passing : {"seconds", "memory_bytes"}) json.erase(passing);
  if (json.contains("options")) json["options"].erase("threads");
  return json;
}

class Batch : public CommandLine {
 protected:
  void SetUp() override {
    fs::create_directory(at("out"));
    sample("scan", "big.ply", 20000);
    sample("sphere", "small.ply", 4);
    fs::rename(at("small.ply"), at("süß und klein.ply"));
    sample("bracket", "b.stl", 8);
    put("junk.ply", "junk");
  }

  [[nodiscard]] std::vector<Json> lines(const std::string& out) const {
    std::vector<Json> found;
    std::istringstream text(out);
    for (std::string line; std::getline(text, line);) found.push_back(Json::parse(line));
    return found;
  }
  /// The names of the files in a folder, sorted.
  [[nodiscard]] std::vector<std::string> names_in(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(at(folder)))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  /// Refused before the work: nothing is written.
  void expect_refused(const std::string& arguments, int code, const std::string& words) const {
    expect_failure(arguments, code, words);
    EXPECT_EQ(names_in("out"), std::vector<std::string>()) << arguments;
  }

  const std::string three_ = "big.ply 'süß und klein.ply' b.stl";
};

TEST_F(Batch, InfoTellsOfEachInOrderWhateverIsDoneFirst) {
  std::string each;
  for (const char* file : {"big.ply", "'süß und klein.ply'", "b.stl"})
    each += aomd(std::string("info ") + file).out;
  for (const char* jobs : {"", " --jobs 1", " --jobs 3", " --jobs 9"}) {
    const Outcome all = aomd("info " + three_ + jobs);
    EXPECT_EQ(all.code, 0);
    EXPECT_EQ(all.out, each) << jobs;
  }
}

TEST_F(Batch, JsonIsOneLineAFile) {
  const std::vector<Json> found = lines(aomd("info --json --jobs 2 " + three_).out);
  ASSERT_EQ(found.size(), 3u);
  const std::string text = aomd("info --json 'süß und klein.ply'").out;
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(found[1]["input"]["file"], "süß und klein.ply");
  EXPECT_EQ(lasting(found[1]), lasting(Json::parse(text)));
  EXPECT_EQ(lines(aomd("check --json --jobs 1 b.stl").out).size(), 1u);
}

TEST_F(Batch, PeakMemoryIsThatOfTheFileAlone) {
  const std::vector<Json> found = lines(aomd("info --json big.ply 'süß und klein.ply'").out);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[1]["memory_bytes"]["peak"], found[0]["memory_bytes"]["peak"]);
}

TEST_F(Batch, AFileThatFailsStopsNoOtherAndDecidesTheExitCode) {
  const Outcome all = aomd("info junk.ply gone.ply b.stl --json --jobs 2");
  EXPECT_EQ(all.code, 3);
  const std::vector<Json> found = lines(all.out);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0]["file"], "junk.ply");
  EXPECT_EQ(found[0]["exit_code"], 3);
  EXPECT_EQ(all.err.substr(0, all.err.find('\n')), "aomd: " + found[0]["error"].get<std::string>());
  EXPECT_NE(all.err.find("\naomd: gone.ply: "), std::string::npos);
  EXPECT_EQ(found[2]["input"]["file"], "b.stl");
  put("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(aomd("check b.stl open.off").code, 0);
  EXPECT_EQ(aomd("check --require closed open.off b.stl").code, 1);
  EXPECT_EQ(aomd("check --require closed open.off junk.ply b.stl").code, 3);
}

TEST_F(Batch, DecimateWritesWhatItWritesForEachAlone) {
  const Outcome all =
      aomd("decimate --to out " + three_ + " junk.ply --target-faces 50% --jobs 3 --json");
  EXPECT_EQ(all.code, 3);
  EXPECT_EQ(names_in("out"), (std::vector<std::string>{"b.stl", "big.ply", "süß und klein.ply"}));
  const std::vector<Json> reports = lines(all.out);
  ASSERT_EQ(reports.size(), 4u);
  const std::vector<std::string> names = {"big.ply", "süß und klein.ply", "b.stl"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string o = "alone" + fs::path(names[i]).extension().string();
    ASSERT_EQ(aomd("decimate '" + names[i] + "' " + o + " --target-faces 50% --report r").code, 0);
    EXPECT_EQ(text("out/" + names[i]), text(o));
    Json report = lasting(json("r")), line = lasting(reports[i]);
    EXPECT_EQ(line["output"]["file"], "out/" + names[i]);
    line["output"]["file"] = o;
    EXPECT_EQ(line, report);
  }
}

TEST_F(Batch, OneMeshPrintsItsReportToo) {
  const Outcome run = aomd("decimate b.stl o.ply --factor 2 --json --report r.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, text("r.json"));
}

TEST_F(Batch, ConvertAndRepairChangeExtensionsByFormat) {
  fs::create_directory(at("sub"));
  sample("sphere", "small.off", 4);
  fs::rename(at("small.off"), at("sub/a\nb.v2.off"));
  const std::vector<std::string> names = {"a\nb.v2.stl", "b.stl", "big.stl", "süß und klein.stl"};
  const Outcome converted =
      aomd("convert --to out " + three_ + " sub/* --format STL --ascii --json");
  EXPECT_EQ(converted.code, 0) << converted.err;
  EXPECT_EQ(names_in("out"), names);
  for (const std::string& name : names) EXPECT_EQ(text("out/" + name).rfind("solid", 0), 0u);
  const std::vector<Json> found = lines(converted.out);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[1]["input"]["faces"], found[1]["output"]["faces"]);
  EXPECT_EQ(found[1]["output"]["file"], "out/süß und klein.stl");
  const Outcome mended = aomd("repair --to out " + three_ + " --jobs 2");
  EXPECT_EQ(mended.code, 0);
  EXPECT_EQ(mended.out,
            "out/big.ply: nothing to mend\nout/süß und klein.ply: nothing to mend\n"
            "out/b.stl: nothing to mend\n");
}

TEST_F(Batch, OutputsAreLookedAtBeforeTheWork) {
  fs::create_directory(at("sub"));
  fs::copy_file(at("b.stl"), at("sub/b.stl"));
  expect_refused("convert --to out b.stl big.ply sub/b.stl", 2,
                 "the result of b.stl and the result of sub/b.stl are one file: out/b.stl");
  expect_refused("repair --to out b.stl big.ply --format ply junk.ply sub/b.stl", 2,
                 "the result of b.stl and the result of sub/b.stl are one file: out/b.ply");
  expect_refused("decimate --to out b.stl -", 2, "- has no name, which --to needs");
  expect_refused("convert --to . out/x.ply b.stl", 2,
                 "b.stl and the result of b.stl are one file: ./b.stl");
  expect_refused("convert --to sub sub/b.stl b.stl --format ply", 2,
                 "the result of sub/b.stl and the result of b.stl are one file");
  expect_refused("convert --to sub b.stl sub/b.stl", 2,
                 "sub/b.stl and the result of b.stl are one file: sub/b.stl");
  put("b.ply", "5\n");
  expect_refused("decimate --to . --format ply b.stl --keep b.ply", 2,
                 "--keep and the result of b.stl are one file: ./b.ply");
  expect_refused("convert --to nowhere b.stl", 4, "nowhere: is not there, or no folder");
  expect_refused("convert --to junk.ply b.stl", 4, "junk.ply: is not there, or no folder");
  expect_refused("convert --to '' b.stl", 2, "--to: ");
  fs::create_directory(at("sub/big.ply"));
  expect_refused("convert --to sub big.ply", 4, "sub/big.ply: cannot be written: it is a folder");
  expect_refused("decimate --to out b.stl --report r", 2, "--report excludes --to");
  expect_refused("decimate b.stl out/o.ply --jobs 2", 2, "--jobs requires --to");
}

TEST_F(Batch, AFileOfNoFormatFailsAlone) {
  const Outcome all = aomd("convert --to out b.stl out 'süß und klein.ply'");
  EXPECT_EQ(all.code, 4);
  EXPECT_EQ(names_in("out"), (std::vector<std::string>{"b.stl", "süß und klein.ply"}));
  EXPECT_NE(all.err.find("aomd: out/out: the extension names no format"), std::string::npos);
}

/// A batch whose second file is a pipe that nobody writes to: its process waits for ever.
class WaitingBatch : public Batch {
 protected:
  void SetUp() override {
    Batch::SetUp();
    ASSERT_EQ(::mkfifo(at("pipe.ply").c_str(), 0600), 0);
    put("out/b.stl", "old");
    put("out/pipe.ply", "old");
  }
  [[nodiscard]] Child start(const std::string& jobs) const {
    return Child({AOMD_PROGRAM, "convert", "--to", at("out"), at("süß und klein.ply"),
                  at("pipe.ply"), at("b.stl"), "--jobs", jobs},
                 {}, at("log"));
  }
  /// The processes that a process has started.
  static std::vector<pid_t> children_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream list("/proc/" + id + "/task/" + id + "/children");
    return {std::istream_iterator<pid_t>(list), {}};
  }
  static bool alive(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    return status >> id >> name >> state && state != "Z";
  }
};

TEST_F(WaitingBatch, EndsByASignalWithTheOldOutputsAndOneLine) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    fs::remove(at("log"));
    fs::remove(at("out/süß und klein.ply"));
    Child batch = start("1");
    ASSERT_TRUE(batch.waits_for([&] { return exists("out/süß und klein.ply"); }));
    ASSERT_TRUE(batch.waits_for([&] { return children_of(batch.id()).size() == 1; }));
    batch.send_signal(signal);
    EXPECT_EQ(batch.wait(), 128 + signal);
    const std::string log = text("log");
    EXPECT_NE(log.find("aomd: cancelled after "), std::string::npos) << log;
    EXPECT_NE(log.find(" of 3 files; all outputs are as they were or complete\n"),
              std::string::npos);
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 1) << log;
    EXPECT_EQ(text("out/b.stl") + text("out/pipe.ply"), "oldold");
    EXPECT_EQ(names_in("out").size(), 3u);
  }
}

TEST_F(WaitingBatch, GoesOnWhereAProcessIsKilled) {
  Child batch = start("2");
  ASSERT_TRUE(batch.waits_for(
      [&] { return text("out/b.stl") != "old" && children_of(batch.id()).size() == 1; }));
  ASSERT_EQ(::kill(children_of(batch.id()).front(), SIGKILL), 0);
  EXPECT_EQ(batch.wait(), 5);
  EXPECT_NE(
      text("log").find("pipe.ply: the process that worked on it ended with signal 9, as where "
                       "memory runs out\n"),
      std::string::npos);
  EXPECT_EQ(text("out/pipe.ply"), "old");
}

TEST_F(WaitingBatch, LeavesNoProcessWhereItIsKilledItself) {
  Child batch = start("2");
  ASSERT_TRUE(batch.waits_for(
      [&] { return text("out/b.stl") != "old" && children_of(batch.id()).size() == 1; }));
  const pid_t left = children_of(batch.id()).front();
  batch.send_signal(SIGKILL);
  EXPECT_EQ(batch.wait(), -SIGKILL);
  Child patience({"sleep", "60"}, {}, "/dev/null");
  EXPECT_TRUE(patience.waits_for([&] { return !alive(left); }));
}

}  // namespace
}  // namespace aomd::test::cli_batch_test
