// aomd decimate and replay: reports, journals, and the figures of the bunny and the
// dragon.

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_decimate_test {
namespace {

class DecimateCommand : public CommandLine {
 protected:
  /// Decimates a file of the shared data and returns the report; skips the test where the data is
  /// not there.
  nlohmann::json decimate_shared(const std::string& name, const std::string& options) const {
    const Outcome run =
        aomd("decimate '" AOMD_SHARED_DATA "/" + name + "' out.ply --report r.json " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return json("r.json");
  }
};

bool have(const std::string& name) {
  return std::filesystem::exists(std::string(AOMD_SHARED_DATA "/") + name);
}

TEST_F(DecimateCommand, WrongOptionsAreCode2) {
  sample("sphere", "s.ply", 2);
  for (const char* wrong : {"--factor 0", "--factor -1", "--factor x", "--angle 0", "--angle 180",
                            "--feature-angle 200", "--improve -1", "--topology loose",
                            "--strategy best", "--coarsest --factor 2", "--target-faces -10",
                            "--regularity 2", "--snap cad", "--processes 2"}) {
    const Outcome run = aomd(std::string("decimate s.ply o.ply ") + wrong);
    EXPECT_EQ(run.code, 2) << wrong << ": " << run.err;
    EXPECT_EQ(run.err.rfind("aomd: ", 0), 0u) << run.err;
  }
  EXPECT_FALSE(exists("o.ply"));
}

TEST_F(DecimateCommand, FailuresHaveTheirCodes) {
  sample("sphere", "s.ply", 2);
  expect_failure("decimate missing.ply o.ply", 3, "missing.ply");
  expect_failure("decimate s.ply o.step", 4, "o.step");
  std::filesystem::create_symlink("/dev/full", at("full.ply"));
  expect_failure("decimate s.ply full.ply", 4, "full.ply");
  expect_failure("decimate s.ply o.ply --report /dev/full", 4, "/dev/full");
}

TEST_F(DecimateCommand, QuadsAreRefusedWithASentence) {
  put("q.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 "
      "0\n$EndNodes\n"
      "$Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n");
  expect_failure("decimate q.msh o.msh", 5, "Only triangles can be decimated");
  EXPECT_FALSE(exists("o.msh"));
}

TEST_F(DecimateCommand, SizesThatCannotBeComputedWithAreRefused) {
  for (const char* size : {"1e20", "1e300", "1e-21", "1e-300"}) {
    const std::string n = size;
    put("t.off", "OFF\n4 4 0\n0 0 0\n" + n + " 0 0\n0 " + n + " 0\n0 0 " + n +
                     "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    for (const char* strategy : {"quality", "paper"})
      expect_failure(std::string("decimate t.off o.off --strategy ") + strategy, 5,
                     "Only meshes from 1e-20 to 1e+18 across can be decimated");
  }
  EXPECT_FALSE(exists("o.off"));
  put("flat.off", "OFF\n3 1 0\n5 5 5\n5 5 5\n5 5 5\n3 0 1 2\n");
  EXPECT_EQ(aomd("decimate flat.off o.off").code, 0) << "a point has no size";
}

// A square of 2 x 2 cells whose file puts all vertices on the model face, the border's too: it is
// refused, or its border is found; no result is ever at odds with verify.
TEST_F(DecimateCommand, NothingIsWrittenThatCheckFindsFaultWith) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n9\n";
  for (int v = 0; v < 9; ++v)
    text += std::to_string(v % 3) + ' ' + std::to_string(v / 3) + " 0 5\n";
  text += "Triangles\n8\n";
  for (const int v : {1, 2, 4, 5})
    for (const auto& t : {std::array{0, 1, 4}, {0, 4, 3}})
      text += std::to_string(v + t[0]) + ' ' + std::to_string(v + t[1]) + ' ' +
              std::to_string(v + t[2]) + " 5\n";
  put("grid.mesh", text + "End\n");
  for (const char* command :
       {"decimate grid.mesh o.ply --coarsest",
        "decimate grid.mesh o.ply --coarsest --strategy paper",
        "decimate grid.mesh o.ply --target-faces 2", "classify grid.mesh o.ply"}) {
    std::filesystem::remove(at("o.ply"));
    const Outcome run = aomd(command);
    EXPECT_TRUE(run.code == 0 || run.code == 3) << command << ": " << run.err;
    EXPECT_EQ(exists("o.ply"), run.code == 0) << command;
    if (run.code == 0) {
      EXPECT_EQ(aomd("check o.ply").code, 0) << command;
    }
  }
}

TEST_F(DecimateCommand, ReportHasEveryKey) {
  sample("scan", "s.ply", 3000);
  const Outcome run = aomd("decimate s.ply o.ply --factor 2 --report r.json --journal j");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("Euler number 2 kept"), std::string::npos) << run.out;
  const auto report = json("r.json");
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["stopped"], nlohmann::json({{"why", "done"},
                                               {"refused", nlohmann::json::object()},
                                               {"would_help", nullptr},
                                               {"help", nlohmann::json::object()},
                                               {"let_go", nlohmann::json::array()},
                                               {"error_pct", nullptr},
                                               {"tries", nullptr}}));
  for (const char* side : {"input", "output"})
    for (const char* key :
         {"file", "vertices", "unused_vertices", "edges", "faces", "regions", "boundary_edges",
          "nonmanifold_edges", "components", "euler", "by_shape", "by_class"})
      EXPECT_TRUE(report[side].contains(key)) << side << '.' << key;
  EXPECT_LT(report["output"]["faces"], report["input"]["faces"]);
  EXPECT_EQ(report["output"]["euler"], report["input"]["euler"]);
  EXPECT_EQ(report["options"]["factor"], 2);
  double parts = 0;
  for (const char* key : {"read", "classify", "adjacency", "decimate", "check", "write"}) {
    EXPECT_GE(report["seconds"][key], 0) << key;
    parts += report["seconds"][key].get<double>();
  }
  EXPECT_LE(parts, report["seconds"]["total"]);
  for (const char* key : {"mesh", "adjacency", "journal", "decimate_peak", "peak"})
    EXPECT_GT(report["memory_bytes"][key], 0) << key;
  ASSERT_FALSE(report["sweeps"].empty());
  for (const char* key : {"collapses", "swaps", "smooths", "faces", "regions", "refused"})
    EXPECT_TRUE(report["sweeps"][0].contains(key)) << key;
  for (const char* reason : {"Spacing", "Classification", "Topology", "Flat", "Angle"})
    EXPECT_TRUE(report["sweeps"][0]["refused"].contains(reason)) << reason;
  EXPECT_EQ(report["sweeps"].back()["faces"], report["output"]["faces"]);
  for (const char* key : {"min_angle_mean_deg", "min_angle_worst_deg", "faces_below_10deg_pct",
                          "min_dihedral_deg", "worst_region"})
    EXPECT_TRUE(report["quality"].contains(key)) << key;
  for (const char* key : {"flips", "self_intersections", "verify"})
    EXPECT_EQ(report["findings"][key], 0) << key;
}

TEST_F(DecimateCommand, QuietPrintsNothing) {
  sample("sphere", "s.ply", 3);
  const Outcome run = aomd("decimate s.ply o.ply --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(DecimateCommand, WritesOnlyTheClassificationThatWasGiven) {
  sample("box", "box.ply", 4);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  ASSERT_EQ(aomd("decimate box.ply classified.ply --coarsest").code, 0);
  ASSERT_EQ(aomd("decimate bare.off bare.ply --coarsest").code, 0);
  EXPECT_TRUE(io::read(at("classified.ply")).mesh.classified());
  EXPECT_FALSE(io::read(at("bare.ply")).mesh.classified());
  EXPECT_EQ(io::read(at("bare.ply")).mesh.faces.size(), 12u);
}

TEST_F(DecimateCommand, FeatureAngleOffLosesTheEdgesOfABox) {
  sample("box", "box.ply", 4);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  ASSERT_EQ(
      aomd("decimate bare.off o.ply --feature-angle off --coarsest --angle 60 --report r.json")
          .code,
      0);
  EXPECT_EQ(json("r.json")["input"]["by_class"]["1"], 0);
  EXPECT_TRUE(json("r.json")["options"]["feature_angle_deg"].is_null());
}

TEST_F(DecimateCommand, ReplayGivesTheSameBytes) {
  for (const char* format : {"ply", "off"}) {
    sample("scan", "s.ply", 2000);
    const std::string in = std::string("in.") + format;
    ASSERT_EQ(aomd("convert s.ply " + in).code, 0);
    ASSERT_EQ(aomd("decimate " + in + " o.ply --journal j --factor 3").code, 0);
    const Outcome replay = aomd("replay " + in + " j o2.ply");
    ASSERT_EQ(replay.code, 0) << replay.err;
    EXPECT_EQ(text("o.ply"), text("o2.ply"));
  }
}

// Where an edge has no face, and where all edges are model edges, a decimation keeps all edges.
TEST_F(DecimateCommand, ReplayGivesTheSameBytesWhateverEdgesThereAre) {
  sample("sphere", "s.obj", 8);
  put("wires.obj", text("s.obj") + "l 1 200\nl 5 300\n");
  // Two slivers: each of their middle vertices lies on a border that is nearly straight.
  put("all.off",
      "OFF\n7 2 0\n0 0 0\n1 0.001 0\n2 0 0\n5 0 0\n6 0.001 0\n7 0 0\n9 9 9\n3 0 2 1\n3 3 5 4\n");
  for (const char* in : {"wires.obj", "all.off"})
    for (const char* options : {"--factor 3", "--factor 3 --strategy paper",
                                "--coarsest --angle 90", "--coarsest --topology paper"}) {
      const std::string file = in;
      ASSERT_EQ(aomd("decimate " + file + " o.ply --journal j " + options).code, 0) << options;
      const Outcome replay = aomd("replay " + file + " j o2.ply");
      ASSERT_EQ(replay.code, 0) << in << ' ' << options << ": " << replay.err;
      EXPECT_EQ(text("o.ply"), text("o2.ply")) << in << ' ' << options;
    }
}

TEST_F(DecimateCommand, ReplayStopsAtAStep) {
  sample("torus", "t.ply", 16);
  ASSERT_EQ(aomd("decimate t.ply o.ply --journal j --coarsest --no-swap --no-smooth --angle 60 "
                 "--feature-angle off")
                .code,
            0);
  const std::size_t faces = io::read(at("t.ply")).mesh.faces.size();
  ASSERT_EQ(aomd("replay t.ply j t0.ply --step 0").code, 0);
  EXPECT_EQ(io::read(at("t0.ply")).mesh.faces.size(), faces);
  ASSERT_EQ(aomd("replay t.ply j t3.ply --step 3").code, 0);
  EXPECT_EQ(io::read(at("t3.ply")).mesh.faces.size(), faces - 6);
  expect_failure("replay t.ply j t4.ply --step 1000000", 2, "the journal has");
  EXPECT_FALSE(exists("t4.ply"));
}

TEST_F(DecimateCommand, ForeignJournalsAreRefused) {
  sample("torus", "t.ply", 16);
  sample("torus", "other.ply", 18);
  ASSERT_EQ(aomd("decimate t.ply o.ply --journal j").code, 0);
  expect_failure("replay other.ply j x.ply", 3, "another mesh");
  expect_failure("replay t.ply t.ply x.ply", 3, "is no journal");
  put("cut", text("j").substr(0, text("j").size() / 2));
  expect_failure("replay t.ply cut x.ply", 3, "byte");
  EXPECT_FALSE(exists("x.ply"));
}

TEST_F(DecimateCommand, BunnyCoarsest) {
  if (!have("bunny.ply")) GTEST_SKIP() << "shared data is not here";
  const auto report = decimate_shared("bunny.ply", "--strategy paper --coarsest --angle 10");
  EXPECT_LE(report["output"]["faces"], 3300);
  EXPECT_EQ(report["input"]["euler"], -3);
  EXPECT_EQ(report["output"]["euler"], -3);
  EXPECT_EQ(report["output"]["unused_vertices"], 1113);
  EXPECT_EQ(report["findings"]["self_intersections"], 0);
  EXPECT_LE(report["findings"]["flips"], 2);
  EXPECT_EQ(report["findings"]["verify"], 0);
}

TEST_F(DecimateCommand, BunnyFactorsAreNearThePaper) {
  if (!have("bunny.ply")) GTEST_SKIP() << "shared data is not here";
  EXPECT_NEAR(decimate_shared("bunny.ply", "--strategy paper --factor 4")["output"]["faces"], 6837,
              0.15 * 6837);
  EXPECT_NEAR(decimate_shared("bunny.ply", "--strategy paper --factor 8")["output"]["faces"], 3645,
              0.15 * 3645);
}

// Each row of three is beaten by no tool that was measured in all of distance, shape, flips and
// intersections.
TEST_F(DecimateCommand, BunnyQualityKeepsItsFigures) {
  if (!have("bunny.ply")) GTEST_SKIP() << "shared data is not here";
  struct Row {
    const char* regularity;
    double rms, hausdorff, angle, slivers;
  };
  for (const Row& row : {Row{"0", 0.0326, 0.4, 33.4, 2.2}, Row{"0.5", 0.0435, 0.4, 42, 0.3},
                         Row{"1", 0.0515, 0.5, 46.2, 0.15}}) {
    SCOPED_TRACE(row.regularity);
    const auto report = decimate_shared(
        "bunny.ply", std::string("--target-faces 3069 --regularity ") + row.regularity);
    EXPECT_LE(report["output"]["faces"], 3069);
    EXPECT_GE(report["output"]["faces"], 3038);
    EXPECT_EQ(report["output"]["euler"], -3);
    EXPECT_EQ(report["findings"]["self_intersections"], 0);
    EXPECT_EQ(report["findings"]["flips"], 0);
    const Outcome compared = aomd("compare --json '" AOMD_SHARED_DATA "/bunny.ply' out.ply");
    const auto distance = nlohmann::json::parse(compared.out);
    EXPECT_LE(distance["rms_pct"], row.rms);
    EXPECT_LE(distance["hausdorff_pct"], row.hausdorff);
    EXPECT_GE(distance["min_angle_mean_deg"], row.angle);
    EXPECT_LE(distance["faces_below_10deg_pct"], row.slivers);
  }
}

TEST_F(DecimateCommand, DragonFinishesInBothTopologies) {
  if (!have("dragon.ply")) GTEST_SKIP() << "shared data is not here";
  EXPECT_LE(decimate_shared("dragon.ply",
                            "--strategy paper --coarsest --topology paper")["output"]["faces"],
            18306);
  EXPECT_EQ(decimate_shared("dragon.ply", "--strategy paper --coarsest")["findings"]["verify"], 0);
}

}  // namespace
}  // namespace aomd::test::cli_decimate_test
