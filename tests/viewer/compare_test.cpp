// `--compare`, by the program itself: what it lets pass, what it does not, and what it leaves.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "core/io/png.h"
#include "core/measure/image_diff.h"
#include "tests/support/io_helpers.h"

namespace aomd::compare_test {
namespace {

namespace fs = std::filesystem;

class Compare : public testing::Test {
 protected:
  int run(const std::string& script, const std::string& options,
          const std::string& environment = "") const {
    std::ofstream(folder_ / "script.aomd") << script;
    const std::string command = "cd '" + (folder_ / "").string() + "' && " + environment +
                                " '" AOMD_VIEW "' --headless --size 960x600 " + options +
                                " --script script.aomd >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_ / name.c_str(); }
  [[nodiscard]] std::string said() const { return test::bytes_of(at("err.txt")); }

  test::TemporaryFolder folder_;
};

const std::string bracket = "sample bracket\n";

TEST_F(Compare, SmallLossesAreSeen) {
  ASSERT_EQ(run(bracket, "--screenshot a.png"), 0) << said();
  EXPECT_EQ(run(bracket, "--compare a.png --screenshot again.png"), 0) << said();
  const io::Image baseline = io::read_png(at("a.png"));
  for (const char* line : {"show axes off", "select edge 12", "orbit 0.2 0", "select face 3",
                           "color none", "show model-vertices off"}) {
    EXPECT_EQ(run(bracket + line + "\n", "--compare a.png --screenshot b.png"), 1) << line;
    EXPECT_NE(said().find("not as a.png: the tile at "), std::string::npos) << said();
    EXPECT_GT(measure::compare_images(baseline, io::read_png(at("b.png"))).ssim, 0.95) << line;
  }
}

TEST_F(Compare, AnotherWidthOfVectorsIsNoLoss) {
  const std::string script = bracket + "camera azimuth=33 elevation=21\ncolor curvature\n";
  ASSERT_EQ(run(script, "--screenshot a.png"), 0) << said();
  for (const char* width : {"128", "256"})
    EXPECT_EQ(run(script, "--compare a.png --screenshot b.png",
                  std::string("LP_NATIVE_VECTOR_WIDTH=") + width),
              0)
        << width << said();
}

TEST_F(Compare, AFailedExpectStillLeavesThePicture) {
  ASSERT_EQ(run(bracket, "--screenshot a.png"), 0) << said();
  EXPECT_EQ(run(bracket + "expect faces = 1\nshow axes off\n", "--screenshot b.png"), 1);
  EXPECT_EQ(said().find("aomd-view: script.aomd:2: expected faces = 1, but it is "), 0u) << said();
  EXPECT_TRUE(io::read_png(at("a.png")) == io::read_png(at("b.png")));

  EXPECT_EQ(run(bracket + "show axes off\nexpect faces = 1\n", "--compare a.png"), 1);
  EXPECT_NE(said().find("not as a.png"), std::string::npos) << said();
  EXPECT_NE(said().find("expected faces = 1"), std::string::npos) << said();
  EXPECT_TRUE(fs::exists(at("a.result.png")));
}

TEST_F(Compare, AnyOtherFailureLeavesNone) {
  EXPECT_EQ(run(bracket + "orbit a b\n", "--screenshot b.png"), 2);
  EXPECT_FALSE(fs::exists(at("b.png")));
}

}  // namespace
}  // namespace aomd::compare_test
