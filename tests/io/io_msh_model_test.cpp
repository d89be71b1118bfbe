// What MSH files say about the model: parts of a partition, periodic links, parametric nodes.

#include "core/repair/repair.h"
#include "tests/support/msh_texts.h"
#include "tests/support/volume_helpers.h"

namespace aomd::io_msh_model_test {
namespace {

using test::expect_error;
using test::Indices;
using test::raw;
using namespace test::msh;

/// A square of two triangles, each in a part of its own: surfaces 11 and 12 are parts of surface 1,
/// curve 21 lies between them, curve 13 is a part of curve 3.
const std::string parts =
    section("PartitionedEntities",
            "2\n1\n7 1\n0 2 2 0\n"
            "13 1 3 1 1 0 0 0 1 0 0 0 2 1 2\n21 2 1 2 1 2 0 0 0 1 1 0 0 2 1 3\n"
            "11 2 1 1 1 0 0 0 1 1 0 1 8 3 13 21 5\n12 2 1 1 2 0 0 0 1 1 0 1 8 3 21 6 7\n");
const std::string square =
    section("Nodes",
            "3 4 1 4\n1 13 0 2\n1\n2\n0 0 0\n1 0 0\n2 12 0 1\n4\n0 1 0\n1 21 0 1\n3\n1 1 0\n") +
    section("Elements",
            "4 4 1 4\n1 13 1 1\n1 1 2\n1 21 1 1\n2 1 3\n2 11 2 1\n3 1 2 3\n2 12 2 1\n4 1 3 4\n");

TEST(MshModel, PartsAreJoinedToWhatTheyArePartsOf) {
  const std::string names = section("PhysicalNames", "1\n2 8 \"plate\"\n");
  const std::string entities =
      section("Entities", "0 1 1 0\n3 0 0 0 1 0 0 0 2 1 2\n1 0 0 0 1 1 0 1 8 4 3 4 5 6\n");
  const io::ReadResult result = read(format4 + names + entities + parts + square +
                                     section("ElementData", "1\n\"e\"\n1\n0\n3\n0\n1\n1\n2 5\n"));
  const MeshData& mesh = result.mesh;
  EXPECT_EQ(mesh.edges.vertices, (Indices{0, 1}));
  EXPECT_EQ(mesh.edges.classes, std::vector{ModelRef(1, 3)});
  EXPECT_EQ(mesh.faces.classes, std::vector(2, ModelRef(2, 1)));
  EXPECT_EQ(mesh.vertex_classes,
            (std::vector{ModelRef(1, 3), ModelRef(1, 3), ModelRef(2, 1), ModelRef(2, 1)}));
  ASSERT_EQ(mesh.model.entities.size(), 2u);
  EXPECT_EQ(mesh.model.entities[1],
            (ModelEntity{ModelRef(2, 1), {8}, {3, 4, 5, 6}, {0, 0, 0, 1, 1, 0}}));
  EXPECT_EQ(mesh.model.groups, (std::vector<PhysicalGroup>{{2, 8, "plate"}}));
  EXPECT_EQ(result.notes,
            (std::vector<std::string>{"parts joined to the model entities that they are parts of, "
                                      "1 element on borders between them dropped",
                                      "1 value on what the mesh does not keep dropped"}));
}

/// Without $Entities, parts tell of the groups of what they are parts of.
TEST(MshModel, PartsAloneTellOfTheGroups) {
  const MeshData mesh = read(format4 + parts + square).mesh;
  EXPECT_EQ(mesh.faces.classes, std::vector(2, ModelRef(2, 1)));
  ASSERT_EQ(mesh.model.entities.size(), 2u);
  EXPECT_EQ(mesh.model.entities[1].ref, ModelRef(2, 1));
  EXPECT_EQ(mesh.model.entities[1].groups, std::vector{8});
  expect_error(
      "a.msh",
      format4 + section("PartitionedEntities", "1\n0\n0 0 1 0\n11 1 1 1 1 0 0 0 1 1 0 0 0\n"),
      {"a.msh:8: ", "a parent of dimension 1"});
}

const std::string line4 = section("Nodes", "1 3 1 9\n1 1 0 3\n4\n5\n9\n0 0 0\n1 0 0\n2 0 0\n") +
                          section("Elements", "1 2 1 2\n1 1 1 2\n1 4 5\n2 5 9\n");
const std::string line2 = section("Nodes", "3\n4 0 0 0\n5 1 0 0\n9 2 0 0\n") +
                          section("Elements", "2\n1 1 2 0 1 4 5\n2 1 2 0 1 5 9\n");

const std::vector<Periodicity> links{
    {{0, 2}, {0, 1}, {1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {{2, 0}}},
    {{1, 7}, {1, -3}, {}, {{1, 0}, {2, 1}}}};

TEST(MshModel, PeriodicLinksStayInBothVersions) {
  const MeshData mesh4 =
      read(format4 +
           section(
               "Periodic",
               "2\n0 2 1\n16 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n1\n9 4\n1 7 -3\n0\n2\n5 4\n9 5\n") +
           line4)
          .mesh;
  EXPECT_EQ(mesh4.periodic, links);
  const MeshData mesh2 =
      read(format2 + line2 +
           section(
               "Periodic",
               "2\n0 2 1\nAffine 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n1\n9 4\n1 7 -3\n2\n5 4\n9 5\n"))
          .mesh;
  EXPECT_EQ(mesh2.periodic, links);
  for (const bool binary : {false, true}) {
    for (const bool msh2 : {false, true}) {
      const test::TemporaryFolder folder;
      io::write(folder / "a.msh", mesh4, {.binary = binary, .msh2 = msh2});
      EXPECT_EQ(io::read(folder / "a.msh").mesh.periodic, links);
    }
  }
}

TEST(MshModel, PeriodicLinksSayWhatIsWrong) {
  const io::ReadResult result =
      read(format4 + line4 + section("Periodic", "1\n0 2 1\n0\n2\n9 4\n9 77\n"));
  EXPECT_EQ(result.mesh.periodic[0].pairs.size(), 1u);
  EXPECT_EQ(result.notes, std::vector<std::string>{
                              "1 periodic pair of nodes that the mesh does not keep dropped"});
  expect_error("a.msh", format4 + line4 + section("Periodic", "1\n4 2 1\n0\n0\n"),
               {"a.msh:22: ", "a periodic entity of dimension 4"});
  expect_error("a.msh", format4 + line4 + section("Periodic", "1\n1 999999999 1\n0\n0\n"),
               {"a.msh:22: ", "entity tag 999999999 is out of range"});
  expect_error("a.msh", format2 + line2 + section("Periodic", "1\n0 2 1\nAffine 1 x\n"),
               {"a.msh:18: ", "\"x\""});
}

/// They name vertices: what changes those ends them, and says so.
TEST(MshModel, RepairKeepsPeriodicLinksWhereItMendsNothing) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  mesh.periodic = links;
  EXPECT_TRUE(repair(mesh).done.empty());
  EXPECT_EQ(mesh.periodic, links);
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  const RepairReport report = repair(mesh);
  EXPECT_TRUE(mesh.periodic.empty());
  EXPECT_EQ(report.done.back().text, "2 periodic links dropped");
}

/// Parametric nodes of 2.2 say where they lie, and 0 to 2 numbers more.
TEST(MshModel, ParametricNodesOf22AreClassified) {
  const std::string elements = section("Elements", "1\n1 2 2 9 1 2 3 4\n");
  const MeshData text =
      read(format2 +
           section("ParametricNodes",
                   "4\n1 0 0 0 0 5\n2 1 0 0 1 3 0.5\n3 1 1 0 2 1 0.5 0.25\n4 0 1 0 3 8\n") +
           elements)
          .mesh;
  EXPECT_EQ(text.vertex_classes,
            (std::vector{ModelRef(0, 5), ModelRef(1, 3), ModelRef(2, 1), ModelRef(2, 1)}));
  ASSERT_EQ(text.model.entities.size(), 1u);
  EXPECT_EQ(text.model.entities[0].groups, std::vector{9});
  std::string bytes = "$MeshFormat\n2.2 1 8\n" + raw(1) + "\n$EndMeshFormat\n$ParametricNodes\n3\n";
  for (int v = 1; v <= 3; ++v) {
    bytes += raw(v) + raw(double(v)) + raw(0.0) + raw(double(v % 2)) + raw(v - 1) + raw(v);
    for (int k = 1; k < v; ++k) bytes += raw(0.25);
  }
  bytes += "\n$EndParametricNodes\n$Elements\n1\n" + raw(2) + raw(1) + raw(2) + raw(1) + raw(0) +
           raw(3) + raw(1) + raw(2) + raw(3) + "\n$EndElements\n";
  const MeshData binary = read(bytes).mesh;
  EXPECT_EQ(binary.positions[2], glm::dvec3(3, 0, 1));
  EXPECT_EQ(binary.vertex_classes, (std::vector{ModelRef(0, 1), ModelRef(1, 2), ModelRef(2, 3)}));
}

TEST(MshModel, CommentsMayComeFirst) {
  const std::string comments = section("Comments", "$MeshFormat\nanything\n");
  EXPECT_EQ(io::read_bytes("unnamed", comments + "\n" + comments + format4 + line4).mesh,
            read(format4 + line4).mesh);
  expect_error("a.msh", "$Comments\nno end\n", {"a.msh:1: ", "no \"$EndComments\""});
  expect_error("a.msh", comments, {"not an MSH file"});
}

}  // namespace
}  // namespace aomd::io_msh_model_test
