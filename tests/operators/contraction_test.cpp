// Contractions and swaps by vertex pair: exact answers on drawn meshes, and the same answers
// whether the edges inside model faces are entities or not.

#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "core/decimate/decimation.h"
#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/operators/collapse.h"
#include "tests/support/pair_bench.h"

namespace aomd::contraction_test {
namespace {

using namespace test;

struct Bench : PairBench {
  using PairBench::PairBench;
  Verdict judge(std::uint32_t deleted, std::uint32_t kept, std::optional<glm::dvec3> at = {},
                const CollapseRules& rules = {}) {
    Collapser collapser(mesh);
    CollapsePlan plan;
    return collapser.judge(
        mesh, Contraction{Vertex(deleted), Vertex(kept), at ? *at : mesh.position(Vertex(kept))},
        rules, plan);
  }
  void contract(std::uint32_t deleted, std::uint32_t kept, const glm::dvec3& at,
                const CollapseRules& rules) {
    Collapser collapser(mesh);
    const Contraction c{Vertex(deleted), Vertex(kept), at};
    CollapsePlan plan;
    ASSERT_TRUE(collapser.judge(mesh, c, rules, plan).accepted());
    collapser.apply(mesh, plan);
    EXPECT_TRUE(verify(mesh).empty());
  }
};

const CollapseRules any_turn{.max_turn = TurnLimit(179)};
const CollapseRules any_turn_paper{.max_turn = TurnLimit(179), .topology = TopologyRule::Paper};

// 12-13-14-15      corners 0 3 12 15 are model vertices, the border is four model edges, 5 6 9 10
//  8--9-10-11      are inside. Diagonals run from lower left to upper right: 0-5, 2-7, ...
//  4--5--6--7
//  0--1--2--3
TEST(ContractionTest, ClassificationOfTheDeletedEnd) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    EXPECT_EQ(b.judge(0, 1).reason, Reason::Classification) << name(edges);  // a model vertex stays
    EXPECT_EQ(b.judge(0, 1).entity, EntityRef(Vertex(0)));
    EXPECT_EQ(b.judge(1, 5).reason, Reason::Classification);  // off its model edge
    EXPECT_EQ(b.judge(2, 7).reason,
              Reason::Classification);              // from one model edge to another, inside
    EXPECT_EQ(b.judge(1, 0).reason, Reason::None);  // along its model edge
    EXPECT_EQ(b.judge(5, 6).reason, Reason::None);  // inside the model face
    EXPECT_EQ(b.judge(5, 1).reason, Reason::None);  // onto the border
    EXPECT_EQ(b.judge(5, 0).reason, Reason::None);  // onto a model vertex
  }
}

TEST(ContractionTest, ClassificationOfTheKeptEndWhereItMoves) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    EXPECT_EQ(b.judge(5, 6, glm::dvec3(1.5, 1, 0)).reason, Reason::None) << name(edges);
    EXPECT_EQ(b.judge(1, 2, glm::dvec3(1.5, 0, 0)).reason, Reason::None);
    const Verdict border = b.judge(5, 1, glm::dvec3(1, 0.5, 0));
    EXPECT_EQ(border.reason, Reason::Classification);
    EXPECT_EQ(border.entity, EntityRef(Vertex(1)));
    const Verdict corner = b.judge(1, 0, glm::dvec3(0.5, 0, 0));
    EXPECT_EQ(corner.reason, Reason::Classification);
    EXPECT_EQ(corner.entity, EntityRef(Vertex(0)));
  }
}

