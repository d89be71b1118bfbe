#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/io_helpers.h"

namespace aomd::io_obj_test {
namespace {

using test::expect_error;
using test::Indices;

MeshData obj(std::string_view text) { return io::read_bytes("a.obj", text).mesh; }

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsTriangles) {
  const MeshData mesh = obj(square + "f 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_FALSE(mesh.classified());
}

TEST(Obj, WeldsByPositionIndexAndKeepsUnusedVertices) {
  const MeshData mesh =
      obj(square + "v 9 9 9\nvn 0 0 1\nvn 0 0 -1\nvt 0 0\nf 1/1/1 2/1/1 3/1/2\nf 1//2 3//1 4//1\n");
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Obj, NegativeIndicesCountFromTheLastVertexSoFar) {
  const MeshData mesh = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(obj("f 1 2 3\n" + square).faces.vertices, (Indices{0, 1, 2}));
}

TEST(Obj, CoordinatesAreExactlyRounded) {
  // tinyobjloader 2.0 rc10 alone gets these wrong in the last places.
  const MeshData mesh =
      obj("v 0.1234567890123456 1e-300 123456789.123456789\nv +.5 1. -1E3\nv 1 0 0\nf 1 2 3");
  EXPECT_EQ(mesh.positions[0], glm::dvec3(0.1234567890123456, 1e-300, 123456789.123456789));
  EXPECT_EQ(mesh.positions[1], glm::dvec3(0.5, 1, -1000));
}

TEST(Obj, LinesBecomeEdges) {
  const MeshData mesh = obj(square + "l 1 2 3\nl -1 1/1\nf 1 2 3\n");
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1, 1, 2, 3, 0}));
}

TEST(Obj, OtherLineEndsCommentsAndContinuations) {
  for (const char* text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "v 0 0 0 # o\nv\t1 0 0\n  v 0 1 0  \nf 1 2 \\\n 3 # f",
        "v 0 0 0\nv 1 0 0\nv 0 1 \\\r\n0\nf 1 2 3"}) {
    const MeshData mesh = obj(text);
    EXPECT_EQ(mesh.positions.size(), 3u) << text;
    EXPECT_EQ(mesh.positions[2], glm::dvec3(0, 1, 0)) << text;
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2})) << text;
  }
}

TEST(Obj, WeightsAndColoursArePassedOver) {
  EXPECT_EQ(obj("v 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 0 1 0\nf 1 2 3\n").positions[1],
            glm::dvec3(1, 0, 0));
}

TEST(Obj, PolygonsAreTriangulatedAndNoted) {
  const io::ReadResult result = io::read_bytes("a.obj", square + "f 1 2 3 4\n");
  EXPECT_EQ(result.mesh.faces.size(), 2u);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0], "1 polygon triangulated");
}

TEST(Obj, PolygonsAreSplitSoundlyInTheirPlace) {
  const MeshData mesh = obj("v 0 0 0\nv 4 .5 0\nv 0 1 0\nv 1 .5 0\nf 1 2 3\nf 1 2 3 4\nf 1 2 4\n");
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 1, 3, 1, 2, 3, 0, 1, 3}));
}

/// tinyobjloader's own polygons stop at 255 corners.
TEST(Obj, LargePolygonsLoseNothing) {
  std::string text, face = "f";
  for (int i = 0; i < 1000; ++i) {
    text += "v " + std::to_string(std::cos(i * 0.00628318)) + ' ' +
            std::to_string(std::sin(i * 0.00628318)) + " 0\n";
    face += ' ' + std::to_string(i + 1);
  }
  EXPECT_EQ(obj(text + face).faces.size(), 998u);
}

TEST(Obj, IndicesAfterSlashesMayBeMissing) {
  const io::ReadResult result = io::read_bytes(
      "a.obj", square + "vt 0 0\nvn 0 0 1\nf 1/ 2/1/ 3//\nf -4// 3//1 4/1/1\nf 1/0 2/99 4/-7/0\n");
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3, 0, 1, 3}));
  EXPECT_EQ(result.notes, std::vector<std::string>{"left out: uv indices out of range"});
}

