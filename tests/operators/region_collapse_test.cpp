// Collapses among a few tetrahedra, of which every answer is known.

#include <gtest/gtest.h>

#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/operators/region_collapse.h"
#include "tests/support/strata.h"
#include "tests/support/tet_zoo.h"

namespace aomd::region_collapse_test {
namespace {

constexpr ModelRef inside(3, 1);

/// A mesh with what the collapser needs.
struct Stored {
  explicit Stored(const MeshData& data) : mesh(data) {
    needs.push_back(mesh.request_listed(0, 1));
    needs.push_back(mesh.request_listed(0, 2));
    needs.push_back(mesh.request(0, 3));
  }
  Verdict judge(std::uint32_t deleted, std::uint32_t kept, const VolumeRules& rules = {}) {
    return collapser().judge(
        mesh, Contraction{Vertex(deleted), Vertex(kept), mesh.position(Vertex(kept))}, rules, plan);
  }
  RegionCollapser& collapser() {
    if (!held) held.emplace(mesh);
    return *held;
  }

  Mesh mesh;
  std::vector<Request> needs;
  std::optional<RegionCollapser> held;
  VolumeCollapsePlan plan;
};

// The corner of a cube with a vertex 4 inside: four tetrahedra. Sides lie on one model face each.
MeshData corner_with_a_point() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
  for (const auto& [a, b, c] : {std::array{0u, 2u, 1u}, std::array{0u, 1u, 3u},
                                std::array{1u, 2u, 3u}, std::array{2u, 0u, 3u}}) {
    data.regions.add(Shape::Tetrahedron, {a, c, b, 4}, inside);
    data.faces.add(Shape::Triangle, {a, b, c},
                   ModelRef(2, static_cast<int>(data.faces.size()) + 1));
  }
  for (const auto& [a, b] : {std::array{0u, 1u}, std::array{0u, 2u}, std::array{0u, 3u},
                             std::array{1u, 2u}, std::array{2u, 3u}, std::array{3u, 1u}})
    data.edges.add(Shape::Line, {a, b}, ModelRef(1, static_cast<int>(data.edges.size()) + 1));
  data.vertex_classes = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, inside};
  return data;
}

// One tetrahedron with nothing but a closed curve around its side 0 1 2.
MeshData cup() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, inside);
  const ModelRef lid(2, 1), side(2, 2), rim(1, 1);
  data.faces.add(Shape::Triangle, {0, 2, 1}, lid);
  data.faces.add(Shape::Triangle, {0, 1, 3}, side);
  data.faces.add(Shape::Triangle, {1, 2, 3}, side);
  data.faces.add(Shape::Triangle, {2, 0, 3}, side);
  data.edges.add(Shape::Line, {0, 1}, rim);
  data.edges.add(Shape::Line, {1, 2}, rim);
  data.edges.add(Shape::Line, {2, 0}, rim);
  data.vertex_classes = {rim, rim, rim, side};
  return data;
}

TEST(RegionCollapseTest, AVertexInsideGoesIntoACorner) {
  Stored s(corner_with_a_point());
  ASSERT_TRUE(s.judge(4, 0).accepted());
  EXPECT_EQ(s.plan.balls[0].size(), 4u);
  EXPECT_EQ(s.plan.balls[1].size(), 3u);
  EXPECT_TRUE(s.plan.stars[0].empty() && s.plan.stars[1].empty());
  s.collapser().apply(s.mesh, s.plan);
  ASSERT_EQ(s.mesh.count(3), 1u);
  EXPECT_EQ(s.mesh.count(2), 4u);
  EXPECT_EQ(s.mesh.count(1), 6u);
  EXPECT_EQ(s.mesh.count(0), 4u);
  EXPECT_EQ(s.mesh.tetrahedron(Region(2)),
            (std::array{Vertex(1), Vertex(3), Vertex(2), Vertex(0)}));
  EXPECT_EQ(test::wrong_with_tets(s.mesh), "");
  EXPECT_TRUE(verify(s.mesh).empty());
}

TEST(RegionCollapseTest, ACornerDoesNotGoInside) {
  Stored s(corner_with_a_point());
  const Verdict v = s.judge(0, 4);
  EXPECT_EQ(v.reason, Reason::Classification);
  EXPECT_EQ(v.entity, EntityRef(Vertex(0)));
}

