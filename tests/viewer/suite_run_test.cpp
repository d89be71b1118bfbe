// `aomd-view test`, by the program itself.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "core/io/png.h"
#include "tests/support/io_helpers.h"

namespace aomd::suite_run_test {
namespace {

namespace fs = std::filesystem;

class SuiteRun : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name)) << text;
  }
  int view(const std::string& options, const std::string& environment = "") const {
    const std::string command = "cd '" + at("").string() + "' && " + environment +
                                " '" AOMD_VIEW "' " + options + " >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int run(const std::string& options = "") const { return view("test suite.toml " + options); }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_ / name.c_str(); }
  [[nodiscard]] std::string said() const { return test::bytes_of(at("err.txt")); }
  [[nodiscard]] std::string table() const { return test::bytes_of(at("out.txt")); }
  [[nodiscard]] bool tells(const std::string& line) const {
    return ("\n" + said()).find("\naomd-view: " + line) != std::string::npos;
  }

  test::TemporaryFolder folder_;
};

const std::string two_cases =
    "[defaults]\nsize = \"320x240\"\n[cases]\n"
    "ball = { commands = \"sample sphere 8\" }\n"
    "part = { commands = [\"sample bracket 4\", \"color quality\"], theme = \"dark\" }\n";

TEST_F(SuiteRun, FromNothingToGreen) {
  write("suite.toml", two_cases);
  EXPECT_EQ(run(), 3);
  EXPECT_TRUE(
      tells("suite.toml:4: ball: there is no baseline; look at the picture that this "
            "makes: aomd-view test suite.toml --update ball\n"))
      << said();
  EXPECT_EQ(run("--update ball"), 0) << said();
  EXPECT_NE(table().find("1 case: 1 new\n"), std::string::npos) << table();
  EXPECT_FALSE(fs::exists(at("baselines/part.png")));
  EXPECT_EQ(run("--update"), 0) << said();
  EXPECT_NE(table().find("2 cases: 1 same, 1 new\n"), std::string::npos) << table();
  EXPECT_EQ(run(), 0) << said();
  EXPECT_EQ(said(), "");
  EXPECT_NE(table().find("ball  same         1.0000        0  0.000 %"), std::string::npos)
      << table();
  EXPECT_EQ(io::read_png(at("baselines/part.png")).width, 320);
}

TEST_F(SuiteRun, ALossIsSeenAndItsPicturesAreKept) {
  write("suite.toml", two_cases);
  ASSERT_EQ(run("--update"), 0) << said();
  write("suite.toml", two_cases + "[cases.more]\ncommands = \"sample sphere 8\"\n");
  fs::copy_file(at("baselines/ball.png"), at("baselines/more.png"));
  std::string changed = test::bytes_of(at("suite.toml"));
  changed.replace(changed.find("sample sphere 8"), 15, "sample sphere 9");
  write("suite.toml", changed);
  EXPECT_EQ(run("--results out --junit j.xml --jobs 3"), 1);
  EXPECT_TRUE(tells("suite.toml:4: ball: the tile at ")) << said();
  EXPECT_NE(table().find("3 cases: 2 same, 1 differs\n"), std::string::npos) << table();
  EXPECT_TRUE(fs::exists(at("out/ball.png")));
  EXPECT_TRUE(fs::exists(at("out/ball.diff.png")));
  EXPECT_FALSE(fs::exists(at("out/part.png")));
  EXPECT_NE(test::bytes_of(at("j.xml")).find("failures=\"1\" errors=\"0\""), std::string::npos);
  EXPECT_EQ(run("--update ball"), 0);
  EXPECT_NE(table().find("1 case: 1 updated\n"), std::string::npos) << table();
  EXPECT_EQ(run("--only ball part"), 0);
  EXPECT_NE(table().find("2 cases: 2 same\n"), std::string::npos) << table();
}

