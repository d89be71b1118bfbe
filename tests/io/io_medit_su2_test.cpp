// Medit and SU2 on tiny inputs.

#include "tests/support/message.h"
#include "tests/support/volume_helpers.h"

namespace aomd::io_medit_su2_test {
namespace {

using test::expect_error;
using test::Indices;

io::ReadResult medit(const std::string& body) {
  return io::read_bytes("a.mesh", "MeshVersionFormatted 2\nDimension 3\n" + body);
}

const std::string three = "Vertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n";  // lines 3 to 7

TEST(Medit, ReadsAndWritesEverything) {
  const io::ReadResult result = medit(
      "# a comment\nvertices 6\n0 0 0 4\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n 9 9 9 0\n"
      "Quadrilaterals 1\n1 2 3 4 7\nTriangles\n2\n1 2 5 3\n2 3 5 -2\nPyramids 1\n1 2 3 4 5 "
      "6\nEdges 2\n1 2 0 "
      "2 3 8\n"
      "Corners 2\n3\n1\nRequiredVertices 1 2\nRequiredTriangles 1 2\nRequiredEdges\n0\nRidges "
      "1\n2\n"
      "Normals 2\n0 0 1\n0 1 0\nNormalAtVertices 1\n2 2\nTangents 1\n1 0 0\nTangentAtVertices 1 4 "
      "1\n"
      "SubDomainFromGeom 1\n2 1 1 1\nEnd\nanything");
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.faces.shapes, (std::vector{Shape::Quad, Shape::Triangle, Shape::Triangle}));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 3, 0, 1, 4, 1, 2, 4}));
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 7}, {2, 3}, {2, -2}}));
  EXPECT_EQ(mesh.edges.classes, (std::vector<ModelRef>{{1, 0}, {1, 8}}));
  EXPECT_EQ(mesh.regions.classes, (std::vector<ModelRef>{{3, 6}}));
  EXPECT_EQ(mesh.vertex_classes,
            (std::vector<ModelRef>{{0, 2}, {1, 0}, {0, 1}, {2, 7}, {2, -2}, {}}));
  const std::vector<Attribute> expected{
      {"medit:reference", 0, 1, true, {4, 0, 0, 0, 0, 0}},
      {"medit:required", 0, 1, true, {0, 1, 0, 0, 0, 0}},
      {"medit:normal", 0, 3, false, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
      {"medit:tangent", 0, 3, false, {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}},
      {"medit:ridge", 1, 1, true, {0, 1}},
      {"medit:required", 2, 1, true, {0, 0, 1}}};
  EXPECT_EQ(mesh.attributes, expected);
  EXPECT_EQ(result.notes, std::vector<std::string>{"passed over: \"SubDomainFromGeom\""});
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"})
    test::expect_same(test::written_and_read(name, mesh).mesh, mesh);
}

/// Corners come first; what only elements of higher order use goes, with its values.
TEST(Medit, ElementsOfHigherOrderAreReadByTheirCorners) {
  const io::ReadResult result = medit(
      "Vertices 8\n0 0 0 1\n2 0 0 2\n0 2 0 3\n1 0 0 4\n1 1 0 5\n0 1 0 6\n0 0 2 7\n9 9 9 8\n"
      "EdgesP2 1\n1 2 4 9\nTrianglesP2 1\n1 2 3 4 5 6 3\nTriangles 1\n1 5 7 0\n"
      "RequiredVertices 1 5\nTrianglesP2Ordering 6\n2 0 0 0 2 0 0 0 2 1 1 0 0 1 1 1 0 1\n");
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{
                                {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 0, 2}, {9, 9, 9}}));
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 3, 4}));
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 3}, {2, 0}}));
  EXPECT_EQ(mesh.attributes,
            (std::vector<Attribute>{{"medit:reference", 0, 1, true, {1, 2, 3, 5, 7, 8}},
                                    {"medit:required", 0, 1, true, {0, 0, 0, 1, 0, 0}}}));
  EXPECT_EQ(result.notes, std::vector<std::string>{"2 higher-order elements read by the corners"});
  const std::string nodes =
      "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27";
  std::string vertices = "Vertices 27\n";
  for (int i = 0; i < 27; ++i) vertices += std::to_string(i) + " 0 0 0\n";
  for (const auto& [keyword, n] : {std::pair{"TetrahedraP2", 10},
                                   {"HexahedraQ2", 27},
                                   {"PrismsP2", 18},
                                   {"PyramidsP2", 14},
                                   {"TetrahedraP3", 20}}) {
    std::string list = nodes.substr(0, nodes.find(' ' + std::to_string(n + 1) + ' '));
    EXPECT_EQ(medit(vertices + keyword + " 1\n" + list + " 5\n").mesh.regions.classes,
              std::vector<ModelRef>(1, {3, 5}))
        << keyword;
  }
}

