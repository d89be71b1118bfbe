// Materials and their pictures, in glTF, beside OBJ and beside PLY.

#include <nlohmann/json.hpp>

#include "tests/support/gltf_text.h"

namespace aomd::test::io_materials_test {
namespace {

using Notes = std::vector<std::string>;

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

TEST(Materials, MaterialsAndPicturesComeBack) {
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

/// A square whose material has all pictures, the colour's by the second set and turned.
GltfText dressed_square() {
  GltfText text = square(R"({"attributes":{"POSITION":0},"mode":5,"material":0})");
  text.more = R"(,"textures":[{"source":1},{"source":0}],
    "images":[{"uri":"bumps.png"},{"uri":"paint.png"}],
    "materials":[{"name":"skin","alphaMode":"MASK","alphaCutoff":0.25,"emissiveFactor":[0,0.5,1],
      "pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":1},
        "baseColorTexture":{"index":0,"texCoord":1,
          "extensions":{"KHR_texture_transform":{"offset":[0.5,0],"scale":[2,2]}}}},
      "normalTexture":{"index":1,"scale":0.5},"occlusionTexture":{"index":1,"texCoord":1},
      "emissiveTexture":{"index":0},
      "extensions":{"KHR_materials_clearcoat":{"clearcoatTexture":{"index":1}}}}])";
  return text;
}

nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(bytes_of(file));
}

TEST(Materials, WhatElseMaterialsSayComesBack) {
  const TemporaryFolder folder;
  io::write_file(folder / "bumps.png", png);
  io::write_file(folder / "paint.png", png);
  io::write_file(folder / "a.gltf", dressed_square().str());
  const io::ReadResult read = io::read(folder / "a.gltf");
  EXPECT_EQ(read.notes, Notes{});
  EXPECT_EQ(io::write(folder / "b.gltf", read.mesh), Notes{});
  const nlohmann::json given = json_of(folder / "a.gltf"), written = json_of(folder / "b.gltf");
  const nlohmann::json &before = given["materials"][0], &after = written["materials"][0];
  const auto picture = [](const nlohmann::json& file, const nlohmann::json& texture) {
    const auto& textures = file["textures"][texture["index"].get<std::size_t>()];
    return file["images"][textures["source"].get<std::size_t>()]["uri"].get<std::string>();
  };
  for (const char* key :
       {"/normalTexture", "/occlusionTexture", "/emissiveTexture",
        "/pbrMetallicRoughness/baseColorTexture", "/pbrMetallicRoughness/metallicRoughnessTexture",
        "/extensions/KHR_materials_clearcoat/clearcoatTexture"}) {
    nlohmann::json a = before.at(nlohmann::json::json_pointer(key)),
                   b = after.at(nlohmann::json::json_pointer(key));
    EXPECT_EQ(picture(given, a), picture(written, b)) << key;
    a.erase("index"), b.erase("index");
    EXPECT_EQ(a, b) << key;
  }
  for (const char* key : {"name", "alphaMode", "alphaCutoff", "emissiveFactor"})
    EXPECT_EQ(before[key], after[key]) << key;
  EXPECT_EQ(written["extensionsUsed"],
            (nlohmann::json{"KHR_materials_clearcoat", "KHR_texture_transform"}));
  EXPECT_EQ(io::read(folder / "b.gltf").mesh.remarks.size(), 1u);
}

TEST(Materials, OtherFormatsNameWhatElseMaterialsSay) {
  const TemporaryFolder folder;
  io::write_file(folder / "bumps.png", png);
  io::write_file(folder / "paint.png", png);
  io::write_file(folder / "a.gltf", dressed_square().str());
  const MeshData mesh = io::read(folder / "a.gltf").mesh;
  const std::string all =
      "left out: normal maps, occlusion maps, maps of metal and roughness, emission, blending of "
      "materials, transforms of texture coordinates, which texture coordinates pictures go by, "
      "extensions of materials";
  EXPECT_EQ(io::write(folder / "a.obj", mesh), Notes{all});
  EXPECT_EQ(io::write(folder / "a.off", mesh),
            Notes{"left out: attribute \"object\", attribute \"material\", 1 material"});
}

