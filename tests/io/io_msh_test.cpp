// MSH files of all versions, as text and as bytes: nodes, elements, classes, and what is refused.

#include <cmath>

#include "tests/support/msh_texts.h"

namespace aomd::io_msh_test {
namespace {

using test::expect_error;
using test::Indices;
using test::raw;
using namespace test::msh;

TEST(Msh, ReadsText4) {
  const std::string names = section("PhysicalNames", "2\n0 5 \"a \"corner\"\"\n2 1 \"wall\"\n");
  const io::ReadResult result = read(format4 + names + entities4 + nodes4 + elements4);
  const MeshData& mesh = result.mesh;
  EXPECT_TRUE(result.notes.empty());
  EXPECT_EQ(mesh.positions[3], glm::dvec3(0, 0, 1));
  EXPECT_EQ(mesh.vertex_classes,
            (std::vector{ModelRef(0, 7), ModelRef(1, 3), ModelRef(2, 4), ModelRef(3, 9)}));
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(mesh.edges.classes, std::vector{ModelRef(1, 3)});
  EXPECT_EQ(mesh.faces.shapes, std::vector{Shape::Triangle});
  EXPECT_EQ(mesh.faces.classes, std::vector{ModelRef(2, 4)});
  EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 2, 3}));
  EXPECT_EQ(mesh.regions.classes, std::vector{ModelRef(3, 9)});
  ASSERT_EQ(mesh.model.entities.size(), 4u);
  EXPECT_EQ(mesh.model.entities[0], (ModelEntity{ModelRef(0, 7), {5}, {}, {0.5, 0, 0, 0.5, 0, 0}}));
  EXPECT_EQ(mesh.model.entities[1], (ModelEntity{ModelRef(1, 3), {}, {7, -8}, {0, 0, 0, 1, 0, 0}}));
  EXPECT_EQ(mesh.model.entities[2], (ModelEntity{ModelRef(2, 4), {1, -2}, {}, {0, 0, 0, 1, 1, 0}}));
  EXPECT_EQ(mesh.model.entities[3], (ModelEntity{ModelRef(3, 9), {}, {-4}, {0, 0, 0, 1, 1, 1}}));
  EXPECT_EQ(mesh.model.groups,
            (std::vector<PhysicalGroup>{{0, 5, "a \"corner\""}, {2, 1, "wall"}}));
}

/// Version 4.0 puts tags before dimensions and before each position, and gives vertices a box.
TEST(Msh, ReadsText40) {
  const std::string text =
      section("MeshFormat", "4 0 8\n") +
      section("Entities", "1 0 1 0\n5 0 0 0 0 0 0 1 9\n1 0 0 0 1 1 0 1 7 0\n") +
      section("Nodes", "2 3\n5 0 0 1\n10 0 0 0\n1 2 1 2\n20 1 0 0 0.5 0.5\n30 0 1 0 0 1\n") +
      section("Elements", "2 2\n5 0 15 1\n1 10\n1 2 2 1\n2 10 20 30\n");
  const io::ReadResult result = read(text);
  EXPECT_EQ(result.notes, std::vector<std::string>{});
  EXPECT_EQ(result.mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(result.mesh.vertex_classes,
            (std::vector{ModelRef(0, 5), ModelRef(2, 1), ModelRef(2, 1)}));
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(result.mesh.faces.classes, std::vector{ModelRef(2, 1)});
  ASSERT_EQ(result.mesh.model.entities.size(), 2u);
  EXPECT_EQ(result.mesh.model.entities[0], (ModelEntity{ModelRef(0, 5), {9}, {}, {}}));
  expect_error("a.msh", text.substr(0, text.find("$Elements")), {"no $Elements"});
}

TEST(Msh, ReadsBinary40) {
  for (const bool swapped : {false, true}) {
    const auto i = [&](std::int32_t value) { return raw(value, swapped); };
    const auto n = [&](std::int64_t value) { return raw(value, swapped); };
    std::string nodes = n(1) + n(3) + i(1) + i(2) + i(0) + n(3);
    for (int v = 1; v <= 3; ++v) {
      nodes += i(v);
      for (const int axis : {2, 3, 4}) nodes += raw(v == axis ? 1.0 : 0.0, swapped);
    }
    const MeshData mesh =
        mesh_of(section("MeshFormat", "4 1 8\n" + i(1) + "\n") + section("Nodes", nodes + "\n") +
                section("Elements", n(1) + n(1) + i(1) + i(2) + i(2) + n(1) + i(1) + i(1) + i(2) +
                                        i(3) + "\n"));
    EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.faces.classes, std::vector{ModelRef(2, 1)});
  }
}

