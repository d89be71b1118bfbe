#include <gtest/gtest.h>

#include <limits>

#include "tests/support/io_helpers.h"

namespace aomd::io_off_stl_test {
namespace {

using test::expect_error;
using test::Indices;
using test::raw;

MeshData off(std::string_view bytes) { return io::read_bytes("a.off", bytes).mesh; }
MeshData stl(std::string_view bytes) { return io::read_bytes("a.stl", bytes).mesh; }

TEST(Off, ReadsItsVariants) {
  for (const char* text :
       {"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
        "OFF 4 2 0\n# c\n0 0 0\n1 0 0 # c\n\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 "
        "1\n# end",
        "# first\nOFF\n4 2\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2\r\n3 0 2 3",
        "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
        "COFF\n4 2 0\n0 0 0 1 1 1 1\n1 0 0 255 0 0\n1 1 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n3 0 2 "
        "3\n",
        "NCOFF\n4 2 0\n0 0 0 0 0 1 9 9 9 9\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
        "NOFF\n4 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n3 0 2 3\n",
        "OFF\n4\n2\n5\n0 0 0\n1 0\n0\n1\n1 0\n0 1 0\n3 0 # c\n# c\n1\n2\n3\n0 2 3 9 9 9\n",
        "OFF\n4\n2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3\n0 1 2\n3 0 2 3",
        "4OFF\n4 2 0\n0 0 0 1\n2 0 0 2\n.5 .5 0 .5\n0 1 0 1\n3 0 1 2\n3 0 2 3\n",
        "STCNOFF\n4 2 0\n0 0 0 0 0 1 1 1 1 0 0 1\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"}) {
    const MeshData mesh = off(text);
    ASSERT_EQ(mesh.positions.size(), 4u) << text;
    EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0)) << text;
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3})) << text;
  }
}

