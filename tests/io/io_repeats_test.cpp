// Faces and edges that name a vertex twice, or too few, in every format.

#include <glm/geometric.hpp>

#include "core/io/entities.h"
#include "core/io/face_sink.h"
#include "tests/support/io_helpers.h"

namespace aomd::io_repeats_test {
namespace {

using test::Indices;
using Notes = std::vector<std::string>;

struct Text {
  const char* name;
  std::string bytes;
  const char* dropped;
  bool edges = true;
  Indices faces{0, 1, 2, 0, 2, 3, 0, 2, 3};
};

constexpr const char* one_face = "1 face of fewer than 3 different corners dropped";
constexpr const char* four_faces = "4 faces of fewer than 3 different corners dropped";

/// On the square 0 1 2 3: two triangles, between them one that repeats a vertex, and last a quad
/// that is the second triangle once more. Where faces may be of any number of corners, one of two,
/// one of one and one of none; where there are edges, one that joins a vertex to itself.
const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Text ply() {
  return {"a.ply",
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
          "property float z\nelement face 7\nproperty list uchar int vertex_indices\n"
          "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n" +
              points + "3 0 1 2\n3 0 1 1\n3 0 2 3\n4 0 2 3 3\n2 0 1\n1 0\n0\n1 1\n0 1\n",
          four_faces};
}
Text off() {
  return {"a.off",
          "OFF\n4 7 0\n" + points + "3 0 1 2\n3 0 1 1\n3 0 2 3\n4 0 2 3 3\n2 0 1\n1 0\n0\n",
          four_faces, false};
}
Text obj() {
  return {"a.obj",
          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\nf 1 3 4\nf 1 3 4 4\nf 1 2\nf 1\n"
          "f\nl 2 2\nl 1 2\n",
          four_faces};
}
Text off_binary() {
  std::string bytes = "OFF BINARY\n";
  for (const int n : {4, 7, 0}) bytes += test::raw(n, true);
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
    bytes += test::raw(x, true);
  for (const int n :
       {3, 0, 1, 2, 0, 3, 0, 1, 1, 0, 3, 0, 2, 3, 0, 4, 0, 2, 3, 3, 0, 2, 0, 1, 0, 1, 0, 0, 0, 0})
    bytes += test::raw(n, true);
  return {"a.off", bytes, four_faces, false};
}
Text medit() {
  return {"a.mesh",
          "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
          "Triangles 3\n1 2 3 0\n1 2 2 0\n1 3 4 0\nQuadrilaterals 1\n1 3 4 4 0\nEdges 2\n2 2 0\n"
          "1 2 0\nEnd\n",
          one_face};
}
Text vtk() {
  return {"a.vtk",
          "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n" +
              points +
              "CELLS 9 29\n3 0 1 2\n3 0 1 1\n3 0 2 3\n4 0 2 3 3\n2 0 1\n2 1 1\n2 0 1\n1 0\n0\n"
              "CELL_TYPES 9\n5 5 5 9 7 3 3 7 7\n",
          four_faces};
}
Text msh() {
  return {"a.msh",
          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
          "$EndNodes\n$Elements\n6\n1 2 0 1 2 3\n2 2 0 1 2 2\n3 2 0 1 3 4\n4 3 0 1 3 4 4\n"
          "5 1 0 2 2\n6 1 0 1 2\n$EndElements\n",
          one_face,
          true,
          {0, 1, 2, 0, 2, 3}};  // an element that is there twice is dropped
}
Text su2() {
  return {"a.su2",
          "NDIME= 2\nNELEM= 4\n5 0 1 2\n5 0 1 1\n5 0 2 3\n9 0 2 3 3\nNPOIN= 4\n0 0\n1 0\n1 1\n0 1\n"
          "NMARK= 1\nMARKER_TAG= m\nMARKER_ELEMS= 2\n3 1 1\n3 0 1\n",
          one_face};
}

TEST(Repeats, AreDroppedOrCutAndCountedInEveryFormat) {
  for (const Text& text : {ply(), off(), obj(), off_binary(), medit(), vtk(), msh(), su2()}) {
    const io::ReadResult result = io::read_bytes(text.name, text.bytes);
    EXPECT_EQ(result.mesh.positions.size(), 4u) << text.name;
    EXPECT_EQ(result.mesh.faces.vertices, text.faces) << text.name;
    EXPECT_EQ(result.mesh.faces.shapes, std::vector(text.faces.size() / 3, Shape::Triangle));
    EXPECT_EQ(result.mesh.edges.vertices, text.edges ? (Indices{0, 1}) : Indices{}) << text.name;
    Notes expected{text.dropped, "1 face with repeated corners cut into triangles"};
    if (text.edges) expected.push_back("1 edge of fewer than 2 different ends dropped");
    Notes notes = result.notes;
    std::erase(notes, "1 repeated element dropped");
    EXPECT_EQ(notes, expected) << text.name;
  }
}

/// What a Medit file says of its elements by their numbers goes to those that are left.
TEST(Repeats, MarksOfMeditKeepTheirElements) {
  const MeshData mesh =
      io::read_bytes(
          "a.mesh",
          "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n"
          "0 1 0 0\nTriangles 4\n1 2 2 5\n1 2 3 6\n3 3 3 7\n1 3 4 8\nEdges 3\n1 2 1\n2 2 2\n"
          "2 3 3\nRequiredTriangles 2\n1 4\nRidges 2\n2 3\nEnd\n")
          .mesh;
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 6}, {2, 8}}));
  EXPECT_EQ(mesh.edges.classes, (std::vector<ModelRef>{{1, 1}, {1, 3}}));
  ASSERT_EQ(mesh.attributes.size(), 2u);
  EXPECT_EQ(mesh.attributes[0], (Attribute{"medit:ridge", 1, 1, true, {0, 1}}));
  EXPECT_EQ(mesh.attributes[1], (Attribute{"medit:required", 2, 1, true, {0, 1}}));
}