TEST_F(SuiteRun, WhatIsWrongWithOneCaseLeavesTheOthers) {
  write("broken.ply", "ply\nnothing\n");
  write("suite.toml", two_cases +
                          "typo = { mesh = \"a.ply\", camra = \"back\" }\n"
                          "gone = \"gone.ply\"\n"
                          "torn = \"broken.ply\"\n"
                          "noscript = \"gone.aomd\"\n"
                          "huge = { mesh = \"gone.ply\", size = \"20000x20000\" }\n"
                          "view = { commands = \"sample sphere 8\", camera = \"bakc\" }\n"
                          "word = { commands = [\"sample sphere 8\", \"orbit a\"] }\n"
                          "nofolder = { commands = \"sample sphere 8\", folder = \"none\" }\n");
  EXPECT_EQ(run("--update"), 3);
  EXPECT_NE(table().find("10 cases: 2 new, 8 broken\n"), std::string::npos) << table();
  for (const char* line :
       {"suite.toml:6: typo: there is no key \"camra\"", "suite.toml:7: gone: gone.ply: ",
        "suite.toml:8: torn: broken.ply:2: ", "suite.toml:9: noscript: gone.aomd: cannot be read",
        "suite.toml:10: huge: '20000x20000' is not a size",
        "suite.toml:11: view: commands: camera: ", "suite.toml:12: word: commands: orbit: ",
        "suite.toml:13: nofolder: "})
    EXPECT_TRUE(tells(line)) << line << "\n" << said();
  EXPECT_TRUE(fs::exists(at("baselines/part.png")));
}

TEST_F(SuiteRun, ACaseInheritsNothing) {
  const std::string loud =
      "loud = { commands = [\"sample bracket 4\", \"theme dark\", \"camera top\", \"color "
      "quality\", \"range 10 20\", \"angle 33\", \"clip x 0.5\", \"show edges off\", \"run\", "
      "\"copy counts\", \"lesson judge\"] }\n";
  const std::string quiet =
      "quiet = { commands = [\"sample sphere 8\", \"expect angle = 10\", \"color quality\"] }\n";
  write("suite.toml", "[defaults]\npanels = true\n[cases]\n" + quiet);
  ASSERT_EQ(run("--update"), 0) << said();
  write("suite.toml", "[defaults]\npanels = true\nthreshold = 1\n[cases]\n" + loud + quiet);
  ASSERT_EQ(run("--update loud"), 0) << said();
  EXPECT_EQ(run("--jobs 1"), 0) << said();
  EXPECT_NE(table().find("2 cases: 2 same\n"), std::string::npos) << table();
}

TEST_F(SuiteRun, ACaseInheritsNothingOfAMeshThatOthersHaveUsed) {
  write("make.aomd", "sample bracket 4\nsave part.ply\nsample tet-box 3\nsave box.msh\n");
  ASSERT_EQ(view("--headless --script make.aomd"), 0) << said();
  const std::string head = "[defaults]\npanels = true\nthreshold = 1\n[cases]\n";
  const auto quiet = [](const std::string& name, const std::string& mesh) {
    return name + " = { mesh = \"" + mesh + "\", commands = \"panel adjacency on\" }\n";
  };
  for (const std::string mesh : {"part.ply", "box.msh"}) {
    write("suite.toml", head + quiet("alone", mesh));
    ASSERT_EQ(run("--update"), 0) << said();
    std::string all = head;
    int cases = 0;
    for (const char* line : {"color quality", "step 3", "select edge 5", "adjacency 1 2 on",
                             "hash-sets build edge 61", "clip x 0.5 cells"}) {
      const std::string number = std::to_string(++cases);
      all += "loud" + number + " = { mesh = \"" + mesh + "\", commands = \"" + line + "\" }\n";
      all += quiet("quiet" + number, mesh);
      fs::copy_file(at("baselines/alone.png"), at("baselines/quiet" + number + ".png"),
                    fs::copy_options::overwrite_existing);
      fs::remove(at("baselines/loud" + number + ".png"));
    }
    write("suite.toml", all);
    ASSERT_EQ(run("--update"), 0) << said();
    EXPECT_NE(table().find("12 cases: 6 same, 6 new\n"), std::string::npos) << mesh << table();
  }
}

