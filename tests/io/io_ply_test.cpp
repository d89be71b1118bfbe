#include <gtest/gtest.h>

#include <limits>

#include "tests/support/io_helpers.h"

namespace aomd::io_ply_test {
namespace {

using test::expect_error;
using test::Indices;
using test::raw;

MeshData ply(std::string_view bytes) { return io::read_bytes("a.ply", bytes).mesh; }

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string three = "element vertex 3\n" + xyz;
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
const std::string triangle = header("ascii", three + one_face) + corners + "3 0 1 2\n";

TEST(Ply, ReadsText) {
  const MeshData mesh = ply(triangle);
  EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2}));
}

TEST(Ply, ReadsTextWithoutFinalNewlineAndWithCrLf) {
  EXPECT_EQ(ply(triangle.substr(0, triangle.size() - 1)).faces.size(), 1u);
  std::string windows;
  for (const char c : triangle) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(ply(windows).faces.vertices, (Indices{0, 1, 2}));
}

TEST(Ply, PassesOverWhatItDoesNotKnow) {
  const std::string text =
      header("ascii",
             "comment c\nobj_info o\nelement camera 2\nproperty list int float k\nproperty int i\n"
             "element vertex 3\nproperty uchar red\nproperty double x\nproperty double y\n"
             "property list uchar int n\nproperty double z\n"
             "element face 1\nproperty float q\nproperty list uint16 uint8 vertex_index\n"
             "property list uchar float texcoord\n");
  const MeshData mesh =
      ply(text + "2 0.5 0.5 7\n0 7\n9 0 0 0 0\n9 1 0 2 8 8 0\n9 0 1 0 0\n.5 3 0 1 2 2 .1 .2\n");
  EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2}));
}

/// A triangle and a quad with odd types, in both byte orders.
TEST(Ply, ReadsBinaryOfBothOrders) {
  for (const bool big : {false, true}) {
    std::string bytes = header(
        big ? "binary_big_endian" : "binary_little_endian",
        "element vertex 4\nproperty double x\nproperty short s\nproperty float y\nproperty int8 z\n"
        "property list ushort short junk\n"
        "element face 2\nproperty list int ushort vertex_indices\nproperty uchar red\n");
    const auto put = [&](auto value) { bytes += raw(value, big); };
    const int at[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& p : at) {
      put(p[0] + 0.1), put(std::int16_t{-2}), put(static_cast<float>(p[1])), put(std::int8_t{-3});
      put(std::uint16_t{2}), put(std::int16_t{5}), put(std::int16_t{6});
    }
    put(std::int32_t{3}), put(std::uint16_t{0}), put(std::uint16_t{1}), put(std::uint16_t{2}),
        put(std::uint8_t{255});
    put(std::int32_t{4}), put(std::uint16_t{0}), put(std::uint16_t{1}), put(std::uint16_t{2}),
        put(std::uint16_t{3});
    put(std::uint8_t{255});
    const MeshData mesh = ply(bytes);
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[2], glm::dvec3(1.1, 1, -3));
    EXPECT_EQ(mesh.faces.size(), 3u);
  }
}

TEST(Ply, FacesMayComeFirst) {
  const MeshData mesh = ply(header("ascii", one_face + "element vertex 4\n" + xyz) +
                            "4 0 1 2 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Ply, ReadsStrips) {
  const MeshData mesh =
      ply(header("ascii", "element vertex 5\n" + xyz +
                              "element tristrips 1\nproperty list int int vertex_indices\n") +
          "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 3 -1 2 3 4\n");
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(Ply, ReadsEdgesAndClassification) {
  const std::string model = "property uchar model_dimension\nproperty int model_tag\n";
  const MeshData mesh = ply(
      header("ascii", "element vertex 3\n" + xyz + model + one_face + model +
                          "element edge 1\nproperty int vertex1\nproperty int vertex2\n" + model) +
      "0 0 0 0 5\n1 0 0 1 -7\n0 1 0 7 0\n3 0 1 2 2 3\n0 1 1 -7\n");
  EXPECT_EQ(mesh.vertex_classes, (std::vector<ModelRef>{{0, 5}, {1, -7}, {}}));
  EXPECT_EQ(mesh.faces.classes, std::vector<ModelRef>{ModelRef(2, 3)});
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(mesh.edges.classes, std::vector<ModelRef>{ModelRef(1, -7)});
}

TEST(Ply, PolygonsGiveTheirClassToTheirTriangles) {
  const MeshData mesh =
      ply(header("ascii", "element vertex 4\n" + xyz + one_face +
                              "property uchar model_dimension\nproperty int model_tag\n") +
          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 2 9\n");
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 9}, {2, 9}}));
}

