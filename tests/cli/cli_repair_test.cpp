// aomd repair: what it prints, writes and refuses.

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_repair_test {
namespace {

using RepairCommand = CommandLine;

// A square, a copy of its first triangle, a pocket on its lower side, and a vertex that nothing
// uses.
constexpr const char* dirty =
    "OFF\n6 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 -1 0\n9 9 9\n"
    "3 0 1 2\n3 0 2 3\n3 1 2 0\n3 0 1 4\n3 1 0 4\n";

TEST_F(RepairCommand, SaysWhatItDidOneLineEach) {
  put("d.off", dirty);
  const Outcome run = aomd("repair d.off o.off --drop-unused");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out,
            "o.off: 2 faces in coincident pairs of opposite orientation removed (faces 3, 4)\n"
            "o.off: 1 repeated face removed (face 2)\n"
            "o.off: 2 vertices that nothing uses dropped (vertices 4, 5)\n");
  const MeshData mesh = io::read(at("o.off")).mesh;
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.positions.size(), 4u);
  const Outcome again = aomd("repair o.off again.off");
  EXPECT_EQ(again.out, "again.off: nothing to mend\n");
  EXPECT_EQ(text("again.off"), text("o.off"));
}

TEST_F(RepairCommand, SwitchesKeepWhatTheyName) {
  put("d.off", dirty);
  ASSERT_EQ(aomd("repair d.off o.off --no-opposite-faces --no-repeated-faces --no-split "
                 "--no-orient --quiet")
                .code,
            0);
  EXPECT_EQ(io::read(at("o.off")).mesh.faces.size(), 5u);
  EXPECT_EQ(text("stdout.txt"), "");
  ASSERT_EQ(aomd("repair d.off o.off --no-opposite-faces --no-split").code, 0);
  EXPECT_EQ(io::read(at("o.off")).mesh.faces.size(), 4u);
}

TEST_F(RepairCommand, JsonHoldsCountsAndEntities) {
  put("d.off", dirty);
  const Outcome run = aomd("repair d.off o.off --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  EXPECT_EQ(report["schema"], 1);
  EXPECT_EQ(report["input"]["faces"], 5);
  EXPECT_EQ(report["output"]["faces"], 2);
  ASSERT_EQ(report["done"].size(), 2u);
  EXPECT_EQ(report["done"][0]["name"], "opposite faces");
  EXPECT_EQ(report["done"][0]["count"], 2);
  EXPECT_EQ(report["done"][0]["first_faces"], (std::vector<int>{3, 4}));
  ASSERT_EQ(report["left"].size(), 1u);
  EXPECT_EQ(report["left"][0]["name"], "unused vertices");
  EXPECT_EQ(report["left"][0]["count"], 2);
  EXPECT_GE(report["seconds"]["repair"], 0);
}

TEST_F(RepairCommand, WhatIsLeftIsTold) {
  put("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 2 4 3\nf 4 1 3\n");
  EXPECT_EQ(aomd("repair m.obj o.obj").out, "o.obj: nothing to mend\n");
  // a twisted band
  put("t.off",
      "OFF\n6 6 0\n0 0 1\n0 0 0\n1 0 1\n1 0 0\n2 1 1\n2 1 0\n"
      "3 0 1 2\n3 1 3 2\n3 2 3 4\n3 3 5 4\n3 4 5 1\n3 5 0 1\n");
  const Outcome run = aomd("repair t.off o.off");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out,
            "o.off: 1 piece left that cannot be oriented (face 0)\no.off: nothing to mend\n");
}

TEST_F(RepairCommand, FailuresHaveTheirCodesAndWriteNothing) {
  put("d.off", dirty);
  expect_failure("repair missing.off o.off", 3, "missing.off");
  expect_failure("repair d.off o.step", 4, "o.step");
  expect_failure("repair d.off o.off --min-piece 101", 2, "min-piece");
  expect_failure("repair d.off", 2, "OUT");
  ASSERT_EQ(aomd("sample tet-box v.msh").code, 0);
  expect_failure("repair v.msh o.msh", 5, "Repair mends surfaces");
  for (const char* file : {"o.off", "o.step", "o.msh"}) EXPECT_FALSE(exists(file)) << file;
}

TEST_F(RepairCommand, WeldsAndRemovesPiecesWhenAsked) {
  put("s.off",
      "OFF\n9 3 0\n0 0 0\n1 1 0\n0 1 0\n0 0 0\n1 0 0\n1 1 0\n5 0 0\n5.01 0 0\n5 0.01 0\n"
      "3 0 1 2\n3 3 4 5\n3 6 7 8\n");
  ASSERT_EQ(aomd("repair s.off o.off --weld --min-piece 1 --drop-unused").code, 0);
  const MeshData mesh = io::read(at("o.off")).mesh;
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 3, 1}));
  EXPECT_EQ(mesh.positions.size(), 4u);
}

}  // namespace
}  // namespace aomd::test::cli_repair_test
