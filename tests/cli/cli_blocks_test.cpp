// aomd decimate --blocks: surfaces that are made coarser in pieces.

#include "core/io/io.h"
#include "core/samples/samples.h"
#include "tests/support/cli_helpers.h"
#include "tests/support/surface_facts.h"
#include "tests/support/vtu_blocks.h"

namespace aomd::test::cli_blocks_test {
namespace {

class BlocksCommand : public CommandLine {
 protected:
  void SetUp() override { sample("scan", "s.ply", 8000); }
};

TEST_F(BlocksCommand, ReachesItsTargetAndReportsWhatTheFileHas) {
  const auto whole = nlohmann::json::parse(aomd("info --json s.ply").out)["input"];
  const Outcome run = aomd("decimate s.ply o.ply --blocks 5 --target-faces 10% --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto report = json("r.json");
  EXPECT_EQ(report["options"]["blocks"], 5);
  for (const char* known : {"faces", "vertices", "euler"})
    EXPECT_EQ(report["input"][known], whole[known]) << known;
  EXPECT_NEAR(double(report["output"]["faces"]), 0.1 * double(whole["faces"]), 2);
  EXPECT_GT(double(report["seconds"]["blocks"]), 0);
  EXPECT_EQ(aomd("check o.ply --require closed,manifold").code, 0);
  EXPECT_EQ(aomd("compare s.ply o.ply --max-distance 1").code, 0);
}

/// The faces on one side of the plane x = 0.
MeshData half_of(const MeshData& whole, bool right) {
  MeshData half = whole;
  half.faces = {};
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    const auto* t = &whole.faces.vertices[3 * f];
    if ((whole.positions[t[0]].x + whole.positions[t[1]].x > 0) != right) continue;
    half.faces.shapes.push_back(Shape::Triangle);
    half.faces.vertices.insert(half.faces.vertices.end(), t, t + 3);
  }
  return half;
}

// Cut along the middle of a torus, the halves come to what is as whole.
TEST_F(BlocksCommand, ReadsAFolderOfTiles) {
  const MeshData whole = make_sample("torus", 40);
  std::filesystem::create_directory(at("tiles"));
  for (const bool right : {false, true})
    io::write(at(right ? "tiles/2.ply" : "tiles/1.ply"), half_of(whole, right));
  ASSERT_EQ(aomd("decimate tiles o.ply --blocks 3 --target-faces 10% --report r.json").code, 0);
  EXPECT_EQ(json("r.json")["input"]["faces"], whole.faces.size());
  const auto result = test::facts_of(io::read(at("o.ply")).mesh);
  EXPECT_EQ(result.euler, 0);
  EXPECT_EQ(aomd("check o.ply --require closed,manifold").code, 0);
  expect_failure("decimate tiles o.ply --target-faces 10%", 3, "tiles: is a folder");
}

// The halves of a torus a little apart are one with --weld; a PVTU names them.
TEST_F(BlocksCommand, WeldsTilesThatAPvtuNames) {
  const MeshData whole = make_sample("torus", 40);
  io::WriteOptions how;
  how.binary = true;
  for (const bool right : {false, true}) {
    MeshData half = half_of(whole, right);
    for (glm::dvec3& p : half.positions) p.z += right ? 0.001 : 0;
    io::write(at(right ? "2.vtu" : "1.vtu"), half, how);
  }
  std::ofstream(at("t.pvtu")) << "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>"
                                 "<Piece Source=\"1.vtu\"/><Piece Source=\"2.vtu\"/>"
                                 "</PUnstructuredGrid></VTKFile>";
  const std::string in_blocks = "decimate t.pvtu o.ply --blocks 3 --target-faces 400";
  ASSERT_EQ(aomd(in_blocks + " --weld 0.0011 --report r.json").code, 0);
  EXPECT_EQ(json("r.json")["options"]["weld"], "0.0011");
  EXPECT_EQ(aomd("check o.ply --require closed,manifold").code, 0);
  ASSERT_EQ(aomd(in_blocks + " --weld 0.1%").code, 0);
  EXPECT_EQ(aomd("check o.ply --require closed,manifold").code, 0);
  ASSERT_EQ(aomd(in_blocks + " --weld 0.0009").code, 0);
  EXPECT_EQ(aomd("check o.ply --require closed").code, 1);
  expect_failure("decimate s.ply o.ply --blocks 3 --target-faces 400 --weld 1", 2,
                 "--weld with --blocks is for the borders of tiles, and s.ply is one file");
  expect_failure("decimate s.ply o.ply --target-faces 400 --weld 1", 2,
                 "--weld requires --repair, or tiles with --blocks");
}

// The facets of an STL file come to what the same surface with vertices comes to.
TEST_F(BlocksCommand, ReadsStl) {
  ASSERT_EQ(aomd("convert s.ply s.stl").code, 0);
  ASSERT_EQ(aomd("convert s.stl t.ply").code, 0);
  const Outcome run = aomd("decimate s.stl a.ply --blocks 5 --target-faces 900");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  ASSERT_EQ(aomd("decimate t.ply b.ply --blocks 5 --target-faces 900").code, 0);
  EXPECT_EQ(text("a.ply"), text("b.ply"));
  ASSERT_EQ(aomd("convert s.stl text.stl --ascii").code, 0);
  expect_failure("decimate text.stl o.ply --blocks 5 --target-faces 900", 3,
                 "text.stl: STL as text cannot be read in blocks, only as a whole: aomd convert");
  std::filesystem::resize_file(at("s.stl"), 1000);
  expect_failure("decimate s.stl o.ply --blocks 5 --target-faces 900", 3,
                 "s.stl: byte 1000: the file ends early");
}

/// The same file, its arrays compressed as VTK's writers do.
std::string compressed(const std::string& vtu) {
  const std::size_t first = vtu.find('_', vtu.find("<AppendedData")) + 1;
  std::string data, text = vtu.substr(0, first);
  std::size_t at = 0;
  while ((at = text.find("offset=\"", at)) != std::string::npos) {
    const std::size_t end = text.find('"', at += 8), from = first + std::stoul(text.substr(at));
    std::uint64_t size = 0;
    std::memcpy(&size, vtu.data() + from, sizeof(size));
    text.replace(at, end - at, std::to_string(data.size()));
    const Packed packed =
        packed_in_blocks<std::uint64_t>(vtu.substr(from + sizeof(size), size), 32'768, Blocks::Vtk);
    data += packed.head + packed.data;
  }
  text.insert(text.find("<VTKFile ") + 9, "compressor=\"vtkZLibDataCompressor\" ");
  return text + data + "</AppendedData></VTKFile>";
}

TEST_F(BlocksCommand, ReadsCompressedVtu) {
  ASSERT_EQ(aomd("convert s.ply plain.vtu --binary").code, 0);
  const std::string packed = compressed(text("plain.vtu"));
  EXPECT_LT(packed.size(), text("plain.vtu").size() / 2);
  std::ofstream(at("packed.vtu"), std::ios::binary) << packed;
  ASSERT_EQ(aomd("decimate plain.vtu a.ply --blocks 5 --target-faces 900").code, 0);
  const Outcome run = aomd("decimate packed.vtu b.ply --blocks 5 --target-faces 900");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(text("a.ply"), text("b.ply"));
  std::string damaged = packed;
  damaged[damaged.size() / 2] ^= 1;
  std::ofstream(at("packed.vtu"), std::ios::binary) << damaged;
  expect_failure("decimate packed.vtu o.ply --blocks 5 --target-faces 900", 3,
                 "of compressed data is damaged");
  std::filesystem::resize_file(at("packed.vtu"), packed.size() - 200);
  expect_failure("decimate packed.vtu o.ply --blocks 5 --target-faces 900", 3,
                 "the data end early");
  EXPECT_FALSE(exists("o.ply"));
}

TEST_F(BlocksCommand, WritesAndReadsPieces) {
  ASSERT_EQ(aomd("decimate s.ply o.ply --target-faces 900 --quiet").code, 0);
  const Outcome run = aomd("decimate s.ply o.pvtu --target-faces 900 --pieces 3 --report r.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(json("r.json")["options"]["pieces"], 3);
  EXPECT_TRUE(exists("o_2.vtu"));
  EXPECT_FALSE(exists("o_3.vtu"));
  ASSERT_EQ(aomd("convert o.pvtu back.ply").code, 0);
  EXPECT_EQ(text("back.ply"), text("o.ply"));
  ASSERT_EQ(aomd("convert o.pvtu again.pvtu --pieces 2").code, 0);
  ASSERT_EQ(aomd("convert again.pvtu back.ply").code, 0);
  EXPECT_EQ(text("back.ply"), text("o.ply"));
  ASSERT_EQ(aomd("decimate o.pvtu coarse.ply --blocks 2 --target-faces 300").code, 0);
  EXPECT_EQ(aomd("check coarse.ply --require closed,manifold").code, 0);
}

TEST_F(BlocksCommand, PiecesAreNoInputsAndNeedAPvtu) {
  ASSERT_EQ(aomd("convert s.ply o.pvtu --pieces 2").code, 0);
  const std::string before = text("o_1.vtu");
  expect_failure("convert o_1.vtu o.pvtu --pieces 2", 2, "are one file: o_1.vtu");
  expect_failure("convert o.pvtu o_1.vtu", 2, "are one file: o_1.vtu");
  expect_failure("decimate o_0.vtu o.pvtu --target-faces 300", 2, "are one file");
  expect_failure("convert s.ply o.ply --pieces 2", 2, "--pieces is for .pvtu, and o.ply is none");
  expect_failure("convert s.ply o.pvtu --pieces 0", 2, "--pieces");
  expect_failure("convert s.ply - --format pvtu", 4, "it needs a place in a folder");
  EXPECT_EQ(text("o_1.vtu"), before);
  std::filesystem::remove(at("o_1.vtu"));
  expect_failure("convert o.pvtu o.ply", 3, "o_1.vtu");
  std::filesystem::create_directory(at("o_1.vtu"));  // a target that is none: nothing appears
  const std::string list = text("o.pvtu");
  expect_failure("convert s.ply o.pvtu --pieces 3", 4, "o_1.vtu");
  EXPECT_EQ(text("o.pvtu"), list);
  EXPECT_FALSE(exists("o_2.vtu"));
}

TEST_F(BlocksCommand, OneBlockIsNone) {
  ASSERT_EQ(aomd("decimate s.ply a.ply --target-faces 900 --blocks 1").code, 0);
  ASSERT_EQ(aomd("decimate s.ply b.ply --target-faces 900").code, 0);
  EXPECT_EQ(text("a.ply"), text("b.ply"));
}

TEST_F(BlocksCommand, ArraysGoAlongAndHaveNoSay) {
  MeshData mesh = make_sample("terrain", 20);
  io::write(at("bare.ply"), mesh);
  Attribute heat{.name = "heat", .values = {}};
  for (const glm::dvec3& p : mesh.positions) heat.values.push_back(p.x);
  mesh.attributes = {heat};
  io::write(at("t.ply"), mesh);
  const Outcome run = aomd("decimate t.ply o.ply --blocks 2 --target-faces 300");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  ASSERT_EQ(aomd("decimate bare.ply b.ply --blocks 2 --target-faces 300").code, 0);
  const MeshData result = io::read(at("o.ply")).mesh;
  EXPECT_EQ(result.positions, io::read(at("b.ply")).mesh.positions);
  ASSERT_EQ(result.attributes.size(), 1u);
  for (std::size_t v = 0; v < result.positions.size(); ++v)
    EXPECT_NEAR(result.attributes[0].values[v], result.positions[v].x, 0.1);
}

TEST_F(BlocksCommand, SaysWhatItLeavesBehind) {
  MeshData mesh = make_sample("terrain", 20);
  mesh.faces.classes.assign(mesh.faces.size(), ModelRef(2, 1));
  io::write(at("t.ply"), mesh);
  const Outcome run = aomd("decimate t.ply o.ply --blocks 2 --target-faces 300");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("left out, since blocks hold vertices and faces alone"), std::string::npos)
      << run.err;
}

TEST_F(BlocksCommand, RefusesWhatIsTooLarge) {
  MeshData mesh = make_sample("terrain", 20);
  for (glm::dvec3& p : mesh.positions) p *= 1e19;
  io::write(at("t.ply"), mesh);
  expect_failure("decimate t.ply o.ply --blocks 2 --target-faces 300", 5,
                 "t.ply: Only meshes from 1e-20 to 1e+18 across can be decimated");
}

TEST_F(BlocksCommand, NamesNothingThatItWouldRefuseWhereATargetIsMissed) {
  ASSERT_EQ(aomd("sample nonmanifold n.ply --size 20").code, 0);
  const Outcome whole = aomd("decimate n.ply o.ply --target-faces 4");
  EXPECT_NE(whole.err.find("--repair"), std::string::npos) << whole.err;
  const Outcome run = aomd("decimate n.ply o.ply --blocks 2 --target-faces 4");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("(aomd repair)"), std::string::npos) << run.err;
  for (const char* refused : {"--repair", "--reach", "--topology"})
    EXPECT_EQ(run.err.find(refused), std::string::npos) << run.err;
}

TEST_F(BlocksCommand, RefusesWhatItCannotDo) {
  expect_failure("decimate s.ply o.ply --blocks 2", 2, "--blocks requires --target-faces");
  expect_failure("decimate s.ply o.ply --blocks 0 --target-faces 9", 2, "--blocks");
  for (const char* other :
       {"--reach", "--spacing h", "--max-distance 1", "--no-intersections", "--topology paper",
        "--keep s.ply", "--only s.ply", "--journal j", "--repair", "--triangulate",
        "--model m.step", "--snap model", "--attributes none"})
    expect_failure(std::string("decimate s.ply o.ply --blocks 2 --target-faces 900 ") + other, 2,
                   "excludes --blocks");
  expect_failure("decimate s.ply o.ply --blocks 2 --target-faces 900 --strategy paper", 2,
                 "--blocks is for --strategy quality");
  ASSERT_EQ(aomd("convert s.ply s.off").code, 0);
  expect_failure("decimate s.off o.ply --blocks 2 --target-faces 900", 3,
                 "s.off: what is no PLY, STL or VTU cannot be read in blocks, only as a whole");
  expect_failure("decimate - o.ply --blocks 2 --target-faces 900", 3, "-: is no file");
  EXPECT_FALSE(exists("o.ply"));
}

}  // namespace
}  // namespace aomd::test::cli_blocks_test
