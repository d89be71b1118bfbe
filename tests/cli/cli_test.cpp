// The program aomd: commands, messages and exit codes (all but decimate, see cli_decimate_test).

#include "core/io/png.h"
#include "core/samples/samples.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_test {
namespace {

using CommandLineTest = CommandLine;

TEST_F(CommandLineTest, HelpAndVersionSucceed) {
  EXPECT_EQ(aomd("--help").code, 0);
  EXPECT_EQ(aomd("decimate --help").code, 0);
  const Outcome version = aomd("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("aomd ", 0), 0u);
}

TEST_F(CommandLineTest, WrongUsageIsCode2) {
  expect_failure("", 2, "subcommand is required");
  expect_failure("frobnicate", 2, "no command \"frobnicate\"");
  expect_failure("info", 2, "FILE");
  expect_failure("info a.ply --wrong", 2, "--wrong");
  expect_failure("sample", 2, "NAME");
  expect_failure("sample cow c.ply", 2, "no sample \"cow\"");
  expect_failure("sample box c.ply --size 100000", 2, "size 100000");
  expect_failure("classify a.ply b.ply --angle 180", 2, "180");
}

TEST_F(CommandLineTest, BadInputIsCode3WithPlace) {
  expect_failure("info missing.ply", 3, "missing.ply");
  expect_failure("info .", 3, ".");
  put("short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\nx 1 0\n3 0 1 2\n");
  expect_failure("info short.off", 3, "short.off:5: ");
  put("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  expect_failure("check range.obj", 3, "range.obj:4: ");
  put("empty.ply", "");
  expect_failure("convert empty.ply out.ply", 3, "empty.ply");
  EXPECT_FALSE(exists("out.ply"));
}

TEST_F(CommandLineTest, NamesAndNotesAreOneLineEach) {
  expect_failure("info 'a\nb\x1b.ply'", 3, "aomd: a\\nb\\x1b.ply: cannot be opened");
  put("a\nb.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\x1b[2J\nf 1 2 3\nf 1 1 2\n");
  EXPECT_EQ(aomd("convert 'a\nb.obj' o.ply").err,
            "aomd: note: a\\nb.obj: 1 face of fewer than 3 different corners dropped\n"
            "aomd: note: a\\nb.obj: left out: \"\\x1b[2J\" lines\n");
}

TEST_F(CommandLineTest, WhatAFileCannotHoldIsSaid) {
  put("far.off",
      "OFF\n4 2 0\n4194304 0 0\n4194304.125 1 0\n4194305 1 0\n4194305 0 0\n3 0 1 2\n"
      "3 0 2 3\n");
  const Outcome run = aomd("convert far.off far.stl");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err,
            "aomd: note: far.stl: coordinates rounded to 32-bit floats by up to 0.125; text keeps "
            "them\n");
  EXPECT_EQ(aomd("repair far.off far.stl --quiet").err, "");
  EXPECT_EQ(aomd("convert far.off far.stl --ascii").err, "");
  put("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
  EXPECT_EQ(aomd("convert line.obj o.off").err, "aomd: note: o.off: left out: 1 edge\n");
  put("flat.off", "OFF\n3 1 0\n4194304 0 0\n4194304.125 0 0\n4194305 1 0\n3 0 1 2\n");
  expect_failure("convert flat.off flat.stl", 4, "1 face of 1 would collapse");
  EXPECT_FALSE(exists("flat.stl"));
}

TEST_F(CommandLineTest, UnwritableOutputIsCode4) {
  sample("box", "box.ply", 2);
  expect_failure("convert box.ply out.xyz", 4, "out.xyz");
  expect_failure("convert box.ply nowhere/out.ply", 4, "nowhere/out.ply");
  std::filesystem::create_symlink("/dev/full", at("full.ply"));
  expect_failure("convert box.ply full.ply", 4, "full.ply");
  expect_failure("sample box full.ply", 4, "full.ply");
}

TEST_F(CommandLineTest, FullStandardOutputIsCode4) {
  sample("box", "box.ply", 2);
  const int status = std::system(
      ("'" AOMD_PROGRAM "' info '" + at("box.ply").string() + "' >/dev/full 2>/dev/null").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 4);
}

TEST_F(CommandLineTest, FailureLeavesTheOldOutput) {
  put("out.ply", "old");
  put("bad.off", "OFF\n1\n");
  EXPECT_EQ(aomd("convert bad.off out.ply").code, 3);
  EXPECT_EQ(text("out.ply"), "old");
}

TEST_F(CommandLineTest, InfoCountsABox) {
  sample("box", "box.ply", 2);
  const Outcome run = aomd("info box.ply --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  const auto& input = json["input"];
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(input["vertices"], 26);
  EXPECT_EQ(input["unused_vertices"], 0);
  EXPECT_EQ(input["edges"], 72);
  EXPECT_EQ(input["faces"], 48);
  EXPECT_EQ(input["regions"], 0);
  EXPECT_EQ(input["boundary_edges"], 0);
  EXPECT_EQ(input["nonmanifold_edges"], 0);
  EXPECT_EQ(input["components"], 1);
  EXPECT_EQ(input["euler"], 2);
  EXPECT_EQ(input["by_shape"], nlohmann::json({{"triangle", 48}}));
  EXPECT_EQ(input["by_class"]["0"], 8);
  EXPECT_NEAR(json["quality"]["min_angle_worst_deg"], 45, 1e-9);
  EXPECT_NEAR(json["quality"]["min_angle_mean_deg"], 45, 1e-9);
  EXPECT_EQ(json["quality"]["faces_below_10deg_pct"], 0);
  EXPECT_GT(json["memory_bytes"]["mesh"], 0);
  EXPECT_NE(aomd("info box.ply").out.find("Euler number"), std::string::npos);
}

TEST_F(CommandLineTest, ConvertKeepsTheMesh) {
  sample("torus", "torus.ply", 12);
  for (const char* step :
       {"torus.ply t.obj", "t.obj t.off", "t.off t2.ply", "--ascii t2.ply t3.ply"})
    ASSERT_EQ(aomd(std::string("convert ") + step).code, 0) << step;
  EXPECT_EQ(io::read(at("t3.ply")).mesh.positions, io::read(at("torus.ply")).mesh.positions);
  EXPECT_EQ(io::read(at("t3.ply")).mesh.faces.vertices,
            io::read(at("torus.ply")).mesh.faces.vertices);
  EXPECT_NE(text("t3.ply").find("format ascii"), std::string::npos);
}

TEST_F(CommandLineTest, ConvertSplitsToTets) {
  sample("mixed", "mixed.msh", 2);
  const Outcome run = aomd("convert --split-to-tets mixed.msh tets.vtu");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err,
            "aomd: note: mixed.msh: cut 4 hexahedra into 24 tetrahedra, 8 prisms into 24 "
            "tetrahedra, 2 pyramids into 4 tetrahedra, 20 quads into 40 triangles\n");
  const MeshData tets = io::read(at("tets.vtu")).mesh;
  EXPECT_EQ(tets.regions.size(), 24u + 24 + 4 + 56);
  EXPECT_EQ(aomd("check tets.vtu").code, 0);
  EXPECT_EQ(aomd("convert --split-to-tets tets.vtu t.vtu").err,
            "aomd: note: tets.vtu: nothing but tetrahedra\n");
  sample("box", "box.ply", 1);
  EXPECT_EQ(aomd("convert --split-to-tets box.ply o.ply").err,
            "aomd: note: box.ply: has no regions to cut\n");
}

TEST_F(CommandLineTest, CheckIsSilentlyHappyWithASample) {
  sample("bracket", "bracket.ply", 1);
  EXPECT_EQ(aomd("check bracket.ply").code, 0);
  const auto json = nlohmann::json::parse(aomd("check bracket.ply --json").out);
  EXPECT_TRUE(json["findings"].empty());
}

TEST_F(CommandLineTest, CheckNamesAWrongClassification) {
  // vertex 2 lies in model region 1, but the face that it bounds on model face 1
  put("bad.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty "
      "double z\n"
      "property uchar model_dimension\nproperty int model_tag\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar model_dimension\n"
      "property int model_tag\nend_header\n0 0 0 2 1\n1 0 0 2 1\n0 1 0 3 1\n3 0 1 2 2 1\n");
  const Outcome run = aomd("check bad.ply");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.out.find("classification closure: vertex 2"), std::string::npos) << run.out;
  const Outcome as_json = aomd("check bad.ply --json");
  EXPECT_EQ(as_json.code, 1);
  EXPECT_EQ(nlohmann::json::parse(as_json.out)["findings"][0]["entity"], "vertex 2");
}

TEST_F(CommandLineTest, ClassifyFindsTheEdgesOfABox) {
  sample("box", "box.ply", 3);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  const Outcome run = aomd("classify bare.off classified.ply --angle 20");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("8 model vertices, 12 model edges, 6 model faces"), std::string::npos)
      << run.out;
  const auto json = nlohmann::json::parse(aomd("info classified.ply --json").out);
  EXPECT_EQ(json["input"]["by_class"]["0"], 8);
  EXPECT_EQ(aomd("classify bare.off all.ply --angle 100 --quiet").out, "");
}

TEST_F(CommandLineTest, SampleListNamesThem) {
  const Outcome run = aomd("sample --list");
  EXPECT_EQ(run.code, 0);
  for (const SampleInfo& info : samples()) EXPECT_NE(run.out.find(info.name), std::string::npos);
}

TEST_F(CommandLineTest, ImageDiffTellsPicturesApart) {
  io::Image white(32, 32), dotted(32, 32);
  std::fill(white.rgba.begin(), white.rgba.end(), std::uint8_t{255});
  dotted = white;
  for (int i = 8; i < 24; ++i) dotted.pixel(i, i)[0] = dotted.pixel(i, i)[1] = 0;
  io::write_png(at("a.png"), white);
  io::write_png(at("b.png"), dotted);
  EXPECT_EQ(aomd("image-diff a.png a.png --threshold 1").code, 0);
  const Outcome run = aomd("image-diff a.png b.png --output d.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("16 of 1024 pixels differ"), std::string::npos) << run.out;
  EXPECT_TRUE(exists("d.png"));
  EXPECT_NE(run.out.find("another picture: the tile at 0,0 "), std::string::npos) << run.out;
  put("c.png", "no picture");
  expect_failure("image-diff a.png c.png", 3, "c.png");
}

// What one index of the whole picture would let pass, and what no two drivers draw alike.
TEST_F(CommandLineTest, ImageDiffSeesSmallLossesAndForgivesNoise) {
  io::Image white(320, 320);
  std::fill(white.rgba.begin(), white.rgba.end(), std::uint8_t{255});
  io::Image dot = white, noise = white;
  for (int i = 0; i < 6; ++i) dot.pixel(100 + i, 100)[0] = 0;
  for (int i = 0; i < 320; ++i) noise.pixel(i, i)[1] = 253;
  io::write_png(at("a.png"), white);
  io::write_png(at("dot.png"), dot);
  io::write_png(at("noise.png"), noise);
  const Outcome run = aomd("image-diff a.png dot.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("ssim 0.99"), std::string::npos) << run.out;
  EXPECT_EQ(aomd("image-diff a.png noise.png").code, 0);
  EXPECT_EQ(aomd("image-diff a.png noise.png --threshold 1").code, 1);
}

// A box of 4 x 4 x 4 cells, six tetrahedra each: V - E + F - R = 1.
TEST_F(CommandLine, VolumesAreCountedCheckedAndConverted) {
  sample("tet-box", "v.msh", 4);
  const Outcome info = aomd("info v.msh --json");
  ASSERT_EQ(info.code, 0) << info.err;
  const auto counts = nlohmann::json::parse(info.out)["input"];
  EXPECT_EQ(counts["regions"], 6 * 4 * 4 * 4);
  EXPECT_EQ(counts["boundary_faces"], 6 * 2 * 4 * 4);
  EXPECT_EQ(counts["nonmanifold_faces"], 0);
  EXPECT_EQ(counts["euler"], 1);
  EXPECT_EQ(counts["by_shape"]["tetrahedron"], 384);
  EXPECT_NEAR(nlohmann::json::parse(info.out)["quality"]["min_dihedral_deg"].get<double>(), 45,
              1e-9);
  EXPECT_EQ(aomd("check v.msh --unused").code, 0);
  for (const char* file : {"w.vtk", "w.vtu --binary", "w.mesh", "w.msh --msh2 --binary"})
    EXPECT_EQ(aomd(std::string("convert v.msh ") + file).code, 0) << file;
  const Outcome back = aomd("info w.vtu --json");
  EXPECT_EQ(nlohmann::json::parse(back.out)["input"]["by_class"], counts["by_class"]);
  expect_failure("convert v.msh w.ply", 4, "the mesh has regions");
}

TEST_F(CommandLine, AnInvertedRegionIsFound) {
  put("v.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n9 9 9 "
      "0\n"
      "Tetrahedra\n1\n1 3 2 4 0\nEnd\n");
  const Outcome run = aomd("check v.mesh");
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out,
            "inverted region: region 0: the file lists it inside out\nv.mesh: 1 finding\n");
  EXPECT_NE(aomd("check v.mesh --unused").out.find("isolated vertex: vertex 4"), std::string::npos);
}

}  // namespace
}  // namespace aomd::test::cli_test
