#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/classify.h"
#include "core/operators/collapse.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"
#include "tests/support/as_listed.h"
#include "tests/support/zoo.h"

namespace aomd::operators_test {
namespace {

// A mesh with what the operators need, classified.
struct Bench {
  explicit Bench(const MeshData& data) : mesh(data) {
    classify(mesh, test::as_listed(data));
    for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) mesh.set(i, j);
  }
  Edge edge(std::uint32_t a, std::uint32_t b) const { return mesh.find_edge(Vertex(a), Vertex(b)); }
  Verdict judge_collapse(std::uint32_t deleted, std::uint32_t kept, double angle = 10,
                         TopologyRule topology = TopologyRule::Safe) {
    Collapser collapser(mesh);
    CollapsePlan plan;
    return collapser.judge(mesh, edge(deleted, kept), Vertex(deleted), {TurnLimit(angle), topology},
                           plan);
  }
  void collapse(std::uint32_t deleted, std::uint32_t kept) {
    Collapser collapser(mesh);
    collapser.apply(mesh, edge(deleted, kept), Vertex(deleted));
    EXPECT_TRUE(verify(mesh).empty());
  }
  Mesh mesh;
};

// The grid of paper figure 5:
//
//  12-13-14-15      corners 0 3 12 15 are model vertices, the border is four model edges, 5 6 9 10
//   8--9-10-11      are inside the model face
//   4--5--6--7
//   0--1--2--3
TEST(CollapseTest, ClassificationDecidesAsInFigure5) {
  Bench b(zoo::grid(3));
  EXPECT_EQ(b.judge_collapse(0, 1).reason, Reason::Classification);  // a model vertex stays
  EXPECT_EQ(b.judge_collapse(1, 5).reason, Reason::Classification);  // off its model edge
  EXPECT_EQ(b.judge_collapse(1, 0).reason, Reason::None);  // case II: along its model edge
  EXPECT_EQ(b.judge_collapse(5, 6).reason, Reason::None);  // case I: inside the model face
  EXPECT_EQ(b.judge_collapse(5, 1).reason, Reason::None);  // onto the border is allowed
  EXPECT_EQ(b.judge_collapse(1, 0).entity, EntityRef());
  EXPECT_EQ(b.judge_collapse(0, 1).entity, EntityRef(Vertex(0)));
}

// 0-1-2 is all that model face 2 has: without one of its sides it would vanish, and the model edge
// around it fall together.
//
//         5
//       / 2 \ .
//     / 0---1 \ .
//   3-----------4
TEST(CollapseTest, TheLastTriangleOfAModelFaceStays) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {-2, -1, 0}, {3, -1, 0}, {0.5, 3, 0}};
  data.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 2));
  for (const auto& [a, b, c] : {std::array{3u, 4u, 1u},
                                {3u, 1u, 0u},
                                {4u, 5u, 2u},
                                {4u, 2u, 1u},
                                {5u, 3u, 0u},
                                {5u, 0u, 2u}})
    data.faces.add(Shape::Triangle, {a, b, c}, ModelRef(2, 1));
  Mesh mesh(data);
  classify(mesh, {.feature_angle_deg = {}, .corner_angle_deg = 180});
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}}) mesh.set(i, j);
  Collapser collapser(mesh);
  CollapsePlan plan;
  CollapseRules rules;
  rules.max_turn = TurnLimit(180);
  rules.max_curve_turn = TurnLimit(180);
  const Edge edge = mesh.find_edge(Vertex(0), Vertex(1));
  ASSERT_EQ(mesh.classification(edge).dimension(), 1);
  for (const Vertex v : {Vertex(0), Vertex(1)}) {
    const Verdict verdict = collapser.judge(mesh, edge, v, rules, plan);
    EXPECT_EQ(verdict.reason, Reason::Topology);
    EXPECT_EQ(verdict.entity, EntityRef(Vertex(2)));
  }
}