TEST(Msh, ReadsVersion1) {
  const std::string nodes = "$NOD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$ENDNOD\n";
  const std::string text = nodes + "$ELM\n2\n1 2 7 1 3 1 2 3\n2 1 8 4 2 1 2\n$ENDELM\n";
  const MeshData mesh = mesh_of(text);
  EXPECT_EQ(mesh.positions[2], glm::dvec3(0, 1, 0));
  EXPECT_EQ(mesh.faces.classes, std::vector{ModelRef(2, 1)});
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(mesh.edges.classes, std::vector{ModelRef(1, 4)});
  ASSERT_EQ(mesh.model.entities.size(), 2u);
  EXPECT_EQ(mesh.model.entities[1].groups, std::vector<std::int32_t>{7});
  EXPECT_EQ(io::read_bytes("no_extension", text).format, io::Format::Msh);
  expect_error("a.msh", nodes + "$ELM\n1\n1 2 7 1 4 1 2 3 3\n$ENDELM\n",
               {"a.msh:9: ", "element 1 has 3 nodes by its type, not 4"});
}

TEST(Msh, ReadsEveryFirstOrderShapeInTemplateOrder) {
  const std::string nodes = section(
      "Nodes", "8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n");
  const MeshData mesh = mesh_of(
      format2 + nodes +
      section("Elements",
              "7\n1 1 0 2 1\n2 2 0 1 2 3\n3 3 0 1 2 3 4\n4 4 0 1 2 4 5\n5 5 0 1 2 3 4 5 6 7 8\n"
              "6 6 0 1 2 4 5 6 8\n7 7 0 1 2 3 4 5\n"));
  EXPECT_EQ(mesh.edges.vertices, (Indices{1, 0}));
  EXPECT_EQ(mesh.faces.shapes, (std::vector{Shape::Triangle, Shape::Quad}));
  EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(mesh.regions.shapes,
            (std::vector{Shape::Tetrahedron, Shape::Hexahedron, Shape::Prism, Shape::Pyramid}));
  EXPECT_EQ(mesh.regions.vertices,
            (Indices{0, 1, 3, 4, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 3, 4, 5, 7, 0, 1, 2, 3, 4}));
  EXPECT_FALSE(mesh.classified());
}