TEST(Medit, OnlyZerosDoNotClassify) {
  EXPECT_FALSE(medit(three + "Triangles 1\n1 2 3 0\n").mesh.classified());
  EXPECT_EQ(medit(three + "Triangles 1\n1 2 3 0\nCorners 1 1\n").mesh.faces.classes[0],
            ModelRef(2, 0));
  EXPECT_EQ(medit(three + "Triangles 1\n1 2 3 0\nEdges 1 1 2 5\n").mesh.faces.classes[0],
            ModelRef(2, 0));
  EXPECT_EQ(medit(three + "Triangles 1\n1 2 3 0\nEdges 1 1 2 0\nRequiredEdges 1 1\n")
                .mesh.edges.classes[0],
            ModelRef(1, 0));
}

TEST(Medit, InThePlane) {
  const MeshData mesh = io::read_bytes("a.mesh",
                                       "MeshVersionFormatted\n1\nDimension\n2\nVertices\n3\n0 0 "
                                       "1\n1 0 1\n0 1 2\nTriangles 1 1 2 3 1")
                            .mesh;
  EXPECT_EQ(mesh.positions[2], glm::dvec3(0, 1, 0));
}

/// Mmg counts tangents on from the last normal.
TEST(Medit, TangentsMayCountOnFromNormals) {
  const MeshData mesh = medit(three +
                              "Normals 2 0 0 1 0 1 0 NormalAtVertices 2 1 1 2 2 Tangents 1 1 0 0 "
                              "TangentAtVertices 1 3 3")
                            .mesh;
  EXPECT_EQ(mesh.attributes[1].values, (std::vector<double>{0, 0, 0, 0, 0, 0, 1, 0, 0}));
}

TEST(Medit, BadFilesSayTheLine) {
  const auto bad = [](const std::string& body, std::initializer_list<const char*> fragments) {
    expect_error("a.mesh", "MeshVersionFormatted 2\nDimension 3\n" + body, fragments);
  };
  expect_error("a.mesh", "MeshVersionFormatted 7\n", {"a.mesh:1: ", "version 7"});
  expect_error("a.mesh", "MeshVersionFormatted 2\nDimension 4\n", {"a.mesh:2: ", "dimension 4"});
  expect_error("a.mesh", "MeshVersionFormatted 2\nVertices 0\n", {"the file has no Dimension"});
  bad("", {"no Vertices"});
  bad("Triangles 1 1 2 3 0\n", {"the file has no Vertices"});
  bad("Vertices 4000000000\n", {"a.mesh:3: ", "too short for 4000000000"});
  bad("Vertices -1\n", {"a.mesh:3: ", "negative"});
  bad("Vertices\n2\n0 0 0 0\n1 nan 0 0\n", {"a.mesh:6: ", "y is not a finite number"});
  bad("Vertices\n2\n0 0 0 0\n1 0 0\n", {"the file ends before a reference"});
  bad(three + "Triangles\n1\n1 2 4 0\n", {"a.mesh:10: ", "index 4 is out of range (1..3)"});
  bad(three + "Triangles\n1\n1 2 0 0\n", {"a.mesh:10: ", "index 0 is out of range (1..3)"});
  bad(three + "Tetrahedra\n1\n1 2 2 3 0\n", {"a.mesh:10: ", "the tetrahedron repeats vertex 2"});
  bad(three + "Triangles\n1\n1 2 3 999999999\n", {"a.mesh:10: ", "999999999 is out of range"});
  bad(three + "Triangles\n2\n1 2 3 0\nEnd\n", {"a.mesh:11: ", "\"End\""});
  bad(three + "Triangles 0 Triangles 0\n", {"a.mesh:8: ", "listed twice"});
  bad(three + three, {"a.mesh:8: ", "listed twice"});
  bad(three + "Corners\n1\n4\n", {"a.mesh:10: ", "index 4 is out of range (1..3)"});
  bad(three + "Ridges\n1\n1\n", {"a.mesh:10: ", "out of range"});
  bad(three + "Normals\n1\n0 0 1\nNormalAtVertices\n1\n1 2\n",
      {"a.mesh:13: ", "index 2 is out of range (1..1)"});
  bad(three + "7\n", {"a.mesh:8: ", "\"7\""});
  bad(three + "EdgesP2\n1\n1 2 4 0\n", {"a.mesh:10: ", "index 4 is out of range (1..3)"});
  bad(three + "EdgesP2Ordering\n3\n0\n1\n2\n", {"a.mesh:11: ", "save the mesh in the usual order"});
}

