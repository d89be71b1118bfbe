// What the program aomd writes: looked at before the work, all of it or nothing, to files and
// pipes.

#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_outputs_test {
namespace {

namespace fs = std::filesystem;

class OutputCommand : public CommandLine {
 protected:
  /// Expects wrong usage that names two files as one, and leaves them as they were.
  void expect_one_file(const std::string& arguments, const std::string& names) const {
    const std::string before = text("s.ply");
    expect_failure(arguments, 2, names + " are one file: ");
    EXPECT_EQ(text("s.ply"), before) << arguments;
  }
  /// What a command line of the shell prints, with $A for the program.
  [[nodiscard]] Outcome shell(const std::string& line) const {
    const std::string command = "cd '" + at("").string() + "' && A='" AOMD_PROGRAM "'; { " + line +
                                "\n} >shell.out 2>shell.err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text("shell.out"), text("shell.err")};
  }
};

TEST_F(OutputCommand, AnInputIsNeverOverwrittenHoweverItIsSpelled) {
  sample("sphere", "s.ply", 4);
  put("keep.txt", "3\n");
  put("spacing.txt", "1\n");
  fs::create_directory(at("d"));
  fs::create_symlink("s.ply", at("link.ply"));
  fs::create_symlink("../d", at("d/self"));
  fs::create_hard_link(at("s.ply"), at("hard.ply"));
  for (const std::string& spelled :
       {std::string("s.ply"), std::string("./s.ply"), std::string(".//s.ply"),
        std::string("d/../s.ply"), std::string("d/self/../s.ply"), std::string("link.ply"),
        std::string("hard.ply"), at("s.ply").string()}) {
    expect_one_file("decimate s.ply o.ply --journal " + spelled, "IN and --journal");
    expect_one_file("decimate s.ply o.ply --report " + spelled, "IN and --report");
    expect_one_file("decimate s.ply " + spelled, "IN and OUT");
    expect_one_file("convert s.ply " + spelled, "IN and OUT");
    expect_one_file("classify s.ply " + spelled, "IN and OUT");
    expect_one_file("repair s.ply " + spelled, "IN and OUT");
  }
  expect_one_file("decimate s.ply o.ply --keep keep.txt --report keep.txt", "--keep and --report");
  expect_one_file("decimate s.ply o.ply --spacing spacing.txt --journal spacing.txt",
                  "--spacing and --journal");
  expect_one_file("decimate s.ply o.ply --model s.ply --journal s.ply", "IN and --journal");
  ASSERT_EQ(aomd("decimate s.ply o.ply --journal j").code, 0);
  expect_one_file("replay s.ply j s.ply", "MODEL and OUT");
  expect_one_file("replay s.ply j j --format ply", "JOURNAL and OUT");
  put("a.png", "");
  expect_one_file("image-diff a.png b.png --output a.png", "A and --output");
  EXPECT_NE(shell("$A convert - s.ply <s.ply").err.find("IN and OUT are one file"),
            std::string::npos);
}

TEST_F(OutputCommand, TwoOutputsAreNeverOneFileHoweverTheyAreSpelled) {
  sample("sphere", "s.ply", 4);
  fs::create_symlink("o.ply", at("later.ply"));
  expect_one_file("decimate s.ply o.ply --report o.ply", "OUT and --report");
  expect_one_file("decimate s.ply o.ply --journal ./o.ply", "OUT and --journal");
  expect_one_file("decimate s.ply o.ply --journal j --report .//j", "--journal and --report");
  expect_one_file("decimate s.ply later.ply --report o.ply", "OUT and --report");
  expect_one_file("decimate s.ply o.ply --report later.ply", "OUT and --report");
  EXPECT_FALSE(exists("o.ply"));
  EXPECT_FALSE(exists("j"));
  EXPECT_EQ(aomd("decimate s.ply o.ply --journal /dev/null --report /dev/null").code, 0)
      << "nothing is lost there";
}

TEST_F(OutputCommand, WhatCannotBeWrittenIsSaidBeforeTheInputIsRead) {
  put("bad.ply", "no mesh at all");
  fs::create_directory(at("folder.ply"));
  fs::create_symlink("loop.ply", at("loop.ply"));
  put("file", "");
  for (const char* target :
       {"nowhere/o.ply", "folder.ply", "loop.ply", "file/o.ply", "/proc/o.ply"}) {
    for (const char* command : {"decimate", "convert", "classify", "repair"})
      expect_failure(std::string(command) + " bad.ply " + target, 4, target);
    for (const char* option : {"--journal", "--report"})
      expect_failure(std::string("decimate bad.ply o.ply ") + option + ' ' + target, 4, target);
  }
  EXPECT_TRUE(fs::is_symlink(at("loop.ply")));
}

TEST_F(OutputCommand, AFolderThatMayNotBeWrittenIsCode4) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  sample("sphere", "s.ply", 2);
  fs::create_directory(at("d"));
  fs::permissions(at("d"), fs::perms::owner_read | fs::perms::owner_exec);
  expect_failure("decimate s.ply d/o.ply", 4, "d/o.ply");
}