std::string binary_off(float x, int last_index, bool big = true) {
  std::string bytes = "OFF BINARY\n";
  for (const int n : {3, 1, 0}) bytes += raw(n, big);
  for (const float c : {0.f, 0.f, 0.f, x, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw(c, big);
  for (const int n : {3, 0, 1, last_index, 1}) bytes += raw(n, big);
  return bytes + raw(0.5f, big);  // one colour value
}

TEST(Off, ReadsBinary) {
  EXPECT_EQ(off(binary_off(1, 2)).faces.vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(off(binary_off(1, 2)).positions[1], glm::dvec3(1, 0, 0));
}

TEST(Off, TellsByteOrdersApart) {
  const io::ReadResult small = io::read_bytes("a.off", binary_off(1, 2, false) + '\n');
  EXPECT_EQ(small.mesh.faces.vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(small.mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(small.notes,
            (std::vector<std::string>{"left out: face colours", "read as little-endian"}));
  // 65,536 vertices read from the wrong end are 256, which this file has room for as well.
  for (const bool big : {false, true}) {
    std::string bytes = "OFF BINARY\n";
    for (const int n : {65536, 65536, 0}) bytes += raw(n, big);
    for (int i = 0; i < 3 * 65536; ++i) bytes += raw(static_cast<float>(i), big);
    for (int i = 0; i < 65536; ++i)
      for (const int n : {3, 0, 1, i + 2 - 2 * (i / 65534), 0}) bytes += raw(n, big);
    const MeshData mesh = off(bytes);
    ASSERT_EQ(mesh.positions.size(), 65536u);
    EXPECT_EQ(mesh.positions[65535].z, 196607);
    EXPECT_EQ(mesh.faces.size(), 65536u);
  }
}

TEST(Off, BigEndianWinsWhereBothMakeSense) {
  EXPECT_TRUE(io::read_bytes("a.off", "OFF BINARY\n" + std::string(12, '\0')).notes.empty());
}

TEST(Off, NamesWhatItLeavesOut) {
  EXPECT_EQ(io::read_bytes("a.off", "STCNOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n").notes,
            std::vector<std::string>{
                "left out: texture coordinates, vertex colours, normals, face colours"});
}

TEST(Off, WhatFollowsTheLastFaceIsPassedOver) {
  const std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_TRUE(io::read_bytes("a.off", text + " \n# c\n").notes.empty());
  EXPECT_EQ(io::read_bytes("a.off", text + "3 0 1 2\n").notes,
            std::vector<std::string>{"8 bytes after the last face passed over"});
  EXPECT_EQ(io::read_bytes("a.off", binary_off(1, 2) + "x").notes.back(),
            "1 byte after the last face passed over");
}

TEST(Off, BadInputsSayLineOrByte) {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  const auto bad = [](const std::string& text, std::initializer_list<const char*> fragments) {
    expect_error("a.off", text, fragments);
  };
  bad("hello\n", {"a.off:1: ", "not an OFF file"});
  bad("nOFF\n3\n1 0 0\n0 0 0\n", {"\"nOFF\"", "export OFF or PLY"});
  bad("4OFF\n1 0 0\n0 0 0 0\n", {"a.off:3: ", "infinity"});
  bad("OFF\n", {"a.off:2: ", "numbers of vertices"});
  bad("OFF\n3\n", {"a.off:3: ", "the number of faces"});
  bad("OFF\n-3 1 0\n", {"a.off:2: ", "negative"});
  bad("OFF\n4000000000 1 0\n0 0 0\n", {"ends after 1 of 4000000000 vertices"});
  bad(start, {"a.off:5: ", "ends after 2 of 3 vertices"});
  bad(start + "0 1\n3 0 1 2\n", {"a.off:6: ", "unexpected \"0\""});
  bad(start + "0 1\n", {"a.off:6: ", "before z"});
  bad(start + "0 1 0 9\n3 0 1 2\n", {"a.off:5: ", "\"9\""});
  bad(start + "0 inf 0\n3 0 1 2\n", {"a.off:5: ", "finite"});
  bad(start + "0 1 0\n", {"ends after 0 of 1 faces"});
  bad(start + "0 1 0\n3 0 1 3\n", {"a.off:6: ", "out of range (0..2)"});
  bad(start + "0 1 0\n3 0 1\n", {"a.off:7: ", "before a vertex index"});
  bad("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1\n3 0 1 2\n", {"ends after 1 of 2 faces"});
  bad(start + "0 1 0\n2000000000 0 1\n", {"a.off:6: ", "2000000000"});
  bad(start + "0 1 0\n3 0 1 2 red\n", {"a.off:6: ", "\"red\""});
  const std::string good = binary_off(1, 2);
  for (std::size_t size = 12; size < good.size(); ++size)
    bad(good.substr(0, size), {"byte", "the file ends"});
  bad(binary_off(std::numeric_limits<float>::quiet_NaN(), 2), {"byte 35:", "finite"});
  bad(binary_off(1, 7), {"byte 59:", "index 7"});
  bad("OFF BINARY\n" + raw(0x7fffffff, true) + raw(1, true) + raw(0, true), {"ends early"});
}

std::string facet(const std::string& c) {
  return "facet normal nan 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + c +
         "\nendloop\nendfacet\n";
}

TEST(Stl, WeldsEqualCornersInOrderOfAppearance) {
  const MeshData mesh =
      stl("solid s\n" + facet("1 1 0") + facet("-0 1 0") + facet("0 1 -0.0") + "endsolid s\n");
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 1, 3, 0, 1, 3}));
  EXPECT_FALSE(mesh.classified());
}

TEST(Stl, DropsFacetsThatWeldingMakesEmpty) {
  const io::ReadResult result =
      io::read_bytes("a.stl", "solid\n" + facet("1 1 0") + facet("1 0 0") + "endsolid");
  EXPECT_EQ(result.mesh.faces.size(), 1u);
  ASSERT_EQ(result.notes.size(), 2u);
  EXPECT_EQ(result.notes[0], "6 corners welded into 3 vertices");
  EXPECT_EQ(result.notes[1], "1 facet without area dropped");
}

TEST(Stl, SolidsClassify) {
  const MeshData mesh = stl("solid a\n" + facet("1 1 0") + "endsolid a\nSOLID\n" + facet("0 1 0") +
                            "ENDSOLID\nsolid none\nendsolid\n");
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 1}, {2, 2}}));
  EXPECT_EQ(stl("solid model_face_9\n" + facet("1 1 0") + "endsolid\n").faces.classes,
            std::vector<ModelRef>{ModelRef(2, 9)});
}