// 3--2     all four vertices and the border lie on one closed model edge: the diagonal does not
// | /|
// 0--1
TEST(ContractionTest, AChordBetweenTwoPlacesOfOneModelEdgeIsRefused) {
  for (const Edges edges : both) {
    Bench b(zoo::square());
    b.on(ModelRef(1, 7), {0u, 1u, 2u, 3u});
    b.on(ModelRef(1, 7), {Ends{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    b.ready(edges);
    const Verdict v = b.judge(0, 2, {}, any_turn_paper);
    EXPECT_EQ(v.reason, Reason::Classification) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(Vertex(0)));
  }
}

// Vertex 1 on one model edge, 2 on another; the edge between lies on that of 1.
TEST(ContractionTest, AModelEdgeOfAnotherTagIsNotLeft) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    const ModelRef first(1, 71), second(1, 72);
    b.on(first, {1u});
    b.on(second, {2u});
    b.on(first, {Ends{0, 1}, {1, 2}});
    b.on(second, {Ends{2, 3}});
    b.ready(edges);
    EXPECT_EQ(b.judge(1, 2).reason, Reason::None) << name(edges);
    EXPECT_EQ(b.judge(2, 1).reason, Reason::Classification);
    EXPECT_EQ(b.judge(1, 2, glm::dvec3(1.5, 0, 0)).reason, Reason::Classification)
        << "2 may not move";
  }
}

TEST(ContractionTest, TheLinkConditionKeepsATetrahedronAndAPocket) {
  for (const Edges edges : both) {
    Bench tetrahedron(on_one_face(zoo::tetrahedron()));
    tetrahedron.on(ModelRef(2, 1), {0u, 1u, 2u, 3u});
    for (const Edge e : tetrahedron.mesh.edges())
      tetrahedron.mesh.set_classification(e, ModelRef(2, 1));
    tetrahedron.ready(edges);
    EXPECT_EQ(tetrahedron.judge(0, 1, {}, any_turn).reason, Reason::Topology) << name(edges);
    MeshData data = zoo::grid(3);
    data.faces.add(Shape::Triangle, {5, 6, 10});
    Bench pocket(on_one_face(data));
    for (const Vertex v : pocket.mesh.vertices()) pocket.mesh.set_classification(v, ModelRef(2, 1));
    for (const Edge e : pocket.mesh.edges()) pocket.mesh.set_classification(e, ModelRef(2, 1));
    pocket.ready(edges);
    EXPECT_EQ(pocket.judge(5, 6, {}, any_turn).reason, Reason::Topology) << name(edges);
    EXPECT_EQ(pocket.judge(5, 6, {}, any_turn_paper).reason, Reason::None) << name(edges);
  }
}

// 3--4--5   the inner edge 1-4 joins two places of the boundary; nothing is classified
// | /| /|
// |/ |/ |
// 0--1--2
TEST(ContractionTest, TheLinkConditionKeepsAStripWide) {
  for (const bool all : {true, false}) {
    Mesh mesh(zoo::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                        {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}));
    if (all) mesh.set(0, 1);
    mesh.set(0, 2);
    Collapser collapser(mesh);
    const Contraction c{Vertex(1), Vertex(4), {1, 0.5, 0}};
    CollapsePlan plan;
    EXPECT_EQ(collapser.judge(mesh, c, any_turn, plan).reason, Reason::Topology) << all;
    EXPECT_TRUE(collapser.judge(mesh, c, any_turn_paper, plan).accepted()) << all;
  }
}

//     4
//    /|\        4 onto 1 would lay the face (2, 3, 4) into the line 1-2-3, unless 1 moves up on
//   / | \ \     its way
//  0--1--2--3
//   \ | / /
//     5
TEST(ContractionTest, AFlatFaceIsRefusedAndThePlaceDecides) {
  for (const Edges edges : both) {
    Bench b(
        on_one_face(zoo::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}, {2, -1, 0}},
                              {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 5, 1}, {1, 5, 2}, {2, 5, 3}})));
    for (const Vertex v : b.mesh.vertices()) b.mesh.set_classification(v, ModelRef(2, 1));
    for (const Edge e : b.mesh.edges()) b.mesh.set_classification(e, ModelRef(2, 1));
    b.ready(edges);
    const CollapseRules rules{.topology = TopologyRule::Paper};
    const Verdict v = b.judge(4, 1, {}, rules);
    EXPECT_EQ(v.reason, Reason::Flat) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(Face(2)));
    EXPECT_EQ(b.judge(4, 1, glm::dvec3(1, 0.25, 0), rules).reason, Reason::None) << name(edges);
  }
}

