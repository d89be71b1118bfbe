// aomd decimate: spacing, what stays, what is guaranteed, and repair before.

#include <algorithm>
#include <cmath>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_decimate_options_test {
namespace {

class DecimateOptionsCommand : public CommandLine {
 protected:
  nlohmann::json decimate(const std::string& in, const std::string& options) const {
    const Outcome run = aomd("decimate " + in + " o.ply --report r.json " + options);
    EXPECT_EQ(run.code, 0) << options << ": " << run.err;
    return json("r.json");
  }
  [[nodiscard]] MeshData mesh(const std::string& name) const { return io::read(at(name)).mesh; }
  /// Which vertices of the input are no longer where they were.
  [[nodiscard]] std::vector<std::size_t> moved(const MeshData& in,
                                               const std::vector<std::size_t>& ids) const {
    const MeshData out = mesh("o.ply");
    std::vector<std::size_t> result;
    for (const std::size_t id : ids)
      if (std::count(out.positions.begin(), out.positions.end(), in.positions[id]) != 1)
        result.push_back(id);
    return result;
  }
};

/// How many faces have their centre at x < 0, and how many beyond.
std::array<double, 2> faces_by_side(const MeshData& mesh) {
  std::array<double, 2> count{};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += mesh.positions[mesh.faces.vertices[3 * f + k]].x;
    ++count[x < 0 ? 0 : 1];
  }
  return count;
}

TEST_F(DecimateOptionsCommand, WrongOptionsAreCode2AndSayWhatWouldBeRight) {
  sample("sphere", "s.ply", 2);
  expect_failure("decimate s.ply o.ply --min-angle 61", 2, "between 0 and 60, not 61");
  expect_failure("decimate s.ply o.ply --min-angle -1", 2, "--min-angle");
  expect_failure("decimate s.ply o.ply --min-dihedral 71", 2, "between 0 and 70, not 71");
  expect_failure("decimate s.ply o.ply --min-dihedral -1", 2, "--min-dihedral");
  for (const std::string deg : {"10", "0"})
    expect_failure(
        "decimate s.ply o.ply --min-dihedral " + deg, 2,
        "--min-dihedral is for volumes, and s.ply has no regions: --min-angle limits the "
        "angles of faces");
  expect_failure("decimate s.ply o.ply --max-distance 0", 2, "a number above 0, not 0");
  expect_failure("decimate s.ply o.ply --target-faces 9 --factor 2", 2, "--factor");
  expect_failure("decimate s.ply o.ply --spacing h --factor 2", 2, "--factor excludes --spacing");
  expect_failure("decimate s.ply o.ply --spacing h --coarsest", 2, "--coarsest excludes --spacing");
  expect_failure("decimate s.ply o.ply --gradation 0.3", 2, "--gradation requires --spacing");
  expect_failure("decimate s.ply o.ply --spacing h --gradation 0", 2, "a number above 0, not 0");
  expect_failure("decimate s.ply o.ply --spacing '2 *'", 2,
                 "--spacing: spacing \"2 *\", character 4");
  expect_failure("decimate s.ply o.ply --spacing nofile.txt", 2, "there is no such file");
  expect_failure("decimate s.ply o.ply --threads -1", 2, "--threads");
  expect_failure("decimate s.ply o.ply --threads two", 2, "--threads");
  expect_failure("decimate s.ply o.ply --spacing x", 2, "must be positive and finite");
  EXPECT_FALSE(exists("o.ply"));
}

TEST_F(DecimateOptionsCommand, WrongFilesAreCode3WithTheirLine) {
  sample("sphere", "s.ply", 1);  // 12 vertices
  const auto refused = [&](const char* option, const char* content, const std::string& why) {
    put("list.txt", content);
    expect_failure(std::string("decimate s.ply o.ply ") + option + " list.txt", 3,
                   "list.txt:" + why);
  };
  refused("--spacing", "1 2 3\n", "2: the file ends after 3 spacings; the mesh has 12 vert");
  refused("--spacing", "1 2\n-3\n", "2: a spacing must be positive, not -3");
  refused("--keep", "3\n\n# all right so far\n12\n",
          "4: there is no vertex 12: the mesh has 12, counted from 0");
  refused("--keep", "3-99999999999\n", "1: there is no vertex 99999999999");
  refused("--keep", "3\n7-5\n", "2: the range \"7-5\" ends before it begins");
  refused("--keep", "-5\n",
          "1: expected a vertex, a range like 10-20 or a model entity like face 2, found \"-5\"");
  refused("--keep", "1 2\n", "1: unexpected \"2\"");
  refused("--keep", "face\n", "1: the line ends before the tag of a model entity");
  refused("--keep", "face x\n", "1: expected a whole number for the tag");
  refused("--keep", "0\nface 1\nedge 99\n", "3: nothing lies on model edge 99");
  refused("--keep", "face 999999999\n", "1: no model entity has such a tag");
  refused("--keep", "region 1\n", "1: nothing lies on model region 1");
  refused("--keep", "solid 1\n", "1: expected a vertex");
  expect_failure("decimate s.ply o.ply --keep missing.txt", 3, "missing.txt");
  EXPECT_FALSE(exists("o.ply"));
}