std::string binary_stl(const std::string& header, std::uint32_t promised, float x = 1) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += raw(promised);
  for (const float c : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, x, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += raw(c);
  return bytes + raw(std::uint16_t{7});
}

TEST(Stl, BinaryThatCallsItselfSolid) {
  const MeshData mesh = stl(binary_stl("solid from some program", 1));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(io::read_bytes("no_extension", binary_stl("x", 1)).format, io::Format::Stl);
}

TEST(Stl, WhatFollowsTheLastFacetIsPassedOver) {
  for (const char* header : {"exported", "solid of bytes"}) {
    const io::ReadResult result =
        io::read_bytes("a.stl", binary_stl(header, 1) + std::string(92, '\0'));
    EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2})) << header;
    EXPECT_EQ(result.notes.back(), "92 bytes after the last facet passed over") << header;
  }
  EXPECT_EQ(io::read_bytes("a.stl", binary_stl("x", 1) + "\r\n").notes.size(), 1u);
  const std::string text = "solid a\n" + facet("1 1 0") + "endsolid a\n";
  EXPECT_EQ(io::read_bytes("a.stl", text + " \n").notes.size(), 1u);
  EXPECT_EQ(io::read_bytes("a.stl", text + "rubbish\n").notes.back(),
            "8 bytes after the last solid passed over");
}

TEST(Stl, EndsMayBeTwoWords) {
  const std::string body =
      "Facet Normal 0 0 1\nOUTER LOOP\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend loop\n"
      "END FACET\n";
  for (const char* end : {"end solid", "end solid a b", "EndSolid a", "endsolid"}) {
    const MeshData mesh = stl("Solid a b\n" + body + end + "\nsolid c\n" + body + end);
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 1, 2})) << end;
    EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 1}, {2, 2}})) << end;
  }
}

TEST(Stl, BadInputsSayLineOrByte) {
  const auto bad = [](const std::string& text, std::initializer_list<const char*> fragments) {
    expect_error("a.stl", text, fragments);
  };
  bad("solid a\n" + facet("1 1 0"), {"a.stl:9: ", "before \"endsolid\""});
  bad("solid a\n" + facet("1 1"), {"a.stl:6: ", "before z"});
  bad("solid a\n" + facet("1 1 nan"), {"a.stl:6: ", "finite"});
  bad("solid a\n" + facet("1 1 1e400"), {"a.stl:6: ", "finite"});
  bad("solid a\n" + facet("1 1 0 1"), {"a.stl:6: ", "unexpected \"1\""});
  bad("solid a\n" + facet("1 1 0\nvertex 2 2 2"),
      {"a.stl:7: ", "expected \"endloop\", found \"vertex\""});
  bad("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
      {"the file ends where \"vertex\""});
  bad("solid a\nwhat\n", {"a.stl:2: ", "found \"what\""});
  bad("solid a\nendsolid a\nrubbish\n", {"a.stl:3: ", "expected \"solid\""});
  bad("solid a\n" + facet("1 1 0") + "endsolid a\n" + facet("0 1 0"),
      {"a.stl:10: ", "expected \"solid\", found \"facet\""});
  bad("solid a\n" + facet("1 1 0") + "end\n", {"a.stl:9: ", "expected \"facet\", found \"end\""});
  bad("too short", {"byte 9:", "too short"});
  bad(binary_stl("x", 2), {"byte 134:", "the file ends early: 2 facets need 184 bytes"});
  bad(binary_stl("x", 4294967295u), {"ends early"});
  bad(binary_stl("solid x", 3), {"ends early"});
  bad(binary_stl("x", 0), {"byte 84:", "promises no facets"});
  bad(binary_stl("x", 1, std::numeric_limits<float>::infinity()), {"byte 108:", "finite"});
}

}  // namespace
}  // namespace aomd::io_off_stl_test