const std::string plane =
    "% a comment\nNDIME= 2\nNELEM= 2\n5 0 1 2 0\n9 0 2 3 4 1\nNPOIN= 5 5\n0 0 0\n1 0 1\n1 1 2\n.5 "
    "2 3\n0 1 "
    "4\n";

TEST(Su2, InThePlane) {
  const io::ReadResult result =
      io::read_bytes("a.su2", plane +
                                  "NMARK= 2\nMARKER_TAG= lower side % c\nMARKER_ELEMS= 1\n3 0 "
                                  "1\nMARKER_TAG= rest\nMARKER_ELEMS= 2\n"
                                  "3 1 2\n3 0 4\nFFD_NBOX= 1\nFFD_CORNER_POINTS= 2\n0 0\n1 1\n");
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 2, 3, 4}));
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1, 1, 2, 0, 4}));
  EXPECT_EQ(mesh.edges.classes, (std::vector<ModelRef>{{1, 1}, {1, 2}, {1, 2}}));
  EXPECT_EQ(mesh.model.groups, (std::vector<PhysicalGroup>{{1, 1, "lower side"}, {1, 2, "rest"}}));
  EXPECT_EQ(mesh.model.entities[1].groups, std::vector<std::int32_t>{2});
  EXPECT_EQ(result.notes, std::vector<std::string>{"passed over: FFD_NBOX, FFD_CORNER_POINTS"});
  test::expect_same(test::written_and_read("a.su2", mesh).mesh, mesh);
}

TEST(Su2, MarkersAreWrittenInTheOrderOfTheirTags) {
  const MeshData mesh =
      io::read_bytes("a.su2", plane +
                                  "NMARK= 2\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n"
                                  "MARKER_TAG= inlet\nMARKER_ELEMS= 1\n3 1 2\n")
          .mesh;
  EXPECT_EQ(mesh.model.groups, (std::vector<PhysicalGroup>{{1, 1, "wall"}, {1, 2, "inlet"}}));
  test::expect_same(test::written_and_read("a.su2", mesh).mesh, mesh);
}

TEST(Su2, ASurfaceInSpaceIsRefused) {
  const test::TemporaryFolder folder;
  for (const double z : {0.5, -0.5}) {
    MeshData mesh = io::read_bytes("a.su2", plane).mesh;
    mesh.positions[3].z = z;
    const std::string said = test::message([&] { io::write(folder / "a.su2", mesh); });
    EXPECT_NE(said.find("faces in the plane z = 0, and the mesh is a surface in space"),
              std::string::npos)
        << said;
    EXPECT_FALSE(std::filesystem::exists(folder / "a.su2"));
  }
}

/// What stands third is z, unless it counts the points.
TEST(Su2, PointsInThePlaneMayHaveThreeCoordinates) {
  const auto read = [](const std::string& points) {
    return io::read_bytes("a.su2", "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n" + points)
        .mesh.positions;
  };
  const std::vector<glm::dvec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const char* points : {"0 0\n1 0\n0 1\n", "0 0 0\n1 0 1\n0 1 2\n", "0 0 1\n1 0 2\n0 1 3\n",
                             "0 0 0 0\n1 0 0 1\n0 1 0 2\n", "0 0 0.0\n1 0 0.0\n0 1 0\n",
                             "0 0 0.0 0\n1 0 0.0 1\n0 1 0.0 2\n", "0 0 0 7\n1 0 1 8\n0 1 2 9\n"})
    EXPECT_EQ(read(points), flat) << points;
  EXPECT_EQ(read("0 0 0.5\n1 0 1e0\n0 1 2\n"),
            (std::vector<glm::dvec3>{{0, 0, 0.5}, {1, 0, 1}, {0, 1, 2}}));
}