// The apex of a pyramid of height 1 on a square of side 2 goes to a corner: the far faces turn by
// 45 degrees.
TEST(ContractionTest, AnAngleRefusalCarriesTheAngleAndTheFace) {
  for (const Edges edges : both) {
    Bench b(on_one_face(zoo::make({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}},
                                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}})));
    b.ready(edges);
    const Verdict v = b.judge(4, 0);
    EXPECT_EQ(v.reason, Reason::Angle) << name(edges);
    EXPECT_NEAR(v.number(), 45, 1e-9);
    EXPECT_EQ(v.entity, EntityRef(Face(1)));
    EXPECT_EQ(b.judge(4, 0, {}, {.max_turn = TurnLimit(46)}).reason, Reason::None);
  }
}

// 5 and 6 of the grid meet right of 7: what 5 leaves behind still faces up, but the face 2-7-6
// (number 5) of the kept end turns over.
TEST(ContractionTest, TheFacesOfTheKeptEndAreJudgedWhereItMoves) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    const Verdict v = b.judge(5, 6, glm::dvec3(3.5, 1, 0));
    EXPECT_EQ(v.reason, Reason::Angle) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(Face(5)));
    EXPECT_NEAR(v.number(), 180, 1e-9);
    const Verdict onto = b.judge(5, 6, glm::dvec3(3, 1, 0));
    EXPECT_EQ(onto.reason, Reason::Flat) << "the place of 7";
  }
}

// 5 onto 6 stretches the face 0-1-5 to 0-1-6, whose least angle is 45 - atan(1/2) degrees.
TEST(ContractionTest, NoFaceGetsAnAngleBelowTheLeast) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    const double least = 45 - std::atan(0.5) * 180 / M_PI;
    const Verdict v = b.judge(5, 6, {}, {.least_angle = LeastAngle(least + 1e-6)});
    EXPECT_EQ(v.reason, Reason::Shape) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(Face(0)));
    EXPECT_NEAR(v.number(), least, 1e-9);
    EXPECT_EQ(b.judge(5, 6, {}, {.least_angle = LeastAngle(least - 1e-6)}).reason, Reason::None);
  }
}

TEST(ContractionTest, AFaceThatHadASmallerAngleMayKeepIt) {
  Bench b(zoo::grid(3));
  b.ready(Edges::OnModelEdges);
  b.mesh.move(Vertex(5), {1, 0.05, 0});  // 0-1-5 has an angle below 3 degrees now
  EXPECT_EQ(b.judge(5, 6, {}, {.least_angle = LeastAngle(19)}).reason, Reason::None);
}

// 0-1-5 is a sliver that 5 takes along: 0-1-6 is better, and may be as poor as any face around 5
// was.
TEST(ContractionTest, WhereASliverWasAnotherMayBe) {
  Bench b(zoo::grid(3));
  b.ready(Edges::OnModelEdges);
  const CollapseRules around{.least_around = LeastAngle(19)};
  EXPECT_EQ(b.judge(5, 6, {}, around).reason, Reason::Shape) << "no face around 5 is poor";
  b.mesh.move(Vertex(1), {0.05, 0, 0});  // 0-1-5 gets thin; 0-1-6 would be thinner still
  EXPECT_EQ(b.judge(5, 6, {}, around).reason, Reason::Shape);
  b.mesh.move(Vertex(1), {1, 0, 0});
  b.mesh.move(Vertex(10), {1, 1.05, 0});  // a thin face at 5, away from 0-1-5
  EXPECT_EQ(b.judge(5, 6, {}, around).reason, Reason::None);
  EXPECT_EQ(b.judge(5, 6, {}, {.least_angle = LeastAngle(19)}).reason, Reason::Shape)
      << "face by face";
}