TEST(RegionCollapseTest, ByAnEdgeEitherEndIsTried) {
  Stored s(corner_with_a_point());
  s.needs.push_back(s.mesh.request(0, 1));
  const Edge e = s.mesh.find_edge(Vertex(0), Vertex(4));
  ASSERT_TRUE(e.valid());
  EXPECT_TRUE(s.collapser().judge(s.mesh, e, {true, true}, {}, s.plan).accepted());
  EXPECT_EQ(s.plan.contraction.deleted, Vertex(4));
  EXPECT_EQ(s.plan.balls[0].size(), 4u) << "of the end that goes";
  const bool first = s.mesh.edge_vertices(e)[0] == Vertex(0);
  EXPECT_EQ(s.collapser().judge(s.mesh, e, {first, !first}, {}, s.plan).reason,
            Reason::Classification);
}

TEST(RegionCollapseTest, AClosedCurveOfThreeEdgesStays) {
  Stored s(cup());
  const Verdict v = s.judge(0, 1);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Vertex(2)));
}

TEST(RegionCollapseTest, TwoModelFacesDoNotFallTogether) {
  MeshData data = cup();
  data.edges = {};
  data.faces.classes.assign(4, ModelRef(2, 1));
  data.vertex_classes.assign(4, ModelRef(2, 1));
  Stored s(data);
  const Verdict v = s.judge(0, 1);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Face(2))) << "1 2 3 and 0 2 3 are one afterwards";
}

TEST(RegionCollapseTest, ATetrahedronThatWouldTurnInsideOutIsNamed) {
  Stored s(corner_with_a_point());
  RegionCollapser& collapser = s.collapser();
  s.mesh.move(Vertex(4), {0.4, 0.4, 0.4});  // beyond the side 1 2 3
  const Verdict v = collapser.judge(s.mesh, {Vertex(4), Vertex(0), {-1, -1, -1}}, {}, s.plan);
  EXPECT_EQ(v.reason, Reason::Classification) << "a corner does not move";
  s.mesh.move(Vertex(0), {0.5, 0.5, 0.5});
  const Verdict turned = s.judge(4, 0);
  EXPECT_EQ(turned.reason, Reason::Inverted);
  EXPECT_EQ(turned.entity, EntityRef(Region(2)));
}

TEST(RegionCollapseTest, AnEdgeThatWouldBeTooLongIsNamedByItsEnd) {
  Stored s(corner_with_a_point());
  const Column<Vertex, double> size(5, 0.5);
  const Verdict v = s.judge(4, 0, {.overshoot = 1.9, .size = &size});
  EXPECT_EQ(v.reason, Reason::Overshoot);
  EXPECT_EQ(v.entity.dimension, 0);
  EXPECT_DOUBLE_EQ(v.number(), 1);
  EXPECT_TRUE(s.judge(4, 0, {.overshoot = 2.1, .size = &size}).accepted());
}

// Vertex 0 among the corners 1 to 6 of an octahedron, of which the first two stand at these x.
MeshData octahedron(double first, double second) {
  MeshData data;
  data.positions = {{0, 0, 0},  {first, 0, 0}, {second, 0, 0}, {0, 1, 0},
                    {0, -1, 0}, {0, 0, 1},     {0, 0, -1}};
  for (const auto& [y, z] :
       {std::array{3u, 5u}, std::array{5u, 4u}, std::array{4u, 6u}, std::array{6u, 3u}}) {
    data.regions.add(Shape::Tetrahedron, {0, 1, y, z}, inside);
    data.regions.add(Shape::Tetrahedron, {0, 2, z, y}, inside);
  }
  data.vertex_classes.assign(data.positions.size(), inside);
  return data;
}