// 5 onto 6 removes the two faces between them and keeps the other four:
//   8--9-10        8--9-10
//   |/ |/ |        | \| /|     (face 4-5-9 becomes 4-6-9 and so on)
//   4--5--6   ->   4-----6
//   |/ |/ |        |/ / /|
//   0--1--2        0--1--2
TEST(CollapseTest, CountsAndStretchedFacesAreExact) {
  Bench b(zoo::grid(3));
  b.collapse(5, 6);
  EXPECT_EQ(b.mesh.count(0), 15u);
  EXPECT_EQ(b.mesh.count(1), 30u);  // 33 - 3
  EXPECT_EQ(b.mesh.count(2), 16u);  // 18 - 2
  EXPECT_FALSE(b.mesh.alive(Vertex(5)));
  EXPECT_TRUE(b.edge(4, 6).valid());
  EXPECT_TRUE(b.edge(0, 6).valid());
  EXPECT_EQ(zoo::euler(b.mesh), 1);
}

TEST(CollapseTest, AStretchedFaceKeepsItsIdAndClassification) {
  Bench b(zoo::grid(3));
  const Face f = b.mesh.row<2>(Vertex(5))[0];  // (0, 1, 5): not at the edge 5-6
  b.collapse(5, 6);
  const auto t = b.mesh.triangle(f);
  EXPECT_EQ(std::set<Vertex>(t.begin(), t.end()),
            (std::set<Vertex>{Vertex(0), Vertex(1), Vertex(6)}));
  EXPECT_EQ(b.mesh.classification(f), ModelRef(2, 1));
  EXPECT_EQ(b.mesh.capacity(2), 18u) << "no face was created";
}

//     4
//    /|\        moving 4 onto 1 would lay the face (2, 3, 4) into the line 1-2-3
//   / | \ \     .
//  0--1--2--3
//   \ | / /
//     5
TEST(CollapseTest, AFaceThatWouldBecomeFlatIsRefused) {
  Bench line(zoo::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}, {2, -1, 0}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 5, 1}, {1, 5, 2}, {2, 5, 3}}));
  EXPECT_EQ(line.judge_collapse(4, 1).reason,
            Reason::Classification);  // 4 is a corner of the sheet
  line.mesh.set_classification(Vertex(4), line.mesh.classification(line.edge(1, 4)));
  const Verdict v = line.judge_collapse(4, 1, 10, TopologyRule::Paper);
  EXPECT_EQ(v.reason, Reason::Flat);
  EXPECT_EQ(v.entity, EntityRef(Face(2)));
}