TEST(Ply, WithoutFacesIsAPointCloud) {
  EXPECT_EQ(ply(header("ascii", three) + corners).positions.size(), 3u);
}

TEST(Ply, RepeatedFacesStay) {
  EXPECT_EQ(
      ply(header("ascii", three + "element face 2\nproperty list uchar int vertex_indices\n") +
          corners + "3 0 1 2\n3 0 1 2\n")
          .faces.size(),
      2u);
}

TEST(Ply, NamesWhatItLeavesOut) {
  const std::string text =
      header("ascii", three +
                          "property float nx\nproperty uchar red\nproperty uchar green\n"
                          "property float quality\n" +
                          one_face +
                          "property uchar red\nproperty list uchar float texcoord\n"
                          "element camera 1\nproperty float f\nelement nothing 0\nproperty int n\n"
                          "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
                          "property float crease\n");
  const io::ReadResult result = io::read_bytes(
      "a.ply", text + "0 0 0 1 2 3 4\n1 0 0 1 2 3 4\n0 1 0 1 2 3 4\n3 0 1 2 9 1 5\n7\n0 1 5\n");
  EXPECT_EQ(result.mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(result.notes,
            std::vector<std::string>{
                "left out: element \"camera\", face texture coordinates that do not fit the "
                "corners"});
  std::vector<std::string> names;
  for (const Attribute& a : result.mesh.attributes) names.push_back(a.name);
  EXPECT_EQ(names, (std::vector<std::string>{"nx", "red", "green", "quality", "red", "crease"}))
      << "what is not complete is an array by itself";
  EXPECT_TRUE(io::read_bytes("a.ply", triangle).notes.empty());
}

TEST(Ply, WhatFollowsTheLastElementIsPassedOver) {
  const std::string start = header("binary_little_endian", three + one_face);
  const std::string binary =
      start + std::string(36, '\0') + raw(std::uint8_t{3}) + raw(0) + raw(1) + raw(2);
  for (const std::string& text : {triangle, binary}) {
    for (const char* rest : {"\n", "\r\n", " \n\t\n"}) {
      const io::ReadResult result = io::read_bytes("a.ply", text + rest);
      EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2}));
      EXPECT_TRUE(result.notes.empty()) << result.notes.front();
    }
    EXPECT_EQ(io::read_bytes("a.ply", text + "more\n").notes,
              std::vector<std::string>{"5 bytes after the last element passed over"});
  }
  EXPECT_EQ(io::read_bytes("a.ply", binary + '\0').notes,
            std::vector<std::string>{"1 byte after the last element passed over"});
}

TEST(Ply, BadHeadersSayTheLine) {
  expect_error("a.ply", "hello", {"a.ply:1: ", "does not start with \"ply\""});
  expect_error("a.ply", "ply\n", {"a.ply:2: ", "ends within the PLY header"});
  expect_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n",
               {"ends within the PLY header"});
  expect_error("a.ply", header("ebcdic", three), {"a.ply:2: ", "\"ebcdic\""});
  expect_error("a.ply", "ply\n" + three + "end_header\n", {"no format line"});
  expect_error("a.ply", header("ascii", "element vertex many\n"), {"a.ply:3: ", "\"many\""});
  expect_error("a.ply", header("ascii", "element vertex -3\n" + xyz), {"a.ply:3: "});
  expect_error("a.ply", header("ascii", "element vertex 99999999999999999999\n" + xyz),
               {"a.ply:3: "});
  expect_error("a.ply", header("ascii", "property float x\n"),
               {"a.ply:3: ", "before the first element"});
  expect_error("a.ply", header("ascii", "element vertex 3\nproperty quad x\n"),
               {"a.ply:4: ", "\"quad\""});
  expect_error("a.ply", header("ascii", "element vertex 3\nproperty float x\n"),
               {"a.ply:3: ", "x, y and z"});
  expect_error("a.ply", header("ascii", "element vertex 3\n"), {"a.ply:3: ", "no properties"});
  expect_error("a.ply", header("ascii", "element face 0\nproperty list uchar int vertex_indices\n"),
               {"no vertices"});
  expect_error("a.ply",
               header("ascii", three + "element face 1\nproperty int a\n") + corners + "1\n",
               {"a.ply:7: ", "vertex_indices"});
  expect_error("a.ply", header("ascii", three + "rubbish here\n"), {"a.ply:7: ", "\"rubbish\""});
}

