// Suites as they are read, and what is said of them: nothing is drawn.

#include "viewer/suite/suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/io/error.h"
#include "tests/support/io_helpers.h"
#include "viewer/suite/report.h"

namespace aomd::suite::suite_test {
namespace {

class SuiteFile : public testing::Test {
 protected:
  Suite read(const std::string& text) const {
    std::ofstream(folder_ / "suite.toml") << text;
    return read_suite(folder_ / "suite.toml");
  }
  /// What is wrong with a suite as a whole, without its folder.
  std::string refusal(const std::string& text) const {
    try {
      (void)read(text);
    } catch (const io::ReadError& error) {
      return std::string(error.what()).substr((folder_ / "").string().size());
    }
    return "nothing";
  }
  /// What is wrong with its only case.
  std::string problem(const std::string& entry) const {
    const Suite suite = read("[cases]\na = " + entry + "\n");
    return suite.cases.size() == 1 ? suite.cases[0].problem : "no case";
  }

  aomd::test::TemporaryFolder folder_;
};

TEST_F(SuiteFile, ACaseIsALineAndDefaultsHoldForAll) {
  const Suite suite = read(
      "baselines = \"pictures\"\n"
      "[defaults]\nsize = \"640x360\"\ntheme = \"dark\"\nnoise = 3\n"
      "[cases]\n"
      "zebra = \"zebra.ply\"\n"
      "run = \"run.aomd\"\n"
      "ape = { mesh = \"ape.obj\", size = \"100x200\", theme = \"light\", camera = \"back\" }\n"
      "[cases.tall]\ncommands = [\"sample sphere 8\", \"fit\"]\nexpect = \"faces = 8\"\n"
      "folder = \"below\"\nmasks = [[1, 2, 3, 4]]\nlargest = 9\n");
  ASSERT_EQ(suite.cases.size(), 4u);
  const auto& [zebra, run, ape, tall] =
      std::tie(suite.cases[0], suite.cases[1], suite.cases[2], suite.cases[3]);
  EXPECT_EQ(zebra.name, "zebra");
  EXPECT_EQ(zebra.line, 7);
  EXPECT_EQ(zebra.mesh, "zebra.ply");
  EXPECT_TRUE(zebra.dark);
  EXPECT_EQ(zebra.limits.noise, 3);
  EXPECT_EQ(run.script, "run.aomd");
  EXPECT_EQ(run.mesh, "");
  EXPECT_EQ(ape.size, glm::ivec2(100, 200));
  EXPECT_FALSE(ape.dark);
  EXPECT_EQ(ape.camera, "back");
  EXPECT_EQ(tall.size, glm::ivec2(640, 360));
  EXPECT_EQ(tall.commands, (std::vector<std::string>{"sample sphere 8", "fit"}));
  EXPECT_EQ(tall.expect, std::vector<std::string>{"faces = 8"});
  EXPECT_EQ(tall.limits.masks, (std::vector<measure::PixelArea>{{1, 2, 3, 4}}));
  EXPECT_EQ(tall.limits.largest, 9);
  EXPECT_EQ(tall.folder.filename(), "below");
  EXPECT_EQ(suite.baseline_of(ape), folder_ / "pictures/ape.png");
}

TEST_F(SuiteFile, AThresholdOfOneForgivesNothing) {
  const Suite suite = read(
      "[defaults]\nmasks = [[0, 0, 9, 9]]\n[cases]\n"
      "a = { mesh = \"a.ply\", threshold = 1 }\n"
      "b = { mesh = \"a.ply\", largest = 7, threshold = 1 }\n"
      "c = { mesh = \"a.ply\", threshold = 0.5 }\n");
  EXPECT_EQ(suite.cases[0].limits.noise, 0);
  EXPECT_FALSE(suite.cases[0].limits.edges);
  EXPECT_EQ(suite.cases[0].limits.masks.size(), 1u);
  EXPECT_EQ(suite.cases[1].limits.largest, 7) << "whatever the order of the keys";
  EXPECT_EQ(suite.cases[2].limits.noise, 2);
  EXPECT_EQ(suite.cases[2].panels_threshold, 0.5);
}

TEST_F(SuiteFile, WhatIsWrongWithTheWholeHasItsLine) {
  EXPECT_EQ(refusal("[cases]\na = \n").substr(0, 14), "suite.toml:2: ");
  EXPECT_EQ(refusal("[cases]\na = \"x.ply\"\na = \"y.ply\"\n").substr(0, 14), "suite.toml:3: ");
  EXPECT_EQ(refusal("cases = 3\n"), "suite.toml:1: 'cases' is a table");
  EXPECT_EQ(refusal("\n[defaults]\nsize = \"5\"\n[cases]\na = \"a.ply\"\n"),
            "suite.toml:3: '5' is not a size like 1280x800");
  EXPECT_EQ(refusal("[cases]\n"), "suite.toml:1: there are no cases: [cases] lists them");
  EXPECT_EQ(refusal("[default]\n"),
            "suite.toml:1: there is no key \"default\"; there are baselines, defaults and cases");
  EXPECT_EQ(refusal("[cases]\na = \"\x80\"\n").substr(0, 14), "suite.toml:2: ");
}

TEST_F(SuiteFile, WhatIsWrongWithACaseLeavesTheOthers) {
  const Suite suite = read(
      "[cases]\na = \"a.ply\"\n[cases.b]\nmesh = \"b.ply\"\ncamra = \"back\"\n"
      "[cases.c]\nmesh = \"c.ply\"\n");
  ASSERT_EQ(suite.cases.size(), 3u);
  EXPECT_EQ(suite.cases[0].problem, "");
  EXPECT_EQ(suite.cases[1].problem.find("there is no key \"camra\"; there are mesh, "), 0u);
  EXPECT_EQ(suite.cases[1].line, 5);
  EXPECT_EQ(suite.cases[2].problem, "");
}

TEST_F(SuiteFile, EachKeySaysWhatItTakes) {
  for (const auto& [entry, why] : std::initializer_list<std::pair<const char*, const char*>>{
           {"3", "a case is a file or a table, such as { mesh = \"part.ply\" }"},
           {"{ theme = \"dark\" }", "give 'mesh', 'script' or 'commands': what the picture shows"},
           {"{ mesh = 3 }", "'mesh' is a text"},
           {"{ mesh = \"\" }", "'mesh' is a text"},
           {"{ mesh = \"a\\nb\" }", "'mesh' is a text of one line"},
           {"{ mesh = \"a\", theme = \"blue\" }", "'theme' is \"light\" or \"dark\", not \"blue\""},
           {"{ mesh = \"a\", size = \"0x9\" }", "'0x9' is not a size like 1280x800"},
           {"{ mesh = \"a\", size = \"16384x16384\" }",
            "'16384x16384' is too large: 8192x8192 is as many pixels as there may be"},
           {"{ mesh = \"a\", scale = 9 }", "'scale' is a number from 0.5 to 4"},
           {"{ mesh = \"a\", threshold = nan }", "'threshold' is a number from -1 to 1"},
           {"{ mesh = \"a\", share = \"1\" }", "'share' is a number from 0 to 1"},
           {"{ mesh = \"a\", noise = 2.5 }", "'noise' is a whole number from 0 to 255"},
           {"{ mesh = \"a\", panels = 1 }", "'panels' is true or false"},
           {"{ mesh = \"a\", expect = [1] }", "'expect' is a text"},
           {"{ mesh = \"a\", masks = [1, 2, 3, 4] }",
            "'masks' is rectangles of pixels: [[LEFT, TOP, WIDTH, HEIGHT], ...]"},
           {"{ mesh = \"a\", masks = [[0, 0, 0, 5]] }",
            "'masks' is a whole number from 1 to 16384"},
           {"{ mesh = \"a\", size = \"20x20\", masks = [[15, 0, 6, 5]] }",
            "the mask [15, 0, 6, 5] reaches out of a picture of 20x20"}})
    EXPECT_EQ(problem(entry), why) << entry;
}

TEST_F(SuiteFile, NamesAreThoseOfFiles) {
  const Suite suite = read(
      "[cases]\n\"a/b\" = \"a.ply\"\n\"..\" = \"a.ply\"\n\"-x\" = \"a.ply\"\n\"\" = \"a.ply\"\n"
      "\"A_1.2-b\" = \"a.ply\"\n");
  ASSERT_EQ(suite.cases.size(), 5u);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(suite.cases[static_cast<std::size_t>(i)].problem.find("the name \""), 0u) << i;
  EXPECT_EQ(suite.cases[4].problem, "");
}

TEST_F(SuiteFile, WhatIsNoFileIsAnError) {
  EXPECT_THROW((void)read_suite(folder_ / "none.toml"), io::ReadError);
  EXPECT_THROW((void)read_suite(folder_ / ""), io::ReadError);
}

CaseResult differing() {
  CaseResult result;
  result.outcome = Outcome::Differs;
  result.exit_code = 1;
  result.why = "the tile at 32,64 says \"no\" & <more>";
  measure::PictureVerdict verdict;
  verdict.worst_tile = 0.25;
  verdict.tile = {32, 64, 32, 32};
  verdict.largest = 77;
  verdict.differing = 20;
  verdict.judged = 1000;
  verdict.why = result.why;
  result.judged = {{"scene", verdict}, {"panels", {}}};
  result.judged[1].verdict.worst_tile = 1;
  result.judged[1].verdict.largest = 3;
  result.judged[1].verdict.judged = 1000;
  result.judged[1].verdict.same = true;
  result.seconds = 1.5;
  result.picture = "a.png";
  return result;
}

TEST(CaseResult, ComesBackFromItsText) {
  const CaseResult a = differing(), b = from_json(to_json(a));
  EXPECT_EQ(b.outcome, a.outcome);
  EXPECT_EQ(b.exit_code, 1);
  EXPECT_EQ(b.why, a.why);
  EXPECT_EQ(b.seconds, 1.5);
  EXPECT_EQ(b.picture, "a.png");
  EXPECT_EQ(b.difference, "");
  ASSERT_EQ(b.judged.size(), 2u);
  EXPECT_EQ(b.judged[0].part, "scene");
  EXPECT_EQ(b.judged[0].verdict.tile, a.judged[0].verdict.tile);
  EXPECT_EQ(b.worst_tile(), 0.25);
  EXPECT_EQ(b.largest(), 77);
  EXPECT_EQ(b.share(), 0.01);
  EXPECT_EQ(to_json(b), to_json(a));
}

TEST(CaseResult, PanelsAndSceneAreJudgedApart) {
  io::Image baseline(64, 64), result(64, 64);
  for (std::size_t i = 0; i < baseline.rgba.size(); ++i)
    baseline.rgba[i] = result.rgba[i] = i % 4 == 3 ? 255 : 90;
  for (int x = 0; x < 8; ++x) std::fill_n(result.pixel(x, 3), 3, 250);
  Case each;
  each.size = {64, 64};
  each.panels = true;
  const measure::PixelArea scene{16, 16, 32, 32};
  auto judged = judge(each, baseline, result, scene);
  ASSERT_EQ(judged.size(), 2u);
  EXPECT_TRUE(judged[0].verdict.same);
  EXPECT_EQ(judged[0].verdict.judged, 32u * 32u);
  EXPECT_FALSE(judged[1].verdict.same);
  EXPECT_EQ(judged[1].verdict.judged, 64u * 64u - 32u * 32u);
  EXPECT_EQ(why_differs(judged).find("in the panels, the tile at 0,0 has "), 0u);
  each.limits.largest = 255;
  each.limits.share = 1;
  each.panels_threshold = -1;
  EXPECT_EQ(why_differs(judge(each, baseline, result, scene)), "");
  for (int x = 20; x < 28; ++x) std::fill_n(result.pixel(x, 20), 3, 250);
  EXPECT_EQ(why_differs(judge(each, baseline, result, scene)).find("in the scene, "), 0u);
}

/// A suite of four cases, one of each kind of end.
struct Ends {
  Ends() {
    suite.file = "folder/parts & more.toml";
    for (const char* name : {"good", "other", "none", "new"})
      suite.cases.emplace_back().name = name;
    CaseResult good, none, made;
    good.outcome = Outcome::Same;
    none.outcome = Outcome::Missing;
    none.exit_code = 3;
    none.why = "there is no baseline";
    made.outcome = Outcome::New;
    const CaseResult results[] = {good, differing(), none, made};
    for (std::size_t i = 0; i < 4; ++i) finished.push_back({&suite.cases[i], results[i]});
  }
  Suite suite;
  std::vector<Finished> finished;
};

TEST(Report, TheTableHasALineACase) {
  EXPECT_EQ(report_table(Ends().finished),
            "case   verdict  worst tile  largest   pixels    time\n"
            "good   same              -        -        -  0.00 s\n"
            "other  differs      0.2500       77  1.000 %  1.50 s\n"
            "none   missing           -        -        -  0.00 s\n"
            "new    new               -        -        -  0.00 s\n"
            "4 cases: 1 same, 1 new, 1 differs, 1 missing\n");
}

TEST(Report, JUnitTellsFailuresFromErrors) {
  const Ends ends;
  EXPECT_EQ(report_junit(ends.suite, ends.finished),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites tests=\"4\" failures=\"1\" errors=\"1\" time=\"1.5\">\n"
            "  <testsuite name=\"parts &amp; more\" tests=\"4\" failures=\"1\" errors=\"1\" "
            "time=\"1.5\">\n"
            "    <testcase classname=\"parts &amp; more\" name=\"good\" time=\"0\" />\n"
            "    <testcase classname=\"parts &amp; more\" name=\"other\" time=\"1.5\">\n"
            "      <failure type=\"differs\" message=\"the tile at 32,64 says &quot;no&quot; &amp; "
            "&lt;more>\" />\n"
            "    </testcase>\n"
            "    <testcase classname=\"parts &amp; more\" name=\"none\" time=\"0\">\n"
            "      <error type=\"missing\" message=\"there is no baseline\" />\n"
            "    </testcase>\n"
            "    <testcase classname=\"parts &amp; more\" name=\"new\" time=\"0\" />\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

}  // namespace
}  // namespace aomd::suite::suite_test