TEST(Msh, ReadsSparseTagsInAnyOrderAndSortsByThem) {
  const MeshData mesh =
      mesh_of(format4 +
              section("Nodes",
                      "1 4 7 9000000000\n2 1 0 4\n9000000000\n70\n7\n8\n3 0 0\n2 0 0\n"
                      "1 0 0\n5 0 0\n") +
              section("Elements", "2 2 5 6\n2 1 2 1\n6 7 8 70\n2 2 2 1\n5 9000000000 70 7\n"));
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{1, 0, 0}, {5, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(mesh.faces.vertices, (Indices{3, 2, 0, 0, 1, 2}));
  EXPECT_EQ(mesh.faces.classes, (std::vector{ModelRef(2, 2), ModelRef(2, 1)}));
  expect_error("a.msh",
               format4 +
                   section("Nodes", "1 2 7 9000000000\n2 1 0 2\n9000000000\n7\n3 0 0\n2 0 0\n") +
                   section("Elements", "1 1 1 1\n1 1 1 1\n1 7 8000000000\n"),
               {"node 8000000000, which is not there"});
}

TEST(Msh, SkipsParametersUnknownSectionsAndLineEnds) {
  std::string text =
      format4 + section("Comments", "$ anything\n") + section("Curious", "1\n0 1 2\n") +
      section("Nodes",
              "3 4 1 4\n1 3 1 1\n1\n0 0 0 0.5\n2 4 1 2\n2 3\n1 0 0 0.5 0.5\n0 1 0 1 1\n3 9 1 "
              "1\n4 0 0 1 .1 .2 .3\n") +
      section("Elements", "1 1 1 1\n2 4 2 1\n1 1 2 3\n");
  const io::ReadResult result = read(text);
  EXPECT_EQ(result.notes, std::vector<std::string>{"section $Curious skipped"});
  EXPECT_EQ(result.mesh.positions[3], glm::dvec3(0, 0, 1));
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(mesh_of(windows), result.mesh);
}

/// The tetrahedron and its triangle as a file of either version and byte order.
std::string binary(bool msh2, bool swapped) {
  const auto i = [&](std::int32_t value) { return raw(value, swapped); };
  const auto n = [&](std::int64_t value) { return raw(value, swapped); };
  const auto points = [&](int from, int to) {
    std::string bytes;
    for (int v = from; v <= to; ++v) {
      if (msh2) bytes += i(v);
      for (const int axis : {2, 3, 4}) bytes += raw(v == axis ? 1.0 : 0.0, swapped);
    }
    return bytes;
  };
  const std::string start = section("MeshFormat", (msh2 ? "2.2 1 8\n" : "4.1 1 8\n") + i(1) + "\n");
  if (msh2) {
    return start + section("Nodes", "4\n" + points(1, 4) + "\n") +
           section("Elements", "2\n" + i(2) + i(1) + i(2) + i(1) + i(0) + i(4) + i(1) + i(2) +
                                   i(3) + i(4) + i(1) + i(2) + i(2) + i(0) + i(9) + i(1) + i(2) +
                                   i(3) + i(4) + "\n");
  }
  return start +
         section("Nodes", n(2) + n(4) + n(1) + n(4) + i(2) + i(4) + i(0) + n(3) + n(1) + n(2) +
                              n(3) + points(1, 3) + i(3) + i(9) + i(0) + n(1) + n(4) +
                              points(4, 4) + "\n") +
         section("Elements", n(2) + n(2) + n(1) + n(2) + i(2) + i(4) + i(2) + n(1) + n(1) + n(1) +
                                 n(2) + n(3) + i(3) + i(9) + i(4) + n(1) + n(2) + n(1) + n(2) +
                                 n(3) + n(4) + "\n");
}

TEST(Msh, ReadsBinaryOfBothOrders) {
  for (const bool msh2 : {false, true}) {
    for (const bool swapped : {false, true}) {
      const MeshData mesh = mesh_of(binary(msh2, swapped));
      EXPECT_EQ(mesh.positions,
                (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
      EXPECT_EQ(mesh.vertex_classes,
                (std::vector{ModelRef(2, 4), ModelRef(2, 4), ModelRef(2, 4), ModelRef(3, 9)}));
      EXPECT_EQ(mesh.faces.vertices, (Indices{0, 1, 2}));
      EXPECT_EQ(mesh.faces.classes, std::vector{ModelRef(2, 4)});
      EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 2, 3}));
      EXPECT_EQ(mesh.regions.classes, std::vector{ModelRef(3, 9)});
    }
  }
}

TEST(Msh, ClassifiesVerticesOf2ByTheirLowestElement) {
  const MeshData mesh =
      mesh_of(format2 + section("Nodes", "5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 9 9 9\n") +
              section("Elements",
                      "6\n1 4 2 0 2 1 2 3 4\n2 2 2 0 8 1 2 3\n3 2 2 0 6 1 2 4\n4 1 2 0 3 1 2\n"
                      "5 15 2 0 30 1\n6 15 2 0 20 1\n"));
  EXPECT_EQ(mesh.vertex_classes, (std::vector{ModelRef(0, 20), ModelRef(1, 3), ModelRef(2, 8),
                                              ModelRef(2, 6), ModelRef()}));
}

