// aomd compare: its keys, its limits and its exit codes.

#include <cmath>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_compare_test {
namespace {

constexpr const char* square = "OFF\n4 2 0\n0 0 0\n3 0 0\n3 4 0\n0 4 0\n3 0 1 2\n3 0 2 3\n";
constexpr const char* raised =
    "OFF\n4 2 0\n0 0 1\n3 0 1\n3 4 1\n0 4 1\n3 0 1 2\n3 0 2 3\n";  // by 20 % of 5
constexpr const char* turned = "OFF\n4 2 0\n0 0 0\n3 0 0\n3 4 0\n0 4 0\n3 0 2 1\n3 0 3 2\n";

class CompareCommand : public CommandLine {
 protected:
  void SetUp() override {
    put("square.off", square);
    put("raised.off", raised);
    put("turned.off", turned);
  }
  [[nodiscard]] nlohmann::json compared(const std::string& arguments) const {
    const Outcome run = aomd("compare --json " + arguments);
    EXPECT_EQ(run.err, "");
    return nlohmann::json::parse(run.out);
  }
};

TEST_F(CompareCommand, DistancesArePercentOfTheDiagonal) {
  const auto json = compared("square.off raised.off");
  EXPECT_EQ(json["schema"], 1);
  EXPECT_DOUBLE_EQ(json["diagonal"], 5);
  for (const auto& side : {json, json["original_to_result"], json["result_to_original"]})
    for (const char* key : {"hausdorff_pct", "rms_pct", "mean_pct"})
      EXPECT_NEAR(side[key], 20, 1e-12) << key;
  EXPECT_EQ(json["original_to_result"]["worst_point"][2], 0);
  EXPECT_EQ(json["original_to_result"]["nearest_point"][2], 1);
  EXPECT_NEAR(json["original_to_result"]["samples"], 500000, 1);
  EXPECT_NEAR(compared("square.off raised.off --samples 100")["result_to_original"]["samples"], 100,
              1);
}

// What is written does not depend on the number of threads, down to the last digit.
TEST_F(CompareCommand, ThreadsMakeNoDifference) {
  sample("scan", "scan.ply", 20000);
  ASSERT_EQ(aomd("decimate scan.ply coarse.ply --target-faces 3000 --quiet").code, 0);
  const std::string one = aomd("compare --json --threads 1 scan.ply coarse.ply").out;
  EXPECT_NE(one.find("hausdorff_pct"), std::string::npos);
  for (const char* threads : {"0", "2", "3", "7"})
    EXPECT_EQ(aomd(std::string("compare --json scan.ply coarse.ply --threads ") + threads).out, one)
        << threads;
  expect_failure("compare scan.ply coarse.ply --threads -1", 2, "--threads");
}

TEST_F(CompareCommand, HasEveryKey) {
  sample("box", "box.ply", 2);
  const auto json = compared("box.ply box.ply");
  for (const char* key : {"hausdorff_pct", "rms_pct", "mean_pct", "normal_dev_gt10_pct",
                          "normal_dev_gt60_pct", "flips", "self_intersections"})
    EXPECT_NEAR(json.at(key), 0, 1e-9) << key;
  EXPECT_EQ(json["euler"], 2);
  EXPECT_NEAR(json["min_angle_mean_deg"], 45, 1e-9);
  EXPECT_EQ(json["faces_below_10deg_pct"], 0);
  EXPECT_EQ(json["original"]["faces"], 48);
  EXPECT_EQ(json["result"]["self_intersections"], 0);
  EXPECT_TRUE(json["objections"].empty());
}

TEST_F(CompareCommand, FlipsAndNormals) {
  const auto json = compared("square.off turned.off");
  EXPECT_EQ(json["flips"], 2);
  EXPECT_EQ(json["normal_dev_gt10_pct"], 100);
  EXPECT_EQ(json["normal_dev_gt60_pct"], 100);
}

TEST_F(CompareCommand, LimitsSayNoWithCode1) {
  const std::string raise = "compare square.off raised.off ";
  EXPECT_EQ(aomd(raise).code, 0);
  EXPECT_EQ(
      aomd(raise +
           "--max-distance 20.1 --max-rms 20.1 --max-flips 0 --max-intersections 0 --same-topology")
          .code,
      0);
  for (const char* limit : {"--max-distance 19.9", "--max-rms 19.9"}) {
    const Outcome run = aomd(raise + limit);
    EXPECT_EQ(run.code, 1) << limit;
    EXPECT_NE(run.out.find("no: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("20 % is above the limit of 19.9 %"), std::string::npos) << run.out;
  }
  EXPECT_EQ(aomd("compare square.off turned.off --max-flips 2").code, 0);
  EXPECT_EQ(aomd("compare square.off turned.off --max-flips 1").code, 1);
  EXPECT_EQ(compared("square.off turned.off --max-flips 1")["objections"].size(), 1u);
}

// Each differs from the square in one thing that is asked for.
TEST_F(CompareCommand, SameTopology) {
  const std::string
      corners = "0 0 0\n1 0 0\n2 0 0\n2 1 0\n2 2 0\n1 1 0\n7 7 0\n8 7 0\n7 8 0\n",
      ring = "3 0 1 5\n3 1 2 3\n3 3 4 5\n";  // three triangles, each touches the next in a vertex
  put("half.off", "OFF\n3 1 0\n0 0 0\n3 0 0\n3 4 0\n3 0 1 2\n");
  put("ring.off", "OFF\n9 3 0\n" + corners + ring);
  put("ring_and_one.off", "OFF\n9 4 0\n" + corners + ring + "3 6 7 8\n");
  put("book.off", "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n-1 1 0\n-1 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  sample("torus", "torus.ply", 12);
  EXPECT_EQ(aomd("compare square.off half.off --same-topology").code, 0);
  EXPECT_EQ(aomd("compare square.off ring.off --same-topology").code, 1) << "Euler number";
  EXPECT_EQ(aomd("compare square.off ring_and_one.off --same-topology").code, 1) << "components";
  EXPECT_EQ(aomd("compare square.off book.off --same-topology").code, 1) << "non-manifold edge";
  EXPECT_EQ(aomd("compare torus.ply ring.off --same-topology").code, 1) << "closed and open";
}

TEST_F(CompareCommand, IntersectionsOfTheResult) {
  put("through.off", "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n2 1 1\n3 0 1 2\n3 3 4 5\n");
  EXPECT_EQ(aomd("compare square.off through.off --max-intersections 1").code, 0);
  EXPECT_EQ(aomd("compare square.off through.off --max-intersections 0").code, 1);
  EXPECT_EQ(aomd("compare through.off square.off --max-intersections 0").code, 0);
}

// In percent of nothing every distance is too large.
TEST_F(CompareCommand, AnOriginalWithoutSize) {
  put("point.off", "OFF\n3 1 0\n1 1 0\n1 1 0\n1 1 0\n3 0 1 2\n");
  EXPECT_EQ(aomd("compare point.off point.off --max-distance 0").code, 0);
  EXPECT_EQ(aomd("compare point.off square.off --max-distance 100").code, 1);
  EXPECT_TRUE(compared("point.off square.off")["hausdorff_pct"].is_null());
}

// A distance whose square is no number would pass for none.
TEST_F(CompareCommand, SizesThatCannotBeMeasuredAreRefused) {
  for (const char* size : {"1e19", "1e160", "1e-21", "1e-200"}) {
    const std::string n = size;
    put("t.off", "OFF\n3 1 0\n0 0 0\n" + n + " 0 0\n0 " + n + " 0\n3 0 1 2\n");
    for (const char* files : {"square.off t.off", "t.off square.off"})
      expect_failure(std::string("compare --max-distance 1 ") + files, 5,
                     "t.off: Only meshes from 1e-20 to 1e+18 across can be compared");
  }
  put("far.off", "OFF\n4 1 0\n0 0 0\n4 0 0\n0 4 0\n1e300 0 0\n3 0 1 2\n");
  EXPECT_EQ(aomd("compare far.off far.off --max-distance 1e-9").code, 0) << "nothing uses vertex 3";
}

TEST_F(CompareCommand, TheTextShowsBothSurfaces) {
  const Outcome run = aomd("compare square.off turned.off");
  for (const char* part :
       {"original to result", "result to original", "than 90 deg", "Euler number"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part;
}

TEST_F(CompareCommand, FailuresHaveTheirCodes) {
  put("points.off", "OFF\n2 0 0\n0 0 0\n1 1 1\n");
  expect_failure("compare square.off", 2, "RESULT");
  expect_failure("compare square.off raised.off --samples 0", 2, "--samples");
  expect_failure("compare square.off raised.off --max-rms -1", 2, "--max-rms");
  expect_failure("compare square.off missing.off", 3, "missing.off");
  expect_failure("compare points.off square.off", 3, "points.off: has no faces to compare");
  expect_failure("compare square.off points.off", 3, "points.off: has no faces to compare");
}

TEST_F(CompareCommand, SharedBunnyAgainstItselfDecimated) {
  const std::string bunny = AOMD_SHARED_DATA "/bunny.ply";
  if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "shared data is not here";
  ASSERT_EQ(aomd("decimate '" + bunny + "' o.ply --report r.json --quiet").code, 0);
  const auto report = json("r.json"), result = compared("'" + bunny + "' o.ply --samples 100000");
  EXPECT_EQ(result["flips"], report["findings"]["flips"]);
  EXPECT_EQ(result["self_intersections"], report["findings"]["self_intersections"]);
  EXPECT_EQ(result["euler"], report["output"]["euler"]);
  EXPECT_EQ(result["min_angle_mean_deg"], report["quality"]["min_angle_mean_deg"]);
  EXPECT_GT(result["rms_pct"], 0);
  EXPECT_LT(result["rms_pct"], result["hausdorff_pct"]);
}

}  // namespace
}  // namespace aomd::test::cli_compare_test
