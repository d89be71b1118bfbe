// glTF 2.0 read from files by hand and written: places, modes, types, seams, and what is refused.

#include <bit>
#include <cmath>

#include "tests/support/gltf_text.h"

namespace aomd::test::io_gltf_test {
namespace {

using Notes = std::vector<std::string>;

io::ReadResult read(const GltfText& text) { return io::read_bytes("a.gltf", text.str()); }

Indices faces_of_mode(int mode) {
  return read(square(R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}"))
      .mesh.faces.vertices;
}

TEST(Gltf, StripsAndFansAreTriangles) {
  EXPECT_EQ(faces_of_mode(5), (Indices{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(faces_of_mode(6), (Indices{0, 1, 2, 0, 2, 3}));
  expect_error("a.gltf", square(R"({"attributes":{"POSITION":0},"mode":4})").str(),
               {"a primitive of 4 vertices ends within a triangle"});
  expect_error("a.gltf", square(R"({"attributes":{"POSITION":0},"mode":7})").str(),
               {"a primitive has mode 7"});
}

TEST(Gltf, LinesAreEdges) {
  for (const auto& [mode, ends] :
       {std::pair(1, Indices{0, 1, 2, 3}), std::pair(2, Indices{0, 1, 1, 2, 2, 3, 3, 0}),
        std::pair(3, Indices{0, 1, 1, 2, 2, 3})}) {
    const std::string primitive =
        R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}";
    EXPECT_EQ(read(square(primitive)).mesh.edges.vertices, ends) << mode;
  }
}

TEST(Gltf, PointsAreVertices) {
  const MeshData mesh = read(square(R"({"attributes":{"POSITION":0},"mode":0})")).mesh;
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(Gltf, NodesPlaceAndMirror) {
  GltfText text = square();
  text.nodes = R"([{"name":"top","translation":[10,0,0],"children":[1,2]},
    {"name":"near","mesh":0,"scale":[2,2,2]},
    {"name":"turned","mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])";
  io::ReadResult two = read(text);
  ASSERT_EQ(two.mesh.positions.size(), 8u);
  EXPECT_EQ(two.mesh.positions[3], glm::dvec3(12, 2, 0));
  EXPECT_NEAR(two.mesh.positions[5].x, 10, 1e-15);
  EXPECT_NEAR(two.mesh.positions[5].y, 1, 1e-15);
  EXPECT_EQ(two.notes, Notes{"faces classified by 2 objects"});
  ASSERT_EQ(two.mesh.attributes.size(), 1u);
  EXPECT_EQ(two.mesh.attributes[0].names, (Notes{"near", "turned"}));
  text.nodes = R"([{"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]}])";
  const MeshData mirrored = read(text).mesh;
  EXPECT_EQ(mirrored.positions[1], glm::dvec3(-1, 0, 5));
  EXPECT_EQ(mirrored.faces.vertices, (Indices{0, 2, 1, 2, 3, 1})) << "still looking up";
}

/// Two triangles with vertices of their own.
GltfText split_square() {
  GltfText text;
  text.meshes = R"([{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,)"
                R"("COLOR_0":3,"_HEAT":4}}]}])";
  text.accessors = R"([{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},
    {"bufferView":1,"componentType":5126,"count":6,"type":"VEC3"},
    {"bufferView":2,"componentType":5123,"normalized":true,"count":6,"type":"VEC2"},
    {"bufferView":3,"componentType":5121,"normalized":true,"count":6,"type":"VEC3"},
    {"bufferView":4,"componentType":5122,"count":6,"type":"SCALAR"}])";
  text.views = R"([{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":72},
    {"buffer":0,"byteOffset":144,"byteLength":24},
    {"buffer":0,"byteOffset":168,"byteLength":24,"byteStride":4},
    {"buffer":0,"byteOffset":192,"byteLength":12}])";
  text.bytes = floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  for (int i = 0; i < 6; ++i) text.bytes += floats(0, 0, 1);
  for (const int u : {0, 0, 65535, 0, 0, 65535, 65535, 65535, 13107, 0, 65535, 65535})
    text.bytes += raw(static_cast<std::uint16_t>(u));
  for (const int c : {10, 20, 30, 20, 40, 30})
    text.bytes += std::string(3, static_cast<char>(c)) + '\0';
  for (const int h : {-1, 2, 3, 2, 400, 3}) text.bytes += raw(static_cast<std::int16_t>(h));
  return text;
}