TEST(RegionCollapseTest, AShapeBelowTheLeastNeedsOneAsBadAround) {
  Stored s(corner_with_a_point());
  EXPECT_TRUE(s.judge(4, 0, {.least_shape = 0.99}).accepted()) << "those around were worse";
  Stored stretched(octahedron(3, -1));
  const double around = std::sqrt(2) * 3 / std::pow(5.5, 1.5),
               made = std::sqrt(2) * 4 / std::pow(7, 1.5);
  ASSERT_LT(made, around);
  EXPECT_TRUE(stretched.judge(0, 1, {.least_shape = made - 1e-9}).accepted());
  const Verdict v = stretched.judge(0, 1, {.least_shape = made + 1e-9});
  EXPECT_EQ(v.reason, Reason::Shape);
  EXPECT_EQ(v.entity, EntityRef(Region(1)));
}

// The kept vertex goes out to x = 2: between a stretched tetrahedron's base and its slope the
// cosine becomes 2/3, and was 1/sqrt(3).
TEST(RegionCollapseTest, ADihedralAngleBelowTheLeastNeedsOneAsBadAround) {
  const double made = std::acos(2.0 / 3) * 180 / M_PI;
  const auto judged = [](const MeshData& data, double x, double least_deg) {
    Stored s(data);
    return s.collapser().judge(s.mesh, {Vertex(0), Vertex(1), {x, 0, 0}},
                               {.least_dihedral = LeastAngle(least_deg)}, s.plan);
  };
  EXPECT_TRUE(judged(octahedron(1, -1), 2, 0).accepted());
  EXPECT_TRUE(judged(octahedron(1, -1), 2, made - 1e-9).accepted());
  const Verdict v = judged(octahedron(1, -1), 2, made + 1e-9);
  EXPECT_EQ(v.reason, Reason::Shape);
  EXPECT_EQ(v.entity, EntityRef(Region(1)));
  EXPECT_NEAR(v.number(), made, 1e-12);
  EXPECT_TRUE(judged(octahedron(2.5, -1), 2, 70).accepted()) << "one as bad was there";
}

TEST(RegionCollapseTest, AnEdgeThatIsTooLongMayBecomeShorter) {
  Stored s(octahedron(1, -3));
  const Column<Vertex, double> size(7, 1);
  const VolumeRules rules{.overshoot = 2, .size = &size};
  EXPECT_TRUE(
      s.collapser().judge(s.mesh, {Vertex(0), Vertex(1), {-0.5, 0, 0}}, rules, s.plan).accepted());
  const Verdict v = s.judge(0, 1, rules);
  EXPECT_EQ(v.reason, Reason::Overshoot);
  EXPECT_EQ(v.entity, EntityRef(Vertex(2)));
  EXPECT_DOUBLE_EQ(v.number(), 4);
}

TEST(RegionCollapseTest, OfTheSizesOfBothEndsTheLargerCounts) {
  Stored s(octahedron(1, -3));
  Column<Vertex, double> size(7, 1);
  size[Vertex(1)] = 2.5;
  EXPECT_TRUE(s.judge(0, 1, {.overshoot = 2, .size = &size}).accepted());
}

// Beyond the side 1 3 5 stands a tetrahedron with 7, which the vertex that stays must not cross.
TEST(RegionCollapseTest, TheVertexThatStaysTurnsNothingInsideOut) {
  MeshData data = octahedron(1, -1);
  data.positions.push_back({2, 2, 2});
  data.regions.add(Shape::Tetrahedron, {1, 3, 5, 7}, inside);
  data.vertex_classes.push_back(inside);
  Stored s(data);
  const auto to = [&](double x) {
    return s.collapser().judge(s.mesh, {Vertex(0), Vertex(1), {x, 0, 0}}, {}, s.plan);
  };
  EXPECT_TRUE(to(-0.5).accepted());
  const Verdict v = to(-0.9);
  EXPECT_EQ(v.reason, Reason::Inverted);
  EXPECT_EQ(v.entity, EntityRef(Region(8)));
}