TEST(Repeats, LinesAndStripsOfVtkMayBeTooShort) {
  const io::ReadResult result = io::read_bytes(
      "a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n" +
                   points +
                   "CELLS 5 15\n1 0\n3 0 1 1\n2 0 1\n3 0 1 2\n1 3\n"
                   "CELL_TYPES 5\n4 4 6 6 6\n");
  EXPECT_EQ(result.mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(result.notes, (Notes{"2 faces of fewer than 3 different corners dropped",
                                 "2 edges of fewer than 2 different ends dropped"}));
}

/// Values of a dropped element go with it.
TEST(Repeats, ValuesKeepTheirElements) {
  const MeshData grid =
      io::read_bytes("a.vtk", vtk().bytes +
                                  "CELL_DATA 9\nSCALARS x int\nLOOKUP_TABLE default\n"
                                  "1 2 3 4 5 6 7 8 9\n")
          .mesh;
  EXPECT_EQ(grid.attributes[0], (Attribute{"x", 1, 1, true, {7}, {}, Meaning::Scalars}));
  EXPECT_EQ(grid.attributes[1], (Attribute{"x", 2, 1, true, {1, 3, 4}, {}, Meaning::Scalars}));
  const MeshData gmsh =
      io::read_bytes("a.msh", msh().bytes +
                                  "$ElementData\n1\n\"x\"\n1\n0\n3\n0\n1\n3\n1 5\n2 6\n3 7\n"
                                  "$EndElementData\n")
          .mesh;
  ASSERT_EQ(gmsh.attributes.size(), 1u);
  EXPECT_EQ(gmsh.attributes[0].values, (std::vector<double>{5, 7}));
}

std::vector<std::int64_t> trimmed(std::vector<std::int64_t> walk) {
  io::detail::trim_walk(walk);
  return walk;
}

TEST(Repeats, WalksLoseWhatLeadsNowhere) {
  using Walk = std::vector<std::int64_t>;
  EXPECT_EQ(trimmed({1, 2, 3}), (Walk{1, 2, 3}));
  EXPECT_EQ(trimmed({1, 1, 2, 2, 2, 3, 1}), (Walk{1, 2, 3}));
  EXPECT_EQ(trimmed({1, 2, 9, 2, 3}), (Walk{1, 2, 3})) << "forth and back";
  EXPECT_EQ(trimmed({1, 2, 8, 9, 8, 2, 3}), (Walk{1, 2, 3})) << "two edges forth and back";
  EXPECT_EQ(trimmed({9, 1, 2, 3, 1}), (Walk{1, 2, 3})) << "where the walk closes";
  EXPECT_EQ(trimmed({8, 9, 8, 1, 2, 3, 1}), (Walk{1, 2, 3}));
  EXPECT_EQ(trimmed({1, 2, 3, 1, 9, 8, 9}), (Walk{1, 2, 3}));
  EXPECT_EQ(trimmed({1, 2, 3, 1, 4, 5}), (Walk{1, 2, 3, 1, 4, 5})) << "two loops at a vertex";
  EXPECT_LT(trimmed({1, 2, 1}).size(), 3u);
  EXPECT_LT(trimmed({1, 2, 3, 2}).size(), 3u);
  EXPECT_LT(trimmed({1, 2, 3, 4, 3, 2}).size(), 3u);
  EXPECT_LT(trimmed({1, 1, 1, 1}).size(), 3u);
  EXPECT_EQ(trimmed({}), Walk{});
}

struct Cut {
  std::size_t triangles;
  double area;    ///< the sum of the triangles' areas
  double lowest;  ///< the smallest of these with their sign: negative where a triangle is turned
};

Cut cut(const std::vector<glm::dvec3>& p, const std::vector<std::uint32_t>& walk) {
  std::vector<std::uint32_t> t;
  io::detail::triangles_of_walk(p, walk, t);
  Cut result{t.size() / 3, 0, 1};
  for (std::size_t i = 0; i < t.size(); i += 3) {
    const glm::dvec3 n = glm::cross(p[t[i + 1]] - p[t[i]], p[t[i + 2]] - p[t[i]]) * 0.5;
    result.area += glm::length(n);
    result.lowest = std::min(result.lowest, n.z);
  }
  return result;
}

/// A square 0 1 2 3 of side 3 with square holes, each reached by a bridge that is walked twice.
TEST(Repeats, PolygonsThatBridgeToTheirHolesAreCut) {
  std::vector<glm::dvec3> p{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                            {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  const Cut one = cut(p, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  EXPECT_EQ(one.triangles, 8u);
  EXPECT_DOUBLE_EQ(one.area, 8);
  EXPECT_GE(one.lowest, 0);
  for (int turn = 0; turn < 10; ++turn) {
    std::vector<std::uint32_t> walk{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
    std::rotate(walk.begin(), walk.begin() + turn, walk.end());
    EXPECT_DOUBLE_EQ(cut(p, walk).area, 8) << turn;
    EXPECT_EQ(cut(p, walk).triangles, 8u) << turn;
  }
  p = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {0, 3, 0}, {1, 1, 0}, {1, 2, 0},
       {2, 2, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}, {4, 2, 0}, {4, 1, 0}};
  const Cut chain = cut(p, {0, 1, 2, 3, 0, 4, 5, 6, 9, 10, 11, 8, 9, 6, 7, 4});
  EXPECT_DOUBLE_EQ(chain.area, 13) << "the second hole hangs on the first";
  EXPECT_GE(chain.lowest, 0);
  const Cut both = cut(p, {0, 4, 5, 6, 7, 4, 0, 1, 11, 8, 9, 10, 11, 1, 2, 3});
  EXPECT_DOUBLE_EQ(both.area, 13) << "a bridge from each of two corners";
  EXPECT_GE(both.lowest, 0);
}

TEST(Repeats, LoopsAtOneVertexAreCut) {
  const std::vector<glm::dvec3> p{{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}, {-2, -1, 0}};
  const Cut bow_tie = cut(p, {0, 1, 2, 0, 3, 4});
  EXPECT_EQ(bow_tie.triangles, 2u);
  EXPECT_DOUBLE_EQ(bow_tie.area, 4);
}

/// Two loops at one vertex have fewer triangles than their corners promise.
TEST(Repeats, LoopsOfAFileLeaveNoEmptyFaces) {
  const io::ReadResult result = io::read_bytes(
      "a.off",
      "OFF\n5 3 0\n0 0 0\n2 -1 0\n2 1 0\n-2 1 0\n-2 -1 0\n3 0 1 2\n6 0 1 2 0 3 4\n3 0 3 4\n");
  EXPECT_EQ(result.mesh.faces.size(), 4u);
  EXPECT_EQ(result.mesh.faces.vertices.size(), 12u);
  for (std::size_t i = 0; i < 12; i += 3)
    EXPECT_NE(result.mesh.faces.vertices[i], result.mesh.faces.vertices[i + 1]) << i;
  EXPECT_EQ(result.mesh.faces.vertices[9], 0u);
  EXPECT_EQ(result.mesh.faces.vertices[10], 3u);
}

TEST(Repeats, ABridgedFaceOfAFileKeepsItsPlaceAndClass) {
  const io::ReadResult result = io::read_bytes(
      "a.obj",
      "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 0 0 1\n"
      "g a\nf 1 2 9\ng b\nf 1 2 3 4 1 5 6 7 8 5\ng c\nf 2 3 9\n");
  EXPECT_EQ(result.mesh.faces.size(), 10u);
  EXPECT_EQ(result.mesh.faces.vertices.size(), 30u);
  EXPECT_EQ(result.mesh.faces.classes.front(), ModelRef(2, 1));
  EXPECT_EQ(result.mesh.faces.classes[1], ModelRef(2, 2));
  EXPECT_EQ(result.mesh.faces.classes[8], ModelRef(2, 2));
  EXPECT_EQ(result.mesh.faces.classes.back(), ModelRef(2, 3));
  EXPECT_EQ(result.notes, (Notes{"1 face with repeated corners cut into triangles",
                                 "faces classified by 3 groups"}));
}

}  // namespace
}  // namespace aomd::io_repeats_test
