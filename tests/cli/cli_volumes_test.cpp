// aomd compare, info and check on meshes with regions.

#include <sstream>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_volumes_test {
namespace {

// Three tetrahedra on one face.
constexpr const char* crowded =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "0 0 -1 0\n0.3 0.3 2 0\nTetrahedra\n3\n1 2 3 4 1\n1 3 2 5 1\n1 2 3 6 1\nEnd\n";

// Two tetrahedra; the second one is on the wrong side of the face that they share.
constexpr const char* folded =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "0.1 0.1 0.1 0\nTetrahedra\n2\n1 2 3 4 1\n5 2 3 4 1\nEnd\n";

class Volumes : public CommandLine {
 protected:
  [[nodiscard]] nlohmann::json json_of(const std::string& arguments) const {
    const Outcome run = aomd(arguments);
    EXPECT_EQ(run.err, "");
    return nlohmann::json::parse(run.out);
  }
};

TEST_F(Volumes, ComparedWithThemselves) {
  sample("ball-in-box", "a.msh", 2);
  const auto json = json_of("compare --json a.msh a.msh");
  EXPECT_EQ(json["schema"], 1);
  for (const char* key : {"hausdorff_pct", "rms_pct", "flips", "self_intersections"})
    EXPECT_NEAR(json.at(key), 0, 1e-9) << key;
  ASSERT_EQ(json["model_regions"].size(), 2u);
  EXPECT_EQ(json["model_regions"][1]["tag"], 2);
  EXPECT_EQ(json["model_regions"][1]["euler"], nlohmann::json({2, 2}));
  EXPECT_EQ(json["model_regions"][1]["parts"], nlohmann::json({1, 1}));
  EXPECT_EQ(json["model_regions"][1]["volume_change_pct"], 0);
  ASSERT_EQ(json["interfaces"].size(), 2u);
  EXPECT_EQ(json["interfaces"][0]["between"], nlohmann::json({"outside", 2}));
  EXPECT_EQ(json["interfaces"][1]["between"], nlohmann::json({1, 2}));
  EXPECT_EQ(json["interfaces"][1]["faces"], nlohmann::json({96, 96}));
  ASSERT_EQ(json["model_faces"].size(), 7u);
  EXPECT_EQ(json["model_faces"][6]["model_face"], 7);
  EXPECT_EQ(json["model_vertices"]["kept"], 8);
  EXPECT_EQ(json["model_vertices"]["lost"], nlohmann::json::array());
  EXPECT_NEAR(json["model_edges"]["hausdorff_pct"], 0, 1e-9);
  const auto& volume = json["result"]["volume"];
  EXPECT_EQ(volume["inverted"], 0);
  EXPECT_EQ(volume["dihedral"]["histogram"]["counts"].size(), 18u);
  EXPECT_NEAR(volume["volume"], 8, 1e-12);
  EXPECT_EQ(json["original"]["regions"], 12 * 512);
}

TEST_F(Volumes, LimitsSayNoWithCode1) {
  sample("ball-in-box", "fine.msh", 3);
  sample("ball-in-box", "coarse.msh", 2);
  EXPECT_EQ(aomd("compare fine.msh coarse.msh --same-topology --max-flips 0").code, 0);
  const double worst = json_of("compare --json fine.msh coarse.msh")["hausdorff_pct"];
  EXPECT_GT(worst, 0.1);  // the sphere: a coarse sheet against a fine one
  const std::string limit = "compare fine.msh coarse.msh --max-distance ";
  EXPECT_EQ(aomd(limit + std::to_string(worst * 1.01)).code, 0);
  EXPECT_EQ(aomd(limit + std::to_string(worst * 0.99)).code, 1);
  sample("tet-box", "box.msh", 2);
  const Outcome run = aomd("compare coarse.msh box.msh --same-topology");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("no: the topology differs"), std::string::npos);
}

// What one of the two lacks is at no distance: no limit holds there.
TEST_F(Volumes, WhatIsLostIsBeyondEveryLimit) {
  sample("ball-in-box", "two.msh", 2);
  sample("tet-box", "one.msh", 2);
  for (const char* files : {"two.msh one.msh", "one.msh two.msh"}) {
    for (const char* limit : {"--max-distance", "--max-rms"}) {
      const Outcome run = aomd(std::string("compare ") + files + ' ' + limit + " 1000");
      EXPECT_EQ(run.code, 1) << files << ' ' << limit;
      EXPECT_NE(run.out.find("distance inf % is above the limit of 1000 %"), std::string::npos);
    }
    EXPECT_TRUE(json_of(std::string("compare --json ") + files)["hausdorff_pct"].is_null());
  }
}

// Where model faces have other tags the interfaces that they are parts of are measured.
TEST_F(Volumes, ModelFacesOfOtherTagsAreMeasuredAsInterfaces) {
  sample("tet-box", "a.mesh", 2);
  std::string other = text("a.mesh");
  const std::size_t triangles = other.find("Triangles\n"), end = other.find("Tetrahedra\n");
  std::istringstream lines(other.substr(triangles, end - triangles));
  std::string line, changed;
  for (int n = 0; std::getline(lines, line); ++n)
    changed += n < 2 || line.find(' ') == std::string::npos
                   ? line + '\n'
                   : line.substr(0, line.rfind(' ')) + " 9\n";
  put("b.mesh", other.replace(triangles, end - triangles, changed));
  const auto json = json_of("compare --json a.mesh b.mesh");
  EXPECT_EQ(json["model_faces"].size(), 7u);
  EXPECT_NEAR(json["hausdorff_pct"], 0, 1e-9);
  EXPECT_EQ(aomd("compare a.mesh b.mesh --max-distance 0.001").code, 0);
}