/// Places are shared, and what differs is on corners.
TEST(Gltf, VerticesOfOnePlaceAreOneAndSeamsAreOnCorners) {
  const GltfText text = split_square();
  const io::ReadResult result = read(text);
  EXPECT_EQ(result.notes, Notes{});
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 1, 3, 2}));
  ASSERT_EQ(mesh.attributes.size(), 3u);
  const Attribute color{"color",
                        0,
                        3,
                        true,
                        {10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40},
                        NumberType::UInt8,
                        Meaning::Colour};
  EXPECT_EQ(mesh.attributes[0], color);
  EXPECT_EQ(mesh.attributes[1].name, "normal");
  EXPECT_EQ(mesh.attributes[2],
            (Attribute{"HEAT", 0, 1, true, {-1, 2, 3, 400}, NumberType::Int16}));
  ASSERT_EQ(mesh.corners.size(), 1u);
  EXPECT_EQ(mesh.corners[0].name, "uv");
  const std::vector<double> uv{0, 1, 1, 1, 0, 0, 1, 0, 13107.f / 65535.f, 1, 1, 0};
  ASSERT_EQ(mesh.corners[0].values.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_FLOAT_EQ(mesh.corners[0].values[i], uv[i]) << i;
}

TEST(Gltf, SparseAccessorsReplaceSome) {
  GltfText text = square();
  text.accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{)"
                   R"("count":1,"indices":{"bufferView":1,"componentType":5121},)"
                   R"("values":{"bufferView":2}}}])";
  text.views = R"([{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":1},
    {"buffer":0,"byteOffset":52,"byteLength":12}])";
  text.bytes += std::string("\3\0\0\0", 4) + floats(5, 6, 7);
  EXPECT_EQ(read(text).mesh.positions[3], glm::dvec3(5, 6, 7));
  text.bytes[48] = 4;
  expect_error("a.gltf", text.str(), {"accessor 0 has a sparse value at 4, and 4 elements"});
}

