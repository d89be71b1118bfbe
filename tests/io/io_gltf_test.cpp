// glTF 2.0 read from files by hand and written: places, modes, types, seams, and what is refused.

#include <bit>
#include <cmath>

#include "core/io/base64.h"
#include "tests/support/io_helpers.h"

namespace aomd::test {
namespace {

using Notes = std::vector<std::string>;

template <class... Values>
std::string floats(Values... values) {
  return (raw(static_cast<float>(values)) + ...);
}

/// Puts a file together from its parts of JSON and the bytes of its one buffer.
struct Text {
  std::string meshes, accessors, views, bytes;
  std::string nodes = R"([{"mesh":0}])", more;

  [[nodiscard]] std::string str() const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":)" + meshes + R"(,"accessors":)" + accessors + R"(,"bufferViews":)" +
           views + more + R"(,"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + io::detail::to_base64(bytes) +
           R"("}]})";
  }
};

/// Four points, of which the file makes primitives.
Text square(const std::string& primitive = R"({"attributes":{"POSITION":0},"mode":5})") {
  Text text;
  text.meshes = R"([{"name":"sheet","primitives":[)" + primitive + "]}]";
  text.accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])";
  text.views = R"([{"buffer":0,"byteLength":48}])";
  text.bytes = floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
  return text;
}

io::ReadResult read(const Text& text) { return io::read_bytes("a.gltf", text.str()); }

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
  Text text = square();
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
Text split_square() {
  Text text;
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
  const Text text = split_square();
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
  Text text = square();
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
  Text text = square();
  text.bytes.replace(0, 4, floats(std::numeric_limits<double>::quiet_NaN()));
  expect_error("a.gltf", text.str(), {"accessor 0 has a position that is no number"});
}

TEST(Gltf, ZerosWithoutDataAreBounded) {
  Text text = square();
  text.accessors = R"([{"componentType":5126,"count":3,"type":"VEC3"}])";
  EXPECT_EQ(read(text).mesh.positions.size(), 1u);
  text.accessors = R"([{"componentType":5126,"count":4000000000,"type":"VEC3"}])";
  expect_error("a.gltf", text.str(), {"accessor 0 of 4000000000 elements has no data"});
}

