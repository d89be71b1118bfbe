// Arrays that files attach: names that repeat, and what operations leave of them.

#include "core/io/left_out.h"
#include "core/mesh/mesh.h"
#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_texts.h"

namespace aomd::io_attributes_test {
namespace {

std::vector<std::string> names_of(const MeshData& mesh) {
  std::vector<std::string> names;
  for (const Attribute& a : mesh.attributes) names.push_back(a.name);
  return names;
}

const std::string vtk_start =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 "
    "0 "
    "1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";

/// Each array gets a name that a Mesh can hold it by, and the file written has them all.
void expect_renamed(const io::ReadResult& result, const std::vector<std::string>& names,
                    const std::string& note) {
  EXPECT_EQ(names_of(result.mesh), names);
  EXPECT_EQ(result.notes, std::vector<std::string>{note});
  const MeshData again = to_data(Mesh(result.mesh));
  EXPECT_EQ(again.attributes.size(), names.size());
  for (const char* file : {"a.vtu", "a.vtk", "a.msh"})
    EXPECT_EQ(names_of(test::written_and_read(file, result.mesh).mesh), names) << file;
}

TEST(Attributes, ArraysOfOneNameAreRenamed) {
  expect_renamed(
      io::read_bytes("a.vtk", vtk_start + "POINT_DATA 3\nSCALARS u int\n1 2 3\nVECTORS u float\n"
                                          "1 0 0 1 0 0 1 0 0\nSCALARS u float\n4 5 6\n"),
      {"u", "u (2)", "u (3)"}, "further arrays of one name are called \"u (2)\", \"u (3)\"");
  const auto array = [](const char* type, const char* values) {
    return test::vtu_array(type, "a", "format=\"ascii\"", values);
  };
  const std::string data = "<PointData>" + array("Int32", "1 2 3 4") + array("Float64", "1 2 3 4") +
                           array("Int32", "5 6 7 8") + "</PointData>\n";
  const std::string piece = test::vtu_piece(test::vtu_text, "format=\"ascii\"", data);
  const io::ReadResult two = io::read_bytes("a.vtu", test::vtu_file(piece + piece));
  expect_renamed(two, {"a", "a (2)", "a (3)"},
                 "further arrays of one name are called \"a (2)\", \"a (3)\"");
  EXPECT_EQ(two.mesh.attributes[2].values, (std::vector<double>{5, 6, 7, 8, 5, 6, 7, 8}));
}

/// A name that is taken is passed over; dimensions have names of their own.
TEST(Attributes, NewNamesAreFree) {
  const io::ReadResult result = io::read_bytes(
      "a.vtk", vtk_start +
                   "POINT_DATA 3\nSCALARS u int\n1 2 3\nSCALARS u%20(2) int\n1 2 3\nSCALARS u "
                   "int\n4 5 6\nCELL_DATA 1\nSCALARS u int\n7\n");
  EXPECT_EQ(names_of(result.mesh), (std::vector<std::string>{"u", "u (2)", "u (3)", "u"}));
}

/// However many there are, the note is short.
TEST(Attributes, NotesListAFewNames) {
  std::string text = vtk_start + "CELL_DATA 1\nFIELD f 1000\n";
  for (int i = 0; i < 1000; ++i) text += "u 1 1 int\n1\n";
  const io::ReadResult result = io::read_bytes("a.vtk", text);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_TRUE(result.notes[0].ends_with("\"u (13)\" and 987 more")) << result.notes[0];
}

/// The array that classifies is used up, another of its name is not.
TEST(Attributes, OnlyTheArrayThatClassifiesGoes) {
  const io::ReadResult result = io::read_bytes(
      "a.vtk", vtk_start + "CELL_DATA 1\nSCALARS material int\n7\nSCALARS material float\n0.5\n");
  EXPECT_EQ(result.mesh.faces.classes, std::vector{ModelRef(2, 7)});
  EXPECT_EQ(result.mesh.attributes,
            (std::vector<Attribute>{
                {"material", 2, 1, false, {0.5}, NumberType::Float32, Meaning::Scalars}}));
}

MeshData with_arrays() {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.edges.add(Shape::Line, {0, 1}, ModelRef(1, 1));
  mesh.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 1));
  mesh.faces.add(Shape::Triangle, {0, 2, 3}, ModelRef(2, 1));
  mesh.vertex_classes = {{1, 1}, {1, 1}, {2, 1}, {2, 1}};
  mesh.attributes = {{"u", 0, 1, false, {1, 2, 3, 4}},
                     {"uv", 0, 2, false, {1, 2, 3, 4, 5, 6, 7, 8}},
                     {"stress", 2, 9, false, std::vector<double>(18, 0.5)},
                     {"medit:required", 0, 1, true, {1, 0, 1, 0}},
                     {"medit:required", 1, 1, true, {1}},
                     {"medit:required", 2, 1, true, {0, 1}},
                     {"medit:ridge", 1, 1, true, {1}},
                     {"medit:reference", 0, 1, true, {4, 0, 0, 0}}};
  mesh.periodic = {{{1, 1}, {1, 2}, {}, {{0, 3}}}};
  return mesh;
}

TEST(LeftOut, WhereNothingChangedAllStays) {
  const MeshData mesh = with_arrays();
  MeshData result = to_data(Mesh(mesh));
  EXPECT_EQ(io::carry_along(mesh, result).notes, std::vector<std::string>{});
  EXPECT_EQ(result.attributes.size(), mesh.attributes.size());
  for (const Attribute& a : mesh.attributes)
    EXPECT_EQ(std::count(result.attributes.begin(), result.attributes.end(), a), 1) << a.name;
  EXPECT_EQ(result.periodic, mesh.periodic);
}

/// A vertex that moved takes along what was said of it and of what it bounds.
TEST(LeftOut, ArraysAndMarksOfWhatMoved) {
  const MeshData mesh = with_arrays();
  MeshData result = to_data(Mesh(mesh));
  result.positions[2].x = 2;
  EXPECT_EQ(io::carry_along(mesh, result).notes,
            std::vector<std::string>{"left out, as it does not follow the operations: "
                                     "\"medit:required\", periodic links"});
  const std::vector<Attribute> expected{{"medit:required", 0, 1, true, {1, 0, 0, 0}},
                                        {"medit:reference", 0, 1, true, {4, 0, 0, 0}},
                                        {"medit:required", 1, 1, true, {1}},
                                        {"medit:ridge", 1, 1, true, {1}},
                                        {"medit:required", 2, 1, true, {0, 0}},
                                        {"u", 0, 1, false, {1, 2, 3, 4}},
                                        {"uv", 0, 2, false, {1, 2, 3, 4, 5, 6, 7, 8}},
                                        {"stress", 2, 9, false, std::vector<double>(18, 0.5)}};
  EXPECT_EQ(result.attributes, expected);
  EXPECT_TRUE(result.periodic.empty());
}

}  // namespace
}  // namespace aomd::io_attributes_test