TEST_F(DecimateOptionsCommand, WordsInAnyCaseAndPercentsWithTheirSign) {
  sample("sphere", "s.ply", 6);
  const std::string plain = "--strategy paper --topology safe --feature-angle off --max-distance 5";
  const auto options = decimate("s.ply", plain)["options"];
  const std::string faces = text("o.ply");
  EXPECT_EQ(decimate("s.ply",
                     "--strategy Paper --topology SAFE --feature-angle OFF "
                     "--max-distance 5%")["options"],
            options);
  EXPECT_EQ(text("o.ply"), faces);
  expect_failure("decimate s.ply n.ply --max-distance %", 2, "must be a number above 0, not %");
  expect_failure("decimate s.ply n.ply --max-distance 5%%", 2, "must be a number above 0, not 5%");
}

/// As meshes are: with a byte order mark, any line ends and an end as in DOS.
TEST_F(DecimateOptionsCommand, ListsAreReadAsOtherTextIs) {
  sample("scan", "s.ply", 100);
  put("plain", "3\n7\n");
  put("other", "\xef\xbb\xbf# kept\r\n\r\n3\r\r7 # too\r\n\x1a");
  decimate("s.ply", "--keep plain");
  const std::string faces = text("o.ply");
  decimate("s.ply", "--keep other");
  EXPECT_EQ(text("o.ply"), faces);
}

TEST_F(DecimateOptionsCommand, ListedVerticesStayWhereTheyAre) {
  sample("scan", "s.ply", 3000);
  const MeshData in = mesh("s.ply");
  std::vector<std::size_t> ids = {3, 1000};
  for (std::size_t id = 200; id <= 260; ++id) ids.push_back(id);
  for (const char* strategy : {"paper", "quality"}) {
    const std::string options = std::string("--target-faces 500 --strategy ") + strategy;
    decimate("s.ply", options);
    EXPECT_GT(moved(in, ids).size(), 40u) << "they would have gone: " << strategy;
    put("keep.txt", "# what stays\n3\n200-260 # a range\n1000");
    EXPECT_EQ(decimate("s.ply", options + " --keep keep.txt")["options"]["keep"], "keep.txt");
    EXPECT_EQ(moved(in, ids), std::vector<std::size_t>()) << strategy;
  }
}