TEST(Ply, BadTextSaysTheLine) {
  const std::string start = header("ascii", three + one_face);  // 9 lines
  const auto bad = [&](const std::string& body, std::initializer_list<const char*> fragments) {
    expect_error("a.ply", start + body, fragments);
  };
  bad("0 0 0\n1 0 0\n", {"a.ply:12: ", "ends after 2 of 3 of \"vertex\""});
  bad(corners, {"ends after 0 of 1 of \"face\""});
  bad("0 0 0\n1 0\n0 1 0\n3 0 1 2\n", {"a.ply:11: ", "before z"});
  bad("0 0 0\n1 0 0 5\n0 1 0\n3 0 1 2\n", {"a.ply:11: ", "unexpected \"5\""});
  bad("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", {"a.ply:11: ", "y is not a finite number"});
  bad("0 0 0\n1 0x1 0\n0 1 0\n3 0 1 2\n", {"a.ply:11: ", "\"0x1\""});
  bad(corners + "3 0 1 3\n", {"a.ply:13: ", "index 3 is out of range (0..2)"});
  bad(corners + "3 0 1 -1\n", {"a.ply:13: ", "index -1 is out of range"});
  bad(corners + "3 0 1\n", {"a.ply:13: ", "before a vertex index"});
  bad(corners + "3 0 1 1.5\n", {"a.ply:13: ", "\"1.5\""});
  bad(corners + "-3 0 1 2\n", {"a.ply:13: ", "negative length"});
  bad(corners + "4000000000 0 1 2\n", {"a.ply:13: ", "a list of 4000000000, longer than the rest"});
  expect_error("a.ply", header("ascii", "element vertex 4000000000\n" + xyz + one_face) + corners,
               {"ends after 3 of 4000000000"});
}

TEST(Ply, BadClassificationSaysTheLine) {
  const std::string start =
      header("ascii", three + one_face + "property int model_dimension\nproperty int model_tag\n");
  expect_error("a.ply", start + corners + "3 0 1 2 1 5\n",
               {"a.ply:15: ", "face cannot lie on a model entity of dimension 1"});
  expect_error("a.ply", start + corners + "3 0 1 2 4 5\n", {"a.ply:15: ", "dimension 4"});
  expect_error("a.ply", start + corners + "3 0 1 2 2 999999999\n", {"a.ply:15: ", "999999999"});
}

TEST(Ply, BadBinarySaysTheByte) {
  const std::string start = header("binary_little_endian", three + one_face);
  const auto vertices = [](float bad) {
    std::string bytes;
    for (const float x : {0.f, 0.f, 0.f, 1.f, bad, 0.f, 0.f, 1.f, 0.f}) bytes += raw(x);
    return bytes;
  };
  const auto face = [](int c) { return raw(std::uint8_t{3}) + raw(0) + raw(1) + raw(c); };
  const std::string good = start + vertices(0) + face(2);
  EXPECT_EQ(ply(good).faces.size(), 1u);
  const std::size_t s = start.size();
  const auto byte = [](std::size_t n) { return "byte " + std::to_string(n) + ":"; };
  expect_error("a.ply", start + vertices(std::numeric_limits<float>::quiet_NaN()) + face(2),
               {byte(s + 16).c_str(), "y is not a finite"});
  expect_error("a.ply", start + vertices(std::numeric_limits<float>::infinity()) + face(2),
               {byte(s + 16).c_str()});
  expect_error("a.ply", start + vertices(0) + face(3), {byte(s + 45).c_str(), "out of range"});
  expect_error("a.ply", start + vertices(0) + face(-1), {"out of range"});
  for (std::size_t size = s; size < good.size(); ++size) {
    expect_error("a.ply", good.substr(0, size), {"byte ", "the file"});
  }
  expect_error("a.ply",
               header("binary_big_endian", "element vertex 4294967295\n" + xyz) + vertices(0),
               {"ends early", "4294967295"});
}

}  // namespace
}  // namespace aomd::io_ply_test
