// aomd decimate and replay on tetrahedra.

#include <algorithm>
#include <array>
#include <vector>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_decimate_volume_test {
namespace {

class DecimateVolume : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    ASSERT_EQ(aomd("sample tet-box v.msh --size 6").code, 0);
  }
  [[nodiscard]] MeshData mesh(const std::string& name) const { return io::read(at(name)).mesh; }
};

TEST_F(DecimateVolume, ReachesATargetAndReports) {
  const Outcome run =
      aomd("decimate v.msh o.msh --strategy paper --target-tets 40% --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto report = json("r.json");
  const int before = report["input"]["regions"], after = report["output"]["regions"];
  EXPECT_EQ(report["options"]["target_tets"], std::lround(0.4 * before));
  EXPECT_TRUE(report["options"]["target_faces"].is_null());
  EXPECT_LE(after, std::lround(0.4 * before));
  EXPECT_EQ(report["sweeps"].back()["regions"], after);
  EXPECT_EQ(report["stopped"]["why"], "target");
  EXPECT_GT(report["quality"]["min_dihedral_deg"], 0);
  EXPECT_TRUE(report["sweeps"][0]["refused"].contains("Inverted"));
  EXPECT_NE(run.out.find(std::to_string(before) + " tetrahedra -> " + std::to_string(after)),
            std::string::npos)
      << run.out;
  EXPECT_EQ(aomd("check o.msh").code, 0);
}

TEST_F(DecimateVolume, TheSameResultFromTheJournal) {
  ASSERT_EQ(aomd("decimate v.msh o.msh --strategy paper --factor 2 --journal j.bin").code, 0);
  const Outcome run = aomd("replay v.msh j.bin again.msh");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(text("o.msh"), text("again.msh"));
}

TEST_F(DecimateVolume, ByQualityToo) {
  const Outcome run =
      aomd("decimate v.msh o.msh --target-tets 50% --report r.json --journal j.bin");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto report = json("r.json");
  EXPECT_EQ(report["stopped"]["why"], "target") << report["stopped"];
  EXPECT_LE(report["output"]["regions"], std::lround(0.505 * double(report["input"]["regions"])));
  ASSERT_EQ(aomd("replay v.msh j.bin again.msh").code, 0);
  EXPECT_EQ(text("o.msh"), text("again.msh"));
}

TEST_F(DecimateVolume, TheSameFromTheJournalWhereAModelLooksOn) {
  for (const std::string strategy : {"quality", "paper"}) {
    ASSERT_EQ(
        aomd("decimate v.msh o.msh --target-tets 30% --snap model --journal j.bin --strategy " +
             strategy)
            .code,
        0);
    const Outcome run = aomd("replay v.msh j.bin again.msh");
    ASSERT_EQ(run.code, 0) << strategy << ": " << run.err;
    EXPECT_EQ(text("o.msh"), text("again.msh")) << strategy;
  }
}

// The share of the diagonal is that of what regions use: no face need be listed.
TEST_F(DecimateVolume, TheDistanceHoldsWhereNoFaceIsListed) {
  ASSERT_EQ(aomd("sample tet-ball b.msh --size 5").code, 0);
  MeshData ball = io::read(at("b.msh")).mesh;
  ball.faces = ball.edges = {};
  ball.vertex_classes.clear();
  io::write(at("b.mesh"), ball);
  ASSERT_EQ(aomd("decimate b.mesh free.mesh --target-tets 5%").code, 0);
  ASSERT_EQ(
      aomd("decimate b.mesh near.mesh --target-tets 5% --max-distance 0.5 --report r.json").code,
      0);
  EXPECT_GT(json("r.json")["output"]["regions"], io::read(at("free.mesh")).mesh.regions.size());
  EXPECT_GT(json("r.json")["stopped"]["refused"]["Distance"], 0);
  EXPECT_EQ(aomd("compare b.mesh near.mesh --max-distance 0.51").code, 0);
  EXPECT_EQ(aomd("compare b.mesh free.mesh --max-distance 0.6").code, 1);
}

TEST_F(DecimateVolume, TargetsAreOfTheirKind) {
  expect_failure("decimate v.msh o.msh --strategy paper --target-faces 10%", 2,
                 "--target-faces is for surfaces");
  sample("sphere", "s.ply", 2);
  expect_failure("decimate s.ply o.ply --target-tets 10%", 2, "--target-tets is for volumes");
  expect_failure("decimate v.msh o.msh --target-tets 10% --factor 2", 2, "--target-tets");
}

TEST_F(DecimateVolume, WhatItCannotDoIsSaid) {
  expect_failure("decimate v.msh o.msh --strategy paper --topology paper", 2,
                 "--topology paper is for surfaces");
  expect_failure("decimate v.msh o.msh --strategy paper --spacing curvature", 2,
                 "by curvature is for surfaces");
  put("h.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
      "0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\nHexahedra\n1\n1 2 3 4 5 6 7 8 1\nEnd\n");
  expect_failure("decimate h.mesh o.mesh --strategy paper", 1, "--split-to-tets");
  EXPECT_FALSE(exists("o.msh") || exists("o.mesh"));
}

// A tetrahedron beside a hexahedron, whose vertices stay.
TEST_F(DecimateVolume, WhatIsBesideOtherShapesStays) {
  put("m.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n9\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
      "0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n2 2 2 0\nHexahedra\n1\n1 2 3 4 5 6 7 8 1\n"
      "Pyramids\n1\n5 6 7 8 9 1\nTetrahedra\n1\n6 3 7 9 1\nEnd\n");
  const Outcome run = aomd("decimate m.mesh o.mesh --strategy paper --coarsest");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("1 tetrahedron -> 1"), std::string::npos) << run.out;
}