TEST(CollapseTest, AnAngleRefusalCarriesTheAngleAndTheFace) {
  // A pyramid of height 1 on a unit square: moving the apex onto a corner turns the far faces.
  MeshData data = zoo::make({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
                            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  data.faces.classes.assign(4, ModelRef(2, 1));
  Bench b(data);
  const Verdict v = b.judge_collapse(4, 0);
  EXPECT_EQ(v.reason, Reason::Angle);
  EXPECT_NEAR(v.number(), 45, 1e-9);  // faces (1,2,4) and (2,3,4) fall flat from 45 degrees
  EXPECT_EQ(v.entity.dimension, 2);
  EXPECT_EQ(b.judge_collapse(4, 0, 46).reason, Reason::None);
}

// The border of a disc of six: in a plane no normal ever turns, but the curve 3-4-5 would, by 30
// degrees.
TEST(CollapseTest, AModelEdgeMayNotTurnTooFar) {
  std::vector<glm::dvec3> p{{0, 0, 0}};
  zoo::Triangles t;
  for (std::uint32_t i = 0; i < 6; ++i) {
    p.emplace_back(std::cos(M_PI * i / 3), std::sin(M_PI * i / 3), 0);
    t.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  Bench b(zoo::make(p, t));
  for (std::uint32_t i = 1; i <= 6; ++i) {
    b.mesh.set_classification(Vertex(i), ModelRef(1, 1));
    b.mesh.set_classification(b.edge(i, i % 6 + 1), ModelRef(1, 1));
  }
  Collapser collapser(b.mesh);
  CollapsePlan plan;
  CollapseRules rules{TurnLimit(10), TopologyRule::Safe, TurnLimit(29)};
  const Verdict v = collapser.judge(b.mesh, b.edge(4, 5), Vertex(4), rules, plan);
  EXPECT_EQ(v.reason, Reason::Angle);
  EXPECT_EQ(v.entity, EntityRef(b.edge(3, 4)));
  EXPECT_NEAR(v.number(), 30, 1e-9);
  rules.max_curve_turn = TurnLimit(31);
  EXPECT_TRUE(collapser.judge(b.mesh, b.edge(4, 5), Vertex(4), rules, plan).accepted());
  rules = {TurnLimit(10), TopologyRule::Paper, TurnLimit(29)};
  EXPECT_TRUE(collapser.judge(b.mesh, b.edge(4, 5), Vertex(4), rules, plan).accepted())
      << "the paper has no such rule";
}

TEST(CollapseTest, TheLinkConditionKeepsATetrahedron) {
  MeshData data = zoo::tetrahedron();
  data.faces.classes.assign(4, ModelRef(2, 1));
  Bench b(data);
  EXPECT_EQ(b.judge_collapse(0, 1, 179).reason, Reason::Topology);
}

// A face twice over is a pocket: collapsing one of its edges would make it vanish.
TEST(CollapseTest, TheLinkConditionKeepsAPocket) {
  MeshData data = zoo::grid(3);
  data.faces.add(Shape::Triangle, {5, 6, 10});
  data.faces.classes.assign(data.faces.size(), ModelRef(2, 1));
  Bench b(data);
  for (const Vertex v : b.mesh.vertices()) b.mesh.set_classification(v, ModelRef(2, 1));
  for (const Edge e : b.mesh.edges()) b.mesh.set_classification(e, ModelRef(2, 1));
  EXPECT_EQ(b.judge_collapse(5, 6, 179).reason, Reason::Topology);
  EXPECT_EQ(b.judge_collapse(5, 6, 10, TopologyRule::Paper).reason, Reason::None);
}

// A tube of three: its ring 0-1-2 is no face, so collapsing 0-1 would pinch it.
TEST(CollapseTest, TheLinkConditionKeepsATube) {
  zoo::Triangles t;
  std::vector<glm::dvec3> p;
  for (std::uint32_t ring = 0; ring < 3; ++ring)
    for (std::uint32_t i = 0; i < 3; ++i) {
      p.emplace_back(std::cos(2 * M_PI * i / 3), std::sin(2 * M_PI * i / 3), ring);
      if (ring == 2) continue;
      const std::uint32_t a = 3 * ring + i, c = 3 * ring + (i + 1) % 3;
      t.push_back({a, c, c + 3});
      t.push_back({a, c + 3, a + 3});
    }
  MeshData data = zoo::make(p, t);
  data.faces.classes.assign(t.size(), ModelRef(2, 1));
  Bench b(data);
  const Verdict v = b.judge_collapse(3, 4, 179);
  EXPECT_EQ(v.reason, Reason::Topology);
  EXPECT_EQ(v.entity, EntityRef(Vertex(5)));
  EXPECT_NE(b.judge_collapse(3, 4, 179, TopologyRule::Paper).reason, Reason::Topology);
}

// 3--4--5   the inner edge 1-4 joins two places of the boundary; without a classification only the
// | /| /|   link condition can know
// |/ |/ |
// 0--1--2
TEST(CollapseTest, TheLinkConditionKeepsAStripWide) {
  Mesh mesh(zoo::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                      {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}));
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}}) mesh.set(i, j);
  Collapser collapser(mesh);
  const Edge rung = mesh.find_edge(Vertex(1), Vertex(4));
  CollapsePlan plan;
  EXPECT_EQ(
      collapser.judge(mesh, rung, Vertex(1), {TurnLimit(179), TopologyRule::Safe}, plan).reason,
      Reason::Topology);
}

// A triangular hole: collapsing one of its edges, whichever way it runs, would close it.
TEST(CollapseTest, TheLinkConditionKeepsATriangularHole) {
  MeshData data = zoo::grid(3);
  data.faces.shapes.erase(data.faces.shapes.begin() + 8);
  data.faces.vertices.erase(data.faces.vertices.begin() + 24,
                            data.faces.vertices.begin() + 27);  // 5, 6, 10
  const std::array<std::array<std::uint32_t, 3>, 3> sides{{{5, 6, 10}, {6, 10, 5}, {10, 5, 6}}};
  for (const bool along : {true, false}) {
    data.edges = {};
    for (const auto& [x, y, third] : sides)
      data.edges.add(Shape::Line, {along ? x : y, along ? y : x}, ModelRef(1, 99));
    Bench b(data);
    for (const auto& [x, y, third] : sides) {
      b.mesh.set_classification(Vertex(x), ModelRef(1, 99));
      b.mesh.set_classification(b.edge(x, y), ModelRef(1, 99));
    }
    for (const auto& [x, y, third] : sides) {
      ASSERT_EQ(b.mesh.edge_vertices(b.edge(x, y))[0], Vertex(along ? x : y));
      const Verdict v = b.judge_collapse(x, y, 179);
      EXPECT_EQ(v.reason, Reason::Topology);
      EXPECT_EQ(v.entity, EntityRef(Vertex(third)));
    }
  }
}