/// Each zone counts its points from 0, and may list its elements first.
TEST(Su2, ZonesAreJoined) {
  const std::string zone = "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 1\n";
  const io::ReadResult result = io::read_bytes(
      "a.su2", "NZONE= 2\nIZONE= 1\n" + zone + "MARKER_TAG= a\nMARKER_ELEMS= 1\n3 0 1\nIZONE= 2\n" +
                   zone + "MARKER_TAG= b\nMARKER_ELEMS= 1\n3 1 2\n");
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 1}, {2, 2}}));
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1, 4, 5}));
  EXPECT_EQ(mesh.edges.classes, (std::vector<ModelRef>{{1, 1}, {1, 2}}));
  EXPECT_EQ(mesh.model.groups, (std::vector<PhysicalGroup>{
                                   {2, 1, "zone 1"}, {1, 1, "a"}, {2, 2, "zone 2"}, {1, 2, "b"}}));
  EXPECT_EQ(result.notes, std::vector<std::string>{"2 zones joined: model faces 1, 2, ..."});
}

/// Model faces of one physical group are one marker.
TEST(Su2, GroupsBecomeMarkers) {
  MeshData mesh = test::one_of_each();
  mesh.model.groups = {{2, 5, "wall"}};
  mesh.model.entities = {{ModelRef(2, 1), {5}, {}, {}}, {ModelRef(2, 2), {-5}, {}, {}}};
  const MeshData again = test::written_and_read("a.su2", mesh).mesh;
  EXPECT_EQ(again.model.groups, (std::vector<PhysicalGroup>{{2, 1, "wall"}}));
  EXPECT_EQ(again.faces.classes, (std::vector<ModelRef>{{2, 1}, {2, 1}}));
}

TEST(Su2, BadFilesSayTheLine) {
  const auto bad = [](const std::string& text, std::initializer_list<const char*> fragments) {
    expect_error("a.su2", text, fragments);
  };
  bad("NELEM= 0\n", {"NDIME is missing"});
  bad("NDIME= 4\n", {"neither 2 nor 3"});
  bad("NZONE= 2\nIZONE= 1\nNDIME= 2\nIZONE= 2\nNDIME= 3\n", {"a.su2:5: ", "of two and of three"});
  bad("NZONE= 2\nIZONE= 1\nNDIME= 2\nNELEM= 0\nIZONE= 2\n", {"a.su2:5: ", "no NPOIN"});
  bad("NDIME= 2\nNELEM= 0\n", {"no NPOIN"});
  bad("NDIME= 2\nNPOIN= 0\n", {"no NELEM"});
  bad("NDIME= 2\nNPOIN= 9999999\n0 0\n", {"a.su2:3: ", "too short"});
  bad("NDIME= 2\nNPOIN= 3\n0 0\n1 0 1\n", {"ends after 2 of 3 points"});
  bad("NDIME= 2\nNPOIN= 1\n0 nan\n", {"a.su2:3: ", "y is not a finite number"});
  bad("NDIME= 2\nNPOIN= 1\n0\n", {"a.su2:3: ", "before y"});
  bad("NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 2\n0 0\n1 1\n",
      {"a.su2:3: ", "2 is out of range (0..1)"});
  bad("NDIME= 3\nNELEM= 1\n10 0 1 1 0\nNPOIN= 2\n0 0 0\n1 1 0\n",
      {"a.su2:3: ", "repeats vertex 1"});
  bad("NDIME= 2\nNELEM= 1\n10 0 1 2 3\nNPOIN= 9\n", {"a.su2:3: ", "no elements of type 10"});
  bad(plane + "MARKER_TAG= a\nNELEM= 1\n", {"a.su2:13: ", "MARKER_ELEMS should follow"});
  bad(plane + "MARKER_TAG= a\nMARKER_ELEMS= 1\n5 0 1 2\n",
      {"a.su2:14: ", "marker of dimension 1", "type 5"});
  bad(plane + "7\n", {"a.su2:12: ", "\"7\""});
}

}  // namespace
}  // namespace aomd::io_medit_su2_test
