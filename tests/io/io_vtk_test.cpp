// Legacy VTK and VTU on tiny inputs: every layout, and what is wrong with damaged ones.

#include <limits>

#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_texts.h"

namespace aomd::io_vtk_test {
namespace {

using test::count;
using test::expect_error;
using test::Indices;
using test::raw;

MeshData vtk(std::string_view bytes) { return io::read_bytes("a.vtk", bytes).mesh; }
MeshData vtu(std::string_view bytes) { return io::read_bytes("a.vtu", bytes).mesh; }

std::string header(const std::string& dataset = "UNSTRUCTURED_GRID",
                   const std::string& version = "3.0") {
  return "# vtk DataFile Version " + version + "\ntitle\nASCII\nDATASET " + dataset + "\n";
}

const std::string square = "POINTS 4 float\n0 0 0 1 0 0\n1 1 0\n0 1 0\n";  // 4 lines
const std::string two_triangles = square + "CELLS 2 8\n3 0 1 2\n3 0 2 3\nCELL_TYPES 2\n5\n5\n";

TEST(Vtk, ReadsText) {
  const MeshData mesh = vtk(header() + two_triangles);
  EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_FALSE(mesh.classified());
}

TEST(Vtk, ReadsCellsOfEveryKind) {
  std::string points = "POINTS 8 double\n";
  for (int i = 0; i < 8; ++i)
    points += std::to_string(i & 1) + ' ' + std::to_string(i >> 1 & 1) + ' ' +
              std::to_string(i >> 2) + '\n';
  const MeshData mesh =
      vtk(header() + points +
          "CELLS 8 45\n1 0\n3 0 1 3\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\n6 0 2 1 4 6 5\n"
          "5 0 1 3 2 4\n6 0 1 3 2 4 5\n4 0 1 3 7\nCELL_TYPES 8\n1 4 11 8 13 14 6 10\n");
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1, 1, 3}));
  EXPECT_EQ(mesh.faces.shapes[0], Shape::Quad);  // the pixel, then the strip
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 3, 2, 0, 1, 3, 1, 2, 3, 3, 2, 4, 2, 5, 4}));
  EXPECT_EQ(mesh.regions.shapes,
            (std::vector{Shape::Hexahedron, Shape::Prism, Shape::Pyramid, Shape::Tetrahedron}));
  EXPECT_EQ(Indices(mesh.regions.vertices.begin(), mesh.regions.vertices.begin() + 14),
            (Indices{0, 1, 3, 2, 4, 5, 7, 6, 0, 1, 2, 4, 5, 6}));
  test::for_each_corner_volume(mesh, [](Shape, double volume) { EXPECT_GT(volume, 0); });
}

TEST(Vtk, ReadsOffsetsOfVersion5) {
  const MeshData mesh = vtk(header("UNSTRUCTURED_GRID", "5.1") + square +
                            "METADATA\nINFORMATION 0\n\nCELLS 3 6\nOFFSETS vtktypeint64\n0 3 6\n"
                            "CONNECTIVITY vtktypeint64\n0 1 2 0 2 3\nCELL_TYPES 2\n5 5\n");
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
}

TEST(Vtk, ReadsPolygonalData) {
  const auto result = io::read_bytes(
      "a.vtk",
      header("POLYDATA") +
          "POINTS 5 int\n0 0 0 2 0 0 2 2 0 1 3 0 0 2 0\nPOLYGONS 2 11\n5 0 1 2 3 4\n4 0 1 2 4\n"
          "VERTICES 1 2\n1 3\nLINES 1 4\n3 0 1 2\nCELL_DATA 4\nSCALARS material int\nLOOKUP_TABLE "
          "x\n"
          "7\n8\n9\n10\nSCALARS h float 1\n.1 .2 .3 .4\n");
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.edges.classes, (std::vector<ModelRef>{{1, 8}, {1, 8}}));
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 9}, {2, 9}, {2, 9}, {2, 10}}));
  EXPECT_EQ(mesh.faces.shapes.back(), Shape::Quad);
  EXPECT_EQ(mesh.vertex_classes[3], ModelRef(0, 7));
  EXPECT_EQ(mesh.attributes,
            (std::vector<Attribute>{
                {"h", 1, 1, false, {.2f, .2f}, NumberType::Float32, Meaning::Scalars},
                {"h", 2, 1, false, {.3f, .3f, .3f, .4f}, NumberType::Float32, Meaning::Scalars}}));
  EXPECT_EQ(result.notes.front(), "classified by the cell array \"material\"");
  EXPECT_EQ(result.notes.back(), "1 polygon triangulated");
}

