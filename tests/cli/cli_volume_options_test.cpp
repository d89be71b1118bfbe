// What aomd decimate is told about regions, and what it reports of them.

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "tests/support/cli_helpers.h"
#include "tests/support/tet_zoo.h"

namespace aomd::test::cli_volume_options_test {
namespace {

class VolumeOptions : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    sample("ball-in-box", "v.msh", 3);
  }
  /// The volume of each model region of a file, by its tag, from plain arrays.
  [[nodiscard]] std::map<int, double> volumes(const std::string& file) const {
    const MeshData mesh = io::read(at(file)).mesh;
    std::map<int, double> sums;
    for (std::size_t i = 0; i < mesh.regions.size(); ++i) {
      const std::uint32_t* v = &mesh.regions.vertices[4 * i];
      const glm::dvec3 a = mesh.positions[v[0]];
      sums[mesh.regions.classes[i].tag()] +=
          glm::dot(mesh.positions[v[1]] - a,
                   glm::cross(mesh.positions[v[2]] - a, mesh.positions[v[3]] - a)) /
          6;
    }
    return sums;
  }
};

// As convert would have done before; a replay starts from there too.
TEST_F(VolumeOptions, MixedRegionsAreCutFirst) {
  sample("mixed", "m.msh", 4);
  ASSERT_EQ(aomd("convert m.msh t.msh --split-to-tets").code, 0);
  ASSERT_EQ(aomd("decimate t.msh a.msh --target-tets 60%").code, 0);
  const Outcome run = aomd("decimate m.msh b.msh --target-tets 60% --split-to-tets --journal j");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("m.msh: cut "), std::string::npos) << run.err;
  EXPECT_EQ(text("a.msh"), text("b.msh"));
  ASSERT_EQ(aomd("replay m.msh j c.msh --split-to-tets --quiet").code, 0);
  EXPECT_EQ(text("c.msh"), text("b.msh"));
}

TEST_F(VolumeOptions, TheLeastDihedralAngleHolds) {
  for (const std::string options :
       {"--strategy paper --coarsest", "--target-tets 2%", "--target-tets 5% --snap model",
        "--target-tets 2% --volume free"}) {
    const auto report = [&](const std::string& more) {
      const Outcome run = aomd("decimate v.msh o.msh --report r.json " + options + more);
      EXPECT_EQ(run.code, 0) << run.err;
      return json("r.json");
    };
    const auto free = report("");
    const std::string usual = text("o.msh");
    EXPECT_LT(free["quality"]["min_dihedral_deg"], 30) << options;
    EXPECT_EQ(free["options"]["min_dihedral_deg"], 0);
    report(" --min-dihedral 0");
    EXPECT_EQ(text("o.msh"), usual) << options;
    const auto held = report(" --min-dihedral 30");
    EXPECT_GE(held["quality"]["min_dihedral_deg"], 30) << options;
    EXPECT_EQ(held["options"]["min_dihedral_deg"], 30);
    EXPECT_GT(held["sweeps"][0]["refused"]["Shape"], 0);
  }
}

TEST_F(VolumeOptions, AMissedTargetPointsToTheLeastDihedralAngle) {
  const auto would_help = [&](const std::string& options) {
    EXPECT_EQ(aomd("decimate v.msh o.msh --target-tets 1% --report r.json " + options).code, 0);
    return json("r.json")["stopped"]["would_help"];
  };
  EXPECT_EQ(would_help("--min-dihedral 38"), "a smaller --min-dihedral");
  EXPECT_EQ(would_help("--min-dihedral 38 --min-angle 5"),
            "a smaller --min-dihedral or --min-angle");
}

TEST_F(VolumeOptions, TheReportHasTheVolumeOfEachRegionBeforeAndAfter) {
  for (const std::string options : {"--strategy paper --factor 2", "--target-tets 20%"}) {
    const Outcome run = aomd("decimate v.msh o.msh --report r.json " + options);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto report = json("r.json");
    const auto before = volumes("v.msh"), after = volumes("o.msh");
    ASSERT_EQ(report["model_regions"].size(), 2u);
    double largest = 0;
    int regions = 0;
    for (const auto& region : report["model_regions"]) {
      const double was = before.at(region["tag"]), is = after.at(region["tag"]);
      EXPECT_NEAR(region["volume"][0], was, 1e-12);
      EXPECT_NEAR(region["volume"][1], is, 1e-12);
      EXPECT_NEAR(region["volume_change_pct"], 100 * (is - was) / was, 1e-9);
      largest = std::max(largest, std::abs(100 * (is - was) / was));
      regions += region["regions"][1].get<int>();
    }
    EXPECT_EQ(report["output"]["regions"], regions);
    EXPECT_NEAR(std::abs(report["volume_change_pct"].get<double>()), largest, 1e-9);
    EXPECT_EQ(largest > 1, options.find("paper") != std::string::npos) << largest;
    EXPECT_NE(run.out.find(", largest change of a region's volume "), std::string::npos);
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 4) << run.out;
  }
  sample("sphere", "s.ply", 2);
  ASSERT_EQ(aomd("decimate s.ply o.ply --report r.json").code, 0);
  EXPECT_TRUE(json("r.json")["model_regions"].is_null());
  EXPECT_TRUE(json("r.json")["options"]["volume"].is_null());
}