TEST(Msh, LowersVertexClassesOf4ThatContradictAnElement) {
  const std::string nodes =
      section("Nodes", "1 4 1 4\n3 9 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const io::ReadResult declared = read(format4 + entities4 + nodes + elements4);
  const std::vector expected{ModelRef(0, 7), ModelRef(1, 3), ModelRef(2, 4), ModelRef(3, 9)};
  EXPECT_EQ(declared.mesh.vertex_classes, expected);
  EXPECT_TRUE(noted(declared, "3 vertices moved"));
  // Without entities the one block says nothing, and there is nothing to report.
  const io::ReadResult undeclared = read(format4 + nodes + elements4);
  EXPECT_EQ(undeclared.mesh.vertex_classes, expected);
  EXPECT_TRUE(undeclared.notes.empty());
}

TEST(Msh, TagZeroIsUnclassifiedAndPhysicalTagsStandIn) {
  const MeshData mesh = mesh_of(
      format2 + nodes2 +
      section("Elements", "4\n1 2 2 0 0 1 2 3\n2 2 2 5 0 1 2 4\n3 2 1 6 1 3 4\n4 2 0 2 3 4\n"));
  EXPECT_EQ(mesh.faces.classes,
            (std::vector{ModelRef(), ModelRef(2, 5), ModelRef(2, 6), ModelRef()}));
  const MeshData four =
      mesh_of(format4 + section("Nodes", "1 3 1 3\n2 0 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n") +
              section("Elements", "1 1 1 1\n2 0 2 1\n1 1 2 3\n"));
  EXPECT_FALSE(four.classified());
}

TEST(Msh, MakesTheModelOf2FromPhysicalTags) {
  const std::string names = section("PhysicalNames", "1\n2 5 \"wall\"\n");
  // The triangle is in two groups, so Gmsh lists it twice; a third element contradicts the entity's
  // group.
  const io::ReadResult result = read(format2 + names + nodes2 +
                                     section("Elements",
                                             "5\n1 2 2 5 1 1 2 3\n2 2 2 6 1 2 3 1\n3 2 2 7 1 1 2 "
                                             "4\n4 2 2 0 1 1 3 4\n5 2 2 0 2 1 2 3\n"));
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2, 0, 1, 3, 0, 2, 3, 0, 1, 2}));
  EXPECT_EQ(result.mesh.faces.classes,
            (std::vector{ModelRef(2, 1), ModelRef(2, 1), ModelRef(2, 1), ModelRef(2, 2)}));
  EXPECT_EQ(result.mesh.model.entities,
            (std::vector{ModelEntity{ModelRef(2, 1), {5, 6}, {}, {0, 0, 0, 1, 1, 1}}}));
  EXPECT_EQ(result.mesh.model.groups, (std::vector<PhysicalGroup>{{2, 5, "wall"}}));
  EXPECT_TRUE(noted(result, "1 repeated element dropped"));
  EXPECT_TRUE(noted(result, "1 element in another physical group"));
}

TEST(Msh, ReadsHigherOrderByCorners) {
  const std::string nodes =
      section("Nodes", "7\n1 0 0 0\n2 .5 0 0\n3 1 0 0\n4 .5 .5 0\n5 0 1 0\n6 0 .5 0\n7 9 9 9\n");
  const io::ReadResult result =
      read(format2 + nodes + section("Elements", "2\n1 8 2 0 1 1 3 2\n2 9 2 0 2 1 3 5 2 4 6\n") +
           section("NodeData", "1\n\"t\"\n0\n3\n0\n1\n2\n3 1.5\n4 2.5\n"));
  EXPECT_EQ(result.mesh.positions,
            (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}));
  EXPECT_EQ(result.mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(result.mesh.faces.vertices, (Indices{0, 1, 2}));
  EXPECT_TRUE(noted(result, "2 higher-order elements read by their corners"));
  ASSERT_EQ(result.mesh.attributes.size(), 1u);
  EXPECT_EQ(result.mesh.attributes[0].values[1], 1.5);
  EXPECT_TRUE(noted(result, "1 value on what the mesh does not keep"));
}