TEST_F(SuiteRun, ACaseIsWhatTheProgramDrawsForItAlone) {
  write("turn.aomd", "sample bracket 4\norbit 20 10\nselect edge 3\n");
  write("suite.toml",
        "[defaults]\nthreshold = 1\nsize = \"400x300\"\n[cases]\n"
        "turn = \"turn.aomd\"\nwith = { script = \"turn.aomd\", panels = true, size = "
        "\"900x600\", theme = \"dark\", scale = 1.5 }\n");
  fs::create_directory(at("baselines"));
  ASSERT_EQ(view("--script turn.aomd --size 400x300 --no-ui --screenshot baselines/turn.png"), 0);
  ASSERT_EQ(view("--script turn.aomd --size 900x600 --theme dark --scale 1.5 --screenshot "
                 "baselines/with.png"),
            0);
  EXPECT_EQ(run(), 0) << said();
}

TEST_F(SuiteRun, AnExpectationThatIsMissedStillLeavesThePicture) {
  write("fails.aomd", "sample sphere 8\nexpect faces = 3\n");
  write("suite.toml",
        "[cases]\nlisted = { commands = \"sample sphere 8\", expect = [\"euler = 2\", \"faces = "
        "1\"] }\nscript = \"fails.aomd\"\n"
        "good = { commands = \"sample sphere 8\", expect = [\"euler = 2\", \"boundary = 0\"] }\n");
  EXPECT_EQ(run("--update"), 3) << "of the two no baseline is made";
  EXPECT_TRUE(fs::exists(at("baselines/good.png")));
  EXPECT_FALSE(fs::exists(at("baselines/listed.png")));
  for (const char* name : {"listed", "script"})
    fs::copy_file(at("baselines/good.png"), at("baselines") / (std::string(name) + ".png"));
  EXPECT_EQ(run("--results out"), 1);
  EXPECT_TRUE(tells("suite.toml:2: listed: expected faces = 1, but it is ")) << said();
  EXPECT_TRUE(tells("suite.toml:3: script: fails.aomd:2: expected faces = 3, but it is "))
      << said();
  EXPECT_NE(table().find("3 cases: 1 same, 2 missed\n"), std::string::npos) << table();
  EXPECT_TRUE(fs::exists(at("out/listed.png"))) << "though it is as its baseline";
}

TEST_F(SuiteRun, ARecordingIsACase) {
  write("session.aomd", "sample bracket 4\npanel mesh off\norbit 20 10\nselect edge 3\nquit\n");
  ASSERT_EQ(view("--headless --script session.aomd --theme dark --camera top --size 900x600 "
                 "--record done.aomd --screenshot shot.png"),
            0)
      << said();
  fs::create_directory(at("baselines"));
  fs::rename(at("shot.png"), at("baselines/done.png"));
  write("suite.toml",
        "[defaults]\nthreshold = 1\npanels = true\nsize = \"900x600\"\n[cases]\ndone = "
        "\"done.aomd\"\n");
  EXPECT_EQ(run(), 0) << said() << test::bytes_of(at("done.aomd"));
}

TEST_F(SuiteRun, ReportsInItsOwnOrderWhateverIsDrawnFirst) {
  write("make.aomd", "sample bracket 4\nsave a.ply\nsample sphere 8\nsave b.ply\n");
  ASSERT_EQ(view("--headless --script make.aomd"), 0) << said();
  write("suite.toml",
        "[cases]\nfirst = \"b.ply\"\nsecond = \"a.ply\"\n"
        "third = { mesh = \"b.ply\", size = \"320x240\" }\nfourth = \"b.ply\"\n");
  ASSERT_EQ(run("--update"), 0) << said();
  std::vector<std::size_t> places;
  for (const char* name : {"\nfirst ", "\nsecond ", "\nthird ", "\nfourth "})
    places.push_back(table().find(name));
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << table();
  EXPECT_NE(places.back(), std::string::npos);
  EXPECT_EQ(run("--jobs 2"), 0) << said();
}