TEST(CollapseTest, ALoneTriangleIsNotFoldedAway) {
  Bench b(zoo::triangle());
  for (const Vertex v : b.mesh.vertices()) b.mesh.set_classification(v, ModelRef(1, 1));
  for (const Edge e : b.mesh.edges()) b.mesh.set_classification(e, ModelRef(1, 1));
  EXPECT_EQ(b.judge_collapse(0, 1, 179).reason, Reason::Topology);
  EXPECT_EQ(b.judge_collapse(0, 1, 179, TopologyRule::Paper).reason, Reason::None);
  b.collapse(0, 1);  // without the link condition its last edge goes with it
  EXPECT_EQ(b.mesh.count(2), 0u);
  EXPECT_EQ(b.mesh.count(1), 0u);
  EXPECT_EQ(b.mesh.count(0), 2u);
}

TEST(CollapseTest, MergedEdgesKeepTheLowerClassification) {
  Bench b(zoo::grid(3));
  b.mesh.set_classification(b.edge(5, 1), ModelRef(1, 77));
  b.mesh.set_classification(b.edge(5, 6), ModelRef(2, 1));
  Collapser(b.mesh).apply(b.mesh, b.edge(5, 6), Vertex(5));  // 5-1 falls onto 6-1
  EXPECT_EQ(b.mesh.classification(b.edge(6, 1)), ModelRef(1, 77));
}

//   2            2
//  /|\          / \        the diagonal 2-3 of a long kite becomes 0-1
// 0 | 1   ->   0---1
//  \|/          \ /
//   3            3
TEST(SwapTest, TurnsTheLongDiagonal) {
  Bench b(zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {3, 1, 2}}));
  const Edge e = b.edge(2, 3);
  EdgePair pair;
  ASSERT_EQ(judge_swap(b.mesh, e, TurnLimit(10), pair).reason, Reason::None);
  apply_swap(b.mesh, e, pair);
  EXPECT_TRUE(verify(b.mesh).empty());
  EXPECT_EQ(b.edge(0, 1), e) << "the edge keeps its id";
  EXPECT_FALSE(b.edge(2, 3).valid());
  for (const Face f : b.mesh.faces()) {
    const auto t = b.mesh.triangle(f);
    EXPECT_GT(area_normal(b.mesh.position(t[0]), b.mesh.position(t[1]), b.mesh.position(t[2])).z,
              0);
  }
  EXPECT_EQ(judge_swap(b.mesh, e, TurnLimit(10), pair).reason, Reason::Quality) << "not back again";
}

TEST(SwapTest, Refusals) {
  EdgePair pair;
  Bench square(zoo::square());
  EXPECT_EQ(judge_swap(square.mesh, square.edge(0, 1), TurnLimit(10), pair).reason,
            Reason::Classification);
  EXPECT_EQ(judge_swap(square.mesh, square.edge(0, 2), TurnLimit(10), pair).reason,
            Reason::Quality);
  // folded by 90 degrees along the diagonal, on one model face: better angles, but the normals
  // would turn too far
  MeshData data = zoo::make({{-1, 0, 0}, {0, 0, 1}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {3, 1, 2}});
  data.faces.classes.assign(2, ModelRef(2, 1));
  Bench folded(data);
  EXPECT_EQ(judge_swap(folded.mesh, folded.edge(2, 3), TurnLimit(10), pair).reason, Reason::Angle);
  // 0-1 exists already: a third face holds it
  MeshData closed = zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 4}},
                              {{0, 3, 2}, {3, 1, 2}, {0, 1, 4}});
  closed.faces.classes.assign(3, ModelRef(2, 1));
  Bench taken(closed);
  EXPECT_EQ(judge_swap(taken.mesh, taken.edge(2, 3), TurnLimit(10), pair).reason, Reason::Topology);
}

