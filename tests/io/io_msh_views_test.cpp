// Values in MSH files: at nodes, of elements, and at the corners of faces.

#include <cmath>

#include "tests/support/msh_texts.h"

namespace aomd::io_msh_views_test {
namespace {

using test::expect_error;
using namespace test::msh;

TEST(MshViews, ReadsViews) {
  const std::string head = "0\n3\n";
  const std::string text =
      format4 + section("NodeData", "1\n\"speed\"\n1\n0.5\n4\n2\n3\n2\n0\n4 1 2 3\n1 4 5 inf\n") +
      entities4 + nodes4 + elements4 +
      section("NodeData", "1\n\"speed\"\n" + head + "3\n1\n1\n2 7\n") +
      section("ElementData", "2\n\"load\"\n\"scheme\"\n" + head + "0\n1\n3\n4 1\n2 2\n1 8\n");
  const io::ReadResult result = read(text);
  ASSERT_EQ(result.mesh.attributes.size(), 3u);
  const Attribute &speed = result.mesh.attributes[0], &inside = result.mesh.attributes[1];
  EXPECT_EQ(speed.name, "speed");
  EXPECT_EQ(speed.dimension, 0);
  EXPECT_EQ(speed.components, 3);
  ASSERT_EQ(speed.values.size(), 12u);
  EXPECT_EQ(speed.values[1], 5);
  EXPECT_TRUE(std::isinf(speed.values[2]));
  EXPECT_TRUE(std::isnan(speed.values[3]));
  EXPECT_EQ(speed.values[11], 3);
  EXPECT_EQ(inside, (Attribute{"load", 3, 1, false, {1}}));
  EXPECT_EQ(result.mesh.attributes[2], (Attribute{"load", 1, 1, false, {2}}));
  EXPECT_TRUE(noted(result, "1 further time step dropped"));
  EXPECT_TRUE(noted(result, "1 value on what the mesh does not keep"));
}

/// A triangle of order 2, whose last three nodes are no corners, a quad, and an edge between.
TEST(MshViews, ReadsValuesAtTheCornersOfFaces) {
  const std::string nodes = section(
      "Nodes", "8\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n5 2 1 0\n6 2 0 0\n7 .5 0 0\n8 0 .5 0\n");
  const std::string elements =
      section("Elements", "3\n1 9 0 1 2 3 7 8 8\n2 3 0 2 6 5 4\n3 1 0 2 4\n");
  const std::string head = "1\n\"q\"\n0\n3\n0\n";
  const io::ReadResult result =
      read(format2 + nodes + elements +
           section("ElementNodeData", head + "2\n3\n1 6 1 2 3 4 5 6 7 7 7 7 7 7\n"
                                             "2 4 10 11 12 13 14 15 16 nan\n3 2 0 0 0 0\n"));
  ASSERT_EQ(result.mesh.corners.size(), 1u);
  const Attribute& q = result.mesh.corners[0];
  EXPECT_EQ(q.name, "q");
  EXPECT_EQ(q.components, 2);
  ASSERT_EQ(q.values.size(), 14u);
  EXPECT_EQ(std::vector(q.values.begin(), q.values.end() - 1),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 10, 11, 12, 13, 14, 15, 16}));
  EXPECT_TRUE(std::isnan(q.values[13]));
  EXPECT_TRUE(noted(result, "1 value on what the mesh does not keep"));
  const std::string text = format2 + nodes + elements;
  expect_error("a.msh", text + section("ElementNodeData", head + "1\n1\n2 3 1 2 3\n"),
               {"a.msh:", "view \"q\" has values at 3 nodes of a quad"});
  expect_error("a.msh", text + section("ElementNodeData", head + "1\n1\n1 4 1 2 3 4\n"),
               {"view \"q\" has values at 4 nodes of a triangle"});
  expect_error("a.msh", text + section("ElementNodeData", head + "1\n1\n2 0\n"),
               {"an element without nodes"});
  expect_error("a.msh", text + section("ElementNodeData", head + "1\n2\n2 4 1 2 3 4\n"),
               {"whole number", "$EndElementNodeData"});
}

/// What is left of a quad that repeats a node has three corners, and no values.
TEST(MshViews, DropsValuesOfFacesThatRepeatNodes) {
  const io::ReadResult result =
      read(format2 + section("Nodes", "4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n") +
           section("Elements", "2\n1 3 0 1 2 3 3\n2 2 0 2 4 3\n") +
           section("ElementNodeData", "1\n\"q\"\n0\n3\n0\n1\n2\n1 4 1 2 3 4\n2 3 5 6 7\n"));
  ASSERT_EQ(result.mesh.faces.size(), 2u);
  ASSERT_EQ(result.mesh.corners.size(), 1u);
  EXPECT_TRUE(std::isnan(result.mesh.corners[0].values[0]));
  EXPECT_EQ(result.mesh.corners[0].values[3], 5);
  EXPECT_TRUE(noted(result, "1 value on what the mesh does not keep"));
}

TEST(MshViews, RefusesBrokenViews) {
  const std::string text = format4 + entities4 + nodes4 + elements4, head = "1\n\"v\"\n0\n3\n0\n";
  expect_error("a.msh", text + section("NodeData", head + "1\n1\n5 0\n"),
               {"a.msh:45:", "\"v\"", "node 5"});
  expect_error("a.msh", text + section("ElementData", head + "1\n1\n5 0\n"), {"element 5"});
  expect_error("a.msh", text + section("NodeData", head + "1\n2\n1 0\n"),
               {"whole number", "$EndNodeData"});
  expect_error("a.msh", text + section("NodeData", head + "0\n1\n1 0\n"), {"without components"});
  expect_error("a.msh", text + section("NodeData", head + "1000000000\n1\n1 0\n"),
               {"too few values"});
  expect_error("a.msh", text + "$NodeData\n" + head, {"$EndNodeData"});
}

}  // namespace
}  // namespace aomd::io_msh_views_test
