// Features through the program: what it keeps towards a number of faces, and what it says of it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/io/io.h"
#include "tests/support/cli_helpers.h"
#include "tests/support/shape_builder.h"

namespace aomd::cli_features_test {
namespace {

class CliFeatures : public test::CommandLine {
 protected:
  void put_mesh(const std::string& name, MeshData mesh) const {
    mesh.faces.classes.clear();
    io::write(at(name), mesh);
  }
  [[nodiscard]] nlohmann::json report() const { return nlohmann::json::parse(text("r.json")); }
};

// A square of 10 by 10 low pyramids: each of the 400 faces meets its neighbours at 27 or 39
// degrees, up and down in turn.
MeshData pyramids() {
  test::Builder b;
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) b.point({2 * i, 2 * j, 0});
  for (std::uint32_t j = 0; j < 10; ++j)
    for (std::uint32_t i = 0; i < 10; ++i) {
      const std::uint32_t v = 11 * j + i;
      b.fan({v, v + 1, v + 12, v + 11}, b.point({2.0 * i + 1, 2.0 * j + 1, 0.35}), 1);
    }
  return b.data;
}

// A tube of 40 rings, every other one further out: they meet at 30 degrees, and nowhere a corner.
MeshData bellows() {
  constexpr std::uint32_t around = 40, rings = 40;
  test::Builder b;
  for (std::uint32_t j = 0; j <= rings; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around, radius = j % 2 == 0 ? 1 : 1.1;
      b.point({radius * std::cos(angle), radius * std::sin(angle), 0.37 * j});
    }
  for (std::uint32_t j = 0; j < rings; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t v = around * j + i, w = around * j + (i + 1) % around;
      b.quad(v, w, w + around, v + around, 1);
    }
  return b.data;
}

TEST_F(CliFeatures, SpheresInFacetsReachTheirTarget) {
  put_mesh("spheres.ply", test::together({test::sphere(16, 8), test::sphere(12, 8)}));
  ASSERT_EQ(aomd("decimate spheres.ply o.ply --target-faces 80 --report r.json").code, 0);
  EXPECT_EQ(report()["stopped"]["why"], "target");
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 20.0);
}

TEST_F(CliFeatures, ThatCostTooMuchOfTheTargetAreNotKept) {
  put_mesh("pyramids.ply", pyramids());
  const auto run = aomd("decimate pyramids.ply o.ply --target-faces 100 --report r.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err,
            "aomd: note: pyramids.ply: 221 model vertices would take more than half of 100 faces: "
            "only corners of 50 degrees and more are kept (--feature-angle 20 keeps all)\n");
  EXPECT_EQ(report()["stopped"]["why"], "target");
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 50.0);
}

TEST_F(CliFeatures, ThatWouldTakeMostVerticesAreNotKept) {
  put_mesh("bellows.ply", bellows());
  const auto run = aomd("decimate bellows.ply o.ply --target-faces 10% --report r.json");
  EXPECT_EQ(run.err,
            "aomd: note: bellows.ply: sharp edges would take more than three quarters of the "
            "vertices of 320 faces: only corners of 50 degrees and more are kept (--feature-angle "
            "20 keeps all)\n");
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 50.0);
  EXPECT_EQ(aomd("decimate bellows.ply o.ply --target-faces 11% --report r.json").err, "");
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 20.0);
}

TEST_F(CliFeatures, ThatAreAskedForAreKept) {
  put_mesh("pyramids.ply", pyramids());
  const std::string run = "decimate pyramids.ply o.ply --target-faces 100 --report r.json";
  EXPECT_EQ(aomd(run + " --feature-angle 20").code, 0);
  EXPECT_EQ(report()["stopped"]["why"], "missed");
  EXPECT_EQ(report()["output"]["faces"], 400);
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 20.0);
}

TEST_F(CliFeatures, ThatCostLittleAreKept) {
  put_mesh("pyramids.ply", pyramids());
  const auto run = aomd("decimate pyramids.ply o.ply --target-faces 884 --report r.json");
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(report()["options"]["feature_angle_deg"], 20.0);
}

TEST_F(CliFeatures, AJournalHoldsTheAngleThatWasTaken) {
  put_mesh("pyramids.ply", pyramids());
  ASSERT_EQ(aomd("decimate pyramids.ply o.ply --target-faces 100 --journal j.aomdj").code, 0);
  ASSERT_EQ(aomd("replay pyramids.ply j.aomdj again.ply").code, 0);
  EXPECT_EQ(text("again.ply"), text("o.ply"));
}

TEST_F(CliFeatures, AreCountedWithRoughnessAndSteps) {
  put_mesh("cylinder.ply", test::cylinder(12, 2, 1, false));
  EXPECT_EQ(aomd("classify cylinder.ply o.ply").out,
            "o.ply: 0 model vertices, 2 model edges, 3 model faces; sharp edges: 24 features, 0 "
            "roughness, 12 steps of rounds\n");
}

}  // namespace
}  // namespace aomd::cli_features_test