TEST(SmoothTest, MovesToTheAverageAndAlongModelEdgesOnly) {
  Bench b(zoo::grid(2));
  b.mesh.move(Vertex(4), {1.3, 1.2, 0});
  glm::dvec3 target;
  ASSERT_TRUE(judge_smooth(b.mesh, Vertex(4), TurnLimit(10), target).accepted());
  EXPECT_EQ(target, glm::dvec3(1, 1, 0));
  b.mesh.move(Vertex(1), {1.4, 0, 0});
  ASSERT_TRUE(judge_smooth(b.mesh, Vertex(1), TurnLimit(10), target).accepted());
  EXPECT_EQ(target, glm::dvec3(1, 0, 0)) << "on the model edge 0-1-2";
  EXPECT_EQ(judge_smooth(b.mesh, Vertex(0), TurnLimit(10), target).reason, Reason::Classification);
}

TEST(SmoothTest, AnEndOfACurveStays) {
  Bench b(zoo::grid(2));
  b.mesh.move(Vertex(1), {1.4, 0, 0});
  b.mesh.set_classification(b.edge(0, 1), ModelRef(1, 99));
  glm::dvec3 target;
  EXPECT_EQ(judge_smooth(b.mesh, Vertex(1), TurnLimit(10), target).reason, Reason::Classification);
}

TEST(SmoothTest, GoesOntoTheModel) {
  Bench b(zoo::grid(2));
  const ModelRef face = b.mesh.classification(Vertex(4));
  const AnalyticModel model({{face.tag(), PlaneShape{Frame::around({0, 0, 0.01}, {0, 0, 1})}, {}}});
  glm::dvec3 target;
  ASSERT_TRUE(judge_smooth(b.mesh, Vertex(4), {TurnLimit(10), &model}, target).accepted());
  EXPECT_EQ(target, glm::dvec3(1, 1, 0.01));
}

TEST(SmoothTest, IsRefusedPastTheAngle) {
  MeshData data = zoo::make({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
                            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  data.faces.classes.assign(4, ModelRef(2, 1));
  Bench b(data);
  glm::dvec3 target;
  const Verdict v = judge_smooth(b.mesh, Vertex(4), TurnLimit(10), target);
  EXPECT_EQ(v.reason, Reason::Angle);
  EXPECT_NEAR(v.number(), 45, 1e-9);
}

//        2
//     .  | `  .
//   3----4-------------1     the average of the four lies at 2.25: the faces at 3 get thin
//     `  | .  '
//        0
TEST(SmoothTest, NoFaceGetsAnAngleBelowTheLeast) {
  Bench b(zoo::make({{0, -1, 0}, {10, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0}},
                    {{3, 0, 4}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}));
  glm::dvec3 target;
  const Verdict v = judge_smooth(b.mesh, Vertex(4), {TurnLimit(10), nullptr, 30}, target);
  EXPECT_EQ(v.reason, Reason::Shape);
  EXPECT_EQ(v.entity, EntityRef(Face(0)));
  EXPECT_NEAR(v.number(), std::atan(1 / 2.25) * 180 / M_PI, 1e-9);
  EXPECT_TRUE(judge_smooth(b.mesh, Vertex(4), {TurnLimit(10), nullptr, 5}, target).accepted());
}

TEST(GeometryTest, TurnLimitAgreesWithTheAngle) {
  const glm::dvec3 x(2, 0, 0);
  for (const double limit : {1.0, 10.0, 89.0, 90.0, 91.0, 135.0, 179.0})
    for (const double angle : {0.0, 0.5, 5.0, 45.0, 88.0, 90.5, 120.0, 178.0, 180.0}) {
      const glm::dvec3 y(3 * std::cos(angle * M_PI / 180), 3 * std::sin(angle * M_PI / 180), 0);
      EXPECT_EQ(TurnLimit(limit).allows(x, y), angle <= limit) << limit << ' ' << angle;
    }
  EXPECT_FALSE(TurnLimit(10).allows(x, {0, 0, 0}));
}

TEST(GeometryTest, SmallestAngles) {
  EXPECT_NEAR(smallest_angle_deg({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3) / 2, 0}), 60, 1e-9);
  EXPECT_NEAR(smallest_angle_deg({0, 0, 0}, {1, 0, 0}, {0, std::sqrt(3), 0}), 30, 1e-9);
  EXPECT_NEAR(smallest_angle_deg({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0, 1e-9);
}

}  // namespace
}  // namespace aomd::operators_test