TEST_F(Volumes, TheTextShowsWhatChanged) {
  sample("ball-in-box", "fine.msh", 3);
  sample("ball-in-box", "coarse.msh", 2);
  const std::string out = aomd("compare fine.msh coarse.msh").out;
  for (const char* part : {"model region", "change, %", "1 | 2, face 7", "  boundary",
                           "model vertices", "smallest dihedral, deg", "648 -> 192"})
    EXPECT_NE(out.find(part), std::string::npos) << part << " in\n" << out;
}

// A volume and a surface are compared by their faces, as before.
TEST_F(Volumes, AgainstASurface) {
  sample("tet-box", "volume.msh", 2);
  sample("box", "surface.ply", 2);
  const auto json = json_of("compare --json volume.msh surface.ply");
  EXPECT_TRUE(json.contains("normal_dev_gt10_pct"));
  EXPECT_FALSE(json.contains("model_regions"));
}

TEST_F(Volumes, ThreadsMakeNoDifference) {
  sample("tet-bracket", "fine.msh", 3);
  sample("tet-bracket", "coarse.msh", 2);
  const std::string one = aomd("compare --json --threads 1 fine.msh coarse.msh").out;
  EXPECT_NE(one.find("model_regions"), std::string::npos);
  for (const char* threads : {"2", "3"})
    EXPECT_EQ(aomd(std::string("compare --json fine.msh coarse.msh --threads ") + threads).out, one)
        << threads;
}

TEST_F(Volumes, InfoListsModelRegions) {
  sample("layered-beam", "beam.vtu", 1);
  const auto json = json_of("info --json beam.vtu");
  const auto& volume = json["volume"];
  ASSERT_EQ(volume["model_regions"].size(), 3u);
  EXPECT_NEAR(volume["model_regions"][1]["volume"], 40, 1e-12);
  EXPECT_EQ(volume["model_regions"][1]["regions"], 240);
  EXPECT_NEAR(volume["dihedral"]["min_deg"], 45, 1e-9);
  EXPECT_NEAR(volume["dihedral"]["mean_deg"], 45, 1e-9);
  EXPECT_EQ(volume["dihedral"]["below_10deg_pct"], 0);
  EXPECT_NEAR(volume["shape"]["min"], volume["shape"]["mean"], 1e-12);
  EXPECT_NE(aomd("info beam.vtu").out.find("smallest angle"), std::string::npos);
  sample("box", "box.ply", 1);
  EXPECT_FALSE(json_of("info --json box.ply").contains("volume"));
}

TEST_F(Volumes, WithoutFacesThereAreNoAnglesOfFaces) {
  put("folded.mesh", folded);
  const std::string out = aomd("info folded.mesh").out;
  EXPECT_EQ(out.find("smallest angle"), std::string::npos) << out;
  EXPECT_NE(out.find("folded faces"), std::string::npos) << out;
}

TEST_F(Volumes, CheckNamesFoldedAndCrowdedRegions) {
  put("folded.mesh", folded);
  const Outcome run = aomd("check folded.mesh");
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out,
            "folded region: region 1: lies on the same side as region 0 of a face of both\n"
            "folded.mesh: 1 finding\n");
  put("crowded.mesh", crowded);
  EXPECT_NE(
      aomd("check crowded.mesh").out.find("crowded face: region 0: has a face that two more "),
      std::string::npos);
  const auto json = nlohmann::json::parse(aomd("check crowded.mesh --json").out);
  EXPECT_EQ(json["volume"]["nonconforming"], 1);
  EXPECT_EQ(json["findings"].size(), 1u);
}

// What check names is a note of a decimation, which makes no more of it.
TEST_F(Volumes, DecimatingFoldedAndCrowdedRegionsSaysSo) {
  put("folded.mesh", folded);
  put("crowded.mesh", crowded);
  for (const char* how : {"--coarsest", "--coarsest --strategy paper"}) {
    const Outcome one = aomd(std::string("decimate folded.mesh o.mesh ") + how);
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.err,
              "aomd: note: folded.mesh: 1 face with two tetrahedra on one side, and may "
              "stay so: aomd check names them\n");
    const Outcome three = aomd(std::string("decimate crowded.mesh o.mesh ") + how);
    EXPECT_EQ(three.code, 0);
    EXPECT_EQ(three.err,
              "aomd: note: crowded.mesh: 1 face of three or more tetrahedra, and may "
              "stay so: aomd check names them\n");
  }
  sample("tet-box", "fine.mesh", 2);
  EXPECT_EQ(aomd("decimate fine.mesh o.mesh").err, "");
}

// A vertex of two upper tetrahedra in the middle of an edge of the lower one.
TEST_F(Volumes, HangingVerticesAreNamed) {
  put("hanging.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n6\n0 0 0 0\n2 0 0 0\n0 2 0 0\n1 1 0 0\n"
      "0 0 2 0\n0 0 -2 0\nTetrahedra\n3\n1 2 4 5 1\n1 4 3 5 1\n1 3 2 6 1\nEnd\n");
  const std::string found =
      "hanging vertices: 1 vertex lies on faces without being a corner of them";
  const Outcome check = aomd("check hanging.mesh");
  EXPECT_EQ(check.code, 0);
  EXPECT_EQ(check.out, found +
                           " (vertex 3)\nhanging.mesh: nothing found in the mesh, 1 kind of "
                           "dirt on the surface\n");
  EXPECT_EQ(aomd("check hanging.mesh --require welded").code, 1);
  for (const char* strategy : {"quality", "paper"}) {
    const Outcome run = aomd(std::string("decimate hanging.mesh o.mesh --strategy ") + strategy);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "aomd: note: hanging.mesh: " + found + ": aomd check names them\n");
  }
}

}  // namespace
}  // namespace aomd::test::cli_volumes_test