TEST_F(VolumeOptions, VolumesAreKeptOrFree) {
  const auto before = volumes("v.msh");
  const auto change = [&](const std::string& options) {
    EXPECT_EQ(aomd("decimate v.msh o.msh --target-tets 5% --report r.json " + options).code, 0);
    const auto after = volumes("o.msh");
    double largest = 0;
    for (const auto& [tag, volume] : before)
      largest = std::max(largest, 100 * std::abs(after.at(tag) - volume) / volume);
    return largest;
  };
  EXPECT_LT(change(""), 0.1);
  EXPECT_EQ(json("r.json")["options"]["volume"], "keep");
  const std::string kept = text("o.msh");
  EXPECT_LT(change("--volume keep"), 0.1);
  EXPECT_EQ(text("o.msh"), kept);
  EXPECT_GT(change("--volume free"), 0.5);
  EXPECT_EQ(json("r.json")["options"]["volume"], "free");
}

TEST_F(VolumeOptions, OptionsOfTheOtherKindAreSaid) {
  sample("sphere", "s.ply", 2);
  for (const std::string rule : {"keep", "free"})
    expect_failure("decimate s.ply o.ply --volume " + rule, 2,
                   "--volume is for volumes, and s.ply has no regions");
  expect_failure("decimate v.msh o.msh --volume keep --strategy paper", 2,
                 "--volume keep is for --strategy quality");
  expect_failure("decimate v.msh o.msh --volume most", 2, "--volume");
  EXPECT_EQ(aomd("decimate v.msh o.msh --volume free --strategy paper").code, 0);
  expect_failure("decimate s.ply o.ply --spacing surface", 2, "--spacing: surface is for volumes");
  expect_failure("decimate v.msh o.msh --spacing surface --target-tets 9 --factor 2", 2,
                 "--factor");
  const Outcome run = aomd("decimate v.msh o.msh --exchange --strategy paper");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("note: v.msh: --exchange changes nothing: a volume keeps T(0,3)"),
            std::string::npos)
      << run.err;
}

TEST_F(VolumeOptions, SpacingBySurfaceTakesAFactorAndAGrowth) {
  for (const std::string strategy : {"paper", "quality"}) {
    const auto left = [&](const std::string& options) {
      EXPECT_EQ(aomd("decimate v.msh o.msh --spacing surface --report r.json --strategy " +
                     strategy + options)
                    .code,
                0);
      EXPECT_EQ(aomd("check o.msh").code, 0);
      return json("r.json")["output"]["regions"].get<int>();
    };
    const int fine = left(" --factor 1 --gradation 0.1");
    EXPECT_EQ(json("r.json")["options"]["factor"], 1);
    EXPECT_EQ(json("r.json")["options"]["gradation"], 0.1);
    EXPECT_LT(left(" --factor 1 --gradation 1"), fine);
    EXPECT_LT(left(" --factor 2 --gradation 0.1"), fine);
  }
}

// A plate between two interfaces that are closer to each other than the distance.
TEST_F(VolumeOptions, EachInterfaceStaysNearItself) {
  MeshData plate = zoo::tet_grid({12, 12, 5}, [](const zoo::Cell& c) { return 1 + (c.z == 2); });
  for (glm::dvec3& p : plate.positions) {
    const double z = p.z < 3 ? p.z - 2 : p.z - 3 + 0.1;
    p.z = z + 0.3 * std::sin(0.9 * p.x) * std::sin(0.9 * p.y);
  }
  io::write(at("p.msh"), plate);
  ASSERT_EQ(aomd("decimate p.msh o.msh --target-tets 5% --max-distance 1 --volume free").code, 0);
  const Outcome run = aomd("compare p.msh o.msh --json --samples 20000");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto compared = nlohmann::json::parse(run.out);
  int measured = 0;
  for (const auto& surface : compared["interfaces"]) {
    if (!surface.contains("hausdorff_pct")) continue;
    ++measured;
    EXPECT_LE(surface["hausdorff_pct"], 1 + 1e-3) << surface["between"];
  }
  EXPECT_GT(measured, 2);
}

TEST_F(VolumeOptions, ReplacingAClassificationKeepsMaterials) {
  ASSERT_EQ(aomd("classify v.msh o.msh --replace").code, 0);
  const auto before = volumes("v.msh"), after = volumes("o.msh");
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(after, before);
}

// A thin lens between two blocks cannot pay for what it owes.
TEST_F(VolumeOptions, WhereVolumesStopARunTheReportSaysSo) {
  MeshData lens = zoo::tet_grid({12, 12, 5}, [](const zoo::Cell& c) {
    const bool inner = 2 <= c.x && c.x < 10 && 2 <= c.y && c.y < 10;
    return c.z == 2 && inner ? 3 : c.z <= 2 ? 1 : 2;
  });
  for (glm::dvec3& p : lens.positions)
    p.z = (p.z < 3 ? p.z : p.z - 0.97) + 0.5 * std::sin(0.9 * p.x) * std::sin(0.9 * p.y);
  io::write(at("lens.msh"), lens);
  const Outcome run = aomd("decimate lens.msh o.msh --target-tets 1% --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto stopped = json("r.json")["stopped"];
  EXPECT_EQ(stopped["why"], "missed");
  EXPECT_GT(stopped["refused"]["Volume"], 0) << stopped;
  EXPECT_EQ(stopped["refused"].count("Distance"), 0u) << stopped;
  EXPECT_NE(run.err.find(" would change a region's volume too much"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace aomd::test::cli_volume_options_test
