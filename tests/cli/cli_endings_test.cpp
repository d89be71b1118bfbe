// How the program aomd ends where others end it: at a hundred moments of each signal the outputs
// are the old ones or the new ones, whole, and nothing else is left.

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/support/child.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_endings_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

#ifdef __SANITIZE_ADDRESS__  // these look for what each moment does to memory, not for all moments
constexpr int moments = 20;
#else
constexpr int moments = 100;
#endif
constexpr std::array names = {"o.ply", "o.journal", "o.json"};

class Endings : public CommandLine {
 protected:
  void SetUp() override {
    sample("scan", "s.ply", 4000);
    words_ = {AOMD_PROGRAM,    "decimate", at("s.ply"),  at("o.ply"),      "--journal",
              at("o.journal"), "--report", at("o.json"), "--target-faces", "1500"};
    const auto start = Clock::now();
    ASSERT_EQ(Child(words_, {}, "/dev/null").wait(), 0);
    step_ = (Clock::now() - start) / (moments - moments / 5);
    new_mesh_ = text("o.ply");
    new_journal_ = text("o.journal");
  }

  void put_old() const {
    for (const char* name : names) put(name, "old");
  }

  /// Runs the program, sends it the signal after a share of the time that it takes, and returns the
  /// code that a shell would show.
  int ended_by(int signal, int moment) const {
    const fs::path log = at("log");
    fs::remove(log);
    Child program(words_, {}, log);
    if (signal == SIGABRT)  // before it has begun the system ends it
      (void)program.waits_for([&] { return catches(program.id(), signal); });
    std::this_thread::sleep_for(moment * step_);
    program.send_signal(signal);
    const int code = program.wait();
    return code < 0 ? 128 - code : code;
  }

  /// Whether a process has a handler for a signal.
  static bool catches(pid_t process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigCgt:", 0) == 0)
        return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1) != 0;
    return false;
  }

  [[nodiscard]] bool all_old() const {
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return text(name) == "old"; });
  }
  [[nodiscard]] bool all_new() const {
    return text("o.ply") == new_mesh_ && text("o.journal") == new_journal_ &&
           json("o.json")["schema"] == 1;
  }
  [[nodiscard]] std::size_t temporaries() const {
    const fs::directory_iterator all(at(""));
    return static_cast<std::size_t>(std::count_if(begin(all), end(all), [](const auto& entry) {
      return entry.path().filename().string().rfind(".aomd-", 0) == 0;
    }));
  }

  /// Both ends of the run are met by the moments, or the machine is too busy to tell.
  void expect_whole_after(int signal) {
    for (int moment = 0; moment < moments; ++moment) {
      put_old();
      const int code = ended_by(signal, moment);
      SCOPED_TRACE("moment " + std::to_string(moment) + ": " + text("log"));
      EXPECT_EQ(temporaries(), 0u);
      if (code == 0) {
        EXPECT_TRUE(all_new());
        continue;
      }
      EXPECT_EQ(code, 128 + signal);
      if (text("log").find("the output had been written") != std::string::npos) {
        EXPECT_TRUE(all_new());
      } else {
        EXPECT_TRUE(all_old());
      }
    }
  }

  std::vector<std::string> words_;
  Clock::duration step_{};
  std::string new_mesh_, new_journal_;
};

TEST_F(Endings, ByCtrlCLeaveAllOldOrAllNew) { expect_whole_after(SIGINT); }
TEST_F(Endings, BySigtermLeaveAllOldOrAllNew) { expect_whole_after(SIGTERM); }
TEST_F(Endings, BySighupLeaveAllOldOrAllNew) { expect_whole_after(SIGHUP); }

TEST_F(Endings, ByCtrlCOfABatchLeaveEachFileOldOrNew) {
  sample("scan", "t.ply", 2000);
  std::filesystem::create_directory(at("d"));
  const std::array outputs = {"d/s.ply", "d/t.ply"};
  words_ = {AOMD_PROGRAM, "decimate",       "--to", at("d"),  at("s.ply"),
            at("t.ply"),  "--target-faces", "1500", "--jobs", "2"};
  ASSERT_EQ(Child(words_, {}, "/dev/null").wait(), 0);
  const std::array whole = {text(outputs[0]), text(outputs[1])};
  for (int moment = 0; moment < moments; moment += 2) {
    for (const char* each : outputs) put(each, "old");
    const int code = ended_by(SIGINT, moment);
    SCOPED_TRACE("moment " + std::to_string(moment) + ": " + text("log"));
    EXPECT_TRUE(code == 0 || code == 130) << code;
    for (std::size_t i = 0; i < whole.size(); ++i)
      EXPECT_TRUE(text(outputs[i]) == whole[i] || (code != 0 && text(outputs[i]) == "old"));
    EXPECT_EQ(std::distance(fs::directory_iterator(at("d")), {}), 2);
  }
}

TEST_F(Endings, ByKillLeaveWholeFilesAndWhatTheNextRunRemoves) {
  put_old();
  for (int moment = 0; moment < moments; ++moment) {
    const int code = ended_by(SIGKILL, moment);
    EXPECT_TRUE(code == 0 || code == 128 + SIGKILL) << code;
    EXPECT_TRUE(text("o.ply") == "old" || text("o.ply") == new_mesh_) << moment;
    EXPECT_TRUE(text("o.journal") == "old" || text("o.journal") == new_journal_) << moment;
  }
  std::ofstream(at(".aomd-1-0.tmp")) << "left by one that was killed";
  ASSERT_EQ(Child(words_, {}, "/dev/null").wait(), 0);
  EXPECT_TRUE(all_new());
  EXPECT_EQ(temporaries(), 0u);
}

TEST_F(Endings, ByCtrlCComeInEveryCommand) {
  sample("scan", "big.ply", 300000);
  const std::string big = at("big.ply").string(), out = at("x.ply").string();
  const std::vector<std::vector<std::string>> commands = {
      {"info", big},
      {"check", big},
      {"classify", big, out},
      {"repair", big, out},
      {"compare", big, big},
      {"convert", big, out},
      {"decimate", big, out, "--coarsest"},
      {"sample", "scan", out, "--size", "300000"}};
  for (const auto& command : commands) {
    words_ = {AOMD_PROGRAM};
    words_.insert(words_.end(), command.begin(), command.end());
    int ended = 0;
    for (int moment = 1; moment <= 400; moment *= 3) {
      const int code = ended_by(SIGINT, moment);
      EXPECT_TRUE(code == 130 || code == 0) << command[0] << ": " << code << text("log");
      ended += code == 130;
      EXPECT_EQ(temporaries(), 0u);
    }
    EXPECT_GT(ended, 0) << command[0];
  }
}

TEST_F(Endings, ByAFaultOfItsOwnAreCode70) {
  for (int moment = 20; moment < moments; moment += 10) {
    const int code = ended_by(SIGABRT, moment);
    EXPECT_TRUE(code == 70 || code == 0) << code;
  }
}

TEST_F(CommandLine, NohupIsRespected) {
  sample("scan", "s.ply", 100000);
  const int status = std::system(("cd '" + at("").string() +
                                  "'; trap '' HUP; '" AOMD_PROGRAM
                                  "' decimate s.ply o.ply --quiet & p=$!; kill -HUP $p; wait $p")
                                     .c_str());
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(exists("o.ply"));
}

}  // namespace
}  // namespace aomd::test::cli_endings_test