/// Each type by its number, its nodes, and how many of them are corners.
TEST(Msh, KnowsHigherOrderTypes) {
  constexpr int types[][3] = {
      {8, 3, 2},    {26, 4, 2},   {27, 5, 2},  {28, 6, 2},  {9, 6, 3},   {20, 9, 3},   {21, 10, 3},
      {22, 12, 3},  {23, 15, 3},  {24, 15, 3}, {25, 21, 3}, {10, 9, 4},  {16, 8, 4},   {36, 16, 4},
      {37, 25, 4},  {38, 36, 4},  {39, 12, 4}, {40, 16, 4}, {11, 10, 4}, {29, 20, 4},  {30, 35, 4},
      {31, 56, 4},  {32, 22, 4},  {12, 27, 8}, {17, 20, 8}, {92, 64, 8}, {93, 125, 8}, {99, 32, 8},
      {100, 44, 8}, {13, 18, 6},  {18, 15, 6}, {90, 40, 6}, {91, 75, 6}, {14, 14, 5},  {19, 13, 5},
      {118, 30, 5}, {119, 55, 5}, {137, 16, 4}};
  for (const auto& [number, nodes, corners] : types) {
    std::string points = std::to_string(nodes) + "\n",
                element = "1\n1 " + std::to_string(number) + " 0";
    for (int v = 1; v <= nodes; ++v) {
      points += std::to_string(v) + " 0 0 0\n";
      element += ' ' + std::to_string(v);
    }
    const MeshData mesh =
        mesh_of(format2 + section("Nodes", points) + section("Elements", element + '\n'));
    EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(corners)) << number;
    EXPECT_EQ(mesh.edges.size() + mesh.faces.size() + mesh.regions.size(), 1u) << number;
  }
}

struct Broken {
  const char* from;
  const char* to;
  const char* says;
};

/// The text with the first `from` replaced.
std::string replaced(std::string text, const Broken& b) {
  const std::size_t at = text.find(b.from);
  EXPECT_NE(at, std::string::npos) << b.from;
  return text.replace(at, std::string_view(b.from).size(), b.to);
}

TEST(Msh, RefusesBroken4) {
  const std::string text = format4 + entities4 + nodes4 + elements4;
  EXPECT_EQ(test::error_of("a.msh", text), "");
  for (const Broken& b :
       {Broken{"4.1 0 8", "4.2 0 8", "a.msh:2: MSH version 4.2 is not one that is known here"},
        Broken{"4.1 0 8", "3 0 8", "gmsh FILE -save -format msh41 -o OUT"},
        Broken{"4.1 0 8", "1 0 8", "MSH version 1 is"},
        Broken{"4.1 0 8", "4.1 2 8", "file type"},
        Broken{"4.1 0 8", "4.1 0 4", "data size of 4"},
        Broken{"$EndMeshFormat", "$End", "$EndMeshFormat"},
        Broken{"$Nodes", "$Knots", "\"$EndKnots\""},
        Broken{"$EndNodes", "", "expected \"$EndNodes\""},
        Broken{"1 1 1 1\n", "1 1 1 -1\n", "is negative"},
        Broken{"1 1 1 1\n", "1 1 1 99\n", "$EndEntities"},
        Broken{"3 9 0 1", "4 9 0 1", "an entity of dimension 4"},
        Broken{"3 9 0 1", "3 300000000 0 1", "entity tag 300000000 is out of range"},
        Broken{"3 9 0 1", "3 9 2 1", "parametric"},
        Broken{"3 9 0 1", "3 9 0 2", "more nodes than"},
        Broken{"4 4 1 4", "4 5 1 4", "promises 5 nodes, its blocks hold 4"},
        Broken{"4 4 1 4", "4 9999999999 1 4", "the file ends early"},
        Broken{"\n4\n0 0 1", "\n0\n0 0 1", "node tag 0"},
        Broken{"\n4\n0 0 1", "\n3\n0 0 1", "node 3 is there twice"},
        Broken{"\n4\n0 0 1", "\n4\n0 0 nan", "z is not a finite number"},
        Broken{"\n4\n0 0 1", "\n4\n0 0", "expected a number for z"},
        Broken{"$Elements\n4 4", "$Elements\n4 5", "promises 5 elements, its blocks hold 4"},
        Broken{"$Elements\n4 4", "$Elements\n4 3", "more elements than"},
        Broken{"2 4 2 1", "2 4 34 1", "element type 34"},
        Broken{"2 4 2 1", "1 4 2 1", "a triangle cannot lie on a model entity of dimension 1"},
        Broken{"3 1 2 3\n", "3 1 2 9\n", "a.msh:33: element 3 refers to node 9"},
        Broken{"4 1 2 3 4\n", "4 1 2 3 2\n", "element 4 repeats node 2: a region that"},
        Broken{"3 1 2 3\n", "3 1 2 x\n", "found \"x\""}})
    expect_error("a.msh", replaced(text, b), {b.says});
  expect_error("a.msh", text + nodes4, {"a second section $Nodes"});
  EXPECT_EQ(read(text + "junk\n" + section("More", "")).notes.front(),
            "1 line outside of sections passed over");
  EXPECT_EQ(mesh_of(format4 + elements4 + nodes4 + entities4), mesh_of(text));
  expect_error("a.msh", format4, {"no $Nodes"});
  expect_error("a.msh", format4 + nodes4, {"no $Elements"});
  expect_error("a.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", {"no $ELM"});
}