TEST(Vtk, ReadsArraysOfEveryKind) {
  const MeshData mesh = vtk(
      header() + two_triangles +
      "POINT_DATA 4\nVECTORS v float\n1 2 3 4 5 6 7 8 9 0 nan inf\nNORMALS n float\n0 0 1 0 0 1 "
      "0 0 1 0 0 1\nCOLOR_SCALARS c 2\n0 1 0 1 0 1 0 1\nLOOKUP_TABLE t 1\n1 1 1 1\n"
      "TEXTURE_COORDINATES uv 2 float\n0 0 1 0 1 1 0 1\nFIELD f 3\na%20b 1 4 long\n1 2 3 4\n"
      "METADATA\nCOMPONENT_NAMES\nx\n\nnames 1 4 string\nw\nx\ny\nz\nlast 1 4 bit\n0 1 1 0\n"
      "CELL_DATA 2\nTENSORS t double\n1 2 3 4 5 6 7 8 9\n1 2 3 4 5 6 7 8 9\n");
  std::vector<std::string> names;
  for (const Attribute& a : mesh.attributes) names.push_back(a.name);
  EXPECT_EQ(names, (std::vector<std::string>{"v", "n", "c", "uv", "a b", "last", "t"}));
  EXPECT_TRUE(std::isnan(mesh.attributes[0].values[10]));
  EXPECT_EQ(mesh.attributes[4], (Attribute{"a b", 0, 1, true, {1, 2, 3, 4}, NumberType::Int64}));
  EXPECT_EQ(mesh.attributes[5].values, (std::vector<double>{0, 1, 1, 0}));
  EXPECT_EQ(mesh.attributes[6].components, 9);
  EXPECT_EQ(mesh.attributes[6].dimension, 2);
}

TEST(Vtk, LabelsBeyondTagsAreNumbered) {
  const std::string start = header() + two_triangles + "CELL_DATA 2\n";
  const io::ReadResult result = io::read_bytes(
      "a.vtk", start + "SCALARS material long\nLOOKUP_TABLE default\n4000000000 -7\n");
  EXPECT_EQ(result.mesh.faces.classes, (std::vector{ModelRef(2, 2), ModelRef(2, 1)}));
  EXPECT_EQ(result.notes.front(),
            "classified by the cell array \"material\", whose 2 values count as 1, 2, ...");
  ASSERT_EQ(result.mesh.attributes.size(), 1u);
  EXPECT_EQ(result.mesh.attributes[0].values, (std::vector<double>{4e9, -7}));
  const MeshData other = vtk(start +
                             "SCALARS material long\nLOOKUP_TABLE default\n4000000000 1\n"
                             "SCALARS region int\nLOOKUP_TABLE default\n5 6\n");
  EXPECT_EQ(other.faces.classes, (std::vector{ModelRef(2, 5), ModelRef(2, 6)}));
}

TEST(Vtk, HigherOrderCellsLoseTheirInnerNodes) {
  const auto result = io::read_bytes(
      "a.vtk",
      header() +
          "POINTS 7 float\n0 0 0 .5 0 0 1 0 0 1 1 0 0 1 0 0 .5 0 9 9 9\nCELLS 2 11\n6 0 2 4 1 3 5\n"
          "3 0 2 3\nCELL_TYPES 2\n22 5\nPOINT_DATA 7\nSCALARS s int\nLOOKUP_TABLE d\n0 1 2 3 4 5 "
          "6\n");
  EXPECT_EQ(result.mesh.positions.size(),
            5u);  // the second triangle uses vertex 3; the last one is unused
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 3, 0, 1, 2}));
  EXPECT_EQ(result.mesh.attributes[0].values, (std::vector<double>{0, 2, 3, 4, 6}));
  EXPECT_EQ(result.notes, std::vector<std::string>{"1 higher-order cell read by the corners"});
}