TEST_F(DecimateOptionsCommand, AListedModelEntityKeepsAllVerticesOfWhatLiesOnIt) {
  sample("box", "box.ply", 4);
  const MeshData in = mesh("box.ply");
  const ModelRef chosen = in.faces.classes.front();
  std::vector<std::size_t> on, off;
  for (std::size_t f = 0; f < in.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (in.faces.classes[f] == chosen) on.push_back(in.faces.vertices[3 * f + k]);
  put("keep.txt", "face " + std::to_string(chosen.tag()) + "\n");
  decimate("box.ply", "--strategy paper --coarsest --keep keep.txt");
  EXPECT_EQ(moved(in, on), std::vector<std::size_t>());
  const MeshData out = mesh("o.ply");
  // The face's 25 vertices, its model edges' among them, and the 4 corners opposite.
  EXPECT_EQ(out.positions.size(), 29u);
}

// A face of the box has 9 of the 98 vertices inside it; the 16 on its model edges are not listed.
TEST_F(DecimateOptionsCommand, OnlyWhatLiesOnAListedModelEntityGoesOrMoves) {
  sample("box", "box.ply", 4);
  const MeshData in = mesh("box.ply");
  ASSERT_EQ(in.positions.size(), 98u);
  const int tag = in.faces.classes.front().tag();
  put("only.txt", "face " + std::to_string(tag) + "\n");
  for (const char* strategy : {"paper", "quality"}) {
    const auto report =
        decimate("box.ply", std::string("--coarsest --only only.txt --strategy ") + strategy);
    EXPECT_EQ(report["options"]["only"], "only.txt");
    EXPECT_EQ(mesh("o.ply").positions.size(), 89u) << strategy;
  }
  put("keep.txt", "face " + std::to_string(tag) + "\n");
  decimate("box.ply", "--coarsest --only only.txt --keep keep.txt");
  EXPECT_EQ(mesh("o.ply").positions.size(), 98u);
  put("only.txt", "face 77\n");
  expect_failure("decimate box.ply x.ply --only only.txt", 3, "1: nothing lies on model face 77");
}

TEST_F(DecimateOptionsCommand, AFormulaMakesOneSideCoarser) {
  sample("sphere", "s.ply", 24);
  for (const char* strategy : {"paper", "quality"}) {
    SCOPED_TRACE(strategy);
    const auto report =
        decimate("s.ply", std::string("--spacing 'x < 0 ? 2 * h : 6 * h' --angle 60 --strategy ") +
                              strategy);
    EXPECT_EQ(report["options"]["spacing"], "x < 0 ? 2 * h : 6 * h");
    EXPECT_TRUE(report["options"]["factor"].is_null());
    EXPECT_TRUE(report["options"]["gradation"].is_null());
    const auto [fine, coarse] = faces_by_side(mesh("o.ply"));
    EXPECT_GT(fine, 4 * coarse);
    EXPECT_GT(coarse, 20);
  }
}

TEST_F(DecimateOptionsCommand, GradationLimitsHowFastTheSpacingGrows) {
  sample("sphere", "s.ply", 24);
  const std::string jump = "--spacing 'x < 0 ? 0.1 : 0.6' ";
  const auto free = decimate("s.ply", jump);
  const auto limited = decimate("s.ply", jump + "--gradation 0.2");
  EXPECT_EQ(limited["options"]["gradation"], 0.2);
  EXPECT_GT(limited["output"]["faces"], free["output"]["faces"].get<int>() + 100);
  EXPECT_EQ(decimate("s.ply", "--spacing curvature")["options"]["gradation"], 0.3);
}

TEST_F(DecimateOptionsCommand, ASpacingFileIsOneNumberAVertex) {
  sample("sphere", "s.ply", 24);
  const MeshData in = mesh("s.ply");
  std::string fine, coarse;
  for (std::size_t v = 0; v < in.positions.size(); ++v) fine += "0.001\n", coarse += "0.4 ";
  put("fine.txt", fine);
  put("coarse.txt", coarse);
  const auto faces = [&](const char* file) {
    const auto report = decimate("s.ply", std::string("--strategy paper --spacing ") + file);
    return report["output"]["faces"].get<std::size_t>();
  };
  EXPECT_EQ(faces("fine.txt"), in.faces.size());
  EXPECT_LT(faces("coarse.txt"), in.faces.size() / 4);
}

TEST_F(DecimateOptionsCommand, ThreadsMakeNoDifference) {
  sample("scan", "s.ply", 20000);
  EXPECT_EQ(decimate("s.ply", "--target-faces 4000 --threads 1")["options"]["threads"], 1);
  const std::string one = text("o.ply");
  const auto sweeps = json("r.json")["sweeps"];
  for (const char* threads : {"", " --threads 0", " --threads 2", " --threads 3", " --threads 7"}) {
    const auto report = decimate("s.ply", std::string("--target-faces 4000") + threads);
    EXPECT_GE(report["options"]["threads"], 1) << threads;
    EXPECT_TRUE(text("o.ply") == one) << threads;
    EXPECT_EQ(report["sweeps"], sweeps) << threads;
  }
  EXPECT_EQ(aomd("decimate s.ply o.ply --target-faces 4000 --threads 2 --journal j.aomd").code, 0);
  EXPECT_TRUE(text("o.ply") == one) << "with a journal";
  const std::string journal = text("j.aomd");
  EXPECT_EQ(aomd("decimate s.ply o.ply --target-faces 4000 --threads 1 --journal j.aomd").code, 0);
  EXPECT_TRUE(text("j.aomd") == journal);
}

TEST_F(DecimateOptionsCommand, MinAngleHolds) {
  sample("sphere", "s.ply", 24);
  EXPECT_LT(
      decimate("s.ply",
               "--strategy paper --target-faces 500 --no-smooth")["quality"]["min_angle_worst_deg"],
      25);
  for (const char* options :
       {"--strategy paper --target-faces 500 --no-smooth", "--target-faces 500"}) {
    const auto report = decimate("s.ply", std::string(options) + " --min-angle 27");
    EXPECT_GE(report["quality"]["min_angle_worst_deg"], 27) << options;
    EXPECT_EQ(report["options"]["min_angle_deg"], 27);
  }
  EXPECT_GT(json("r.json")["sweeps"][0]["refused"].count("Shape"), 0u);
}

TEST_F(DecimateOptionsCommand, MaxDistanceHolds) {
  sample("scan", "s.ply", 3000);
  const auto distance = [&](const std::string& options) {
    decimate("s.ply", "--target-faces 200 --strategy " + options);
    const Outcome compared = aomd("compare --json s.ply o.ply");
    return nlohmann::json::parse(compared.out)["result_to_original"]["hausdorff_pct"].get<double>();
  };
  for (const std::string strategy : {"paper --angle 60", "quality"}) {
    EXPECT_GT(distance(strategy), 0.6) << strategy;
    EXPECT_LE(distance(strategy + " --max-distance 0.4"), 0.4) << strategy;
    EXPECT_EQ(json("r.json")["options"]["max_distance_pct"], 0.4);
  }
}

TEST_F(DecimateOptionsCommand, EveryReasonAndOptionIsInTheReport) {
  sample("sphere", "s.ply", 8);
  const auto report = decimate("s.ply", "");
  for (const char* reason : {"Spacing", "Classification", "Topology", "Flat", "Angle", "Quality",
                             "Kept", "Shape", "Distance", "Intersection"})
    EXPECT_TRUE(report["sweeps"][0]["refused"].contains(reason)) << reason;
  for (const char* option : {"strategy",
                             "regularity",
                             "target_faces",
                             "factor",
                             "coarsest",
                             "spacing",
                             "gradation",
                             "angle_deg",
                             "min_angle_deg",
                             "min_dihedral_deg",
                             "max_distance_pct",
                             "no_intersections",
                             "feature_angle_deg",
                             "improve",
                             "exchange",
                             "swap",
                             "smooth",
                             "threads",
                             "topology",
                             "keep",
                             "snap",
                             "model",
                             "repair",
                             "journal"})
    EXPECT_TRUE(report["options"].contains(option)) << option;
  EXPECT_TRUE(report["repair"].is_null());
}

// A square of two triangles, a copy of the first, a pocket on its lower side.
constexpr const char* dirty =
    "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 -1 0\n"
    "3 0 1 2\n3 0 2 3\n3 1 2 0\n3 0 1 4\n3 1 0 4\n";

TEST_F(DecimateOptionsCommand, RepairSaysWhatItDid) {
  put("d.off", dirty);
  const Outcome run = aomd("decimate d.off o.off --repair --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err,
            "aomd: note: d.off: 2 faces in coincident pairs of opposite orientation removed (faces "
            "3, 4)\n"
            "aomd: note: d.off: 1 repeated face removed (face 2)\n");
  const auto report = json("r.json");
  ASSERT_EQ(report["repair"]["done"].size(), 2u);
  EXPECT_EQ(report["repair"]["done"][1]["name"], "repeated faces");
  EXPECT_EQ(report["repair"]["done"][1]["first_faces"], std::vector<int>{2});
  EXPECT_TRUE(report["repair"]["left"].empty());
  EXPECT_EQ(report["output"]["faces"], 2);
  EXPECT_EQ(aomd("decimate d.off o.off --repair --quiet").err, "");
  ASSERT_EQ(aomd("decimate d.off o.off --quiet").code, 0);
  EXPECT_EQ(mesh("o.off").faces.size(), 5u) << "without --repair nothing is mended";
}

TEST_F(DecimateOptionsCommand, AReplayRepairsAsTheDecimationDid) {
  sample("sphere", "s.off", 8);
  std::string text_of_sphere = text("s.off");
  const std::size_t faces = mesh("s.off").faces.size();
  const std::string count = " " + std::to_string(faces) + " ";
  text_of_sphere.replace(text_of_sphere.find(count), count.size(),
                         " " + std::to_string(faces + 1) + " ");
  put("d.off", text_of_sphere + text_of_sphere.substr(text_of_sphere.rfind("\n3 ") + 1));
  ASSERT_EQ(aomd("decimate d.off o.ply --repair --journal j --quiet").code, 0);
  expect_failure("replay d.off j again.ply", 3, "another mesh");
  const Outcome replay = aomd("replay d.off j again.ply --repair");
  ASSERT_EQ(replay.code, 0) << replay.err;
  EXPECT_EQ(text("again.ply"), text("o.ply"));
}

}  // namespace
}  // namespace aomd::test::cli_decimate_options_test