/// The tetrahedra of a model region, each by the positions of its vertices in their order.
std::vector<std::array<double, 12>> tetrahedra_of(const MeshData& data, int region) {
  std::vector<std::array<double, 12>> list;
  for (std::size_t r = 0; r < data.regions.size(); ++r) {
    if (data.regions.classes[r] != ModelRef(3, region)) continue;
    auto& at = list.emplace_back();
    for (std::size_t k = 0; k < 12; ++k)
      at[k] = data.positions[data.regions.vertices[4 * r + k / 3]][static_cast<int>(k % 3)];
  }
  std::sort(list.begin(), list.end());
  return list;
}

// A ball, region 1, in a box.
TEST_F(DecimateVolume, RegionsCanBeKeptOrBeTheOnlyOnes) {
  ASSERT_EQ(aomd("sample ball-in-box b.msh --size 3").code, 0);
  const MeshData before = mesh("b.msh");
  put("one.txt", "region 1\n");
  put("two.txt", "region 2\n");
  for (const char* strategy : {"paper", "quality"}) {
    const std::string run = std::string("decimate b.msh o.msh --coarsest --strategy ") + strategy;
    ASSERT_EQ(aomd(run + " --keep one.txt").code, 0);
    EXPECT_EQ(tetrahedra_of(mesh("o.msh"), 1), tetrahedra_of(before, 1)) << strategy;
    EXPECT_LT(2 * tetrahedra_of(mesh("o.msh"), 2).size(), tetrahedra_of(before, 2).size());
    ASSERT_EQ(aomd(run + " --only two.txt").code, 0);
    EXPECT_EQ(tetrahedra_of(mesh("o.msh"), 1), tetrahedra_of(before, 1)) << strategy;
    EXPECT_LT(tetrahedra_of(mesh("o.msh"), 2).size(), tetrahedra_of(before, 2).size());
  }
}

// What the file does not say is not said of the result either.
TEST_F(DecimateVolume, NothingIsClassifiedThatWasNot) {
  put("t.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
      "0.2 0.2 0.2 0\nTetrahedra\n4\n1 2 3 5 0\n1 4 2 5 0\n2 4 3 5 0\n1 3 4 5 0\nEnd\n");
  ASSERT_EQ(aomd("decimate t.mesh o.mesh --strategy paper --coarsest").code, 0);
  const std::string result = text("o.mesh");
  EXPECT_NE(result.find("Tetrahedra\n1\n"), std::string::npos) << result;
  EXPECT_EQ(result.find("Triangles"), std::string::npos) << result;
}

}  // namespace
}  // namespace aomd::test::cli_decimate_volume_test