// The border 0-1-2-3 of the grid as a curve: where 1 and 2 meet, its pieces to 0 and to 3 both
// turn.
TEST(ContractionTest, AModelEdgeMayNotTurnTooFarOnTheDeletedSide) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    const glm::dvec3 down(1, -2, 0);  // seen from 0: 63 degrees below the old direction
    const Verdict v = b.judge(1, 2, down);
    EXPECT_EQ(v.reason, Reason::Angle) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(b.edge(0, 1)));
    EXPECT_NEAR(v.number(), std::atan(2) * 180 / M_PI, 1e-9);
    CollapseRules rules{.topology = TopologyRule::Paper};
    EXPECT_TRUE(b.judge(1, 2, down, rules).accepted()) << "the paper has no such rule";
  }
}

TEST(ContractionTest, AModelEdgeMayNotTurnTooFarOnTheKeptSide) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    const Verdict v =
        b.judge(1, 2, glm::dvec3(2.9, -0.5, 0));  // seen from there 3 lies at 79 degrees
    EXPECT_EQ(v.reason, Reason::Angle) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(b.edge(2, 3)));
  }
}

// 5 and 6 meet in the middle: the two faces between them go, four are stretched, none is created.
TEST(ContractionTest, TheResultIsExact) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    b.contract(5, 6, {1.5, 1, 0}, {});
    EXPECT_FALSE(b.mesh.alive(Vertex(5)));
    EXPECT_EQ(b.mesh.position(Vertex(6)), glm::dvec3(1.5, 1, 0));
    EXPECT_EQ(b.mesh.count(0), 15u);
    EXPECT_EQ(b.mesh.count(1), edges == Edges::All ? 30u : 12u);
    EXPECT_EQ(b.mesh.count(2), 16u);
    EXPECT_EQ(b.mesh.capacity(2), 18u);
    EXPECT_EQ(b.mesh.triangle(Face(0)), (std::array{Vertex(0), Vertex(1), Vertex(6)}));
    EXPECT_FALSE(b.mesh.alive(Face(3)));  // 1-6-5
    EXPECT_FALSE(b.mesh.alive(Face(8)));  // 5-6-10
    EXPECT_EQ(zoo::euler(b.mesh), 1);
  }
}

// A curve 1-5-9 goes through the sheet; with 5 onto 6, 5-1 falls onto 6-1 and 5-9 becomes 6-9: the
// curve goes on.
TEST(ContractionTest, AModelEdgeFallsOntoAPlainOne) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    const ModelRef curve(1, 77);
    b.on(curve, {5u, 6u, 9u});
    b.on(curve, {Ends{1, 5}, {5, 6}, {5, 9}});
    b.ready(edges);
    b.contract(5, 6, {2, 1, 0}, {.max_curve_turn = TurnLimit(180)});
    for (const std::uint32_t far : {1u, 9u}) {
      ASSERT_TRUE(b.edge(6, far).valid()) << name(edges) << ' ' << far;
      EXPECT_EQ(b.mesh.classification(b.edge(6, far)), curve);
    }
  }
}

TEST(ContractionTest, OneJournalStepWhateverItDoes) {
  for (const Edges edges : both) {
    Bench b(zoo::grid(3));
    b.ready(edges);
    const std::string start = zoo::fingerprint(b.mesh);
    Journal journal;
    b.mesh.attach(&journal);
    b.contract(5, 6, {1.5, 1, 0}, {});
    ASSERT_EQ(journal.size(), 1u) << name(edges);
    EXPECT_EQ(journal.step(0).kind, StepKind::Collapse);
    EXPECT_EQ(journal.step(0).entity, EntityRef(Vertex(6)));
    journal.undo(b.mesh);
    EXPECT_EQ(zoo::fingerprint(b.mesh), start);
    EXPECT_TRUE(verify(b.mesh).empty());
  }
}