TEST_F(OutputCommand, AFailingOutputLeavesAllOthersAsTheyWere) {
  sample("sphere", "s.ply", 8);
  for (const char* name : {"o.ply", "j", "r"}) put(name, "old");
  const std::size_t entries = folder_.entries();
  expect_failure("decimate s.ply o.ply --journal j --report /dev/full", 4, "/dev/full");
  expect_failure("decimate s.ply o.ply --journal /dev/full --report r", 4, "/dev/full");
  for (const char* name : {"o.ply", "j", "r"}) EXPECT_EQ(text(name), "old");
  EXPECT_EQ(folder_.entries(), entries);
}

// Blocks of 512 bytes: the mesh fits, the journal does not.
TEST_F(OutputCommand, AFullDiskLeavesAllAsItWas) {
  sample("sphere", "s.ply", 16);
  for (const char* name : {"o.ply", "j"}) put(name, "old");
  const Outcome run = shell("ulimit -f 20; $A decimate s.ply o.ply --target-faces 20 --journal j");
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("aomd: j: cannot be written: File too large\n"), std::string::npos)
      << run.err;
  for (const char* name : {"o.ply", "j"}) EXPECT_EQ(text(name), "old");
  for (const auto& entry : fs::directory_iterator(at("")))
    EXPECT_EQ(entry.path().filename().string().find(".aomd"), std::string::npos) << entry.path();
}

TEST_F(OutputCommand, ALinkStaysAndItsTargetIsReplaced) {
  sample("sphere", "s.ply", 4);
  put("real.ply", "old");
  fs::create_symlink("real.ply", at("link.ply"));
  ASSERT_EQ(aomd("convert s.ply link.ply").code, 0);
  EXPECT_TRUE(fs::is_symlink(at("link.ply")));
  EXPECT_EQ(text("real.ply"), text("s.ply"));
}

