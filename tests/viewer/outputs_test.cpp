// Pictures and series of them, by the program itself; and that it leaves no traces without a
// window.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "core/io/png.h"
#include "core/measure/image_diff.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"

namespace aomd::outputs_test {
namespace {

namespace fs = std::filesystem;

/// Runs scripts in a folder of its own, which is the user's home too.
class Outputs : public testing::Test {
 protected:
  int run(const std::string& script, const std::string& options = "") const {
    std::ofstream(folder_ / "script.aomd") << script;
    const std::string home = (folder_ / "").string();
    const std::string command = "cd '" + home + "' && env -u XDG_STATE_HOME HOME='" + home +
                                "' XDG_CONFIG_HOME='" + home +
                                "config' '" AOMD_VIEW "' --headless --size 320x240 " + options +
                                " --script script.aomd >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] io::Image picture(const std::string& name) const { return io::read_png(at(name)); }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_ / name.c_str(); }
  [[nodiscard]] std::string text(const std::string& name) const { return test::bytes_of(at(name)); }

  test::TemporaryFolder folder_;
};

TEST_F(Outputs, AScreenshotIsAsLargeAsTheWindowOrAsAsked) {
  ASSERT_EQ(run("sample sphere 8\nscreenshot a.png\nscreenshot b.png 500x300\nscreenshot c.png "
                "no-ui 500x300\n"),
            0);
  EXPECT_EQ(picture("a.png").width, 320);
  EXPECT_EQ(picture("b.png").width, 500);
  EXPECT_EQ(picture("b.png").height, 300);
  EXPECT_EQ(picture("c.png").width, 500);
  EXPECT_FALSE(picture("b.png") == picture("c.png"));
}

/// How many pixels are nearly black: what lines cover.
int dark_pixels(const io::Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto* p = image.pixel(x, y);
      count += p[3] > 200 && p[0] < 110 && p[1] < 110 && p[2] < 110;
    }
  return count;
}

TEST_F(Outputs, LinesGrowByAFactorAndWithLargePicturesByThemselves) {
  ASSERT_EQ(run("sample cylinder 8\ncolor none\nshow edges off\nscreenshot a.png no-ui transparent "
                "800x600\n"
                "screenshot b.png no-ui transparent 800x600 scale 3\n"
                "screenshot c.png no-ui transparent 2160x2160\n"
                "screenshot d.png no-ui transparent 2160x2160 scale 1\n"
                "screenshot again.png no-ui transparent 800x600\n"),
            0)
      << text("err.txt");
  EXPECT_GT(dark_pixels(picture("b.png")), 2 * dark_pixels(picture("a.png")));
  EXPECT_GT(dark_pixels(picture("c.png")), 3 * dark_pixels(picture("d.png")) / 2);
  EXPECT_TRUE(picture("a.png") == picture("again.png"));
}

TEST_F(Outputs, FewerFacesLookAlike) {
  ASSERT_EQ(run("sample scan 120000\nshow edges off\nshow model-vertices off\n"
                "screenshot full.png no-ui\ndetail coarse\nscreenshot coarse.png no-ui\n"
                "detail full\nscreenshot again.png no-ui\n",
                "--size 480x360"),
            0)
      << text("err.txt");
  EXPECT_FALSE(picture("full.png") == picture("coarse.png"));
  EXPECT_GT(measure::compare_images(picture("full.png"), picture("coarse.png")).ssim, 0.97);
  EXPECT_TRUE(picture("full.png") == picture("again.png"));
}

TEST_F(Outputs, FoldsGroundAndLightShow) {
  ASSERT_EQ(run("sample torus 24\nscreenshot plain.png no-ui\nshow occlusion on\n"
                "screenshot folds.png no-ui\nshow occlusion off\nshow ground on\n"
                "screenshot ground.png no-ui\ncamera bottom\nscreenshot below.png no-ui\n"
                "show ground off\nscreenshot without.png no-ui\ncamera iso\nlight stay\n"
                "screenshot stays.png no-ui\norbit 120 0\nscreenshot behind.png no-ui\n"
                "light follow\nscreenshot follows.png no-ui\n"),
            0)
      << text("err.txt");
  EXPECT_FALSE(picture("plain.png") == picture("folds.png"));
  EXPECT_FALSE(picture("plain.png") == picture("ground.png"));
  EXPECT_TRUE(picture("below.png") == picture("without.png"))
      << "from below nothing hides the mesh";
  EXPECT_GT(measure::compare_images(picture("plain.png"), picture("stays.png")).ssim, 0.99);
  EXPECT_LT(measure::compare_images(picture("behind.png"), picture("follows.png")).ssim, 0.99);
}

/// Whether a pixel is another one in two pictures.
bool others(const io::Image& a, const io::Image& b, int x, int y) {
  return !std::equal(a.pixel(x, y), a.pixel(x, y) + 4, b.pixel(x, y));
}

TEST_F(Outputs, WhatAScriptOpensIsInItsPictures) {
  const std::string head = "sample sphere 8\n";
  const std::string pictures = "screenshot closed.png 640x480\n";
  for (const char* line : {"dialog about", "palette color", "menu view", "dialog open"}) {
    ASSERT_EQ(
        run(head + pictures + line + "\nscreenshot open.png 640x480\ndialog none\nmenu off\n" +
                "screenshot after.png 640x480\n",
            "--size 640x480"),
        0)
        << text("err.txt");
    ASSERT_EQ(run(head + line + "\n", "--size 640x480 --screenshot right.png"), 0);
    EXPECT_GT(measure::compare_images(picture("open.png"), picture("right.png")).ssim, 0.99)
        << line;
    EXPECT_LT(measure::compare_images(picture("open.png"), picture("closed.png")).ssim, 0.98)
        << line;
    EXPECT_GT(measure::compare_images(picture("after.png"), picture("closed.png")).ssim, 0.99)
        << line;
  }
}

TEST_F(Outputs, PicturesWithoutPanelsHaveTheScaleOfTheColours) {
  ASSERT_EQ(run("sample sphere 8\ncolor quality\nscreenshot a.png 640x480 no-ui\n"
                "show scale off\nscreenshot b.png 640x480 no-ui\n"
                "camera orthographic\nscreenshot c.png 640x480 no-ui\n"
                "show length-scale off\nscreenshot d.png 640x480 no-ui\n"),
            0);
  const auto differ = [&](const char* a, const char* b, bool right) {
    const io::Image one = picture(a), other = picture(b);
    int count = 0;
    for (int y = 0; y < one.height; ++y)
      for (int x = 0; x < one.width; ++x)
        count += others(one, other, x, y) && (right ? x > 480 : y > 400);
    return count;
  };
  EXPECT_GT(differ("a.png", "b.png", true), 2000);
  EXPECT_GT(differ("c.png", "d.png", false), 300);
}

TEST_F(Outputs, APageOfALessonHasOneCameraHoweverItIsReached) {
  for (const auto& [page, before] : {std::pair{3, 2}, {2, 1}}) {
    const std::string at = std::to_string(page), from = std::to_string(before);
    ASSERT_EQ(run("lesson judge " + at + "\nscreenshot direct.png\nlesson judge " + from +
                      "\nlesson next\nscreenshot next.png\n",
                  "--size 1280x720"),
              0)
        << text("err.txt");
    EXPECT_TRUE(picture("direct.png") == picture("next.png")) << page;
  }
}

TEST_F(Outputs, WhatWasInSightStaysThereBesidePanels) {
  const std::string size = "--size 900x900";
  ASSERT_EQ(run("sample sphere 16\ncamera front\npanel timeline off\npanel decimation off\n"
                "panel mesh off\nfit\npanel runs on\nscreenshot narrow.png\nfit\n"
                "screenshot fitted.png\npanel runs off\npanel runs on\nscreenshot again.png\n",
                size),
            0)
      << text("err.txt");
  const io::Image fitted = picture("fitted.png");
  for (const char* name : {"narrow.png", "again.png"}) {
    const io::Image image = picture(name);
    int count = 0;
    for (int y = 0; y < image.height - 40; ++y)  // the lowest line says what was saved last
      for (int x = 0; x < image.width; ++x) count += others(image, fitted, x, y);
    EXPECT_EQ(count, 0) << name;
  }
}

TEST_F(Outputs, ATransparentPictureHasNothingBehindTheMesh) {
  ASSERT_EQ(run("sample sphere 24\nshow edges off\nscreenshot a.png 400x300 transparent no-ui\n"
                "screenshot b.png 400x300 no-ui\n"),
            0);
  const io::Image clear = picture("a.png"), full = picture("b.png");
  EXPECT_EQ(clear.pixel(0, 0)[3], 0);
  EXPECT_EQ(clear.pixel(399, 299)[3], 0);
  int partly = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const std::uint8_t* p = clear.pixel(x, y);
      partly += p[3] > 0 && p[3] < 255;
      for (int c = 0; c < 3 && p[3] == 255; ++c)
        ASSERT_EQ(p[c], full.pixel(x, y)[c]) << x << ' ' << y;
    }
  EXPECT_EQ(clear.pixel(200, 150)[3], 255);
  EXPECT_GT(partly, 50);  // the rim of the sphere
  EXPECT_EQ(full.pixel(0, 0)[3], 255);
}

TEST_F(Outputs, ALargePictureIsTheSameInPieces) {
  const std::string scene =
      "sample bracket 8\nshow edges off\nshow model-edges off\nshow model-vertices off\n";
  ASSERT_EQ(
      run(scene + "screenshot small.png 1250x1100 no-ui\nscreenshot large.png 2500x2200 no-ui\n"),
      0);
  const io::Image small = picture("small.png"), large = picture("large.png");
  ASSERT_EQ(large.width, 2500);
  io::Image half(1250, 1100);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
          sum += large.pixel(2 * x + dx, 2 * y + dy)[c];
        half.pixel(x, y)[c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
  EXPECT_GT(measure::compare_images(small, half).ssim, 0.99);
}

TEST_F(Outputs, SizesThatNobodyCouldReadAreRefused) {
  EXPECT_EQ(run("sample sphere 8\nscreenshot a.png 16384x16384\n"), 2);
  EXPECT_NE(text("err.txt").find("8192x8192"), std::string::npos) << text("err.txt");
  EXPECT_EQ(run("sample sphere 8\nscreenshot a.png 0x4\n"), 2);
  EXPECT_EQ(run("sample sphere 8\n", "--size 16384x16384"), 2);
  EXPECT_NE(text("err.txt").find("8192x8192"), std::string::npos) << text("err.txt");
}

TEST_F(Outputs, NothingIsWrittenOverWhatAnOptionNames) {
  const std::string script = "sample sphere 8\n";
  fs::create_symlink("script.aomd", at("link"));
  for (const char* options :
       {"--record script.aomd", "--record ./script.aomd", "--record link",
        "--record ../$(basename $PWD)/script.aomd", "--screenshot script.aomd",
        "--screenshot a.png --record a.png", "--compare a.png --screenshot a.png",
        "--compare a.diff.png --screenshot a.png",
        "--compare b.result.png --record b.result.result.png"}) {
    EXPECT_EQ(run(script, options), 2) << options;
    EXPECT_EQ(text("script.aomd"), script) << options;
    EXPECT_NE(text("err.txt").find("are one file"), std::string::npos) << text("err.txt");
  }
  EXPECT_EQ(run(script, "--record /dev/null --screenshot a.png"), 0);
}

TEST_F(Outputs, ARecordHoldsWhatTheScriptDid) {
  ASSERT_EQ(run("# a ball\n\nsample sphere 12  # of 440 faces\nstep 9\nunsaved cancel\nexpect "
                "cursor = 9\n",
                "--record done.aomd"),
            0)
      << text("err.txt");
  EXPECT_EQ(text("done.aomd"), "sample sphere 12\nstep 9\nunsaved cancel\nexpect cursor = 9\n");
}

TEST_F(Outputs, AScriptThatCannotBeReadIsAnError) {
  EXPECT_EQ(run("", "--script ."), 0) << "the last one counts";
  fs::create_directory(at("folder"));
  const std::string program = "cd '" + at("").string() + "' && '" AOMD_VIEW "' --headless ";
  for (const char* script : {"folder", "none", "/proc/self/mem"}) {
    const int status = std::system((program + "--script " + script + " 2>err.txt").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 3) << script;
    EXPECT_EQ(text("err.txt").rfind("aomd-view: " + std::string(script) + ": ", 0), 0u)
        << text("err.txt");
  }
}

TEST_F(Outputs, ATurntableComesBackToWhereItBegan) {
  ASSERT_EQ(run("sample bracket 6\ncamera copy\nexport turntable turn 4 160x120\ncamera copy\n"
                "screenshot after.png 160x120 no-ui\n"),
            0)
      << text("err.txt");
  EXPECT_TRUE(picture("turn/turn-0001.png") == picture("after.png"));
  EXPECT_FALSE(picture("turn/turn-0002.png") == picture("turn/turn-0001.png"));
  EXPECT_TRUE(fs::exists(at("turn/turn-0004.png")));
  EXPECT_FALSE(fs::exists(at("turn/turn-0005.png")));
}

TEST_F(Outputs, AHistoryGoesFromTheMeshAsLoadedToTheLastOperation) {
  ASSERT_EQ(run("sample sphere 12\nscreenshot first.png 160x120 no-ui\nsweep\nscreenshot last.png "
                "160x120 no-ui\n"
                "undo\nexport history h 5 160x120\nexpect cursor = 0\nexpect steps > 5\n"),
            0)
      << text("err.txt");
  EXPECT_TRUE(picture("h/history-0001.png") == picture("first.png"));
  EXPECT_TRUE(picture("h/history-0005.png") == picture("last.png"));
}

TEST_F(Outputs, AHistoryOfFewOperationsHasFewPictures) {
  ASSERT_EQ(run("sample sphere 8\nstep 2\nexport history h 50 64x48\n"), 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(at("h")), {}), 3);
}

TEST_F(Outputs, ASeriesThatCannotBeWrittenEndsTheScript) {
  EXPECT_EQ(run("sample sphere 8\nexport turntable /proc/nowhere 3\n"), 4);
  const std::string said = text("err.txt");
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST_F(Outputs, WithoutAWindowNothingIsRememberedOrKept) {
  fs::create_directories(at("config/aomd-studio"));
  ASSERT_EQ(run("sample sphere 8\nscreenshot usual.png\n"), 0);
  std::ofstream(at("config/aomd-studio/settings")) << "theme=dark\nmesh-panel=off\nside-width=30\n";
  ASSERT_EQ(run("sample sphere 8\nscreenshot other.png\nstep 3\ntheme dark\n"), 0);
  EXPECT_TRUE(picture("usual.png") == picture("other.png"));
  EXPECT_EQ(text("config/aomd-studio/settings"), "theme=dark\nmesh-panel=off\nside-width=30\n");
  EXPECT_FALSE(fs::exists(at(".local")));
}

TEST_F(Outputs, WorkIsKeptWithoutAWindowWhereThatIsAskedForAndGoneAtACleanEnd) {
  ASSERT_EQ(run("sample sphere 12\nrun\nrecover\n", "--recovery kept"), 2);
  EXPECT_NE(text("err.txt").find("nothing to recover"), std::string::npos) << text("err.txt");
  ASSERT_EQ(run("sample sphere 12\nrun\n", "--recovery kept2"), 0);
  EXPECT_TRUE(!fs::exists(at("kept2")) || fs::is_empty(at("kept2")));
}

namespace in_steps {

using namespace scene;

/// What a renderer would do.
int take_all(Session& s) {
  int taken = 0;
  for (s.advance_series(); s.series() != nullptr; s.advance_series()) {
    taken += static_cast<int>(s.screenshots.size());
    s.screenshots.clear();
  }
  return taken;
}

TEST(Series, TakesOnePictureAfterTheOtherAndPutsEverythingBack) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  scene::test::drive(s, {"sample sphere 12", "step 9", "step -4"});
  const Camera before = s.view.camera;
  execute(s, "export history " + (folder / "h").string() + " 4");
  EXPECT_FALSE(s.idle());
  EXPECT_EQ(take_all(s), 4);
  EXPECT_EQ(s.document().journal().cursor(), 5u);
  EXPECT_TRUE(s.view.operation);
  execute(s, "export turntable " + (folder / "t").string() + " 7 64x64");
  EXPECT_EQ(take_all(s), 7);
  EXPECT_TRUE(s.view.camera == before);
  EXPECT_TRUE(s.idle());
}

TEST(Series, CancelPutsEverythingBackToo) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  scene::test::drive(s, {"sample sphere 12", "step 9"});
  execute(s, "export history " + (folder / "h").string() + " 4");
  s.advance_series();
  EXPECT_EQ(s.document().journal().cursor(), 0u);
  EXPECT_THROW(execute(s, "step"), CommandError);  // it would be in the pictures
  execute(s, "cancel");
  EXPECT_EQ(s.document().journal().cursor(), 9u);
  EXPECT_TRUE(s.screenshots.empty());
  EXPECT_NO_THROW(execute(s, "step"));
}

}  // namespace in_steps
}  // namespace
}  // namespace aomd::outputs_test