// Without the link condition a lone triangle folds away, and its edges with it.
TEST(ContractionTest, ALoneTriangleFoldsAwayWithItsEdges) {
  for (const Edges edges : both) {
    Bench b(zoo::triangle());
    b.on(ModelRef(1, 1), {0u, 1u, 2u});
    b.on(ModelRef(1, 1), {Ends{0, 1}, {1, 2}, {2, 0}});
    b.ready(edges);
    EXPECT_EQ(b.judge(0, 1, {}, any_turn).reason, Reason::Topology) << name(edges);
    b.contract(0, 1, b.mesh.position(Vertex(1)), any_turn_paper);
    EXPECT_EQ(b.mesh.count(2), 0u);
    EXPECT_EQ(b.mesh.count(1), 0u);
    EXPECT_EQ(b.mesh.count(0), 2u);
  }
}

// Only one of the two edges that fall together is an entity, and no face is left beside them.
TEST(ContractionTest, AnEdgeThatLosesItsLastFaceGoesWhicheverWasAnEntity) {
  for (const Ends& model : {Ends{0, 2}, {1, 2}}) {
    std::map<Edges, std::uint32_t> left;
    for (const Edges edges : both) {
      Bench b(on_one_face(zoo::triangle()));
      for (const Edge e : b.mesh.edges()) b.mesh.set_classification(e, ModelRef(2, 1));
      b.on(ModelRef(1, 1), {0u, 1u, 2u});
      b.on(ModelRef(1, 1), {model, Ends{0, 1}});
      b.ready(edges);
      b.contract(0, 1, b.mesh.position(Vertex(1)), any_turn_paper);
      left[edges] = b.mesh.count(1);
    }
    EXPECT_EQ(left[Edges::All], 0u);
    EXPECT_EQ(left[Edges::OnModelEdges], 0u) << model.first << '-' << model.second;
  }
}

// A curve 6-5-16 leaves the sheet at 5: its piece 5-16 has no face, and goes on from 6 when 5 has
// gone there. Only T(0,1) can find it, so a decimation asks for that.
TEST(ContractionTest, AModelEdgeWithoutFacesFollows) {
  MeshData data = zoo::grid(3);
  data.positions.emplace_back(1, 1, 5);
  data.edges.add(Shape::Line, {5, 16}, ModelRef(1, 50));
  Bench b(on_one_face(data));
  b.on(ModelRef(1, 50), {5u, 6u});
  b.on(ModelRef(1, 50), {Ends{5, 6}});
  b.ready(Edges::All);
  ASSERT_TRUE(b.edge(5, 16).valid());
  b.contract(5, 6, b.mesh.position(Vertex(6)), {.max_curve_turn = TurnLimit(180)});
  EXPECT_TRUE(b.edge(6, 16).valid());
  Mesh listed(data);
  const Decimation decimation(listed, {.strategy = Strategy::Quality});
  EXPECT_TRUE(listed.stored(0, 1));
}

// Classes of edges alone: a file may list model edges and say nothing of their vertices.
TEST(ContractionTest, AModelEdgeBetweenUnclassifiedVerticesFollows) {
  MeshData data = zoo::grid(3);
  data.edges.add(Shape::Line, {5, 9}, ModelRef(1, 50));
  for (const bool all : {true, false}) {
    Mesh mesh(data);
    if (all) mesh.set(0, 1);
    mesh.set(0, 2);
    Collapser collapser(mesh);
    const Contraction c{Vertex(5), Vertex(6), mesh.position(Vertex(6))};
    CollapsePlan plan;
    ASSERT_TRUE(collapser.judge(mesh, c, any_turn, plan).accepted());
    collapser.apply(mesh, plan);
    EXPECT_TRUE(verify(mesh).empty()) << all;
    EXPECT_TRUE(mesh.find_edge(Vertex(6), Vertex(9)).valid()) << all;
  }
}

}  // namespace
}  // namespace aomd::contraction_test