TEST_F(OutputCommand, PipesTakeAndGiveMeshes) {
  sample("sphere", "s.ply", 4);
  ASSERT_EQ(aomd("convert s.ply s.off").code, 0);
  EXPECT_EQ(shell("$A convert s.ply - --format off").out, text("s.off"));
  EXPECT_EQ(shell("$A convert s.ply /dev/stdout --format OFF").out, text("s.off"));
  EXPECT_EQ(shell("$A convert s.ply - --format ply | $A convert - - --format off").out,
            text("s.off"));
  EXPECT_EQ(shell("echo before; $A convert s.ply - --format off >>log; cat log").out,
            "before\n" + text("s.off"));
  ASSERT_EQ(aomd("decimate s.ply d.obj --target-faces 100 --journal j").code, 0);
  const Outcome run = shell("$A decimate - - --format obj --target-faces 100 <s.ply");
  EXPECT_EQ(run.out, text("d.obj"));
  EXPECT_NE(run.err.find("320 faces -> 100"), std::string::npos) << "the summary is beside it";
  EXPECT_EQ(shell("$A replay - j - --format obj <s.ply 2>/dev/null").out, text("d.obj"));
  ASSERT_EQ(::mkfifo(at("fifo").c_str(), 0600), 0);
  EXPECT_EQ(shell("cat s.ply >fifo & $A convert fifo - --format off; wait").out, text("s.off"));
  EXPECT_EQ(shell("cat fifo & $A convert s.ply fifo --format off; wait").out, text("s.off"));
  EXPECT_TRUE(fs::is_fifo(at("fifo")));
  expect_failure("convert s.ply -", 2, "--format says in which format");
  expect_failure("convert s.ply o --format step", 2, "--format: must be obj, ply, off");
  expect_failure("convert - o.ply", 3, "standard input: is empty");
}

TEST_F(OutputCommand, AReaderThatGoesAwayIsCode4) {
  sample("sphere", "s.ply", 40);
  const Outcome run = shell(
      "{ $A decimate s.ply - --format off --factor 1 --journal j --quiet; echo $? >code; } "
      "| true; while ! [ -s code ]; do sleep 0.01; done");
  EXPECT_EQ(text("code"), "4\n");
  EXPECT_FALSE(exists("j"));
  EXPECT_NE(run.err.find("aomd: /dev/stdout: cannot be written: Broken pipe\n"), std::string::npos)
      << run.err;
}

TEST_F(OutputCommand, AClosedStandardOutputIsNoFileOfOurs) {
  sample("sphere", "s.ply", 4);
  EXPECT_EQ(shell("$A convert s.ply o.off >&-").code, 0);
  EXPECT_EQ(shell("$A convert s.ply p.off").code, 0);
  EXPECT_EQ(text("o.off"), text("p.off"));
  const Outcome run = shell("$A decimate s.ply d.off >&-");
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, "aomd: standard output: cannot be written\n");
  ASSERT_EQ(aomd("decimate s.ply e.off").code, 0);
  EXPECT_EQ(text("d.off"), text("e.off")) << "it is written whole";
  EXPECT_EQ(shell("$A info s.ply >&- 2>&-").code, 4);
  EXPECT_EQ(shell("$A convert - o.ply <&-").code, 3);
}

TEST_F(OutputCommand, NamesThatAreOddAreShownOnOneLine) {
  sample("sphere", "s.ply", 1);
  expect_failure("info 'new\nline\x1b[31m.ply'", 3, "new\\nline\\x1b[31m.ply: cannot be opened");
  expect_failure("convert s.ply ''", 2, "OUT: must not be empty");
  expect_failure("decimate s.ply o.ply --spacing ''", 2, "--spacing: must not be empty");
}

TEST_F(OutputCommand, WrongWordsAreNamedInTheOrderInWhichTheyStand) {
  expect_failure("classify a.ply b.ply --feature-angle off", 2,
                 "there is no option --feature-angle (aomd classify --help lists what there is)");
  expect_failure("compare a.ply b.ply c.ply", 2, "one argument too many: c.ply (aomd compare --");
  expect_failure("convert a.ply b.ply c.ply", 2,
                 "one argument too many: c.ply; several meshes go with --to DIR (aomd convert --");
  expect_failure("decimate a.ply b.ply --feature-angle", 2, "--feature-angle needs a value");
  expect_failure("sample box o.ply --size 1.5", 2,
                 "--size: must be a whole number between 1 and 2147483647, not 1.5");
  expect_failure("compare a.ply b.ply --max-rms -1", 2,
                 "--max-rms: must be a number of at least 0, not -1");
  expect_failure("decimate a.ply b.ply --threads 1e9", 2, "between 0 and 1024, not 1e9");
}

}  // namespace
}  // namespace aomd::test::cli_outputs_test