TEST(Materials, PicturesThatAreNotThereAreLeftOut) {
  const TemporaryFolder folder;
  GltfText text = square(R"({"attributes":{"POSITION":0},"mode":5,"material":0})");
  text.more = R"(,"materials":[{"name":"skin","normalTexture":{"index":7},
    "pbrMetallicRoughness":{"baseColorTexture":{"index":3,
      "extensions":{"KHR_texture_transform":{"scale":[2,2]}}}}}])";
  io::write_file(folder / "a.gltf", text.str());
  const io::ReadResult read = io::read(folder / "a.gltf");
  EXPECT_EQ(read.notes, Notes{"left out: pictures that are not there"});
  io::write(folder / "b.gltf", read.mesh);
  const nlohmann::json material = json_of(folder / "b.gltf")["materials"][0];
  EXPECT_FALSE(material.contains("normalTexture"));
  EXPECT_FALSE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
}

TEST(Materials, WhatIsOfAnotherTypeIsLeftOut) {
  for (const char* said :
       {R"("normalTexture":5)", R"("normalTexture":{"index":-1})", R"("alphaMode":3)",
        R"("pbrMetallicRoughness":[1])", R"("pbrMetallicRoughness":{"baseColorTexture":[1]})",
        R"("extensions":[{"anyTexture":{"index":0}}])", R"("occlusionTexture":{"index":"x"})"}) {
    GltfText text = square(R"({"attributes":{"POSITION":0},"mode":5,"material":0})");
    text.more = std::string(R"(,"materials":[{"name":"skin",)") + said + "}]";
    EXPECT_TRUE(io::read_bytes("a.gltf", text.str()).mesh.remarks.empty()) << said;
  }
}

/// An OBJ whose library names a map of normals beside the picture of the colour.
MeshData with_normal_map(const TemporaryFolder& folder) {
  io::write_file(folder / "a.mtl", "newmtl skin\nmap_Kd paint.png\nnorm bumps.png\n");
  io::write_file(folder / "a.obj",
                 "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl skin\nf 1 2 3\n");
  io::write_file(folder / "paint.png", png);
  io::write_file(folder / "bumps.png", jpeg);
  return io::read(folder / "a.obj").mesh;
}

TEST(Materials, AllMapsOfALibraryGoAlong) {
  const TemporaryFolder folder, other, third;
  const MeshData mesh = with_normal_map(folder);
  EXPECT_EQ(io::write(other / "b.obj", mesh), Notes{});
  EXPECT_EQ(bytes_of(other / "bumps.png"), jpeg);
  EXPECT_EQ(bytes_of(other / "a.mtl"), bytes_of(folder / "a.mtl"));
  io::write_file(third / "bumps.png", "of another mesh");
  EXPECT_EQ(io::write(third / "b.obj", mesh),
            Notes{"left out: pictures of materials but that of their colour"});
  EXPECT_EQ(bytes_of(third / "bumps.png"), "of another mesh");
  EXPECT_EQ(io::read(third / "b.obj").mesh.appearance.pictures[0].name, "paint.png");
}

TEST(Materials, MapsThatAreNotThereOrHaveNoPlaceAreNamed) {
  const TemporaryFolder folder;
  const MeshData mesh = with_normal_map(folder);
  EXPECT_EQ(io::to_bytes("a.glb", io::Format::Gltf, mesh).notes,
            Notes{"left out: pictures of materials but that of their colour"});
  std::filesystem::remove(folder / "bumps.png");
  EXPECT_EQ(io::read(folder / "a.obj").notes, Notes{"not there: picture \"bumps.png\""});
}

TEST(Materials, PicturesGoAlongToAnotherFolder) {
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

TEST(Materials, LibrariesOfObjGoAlong) {
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

TEST(Materials, ThePictureOfAPlyGoesAlong) {
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
}  // namespace aomd::test::io_materials_test
