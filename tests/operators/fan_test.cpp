// Safe collapses let no two fans of faces meet in one vertex that had one.

#include <gtest/gtest.h>

#include "core/mesh/verify.h"
#include "core/operators/collapse.h"
#include "tests/support/zoo.h"

namespace aomd::fan_test {
namespace {

Reason judge(const MeshData& data, TopologyRule topology) {
  Mesh mesh(data);
  mesh.set(0, 1), mesh.set(0, 2);
  Collapser collapser(mesh);
  CollapsePlan plan;
  const CollapseRules rules{.max_turn = TurnLimit(179), .topology = topology};
  return collapser.judge(mesh, mesh.find_edge(Vertex(0), Vertex(1)), Vertex(1), rules, plan).reason;
}

//    5
//   /|\            three pages 2, 3, 4 on the edge 0-1, which looks at you; the faces 0 2 5 and
//  2 | 3           0 3 5 connect two of them around 0
//   \|/
//    0=1--4        the face 1 4 6 (6 lies behind 4) is connected to the others by the edge alone
zoo::Triangles pages() {
  return {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 2, 5}, {0, 5, 3}, {1, 4, 6}};
}

MeshData three_pages(const zoo::Triangles& triangles) {
  return zoo::make({{0, 0, 0}, {0, 0, 1}, {-1, 1, 0}, {1, 1, 0}, {2, -1, 0}, {0, 2, 0}, {3, -2, 1}},
                   triangles);
}

TEST(FanTest, PagesThatTheEdgeAloneConnectsStayConnected) {
  EXPECT_EQ(judge(three_pages(pages()), TopologyRule::Safe), Reason::Topology);
  EXPECT_EQ(judge(three_pages(pages()), TopologyRule::Paper), Reason::None);
  zoo::Triangles connected = pages();
  connected.push_back({1, 6, 3});
  EXPECT_EQ(judge(three_pages(connected), TopologyRule::Safe), Reason::None);
}

//  3      5
//  |\    /|        two triangles, and an edge without faces between their tips 0 and 1
//  | 0--1 |
//  |/    \|
//  2      4
TEST(FanTest, AnEdgeWithoutFacesDoesNotPinchTwoSurfaces) {
  MeshData data = zoo::make({{0, 0, 0}, {1, 0, 0}, {-1, -1, 0}, {-1, 1, 0}, {2, -1, 0}, {2, 1, 0}},
                            {{0, 3, 2}, {1, 4, 5}});
  data.edges.add(Shape::Line, {0, 1});
  EXPECT_EQ(judge(data, TopologyRule::Safe), Reason::Topology);
  EXPECT_EQ(judge(data, TopologyRule::Paper), Reason::None);
  data.faces.vertices.resize(3), data.faces.shapes.resize(1);
  EXPECT_EQ(judge(data, TopologyRule::Safe), Reason::None) << "a wire at one triangle";
}

}  // namespace
}  // namespace aomd::fan_test