MeshData sheet() {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  mesh.faces.add(Shape::Triangle, {2, 1, 3});
  return mesh;
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

const std::string png = "\x89PNG\r\n\x1a\npicture", jpeg = "\xff\xd8\xff\xe0picture";

MeshData painted(const TemporaryFolder& folder) {
  MeshData mesh = sheet();
  mesh.attributes = {{"material", 2, 1, true, {0, 1}}};
  mesh.attributes[0].names = {"wood", "paint"};
  mesh.corners = {};
  mesh.appearance.folder = (folder / "").string();
  mesh.appearance.pictures = {{"wood grain.png", {}}, {"inside", jpeg}};
  mesh.appearance.materials = {{.name = "wood", .colour = {0.5, 0.25, 1, 1}, .picture = 0},
                               {.name = "paint", .picture = 1, .metallic = 0.5, .two_sided = true}};
  io::write_file(folder / "wood grain.png", png);
  return mesh;
}

TEST(Gltf, MaterialsAndPicturesComeBack) {
  const TemporaryFolder folder;
  const MeshData mesh = painted(folder);
  for (const char* file : {"a.glb", "a.gltf"}) {
    EXPECT_EQ(io::write(folder / file, mesh), Notes{});
    const io::ReadResult again = io::read(folder / file);
    EXPECT_EQ(again.notes, Notes{"faces classified by 2 materials"});
    EXPECT_EQ(again.mesh.appearance.materials, mesh.appearance.materials);
    ASSERT_EQ(again.mesh.appearance.pictures.size(), 2u);
    const Picture& wood = again.mesh.appearance.pictures[0];
    EXPECT_EQ(wood.name, "wood grain.png");
    EXPECT_EQ(wood.bytes, std::string(file) == "a.glb" ? png : "");
    EXPECT_EQ(again.mesh.appearance.pictures[1], mesh.appearance.pictures[1]);
    EXPECT_EQ(again.mesh.attributes[0].names, mesh.attributes[0].names);
  }
}

TEST(Gltf, PicturesGoAlongToAnotherFolder) {
  const TemporaryFolder folder, other;
  const MeshData mesh = painted(folder);
  io::write(other / "a.gltf", mesh);
  EXPECT_EQ(bytes_of(other / "wood grain.png"), png);
  io::write_file(folder / "wood grain.png", "something else, by another mesh");
  io::write(other / "b.obj", mesh);
  EXPECT_EQ(bytes_of(other / "wood grain.png"), png) << "what is there stays";
  EXPECT_EQ(bytes_of(other / "b_wood grain.png"), "something else, by another mesh");
  EXPECT_EQ(bytes_of(other / "inside.jpg"), jpeg);
  EXPECT_EQ(bytes_of(other / "b.mtl"),
            "# AOMD Studio\nnewmtl wood\nKd 0.5 0.25 1\nd 1\nPm 0\nPr 1\nmap_Kd b_wood grain.png\n"
            "newmtl paint\nKd 1 1 1\nd 1\nPm 0.5\nPr 1\nmap_Kd inside.jpg\n");
  const io::ReadResult again = io::read(other / "b.obj");
  EXPECT_EQ(again.notes, Notes{"faces classified by 2 materials"});
  ASSERT_EQ(again.mesh.appearance.materials.size(), 2u);
  EXPECT_EQ(again.mesh.appearance.materials[0].colour, mesh.appearance.materials[0].colour);
  EXPECT_EQ(again.mesh.appearance.materials[1].metallic, 0.5);
  EXPECT_EQ(again.mesh.appearance.pictures[0].name, "b_wood grain.png");
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

TEST(Gltf, LibrariesOfObjGoAlong) {
  const TemporaryFolder folder, other;
  io::write_file(folder / "a.obj",
                 "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n");
  io::ReadResult result = io::read(folder / "a.obj");
  EXPECT_EQ(result.notes, Notes{"not there: material library \"m.mtl\""});
  io::write_file(folder / "m.mtl", "newmtl wood\nKd 0 0 0\nmap_Kd tex\\w.png\n");
  result = io::read(folder / "a.obj");
  EXPECT_EQ(result.notes, Notes{"not there: picture \"tex/w.png\""});
  EXPECT_EQ(io::write(other / "b.obj", result.mesh), Notes{});
  EXPECT_EQ(bytes_of(other / "m.mtl"), bytes_of(folder / "m.mtl"));
  EXPECT_EQ(io::write(other / "b.vtk", result.mesh),
            (Notes{"left out: names of \"material\", material library \"m.mtl\""}));
  EXPECT_EQ(io::write(folder / "b.glb", result.mesh), Notes{});
  const Appearance looks = io::read(folder / "b.glb").mesh.appearance;
  EXPECT_EQ(looks.materials[0].colour, (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_EQ(looks.pictures[0], (Picture{"tex/w.png", {}}));
}

TEST(Gltf, ThePictureOfAPlyGoesAlong) {
  const TemporaryFolder folder, other;
  MeshData mesh = sheet();
  mesh.remarks = {{"comment", "TextureFile wood.png"}};
  io::write_file(folder / "wood.png", png);
  io::write(folder / "a.ply", mesh);
  const MeshData read = io::read(folder / "a.ply").mesh;
  EXPECT_EQ(read.appearance.pictures, (std::vector<Picture>{{"wood.png", {}}}));
  EXPECT_EQ(io::write(other / "a.ply", read), Notes{});
  EXPECT_EQ(bytes_of(other / "wood.png"), png);
  EXPECT_EQ(io::write(other / "a.glb", read), Notes{});
  const MeshData embedded = io::read(other / "a.glb").mesh;
  EXPECT_EQ(embedded.appearance.pictures[0].bytes, png);
  const TemporaryFolder third;
  EXPECT_EQ(io::write(third / "a.ply", embedded), Notes{"left out: names of \"material\""});
  EXPECT_EQ(io::read(third / "a.ply").mesh.remarks, mesh.remarks);
}

}  // namespace
}  // namespace aomd::test