TEST(Msh, RefusesBroken2) {
  const std::string text =
      format2 + nodes2 + section("Elements", "2\n1 2 2 5 1 1 2 3\n2 2 3 5 1 6 1 2 4\n");
  EXPECT_EQ(test::error_of("a.msh", text), "");
  EXPECT_EQ(test::error_of("a.msh", replaced(text, {"2.2", "2.0", ""})), "");
  for (const Broken& b :
       {Broken{"$Nodes\n4", "$Nodes\n5", "a node tag"},
        Broken{"$Nodes\n4", "$Nodes\n3", "$EndNodes"},
        Broken{"$Nodes\n4", "$Nodes\n-4", "negative"},
        Broken{"$Nodes\n4", "$Nodes\n99999999999", "the file ends early"},
        Broken{"$Elements\n2", "$Elements\n3", "an element tag"},
        Broken{"$Elements\n2", "$Elements\n1", "$EndElements"},
        Broken{"2 2 3 5", "2 2 -3 5", "negative number of tags"},
        Broken{"2 2 3 5", "2 2 4 5", "a node tag"}, Broken{"1 1 2 3\n", "1 1 2 -3\n", "node -3"},
        Broken{"2.2 0 8", "3 0 8", "version"}})
    expect_error("a.msh", replaced(text, b), {b.says});
}

TEST(Msh, RefusesBrokenBinaryWithTheByte) {
  const std::string bytes = binary(false, false);
  const std::size_t nodes = bytes.find("$Nodes\n") + 7;
  const auto with = [&](std::size_t at, const std::string& value) {
    std::string changed = bytes;
    return changed.replace(at, value.size(), value);
  };
  expect_error("a.msh", with(bytes.find("8\n") + 2, raw(7)), {"byte 20", "byte order"});
  expect_error("a.msh", with(nodes + 8, raw(std::int64_t{1} << 40)),
               {"byte", "the file ends early"});
  expect_error("a.msh", with(nodes + 8, raw(std::int64_t{-1})), {"out of range"});
  const std::string place = "byte " + std::to_string(nodes + 32) + ":";
  expect_error("a.msh", with(nodes + 32, raw(5)), {place.c_str(), "dimension 5"});
  expect_error("a.msh", with(nodes + 76, raw(std::nan(""))), {"x is not a finite number"});
}

}  // namespace
}  // namespace aomd::io_msh_test