TEST(Obj, NamesWhatItLeavesOut) {
  const io::ReadResult result =
      io::read_bytes("a.obj", "mtllib a.mtl\n" + square +
                                  "v 9 9 9 .1 .2 .3\nvt 0 0 \\\n0\nvn 0 0 1\ns 1\np 1\n"
                                  "vp 0 1\nshadow_obj x\nusemtl red\nf 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(result.notes,
            std::vector<std::string>{"left out: points, free-form geometry, \"shadow_obj\" lines"});
  EXPECT_EQ(io::read_bytes("a.obj", "vn 0 0 1\nvt 0 0\n" + square + "f 1 2 3\n").notes,
            std::vector<std::string>{
                "left out: uv values that no face names, normal values that no face names"});
  EXPECT_TRUE(io::read_bytes("a.obj", "# c\n#c\ns off\n" + square + "s 0\nv 1 1 1 1\nf 1 2 3\n")
                  .notes.empty());
}

TEST(Obj, GroupsThenObjectsThenMaterialsClassify) {
  const auto tags = [](const std::string& text) {
    std::vector<int> found;
    for (const ModelRef m : obj(square + text).faces.classes)
      found.push_back(m.valid() ? m.tag() : -1);
    return found;
  };
  using Tags = std::vector<int>;
  EXPECT_EQ(tags("g a\nf 1 2 3\ng b\nf 1 3 4\ng a\nf 1 2 4\n"), (Tags{1, 2, 1}));
  EXPECT_EQ(tags("f 1 2 3\ng b\nf 1 3 4\n"), (Tags{1, 2}));
  EXPECT_EQ(tags("o a\nf 1 2 3\no b\nf 1 3 4\n"), (Tags{1, 2}));
  EXPECT_EQ(tags("g all\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n"), (Tags{1, 2}));
  EXPECT_EQ(tags("g one\no one\nusemtl one\nf 1 2 3\n"), Tags{});
  EXPECT_EQ(tags("g a\ng b\nf 1 2 3\n"), Tags{}) << "a group without faces is no model face";
  EXPECT_EQ(tags("g model_face_7\nf 1 2 3\ng unclassified\nf 1 3 4\n"), (Tags{7, -1}));
}

TEST(Obj, ClassificationIsNoted) {
  const io::ReadResult result = io::read_bytes("a.obj", square + "g a\nf 1 2 3\ng b\nf 1 3 4\n");
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0], "faces classified by 2 groups");
}

TEST(Obj, BadInputsSayTheLine) {
  const auto bad = [](const std::string& text, std::initializer_list<const char*> fragments) {
    expect_error("a.obj", square + text, fragments);
  };
  bad("f 1 2 5\n", {"a.obj:5: ", "index 5 is out of range (1..4)"});
  bad("\n# c\nf 1 2 -5\n", {"a.obj:7: ", "out of range"});
  bad("f 0 1 2\n", {"a.obj:5: ", "index 0"});
  bad("f 1 2 4294967297\n", {"a.obj:5: ", "4294967297"});
  bad("f 1 2 x\n", {"a.obj:5: ", "\"x\""});
  bad("f 1 2 3x\n", {"a.obj:5: ", "\"3x\""});
  bad("f 1 2 3/x\n", {"a.obj:5: ", "\"3/x\""});
  bad("f 1 2 /3\n", {"a.obj:5: ", "\"/3\""});
  bad("f 1 2 3///\n", {"a.obj:5: ", "\"3///\""});
  bad("f 1 2 3/1/1/1\n", {"a.obj:5: ", "\"3/1/1/1\""});
  bad("f 1 2 2 5\n", {"a.obj:5: ", "index 5 is out of range (1..4)"});
  bad("v 1 2\nf 1 2 3\n", {"a.obj:5: ", "before z"});
  bad("v 1 2 nan\nf 1 2 3\n", {"a.obj:5: ", "finite"});
  bad("v 1 2 -inf\nf 1 2 3\n", {"a.obj:5: ", "finite"});
  bad("v 1 2 1e999\nf 1 2 3\n", {"a.obj:5: ", "finite"});
  bad("v 1 2 three\nf 1 2 3\n", {"a.obj:5: ", "\"three\""});
  bad("v 1 2 3 four\nf 1 2 3\n", {"a.obj:5: ", "\"four\""});
  bad("l 1 9\n", {"a.obj:5: ", "out of range"});
  bad(std::string("f 1 2 3\0\n1", 10), {"a.obj: byte 39: ", "zero byte"});
  expect_error("a.obj", "hello world\n", {"a.obj: ", "not an OBJ"});
}

}  // namespace
}  // namespace aomd::io_obj_test