TEST_F(SuiteRun, AMenuShowsThoughAPictureWithoutPanelsCameBefore) {
  for (const char* menu : {"menu view", "menu 0.1 0.2"}) {
    const std::string begin = "sample bracket 4\nselect edge 3\nwait-idle\n";
    const std::string end = std::string(menu) + "\nscreenshot ";
    write("first.aomd", begin + end + "first.png 900x600\n");
    write("later.aomd", begin + "screenshot x.png 300x200 no-ui\n" + end + "later.png 900x600\n");
    ASSERT_EQ(view("--headless --script first.aomd --size 900x600"), 0) << said();
    ASSERT_EQ(view("--headless --script later.aomd --size 900x600"), 0) << said();
    // The line below says that the other picture is saved.
    io::Image first = io::read_png(at("first.png")), later = io::read_png(at("later.png"));
    for (io::Image* each : {&first, &later}) each->rgba.resize(std::size_t{4} * 900 * 560);
    EXPECT_TRUE(first.rgba == later.rgba) << menu;
  }
}

TEST_F(SuiteRun, PicturesWithoutPanelsSayHowLongWhatIsMeasuredIs) {
  write("part.aomd", "sample bracket 4\nselect vertex 1 40\nscreenshot shot.png 600x400 no-ui\n");
  ASSERT_EQ(view("--headless --no-ui --size 600x400 --script part.aomd --screenshot whole.png"), 0)
      << said();
  EXPECT_TRUE(io::read_png(at("shot.png")) == io::read_png(at("whole.png")));
}

TEST_F(SuiteRun, PathsAreThoseOfTheSuite) {
  fs::create_directories(at("deep/meshes"));
  write("deep/make.aomd", "sample sphere 8\nsave meshes/ball.ply\nopen meshes/ball.ply\n");
  write("deep/suite.toml",
        "[cases]\na = \"make.aomd\"\nb = \"meshes/ball.ply\"\n"
        "c = { mesh = \"ball.ply\", folder = \"meshes\" }\n");
  EXPECT_EQ(view("test deep/suite.toml --update --junit j.xml"), 0) << said();
  EXPECT_TRUE(fs::exists(at("deep/baselines/c.png")));
  EXPECT_TRUE(fs::exists(at("j.xml")));
}

TEST_F(SuiteRun, WrongUsageIsSaid) {
  write("suite.toml", two_cases);
  for (const auto& [options, why] :
       {std::pair{"--only nobody", "suite.toml has no case \"nobody\"\n"},
        {"--update ball nobody", "suite.toml has no case \"nobody\"\n"},
        {"--jobs 0", "--jobs: "},
        {"--junit suite.toml", "SUITE and --junit are one file, suite.toml\n"},
        {"--update --only ball", "--update names the cases itself"},
        {"--nonsense", "The following argument was not expected: --nonsense"}}) {
    EXPECT_EQ(run(options), 2) << options;
    EXPECT_TRUE(tells(why)) << said();
  }
  EXPECT_EQ(view("test"), 2);
  EXPECT_EQ(view("test --help"), 0);
  EXPECT_EQ(run("--junit none/j.xml"), 4);
  EXPECT_EQ(table(), "") << "before anything is drawn";
  EXPECT_EQ(view("test none.toml"), 3);
  EXPECT_TRUE(tells("none.toml: cannot be opened")) << said();
  write("suite.toml", "[cases]\na = {\n");
  EXPECT_EQ(run(), 3);
  EXPECT_TRUE(tells("suite.toml:2: ")) << said();
}

TEST_F(SuiteRun, AProcessThatDiesCostsItsCaseAlone) {
  write("dies.aomd", "sample sphere 8\n");
  write("suite.toml", two_cases + "after = { commands = \"sample sphere 9\" }\n");
  ASSERT_EQ(run("--update"), 0) << said();
  // Mesa writes its log when a context is made; a limit on the size of files then ends the process.
  write("suite.toml", two_cases +
                          "dies = { commands = [\"sample sphere 40\", \"save big.ply\"] }\n"
                          "after = { commands = \"sample sphere 9\" }\n");
  EXPECT_EQ(view("test suite.toml", "ulimit -f 8;"), 70);
  EXPECT_TRUE(tells("suite.toml:6: dies: the process that drew it ended with signal 25")) << said();
  EXPECT_NE(table().find("4 cases: 3 same, 1 broken\n"), std::string::npos) << table();
}

}  // namespace
}  // namespace aomd::suite_run_test