std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Gltf, WhatIsDamagedIsRefusedInOneLine) {
  const std::string good = square().str();
  EXPECT_EQ(error_of("a.gltf", good), "");
  const struct {
    const char *from, *to, *said;
  } cases[] = {
      {R"("count":4)", R"("count":5)", "accessor 0 of 5 elements goes beyond its view of 48 bytes"},
      {R"("count":4)", R"("count":18446744073709551615)", "goes beyond its view"},
      {R"("count":4)", R"("count":-1)", "no sound glTF"},
      {R"("bufferView":0)", R"("bufferView":9)", "there is no buffer view 9"},
      {R"("byteLength":48})", R"("byteLength":480})",
       "buffer view 0 goes beyond its buffer of 48 bytes"},
      {R"("buffer":0)", R"("buffer":3)", "buffer view 0 is of buffer 3, which is not there"},
      {R"("POSITION":0)", R"("POSITION":3)", "there is no accessor 3"},
      {R"("mesh":0)", R"("mesh":2)", "there is no mesh 2"},
      {R"("mesh":0)", R"("mesh":0,"children":[0])",
       "node 0 has two parents, or is part of a circle"},
      {R"("mesh":0)", R"("mesh":0,"scale":[1,2])", "node 0 is placed by other than 3 numbers"},
      {R"("nodes":[0])", R"("nodes":[7])", "there is no node 7"},
      {R"("scene":0)", R"("scene":5)", "there is no scene 5"},
      {R"("mode":5)", R"("mode":5,"material":2)", "there is no material 2"},
      {R"("mode":5)", R"("mode":5,"indices":0)", "accessor 0 lists vertices"},
      {R"("componentType":5126)", R"("componentType":5124)", "numbers of type 5124"},
      {R"("2.0")", R"("1.0")", "is glTF \"1.0\", and only 2.0 can be read"},
      {R"("asset")", R"("assets")", "is JSON, but no glTF file"},
      {R"("scene":0)", R"("extensionsRequired":["KHR_draco_mesh_compression"])",
       "is compressed by Draco"},
      {R"("mode":5)", R"("mode":5,"extensions":{"KHR_draco_mesh_compression":{}})",
       "is compressed by Draco"},
      {R"("scene":0)", R"("extensionsRequired":["EXT_meshopt_compression"])",
       "is compressed by meshoptimizer"},
      {"data:application/octet-stream;base64,", "../missing.bin", "cannot be read"},
      {R"("byteLength":48,"uri")", R"("byteLength":480,"uri")",
       "buffer 0 is promised 480 bytes, and there are 48"},
  };
  for (const auto& each : cases)
    expect_error("a.gltf", without(good, each.from, each.to), {"a.gltf: ", each.said});
  expect_error("a.gltf", good.substr(0, 100), {"a.gltf:1: this is no JSON"});
  expect_error("a.gltf", std::string(100'000, '['), {"nested too deeply"});
  GltfText text = square();
  text.bytes.replace(0, 4, floats(std::numeric_limits<double>::quiet_NaN()));
  expect_error("a.gltf", text.str(), {"accessor 0 has a position that is no number"});
}

TEST(Gltf, ZerosWithoutDataAreBounded) {
  GltfText text = square();
  text.accessors = R"([{"componentType":5126,"count":3,"type":"VEC3"}])";
  EXPECT_EQ(read(text).mesh.positions.size(), 1u);
  text.accessors = R"([{"componentType":5126,"count":4000000000,"type":"VEC3"}])";
  expect_error("a.gltf", text.str(), {"accessor 0 of 4000000000 elements has no data"});
}

std::string glb(const MeshData& mesh) {
  return io::to_bytes("a.glb", io::Format::Gltf, mesh).bytes;
}

TEST(Gltf, ABinaryFileIsCheckedAgainstItsHeader) {
  const std::string good = glb(sheet());
  EXPECT_EQ(io::read_bytes("a", good).mesh, sheet());
  expect_error("a.glb", good.substr(0, good.size() - 1), {"the file ends early"});
  expect_error("a.glb", good.substr(0, 15), {"ends early"});
  std::string other = good;
  other[4] = 1;
  expect_error("a.glb", other, {"is glTF 1, and only 2.0 can be read"});
  other = good;
  other[15] = 1;
  expect_error("a.glb", other, {"a chunk is promised"});
}

/// Vertices at one place stay apart, and those that nothing uses stay.
TEST(Gltf, VerticesAreTheSameAgain) {
  MeshData mesh = sheet();
  mesh.positions.push_back({1, 0, 0});
  mesh.positions.push_back({5, 5, 5});
  mesh.faces.vertices[4] = 4;
  mesh.edges.add(Shape::Line, {0, 3});
  EXPECT_EQ(io::read_bytes("a.glb", glb(mesh)).mesh, mesh);
}

/// Numbers that are none stay so where a whole face, or an unused vertex, has none.
TEST(Gltf, WhatIsNoNumberIsLeftOutOrNamed) {
  MeshData mesh = sheet();
  mesh.positions.push_back({5, 5, 5});
  const double none = std::numeric_limits<double>::quiet_NaN();
  mesh.attributes = {{"u", 0, 1, false, {1, 2, 3, 4, none}, NumberType::Float32}};
  io::EncodedMesh encoded = io::to_bytes("a.glb", io::Format::Gltf, mesh);
  EXPECT_EQ(encoded.notes, Notes{});
  MeshData again = io::read_bytes("a.glb", encoded.bytes).mesh;
  ASSERT_EQ(again.attributes.size(), 1u);
  EXPECT_TRUE(std::isnan(again.attributes[0].values[4]));
  mesh.attributes[0].values[3] = none;
  encoded = io::to_bytes("a.glb", io::Format::Gltf, mesh);
  EXPECT_EQ(encoded.notes, Notes{"1 value at corners that are no numbers written as 0"});
  again = io::read_bytes("a.glb", encoded.bytes).mesh;
  EXPECT_EQ(again.attributes[0].values[3], 0);
}

/// 32-bit floats far from the origin, and what to do about it.
TEST(Gltf, RoundedCoordinatesAreNamed) {
  MeshData mesh = sheet();
  for (glm::dvec3& p : mesh.positions) p.x += 1e5 + 1e-3;
  const Notes notes = io::to_bytes("a.glb", io::Format::Gltf, mesh).notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "coordinates rounded to 32-bit floats by up to 0.001; .ply keeps them");
  for (glm::dvec3& p : mesh.positions) p.x += 1e12;
  try {
    (void)io::to_bytes("a.glb", io::Format::Gltf, mesh);
    FAIL();
  } catch (const io::WriteError& error) {
    EXPECT_TRUE(std::string(error.what()).ends_with(": write .ply, or move the mesh to the origin"))
        << error.what();
  }
}

TEST(Gltf, NumbersThatHaveNoPlaceAreNamed) {
  MeshData mesh = sheet();
  mesh.attributes = {{"six", 0, 6, false, std::vector<double>(24, 1)},
                     {"large", 0, 1, true, {1, 2, 3, 123456789}},
                     {"whole", 0, 1, true, {1, 2, 3, 70000}},
                     {"byface", 2, 1, false, {1, 2}}};
  const io::EncodedMesh encoded = io::to_bytes("a.glb", io::Format::Gltf, mesh);
  EXPECT_EQ(encoded.notes,
            Notes{"left out: attribute \"six\", attribute \"large\", attribute \"byface\""});
  const MeshData again = io::read_bytes("a.glb", encoded.bytes).mesh;
  ASSERT_EQ(again.attributes.size(), 1u);
  EXPECT_EQ(again.attributes[0].values, mesh.attributes[2].values);
}

/// By the second set go maps of light, which jump nowhere, while the first one has seams.
TEST(Gltf, SetsOfTextureCoordinatesKeepTheirNumbers) {
  MeshData mesh = sheet();
  Attribute second{"uv_1", 0, 2, false, {0, 0, 1, 0, 1, 1, 0, 1}};
  Attribute first{"uv", 2, 2, false, {0, 0, 1, 0, 1, 1, 0.5, 0, 1, 1, 0, 1}};
  for (Attribute* a : {&first, &second}) a->meaning = Meaning::Texture;
  for (const bool seams : {true, false}) {
    mesh.attributes = {second};
    mesh.corners = {first};
    if (!seams) {
      mesh.corners[0].name = "uv_1";
      mesh.attributes[0].name = "uv";
    }
    const MeshData again =
        io::read_bytes("a.glb", io::to_bytes("a.glb", io::Format::Gltf, mesh).bytes).mesh;
    ASSERT_EQ(again.corners.size(), 1u);
    EXPECT_EQ(again.corners[0].name, mesh.corners[0].name);
    EXPECT_EQ(again.corners[0].values, mesh.corners[0].values);
    EXPECT_EQ(again.attributes[0].values, mesh.attributes[0].values);
  }
}

TEST(Gltf, AFileOfItsNumbersIsNotWrittenOverAnothers) {
  const TemporaryFolder folder;
  io::write_file(folder / "a.bin", "of another mesh");
  for (int times = 0; times < 2; ++times) {
    io::write(folder / "a.gltf", sheet());
    EXPECT_EQ(io::read(folder / "a.gltf").mesh, sheet());
    EXPECT_EQ(bytes_of(folder / "a.bin"), "of another mesh") << times;
  }
  EXPECT_EQ(folder.entries(), 3u);
  std::filesystem::remove(folder / "a.bin");
  io::write(folder / "b.gltf", sheet());
  EXPECT_EQ(io::read(folder / "b.gltf").mesh, sheet());
  EXPECT_TRUE(std::filesystem::exists(folder / "b.bin"));
}

}  // namespace
}  // namespace aomd::test::io_gltf_test
