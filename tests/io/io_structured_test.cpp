// Legacy VTK grids that list no cells.

#include "tests/support/volume_helpers.h"

namespace aomd::io_structured_test {
namespace {

using test::expect_error;
using test::Indices;
using test::raw;

std::string header(const std::string& kind, const std::string& encoding = "ASCII") {
  return "# vtk DataFile Version 3.0\nt\n" + encoding + "\nDATASET " + kind + "\n";
}

MeshData vtk(const std::string& text) { return io::read_bytes("a.vtk", text).mesh; }

void expect_positive(const MeshData& mesh, std::size_t regions) {
  EXPECT_EQ(mesh.regions.size(), regions);
  test::for_each_corner_volume(mesh, [](Shape shape, double volume) {
    EXPECT_EQ(shape, Shape::Hexahedron);
    EXPECT_GT(volume, 0);
  });
}

TEST(Structured, UniformPointsBecomeHexahedra) {
  const MeshData mesh = vtk(
      header("STRUCTURED_POINTS") +
      "DIMENSIONS 3 2 2\nORIGIN 1 0 0\nSPACING 0.5 1 2\nPOINT_DATA 12\nSCALARS s int\n"
      "LOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8 9 10 11\nCELL_DATA 2\nSCALARS material int\n7\n8\n");
  EXPECT_EQ(mesh.positions.size(), 12u);
  EXPECT_EQ(mesh.positions[11], glm::dvec3(2, 1, 2));
  EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10}));
  expect_positive(mesh, 2);
  EXPECT_EQ(mesh.regions.classes, (std::vector<ModelRef>{{3, 7}, {3, 8}}));
  EXPECT_EQ(mesh.attributes[0].values[5], 5);
}

TEST(Structured, FlatGridsBecomeQuadsAndLines) {
  for (const char* size : {"3 2 1", "3 1 2", "1 3 2"}) {
    const MeshData mesh = vtk(header("STRUCTURED_POINTS") + "DIMENSIONS " + size + "\n");
    EXPECT_EQ(mesh.faces.shapes, std::vector<Shape>(2, Shape::Quad)) << size;
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 4, 3, 1, 2, 5, 4})) << size;
  }
  const MeshData line = vtk(header("STRUCTURED_POINTS") + "DIMENSIONS 1 3 1\n");
  EXPECT_EQ(line.edges.vertices, (Indices{0, 1, 1, 2}));
  EXPECT_EQ(line.positions[2], glm::dvec3(0, 2, 0));
  EXPECT_EQ(vtk(header("STRUCTURED_POINTS") + "DIMENSIONS 1 1 1\n").positions.size(), 1u);
}

TEST(Structured, RectilinearAndCurvilinear) {
  const MeshData a = vtk(header("RECTILINEAR_GRID") +
                         "DIMENSIONS 2 3 2\nX_COORDINATES 2 float\n0 1\nY_COORDINATES 3 double\n"
                         "0 1 4\nZ_COORDINATES 2 int\n5 6\n");
  expect_positive(a, 2);
  EXPECT_EQ(a.positions[5], glm::dvec3(1, 4, 5));
  std::string points = "POINTS 12 float\n";
  for (const glm::dvec3& p : a.positions)
    points += std::to_string(p.x + 0.1 * p.y) + ' ' + std::to_string(p.y) + ' ' +
              std::to_string(p.z) + '\n';
  const MeshData b =
      vtk(header("STRUCTURED_GRID") + "DIMENSIONS 2 3 2\n" + points + "CELL_DATA 2\n");
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(b.positions[5], glm::dvec3(1.4, 4, 5));
}

TEST(Structured, ReadsBinary) {
  const bool big = true;
  std::string bytes =
      header("RECTILINEAR_GRID", "BINARY") + "DIMENSIONS 2 2 1\nX_COORDINATES 2 float\n";
  bytes += raw(0.f, big) + raw(2.f, big) + "\nY_COORDINATES 2 double\n" + raw(0.0, big) +
           raw(3.0, big) + "\nZ_COORDINATES 1 short\n" + raw(std::int16_t{4}, big) +
           "\nCELL_DATA 1\nSCALARS c unsigned_char\nLOOKUP_TABLE default\n\xff\n";
  const MeshData mesh = vtk(bytes);
  EXPECT_EQ(mesh.positions[3], glm::dvec3(2, 3, 4));
  const Attribute c{"c", 2, 1, true, {255}, NumberType::UInt8, Meaning::Scalars};
  EXPECT_EQ(mesh.attributes, std::vector{c});
}

TEST(Structured, BadGridsSayWhatIsWrong) {
  const auto bad = [](const char* kind, const std::string& body,
                      std::initializer_list<const char*> fragments) {
    expect_error("a.vtk", header(kind) + body, fragments);
  };
  bad("STRUCTURED_POINTS", "", {"DIMENSIONS are missing"});
  bad("STRUCTURED_POINTS", "DIMENSIONS 3 0 3\n", {"one of them is 0"});
  bad("STRUCTURED_POINTS", "DIMENSIONS 3 -1 3\n", {"a.vtk:5: ", "\"-1\""});
  bad("STRUCTURED_POINTS", "DIMENSIONS 2 2 2\nORIGIN 0 nan 0\n", {"a.vtk:6: ", "finite"});
  bad("STRUCTURED_POINTS", "DIMENSIONS 2 2 2\nCELL_DATA 2\n", {"a.vtk:6: ", "data for 2 of 1"});
  bad("STRUCTURED_POINTS", "DIMENSIONS 2 2 2\nPOINTS 1 float\n0 0 0\n", {"\"POINTS\""});
  bad("STRUCTURED_POINTS", "DIMENSIONS 4000000000 4000000000 4000000000\n",
      {"limit", "more points than 16 for each byte", "save it as an unstructured grid"});
  bad("STRUCTURED_GRID", "DIMENSIONS 2 2 2\nPOINTS 1 float\n0 0 0\n",
      {"ask for 8 points, and there are 1"});
  bad("RECTILINEAR_GRID", "DIMENSIONS 2 1 1\nX_COORDINATES 1 float\n0\n",
      {"ask for 2 coordinates", "axis that has 1"});
}

}  // namespace
}  // namespace aomd::io_structured_test