// The skin of an octahedron is one model face, on which 1 goes into 3.
TEST(RegionCollapseTest, TheStarsAreThoseOfTheEndsThatGoAndStay) {
  const ModelRef skin(2, 1);
  for (const bool second : {false, true}) {
    MeshData data = octahedron(1, -1);
    data.positions[3].x = 0.5;
    for (const auto& [y, z] :
         {std::array{3u, 5u}, std::array{5u, 4u}, std::array{4u, 6u}, std::array{6u, 3u}}) {
      data.faces.add(Shape::Triangle, {1, y, z}, skin);
      data.faces.add(Shape::Triangle, {2, z, y}, skin);
    }
    data.edges.add(Shape::Line, {second ? 3u : 1u, second ? 1u : 3u}, skin);
    data.vertex_classes.assign(7, skin);
    data.vertex_classes[0] = inside;
    Stored s(data);
    VolumeRules rules;
    rules.faces.max_turn = TurnLimit(179);
    ASSERT_TRUE(s.collapser().judge(s.mesh, Edge(0), {!second, second}, rules, s.plan).accepted());
    ASSERT_EQ(s.plan.contraction.deleted, Vertex(1));
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_EQ(s.plan.stars[i].size(), 4u);
      for (const StarFace& f : s.plan.stars[i])
        EXPECT_EQ(s.mesh.triangle(f.face)[f.slot], Vertex(i == 0 ? 1 : 3)) << second;
    }
  }
}

// A pyramid far off stands with its apex on one end of the edge.
TEST(RegionCollapseTest, AnEndOfAnotherShapeStays) {
  for (const std::uint32_t end : {0u, 4u}) {
    MeshData data = corner_with_a_point();
    data.positions.insert(data.positions.end(), {{8, 0, 9}, {9, 0, 9}, {9, 1, 9}, {8, 1, 9}});
    data.regions.add(Shape::Pyramid, {5, 6, 7, 8, end}, inside);
    data.vertex_classes.resize(9, inside);
    Stored s(data);
    const Verdict v = s.judge(4, 0);
    EXPECT_EQ(v.reason, Reason::Kept) << end;
    EXPECT_EQ(v.entity, EntityRef(Region(4))) << end;
  }
}

// An edge that is listed, and of which no tetrahedron has both ends.
TEST(RegionCollapseTest, AnEdgeBetweenTwoPiecesStays) {
  MeshData data = octahedron(1, -1);
  data.positions.insert(data.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}});
  data.regions.add(Shape::Tetrahedron, {7, 8, 9, 10}, inside);
  data.edges.add(Shape::Line, {0, 7}, inside);
  data.vertex_classes.resize(11, inside);
  Stored s(data);
  const Verdict v = s.collapser().judge(s.mesh, Edge(0), {true, true}, {}, s.plan);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Vertex(0)));
}

// A tetrahedron elsewhere joins 1 and 2, which 0 lies between.
TEST(RegionCollapseTest, WhatBothEndsShareStandsBesideTheEdge) {
  MeshData data = octahedron(1, -1);
  data.positions.insert(data.positions.end(), {{0, 5, 5}, {0, 5, 6}});
  data.regions.add(Shape::Tetrahedron, {1, 2, 7, 8}, inside);
  data.vertex_classes.resize(9, inside);
  Stored s(data);
  const Verdict v = s.judge(0, 1);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Vertex(2)));
}

// Three tetrahedra around the edge 0-1, and both ends with the triangle 2 3 4 that goes around it.
TEST(RegionCollapseTest, TwoTetrahedraDoNotFallTogether) {
  MeshData data;
  data.positions = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}};
  for (const auto& [a, b] : {std::array{2u, 3u}, std::array{3u, 4u}, std::array{4u, 2u}})
    data.regions.add(Shape::Tetrahedron, {0, 1, b, a}, inside);
  for (const std::uint32_t end : {1u, 0u})
    data.regions.add(Shape::Tetrahedron, {end, 2, 3, 4}, inside);
  data.vertex_classes.assign(5, inside);
  Stored s(data);
  const Verdict v = s.judge(0, 1);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Region(3)));
}

TEST(RegionCollapseTest, ACrowdWaits) {
  MeshData data;
  const std::uint32_t n = largest_ball + 1;
  data.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    data.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    data.regions.add(Shape::Tetrahedron, {0, 2 + i, 2 + (i + 1) % n, 1}, inside);
  }
  data.vertex_classes.assign(data.positions.size(), inside);
  Stored s(data);
  const Verdict v = s.judge(2, 0);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Vertex(0)));
}

}  // namespace
}  // namespace aomd::region_collapse_test