std::string binary_square(float x = 1, std::int32_t last = 3, const std::string& version = "3.0") {
  const bool big = true;
  std::string bytes = "# vtk DataFile Version " + version +
                      "\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n";
  for (const float f : {0.f, 0.f, 0.f, x, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    bytes += raw(f, big);
  if (version == "3.0") {
    bytes += "\nCELLS 1 5\n";
    for (const std::int32_t i : {4, 0, 1, 2, last}) bytes += raw(i, big);
  } else {
    bytes += "\nCELLS 2 4\nOFFSETS vtktypeint64\n" + raw(std::int64_t{0}, big) +
             raw(std::int64_t{4}, big);
    bytes += "\nCONNECTIVITY vtktypeint64\n";
    for (const std::int64_t i : {0, 1, 2, last}) bytes += raw(i, big);
  }
  return bytes + "\nCELL_TYPES 1\n" + raw(std::int32_t{9}, big) + "\n";
}

TEST(Vtk, ReadsBinary) {
  for (const char* version : {"3.0", "5.1"}) {
    const MeshData mesh =
        vtk(binary_square(1, 3, version) +
            "CELL_DATA 1\nFIELD F 2\nc 1 1 unsigned_char\n\xff\nd 3 1 bit\n\xa0\n");
    EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(mesh.attributes[0], (Attribute{"c", 2, 1, true, {255}, NumberType::UInt8}));
    EXPECT_EQ(mesh.attributes[1], (Attribute{"d", 2, 3, true, {1, 0, 1}}));
  }
}

TEST(Vtk, BadBinarySaysTheByte) {
  const std::string good = binary_square();
  const std::size_t points = good.find("float\n") + 6, cells = good.find("1 5\n") + 4;
  const auto byte = [](std::size_t n) { return "byte " + std::to_string(n) + ":"; };
  expect_error("a.vtk", binary_square(std::numeric_limits<float>::quiet_NaN()),
               {byte(points + 12).c_str(), "finite"});
  expect_error("a.vtk", binary_square(1, 4),
               {byte(cells).c_str(), "index 4 is out of range (0..3)"});
  expect_error("a.vtk", binary_square(1, 7, "5.1"), {"byte ", "index 7"});
  for (std::size_t size = points; size + 1 < good.size(); ++size) {
    SCOPED_TRACE(size);
    expect_error("a.vtk", good.substr(0, size), {"byte "});
  }
}

TEST(Vtk, BadTextSaysTheLine) {
  const auto bad = [](const std::string& body, std::initializer_list<const char*> fragments) {
    expect_error("a.vtk", header() + body, fragments);
  };
  const std::string one = "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n";  // lines 9 to 11
  expect_error("a.vtk", "# vtk DataFile Version 9.0\n", {"a.vtk:1: ", "\"9.0\""});
  expect_error("a.vtk", "# vtk DataFile Version 3.0\nt\nEBCDIC\n", {"a.vtk:3: ", "\"ebcdic\""});
  expect_error("a.vtk", header("HYPER_TREE_GRID"),
               {"a.vtk:4: ", "\"hyper_tree_grid\"", "save it as"});
  bad("POINTS 4 float\n0 0 0 1 x 0\n", {"a.vtk:6: ", "\"x\""});
  bad("POINTS 4 float\n0 0 0 1 0 0\n1 nan 0 0 1 0\n", {"a.vtk:7: ", "not a finite number"});
  bad("POINTS 4 float\n0 0 0 1 0 0\n1 1 0 0 1\n", {"a.vtk:8: ", "ends after 11 of 12 values"});
  bad("POINTS 4000000000 float\n0 0 0\n", {"too short for 4000000000 values"});
  bad("POINTS 4 quaternion\n", {"a.vtk:5: ", "\"quaternion\""});
  bad(square + "CELLS 1 5\n3 0 1 2\nCELL_TYPES 1\n5\n", {"a.vtk:11: ", "\"CELL_TYPES\""});
  bad(square + "CELLS 2 8\n3 0 1 2\n9 0 2 3\n", {"a.vtk:11: ", "cell 1 go beyond the list"});
  bad(square + "CELLS 2 8\n3 0 1 2\n2 0 2 3\n", {"2 cells take 7 of 8 numbers"});
  bad(square + "CELLS 2 8\n3 0 1 2\n3 0 2 4\nCELL_TYPES 2\n5 5\n",
      {"a.vtk:11: ", "4 is out of range (0..3)"});
  bad(square + "CELLS 2 8\n3 0 1 2\n3 0 2 -1\nCELL_TYPES 2\n5 5\n",
      {"a.vtk:11: ", "-1 is out of range"});
  bad(square + one + "9\n", {"a.vtk:10: ", "a quad of 3 vertices; it has 4"});
  bad(square + one + "42\n", {"a.vtk:10: ", "42 (polyhedron) are not read"});
  bad(square + one + "500\n", {"a.vtk:12: ", "no cell type 500"});
  bad(square + "CELLS 1 4\n3 0 1 2\n", {"0 cell types for 1 cell"});
  bad(two_triangles + "CELL_DATA 3\n", {"a.vtk:15: ", "data for 3 of 2"});
  bad(two_triangles + "CELL_DATA 2\nSCALARS a int\nLOOKUP_TABLE default\n1\n",
      {"ends after 1 of 2"});
  bad(two_triangles + "CELL_DATA 2\nSCALARS a int\n1\n1.5\n",
      {"a.vtk:18: ", "whole number", "\"1.5\""});
  bad(two_triangles + "CELL_DATA 2\n" + square, {"a.vtk:16: ", "\"POINTS\" among the data"});
  bad(two_triangles + "CELL_DATA 2\nFIELD F 1\na 4294967295 2 int\n", {"4294967295 components"});
  bad("", {"a.vtk:5: ", "ends before POINTS"});
  bad(square, {"a.vtk:9: ", "ends before CELLS"});
  bad(two_triangles + "rubbish\n", {"a.vtk:15: ", "\"rubbish\""});
  expect_error(
      "a.vtk",
      header("UNSTRUCTURED_GRID", "5.1") + square + "CELLS 2 3\nOFFSETS vtktypeint64\n0 4\n",
      {"a.vtk:10: ", "ascend from 0 to 3"});
}

TEST(Vtk, BadClassesSayTheCell) {
  const std::string data =
      "CELL_DATA 2\nFIELD F 2\nmodel_dimension 1 2 int\n2 1\nmodel_tag 1 2 int\n5 5\n";
  expect_error("a.vtk", header() + two_triangles + data,
               {"a.vtk:11: ", "face cannot lie on model entity 5 of dimension 1"});
}

/// One long strip and many arrays would make a mesh that is larger than the file by any factor.
TEST(Vtk, ValuesOfSplitCellsAreBounded) {
  std::string text = header() + square + "CELLS 1 20001\n20000";
  for (int i = 0; i < 20'000; ++i) text += ' ' + std::to_string(i % 4);
  text += "\nCELL_TYPES 1\n4\nCELL_DATA 1\nFIELD F 1000\n";
  for (int i = 0; i < 1000; ++i) text += 'a' + std::to_string(i) + " 1 1 int\n1\n";
  expect_error("a.vtk", text, {"limit", "take too much memory"});
}

TEST(Vtu, ReadsEveryPacking) {
  const std::string inline_base64 = "format=\"binary\"";
  for (const std::string& text :
       {test::vtu_file(test::vtu_piece(test::vtu_text, "format=\"ascii\"")),
        test::vtu_file(test::vtu_piece(test::vtu_base64, inline_base64)),
        test::vtu_file(test::vtu_piece(test::vtu_base64_big, inline_base64), test::big_wide),
        test::vtu_file(test::vtu_piece(test::vtu_zlib, inline_base64), test::zlib),
        test::vtu_file(test::vtu_piece(test::vtu_zlib_wide, inline_base64), test::zlib_wide),
        test::vtu_appended(test::vtu_base64, ""),
        test::vtu_appended(test::vtu_base64_big, test::big_wide),
        test::vtu_appended(test::vtu_zlib, test::zlib),
        test::vtu_appended(test::vtu_zlib_wide, test::zlib_wide)}) {
    SCOPED_TRACE(text);
    const MeshData mesh = vtu(text);
    EXPECT_EQ(mesh.positions,
              (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(mesh.regions.shapes, std::vector<Shape>{Shape::Tetrahedron});
    EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 2, 3}));
  }
}

TEST(Vtu, JoinsPieces) {
  const auto data = [](const char* value) {
    return "<CellData>" + test::vtu_array("Int64", "region", "format=\"ascii\"", value) +
           "</CellData>";
  };
  const std::string format = "format=\"ascii\"";
  const MeshData mesh = vtu(test::vtu_file(test::vtu_piece(test::vtu_text, format, data("5")) +
                                           test::vtu_piece(test::vtu_text, format, data("6"))));
  EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.regions.classes, (std::vector<ModelRef>{{3, 5}, {3, 6}}));
  expect_error("a.vtu",
               test::vtu_file(test::vtu_piece(test::vtu_text, format, data("5")) +
                              test::vtu_piece(test::vtu_text, format)),
               {"\"region\" is not in every piece"});
}

TEST(Vtu, BadFilesSayTheLine) {
  const auto bad = [](const test::VtuArrays& arrays, std::initializer_list<const char*> fragments) {
    expect_error("a.vtu", test::vtu_file(test::vtu_piece(arrays, "format=\"ascii\"")), fragments);
  };
  const char *points = test::vtu_text[0], *cell = test::vtu_text[1];
  bad({"0 0 0 1 0 0 0 1 0 0 0", cell, "4", "10"}, {"a.vtu:5: ", "11 coordinates for 4 points"});
  bad({"0 0 0 1 0 0 0 1 0 0 0 nan", cell, "4", "10"},
      {"a.vtu:5: ", "point 3 is not a finite number"});
  bad({"0 0 0 1 0 0 0 1 0 0 0 \nx", cell, "4", "10"}, {"a.vtu:6: ", "\"x\""});
  bad({points, "0 1 2 4", "4", "10"}, {"a.vtu:8: ", "vertex index 4 is out of range"});
  bad({points, "0 1 2 2", "4", "10"}, {"a.vtu:8: ", "cell 0: the tetrahedron repeats vertex 2"});
  bad({points, cell, "5", "10"}, {"a.vtu:9: ", "do not ascend to 4"});
  bad({points, cell, "4", "42"}, {"a.vtu:8: ", "42 (polyhedron)"});
  bad({points, cell, "4", "10 10"}, {"a.vtu:10: ", "2 types for 1 cell"});
  expect_error("a.vtu", "<?xml version=\"1.0\"?>\n<x>\n</y>\n", {"a.vtu:3: ", "XML"});
  expect_error("a.vtu", "<?xml version=\"1.0\"?>\n<COLLADA/>\n", {"a.vtu:2: ", "not VTKFile"});
  expect_error("a.vtu", "<VTKFile type=\"PolyData\"/>",
               {"\"PolyData\"", "only UnstructuredGrid", "save it as .vtu"});
  expect_error("a.vtu", test::vtu_file("", "compressor=\"vtkLZ4DataCompressor\""),
               {"vtkLZ4DataCompressor", "save it with that, or uncompressed"});
}

TEST(Vtu, BadPackingsSayTheByte) {
  const auto bad = [](test::VtuArrays arrays, const char* points, const char* attributes,
                      std::initializer_list<const char*> fragments) {
    arrays[0] = points;
    expect_error("a.vtu", test::vtu_file(test::vtu_piece(arrays, "format=\"binary\""), attributes),
                 fragments);
  };
  bad(test::vtu_base64, "MAAAAAAA", "", {"byte ", "the data end early: 48 bytes"});
  bad(test::vtu_base64, "MAAA$AAA", "", {"byte ", "not base64: \"$\""});
  bad(test::vtu_base64, "/////wAA", "", {"byte ", "4294967295 bytes"});
  bad(test::vtu_zlib,
      "AgAAACAAAAAQAAAAEAAAAA0AAAA=eJxjYEAGDfYMaHwADo4Bf3icY2BABg42AAFPAMA=", test::zlib,
      {"byte ", "block 1 of compressed data is damaged"});
  bad(test::vtu_zlib, "/////////////////////w==", test::zlib,
      {"byte ", "a header of 4294967295 words"});
  bad(test::vtu_zlib, "AQAAAP////8AAAAAAQAAAA==AAAA", test::zlib,
      {"byte ", "1 block of 4294967295 bytes"});
}

/// Appended data belong to one array: if any number could share them, memory would have no bound.
TEST(Vtu, SharedDataAreRefused) {
  const auto file = [](int arrays) {
    std::string text;
    for (int i = 0; i < arrays; ++i)
      text += test::vtu_array("UInt8", std::to_string(i),
                              "format=\"appended\" offset=\"0\" NumberOfComponents=\"2500\"", "");
    const std::uint32_t size = 10'000;
    return test::vtu_file(test::vtu_piece(test::vtu_text, "format=\"ascii\"",
                                          "<PointData>" + text + "</PointData>\n"),
                          "",
                          "<AppendedData encoding=\"raw\">_" + raw(size) + std::string(size, 'x') +
                              "</AppendedData>");
  };
  EXPECT_EQ(vtu(file(1)).attributes[0].components, 2500);
  expect_error("a.vtu", file(20), {"a.vtu:13: ", "arrays share their data"});
}

}  // namespace
}  // namespace aomd::io_vtk_test
