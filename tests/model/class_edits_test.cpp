// Classification edited by hand: exact on tiny meshes, against a check of the whole mesh, and in
// programs.
#include "core/model/class_edits.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/feature_preview.h"
#include "tests/support/zoo.h"

namespace aomd::class_edits_test {
namespace {

//  6---7---8    Eight triangles, every square cut from its lower left to its upper right corner.
//  | / | / |    All of it is model face 1; the border is four model edges between the corners 0,
//  3---4---5    2, 6, 8, which are model vertices.
//  | / | / |
//  0---1---2
class SquareTest : public testing::Test {
 protected:
  SquareTest() : mesh(zoo::grid(2)) {
    for (const auto& [i, j] : {std::pair{2, 1}, {1, 2}, {0, 1}, {0, 2}}) mesh.set(i, j);
    classify(mesh);
    mesh.attach(&journal);
  }

  EntityRef edge(std::uint32_t a, std::uint32_t b) const {
    return mesh.find_edge(Vertex(a), Vertex(b));
  }
  ModelRef on(EntityRef e) const { return mesh.classification(e); }
  ModelRef on(std::uint32_t vertex) const { return mesh.classification(Vertex(vertex)); }

  ClassVerdict carry_out(const ClassOverlay& classes) {
    const ClassVerdict verdict = judge_classes(classes);
    if (verdict.accepted()) apply_classes(mesh, classes);
    EXPECT_TRUE(verify(mesh).empty());
    return verdict;
  }
  std::vector<EntityRef> middle_line() const { return {edge(3, 4), edge(4, 5)}; }

  Mesh mesh;
  Journal journal;
};

TEST_F(SquareTest, TheMiddleLineBecomesOneModelEdgeBetweenTwoNewModelVertices) {
  const ModelRef left = on(edge(0, 3)), right = on(edge(2, 5));
  ASSERT_TRUE(carry_out(promote(mesh, middle_line())).accepted());
  EXPECT_EQ(on(edge(3, 4)), ModelRef(1, 5));
  EXPECT_EQ(on(edge(4, 5)), ModelRef(1, 5));
  EXPECT_EQ(on(4), ModelRef(1, 5));
  EXPECT_EQ(on(3), ModelRef(0, 5));
  EXPECT_EQ(on(5), ModelRef(0, 6));
  EXPECT_EQ(on(edge(0, 3)), left);  // the border is cut where it now branches: a part keeps the tag
  EXPECT_EQ(on(edge(3, 6)).dimension(), 1);
  EXPECT_NE(on(edge(3, 6)), left);
  EXPECT_EQ(on(edge(2, 5)), right);
  EXPECT_NE(on(edge(5, 8)), right);
  EXPECT_EQ(journal.size(), 1u);  // one step
  for (const Face f : mesh.faces()) EXPECT_EQ(on(f), ModelRef(2, 1));
}

TEST_F(SquareTest, DemotedItIsInsideTheFaceAgain) {
  carry_out(promote(mesh, middle_line()));
  ASSERT_TRUE(carry_out(demote(mesh, middle_line())).accepted());
  EXPECT_EQ(on(edge(3, 4)), ModelRef(2, 1));
  EXPECT_EQ(on(4), ModelRef(2, 1));
  EXPECT_EQ(on(3).dimension(), 0);  // two model edges meet there: it stays, until it is demoted
  const std::vector<EntityRef> ends{Vertex(3), Vertex(5)};
  ASSERT_TRUE(carry_out(demote(mesh, ends)).accepted());
  EXPECT_EQ(on(3), on(edge(0, 3)));
  EXPECT_EQ(on(edge(3, 6)), on(edge(0, 3)));
}

TEST_F(SquareTest, AnEdgeAloneEndsInModelVertices) {
  ASSERT_TRUE(carry_out(promote(mesh, std::vector{edge(3, 4)})).accepted());
  EXPECT_EQ(on(4), ModelRef(0, 6));
  ASSERT_TRUE(carry_out(promote(mesh, std::vector{edge(4, 8)})).accepted());
  EXPECT_EQ(on(4), ModelRef(0, 6));
  ASSERT_TRUE(carry_out(demote(mesh, std::vector{edge(3, 4), edge(4, 8)})).accepted());
  EXPECT_EQ(on(4), ModelRef(2, 1));
}

//  the curve 3-4-7 turns by 90 degrees
TEST_F(SquareTest, ASharpTurnIsAModelVertex) {
  ASSERT_TRUE(carry_out(promote(mesh, std::vector{edge(3, 4), edge(4, 7)})).accepted());
  EXPECT_EQ(on(4).dimension(), 0);
  EXPECT_NE(on(edge(3, 4)), on(edge(4, 7)));
}

TEST_F(SquareTest, TheBorderCannotBeDemoted) {
  const ClassVerdict v = carry_out(demote(mesh, std::vector{edge(0, 1)}));
  EXPECT_EQ(v.rule, ClassRule::Border);
  EXPECT_EQ(v.entity, edge(0, 1));
  EXPECT_EQ(class_words(v),
            "edge " + std::to_string(edge(0, 1).index) +
                " has 1 face and would lie inside model face 1: inside a model face every edge "
                "has two faces");
  EXPECT_EQ(journal.size(), 0u);
}

TEST_F(SquareTest, ACornerCannotBeDemotedWhereThreeModelEdgesMeet) {
  carry_out(promote(mesh, middle_line()));
  const ClassVerdict v = carry_out(demote(mesh, std::vector<EntityRef>{Vertex(3)}));
  EXPECT_EQ(v.rule, ClassRule::Curve);
  EXPECT_EQ(v.entity, EntityRef(Vertex(3)));
  EXPECT_EQ(v.count, 3u);
}

TEST_F(SquareTest, ACornerBetweenTwoModelEdgesJoinsThem) {
  const ModelRef bottom = on(edge(0, 1)), left = on(edge(0, 3));
  ASSERT_NE(bottom, left);
  ASSERT_TRUE(carry_out(demote(mesh, std::vector<EntityRef>{Vertex(0)})).accepted());
  const ModelRef joined = std::min(bottom, left);
  for (const EntityRef e : {edge(0, 1), edge(1, 2), edge(0, 3), edge(3, 6)})
    EXPECT_EQ(on(e), joined);
  for (const std::uint32_t v : {0u, 1u, 3u}) EXPECT_EQ(on(v), joined);
}

TEST_F(SquareTest, TheFaceSplitsAlongTheLine) {
  carry_out(promote(mesh, middle_line()));
  ASSERT_TRUE(carry_out(split_face(mesh, ModelRef(2, 1))).accepted());
  std::map<ModelRef, int> faces;
  for (const Face f : mesh.faces()) ++faces[on(f)];
  EXPECT_EQ(faces, (std::map<ModelRef, int>{{ModelRef(2, 1), 4}, {ModelRef(2, 2), 4}}));
  EXPECT_EQ(on(edge(0, 4)), ModelRef(2, 1));
  EXPECT_EQ(on(edge(3, 7)), ModelRef(2, 2));
  // Now demoting the line would leave an edge on one face that bounds the other.
  EXPECT_EQ(carry_out(demote(mesh, middle_line())).rule, ClassRule::Closure);
  EXPECT_EQ(carry_out(split_face(mesh, ModelRef(2, 1))).rule, ClassRule::Nothing);
}

TEST_F(SquareTest, FacesPutOnAnotherNeedModelEdgesAroundThem) {
  const std::vector<EntityRef> lower{Face(0), Face(1), Face(2), Face(3)};
  const ClassVerdict v = carry_out(assign(mesh, lower, ModelRef(2, 7)));
  EXPECT_EQ(v.rule, ClassRule::Closure);
  EXPECT_EQ(v.entity.dimension, 1);  // an edge on face 1 would bound a face on face 7
  EXPECT_EQ(v.other_model, ModelRef(2, 7));
  ASSERT_TRUE(carry_out(assign(mesh, lower, ModelRef(2, 7), true)).accepted());
  EXPECT_EQ(on(edge(3, 4)), ModelRef(1, 5));
  EXPECT_EQ(on(edge(0, 4)), ModelRef(2, 7));
  EXPECT_EQ(on(Face(0)), ModelRef(2, 7));
  EXPECT_EQ(on(Face(4)), ModelRef(2, 1));
}

TEST_F(SquareTest, DimensionAndPointAreRules) {
  EXPECT_EQ(carry_out(assign(mesh, std::vector<EntityRef>{Face(0)}, ModelRef(1, 1))).rule,
            ClassRule::Dimension);
  const ClassVerdict v = carry_out(assign(mesh, std::vector<EntityRef>{Vertex(4)}, on(0)));
  EXPECT_EQ(v.rule, ClassRule::Point);
  EXPECT_EQ(v.other, EntityRef(Vertex(0)));
}

// Paper, figure 4: an edge between vertices on model edges may lie on a model edge or across the
// face.
TEST_F(SquareTest, Figure4CanBeDecidedEitherWayByHand) {
  const EntityRef across = edge(1, 5);
  ASSERT_EQ(on(1).dimension(), 1);
  ASSERT_EQ(on(5).dimension(), 1);
  ASSERT_EQ(on(across), ModelRef(2, 1));
  ASSERT_TRUE(carry_out(assign(mesh, std::vector{across}, ModelRef(1, 42))).accepted());
  EXPECT_EQ(on(across), ModelRef(1, 42));
  EXPECT_EQ(on(1).dimension(), 0);
  journal.seek(mesh, 0);
  EXPECT_EQ(on(across), ModelRef(2, 1));
  EXPECT_EQ(on(1).dimension(), 1);
}

TEST_F(SquareTest, TagsGoOnAboveThoseOfTheMeshAndItsTable) {
  EXPECT_EQ(free_tag(mesh, 2), 2);
  EXPECT_EQ(free_tag(mesh, 1), 5);
  mesh.keep_class_lists(true);
  EXPECT_EQ(free_tag(mesh, 1), 5);
  EXPECT_EQ(free_tag(mesh, 3), 1);
}

TEST(FeaturePreviewTest, CountsWhatClassifyingMakes) {
  for (const MeshData& data : {zoo::tetrahedron(), zoo::octahedron(), zoo::book(), zoo::bow_tie(),
                               zoo::grid(3), zoo::torus(9, 7), zoo::torus(24, 18)})
    for (const double angle : {2.0, 12.0, 30.0, 60.0, 120.0}) {
      Mesh mesh(data);
      for (const auto& [i, j] : {std::pair{2, 1}, {1, 2}, {0, 1}}) mesh.set(i, j);
      classify(mesh, {.feature_angle_deg = 5.0,
                      .corner_angle_deg = 60,
                      .nonmanifold_edges = true,
                      .keep_present = true});
      ClassifyOptions options;
      options.feature_angle_deg = angle;
      options.keep_present = false;
      const FeaturePreview preview = preview_features(mesh, options);
      const ClassifyResult made = classify(mesh, options);
      EXPECT_EQ(preview.model_edges, made.model_edges) << angle;
      EXPECT_EQ(preview.model_vertices, made.model_vertices) << angle;
      EXPECT_EQ(preview.edges.size(), made.features.borders + made.features.sharp) << angle;
    }
}

/// The rules as they are written down, asked of everything.
bool sound(const ClassOverlay& c) {
  const Mesh& mesh = c.mesh();
  std::map<std::uint32_t, int> points;
  const auto below = [&](EntityRef low, EntityRef high) {
    const ModelRef a = c.of(low), b = c.of(high);
    return a.dimension() < b.dimension() || a == b;
  };
  for (const Face f : mesh.faces()) {
    if (c.of(f).dimension() < 2) return false;
    for (const Edge e : mesh.row<1>(f))
      if (!below(e, f)) return false;
    for (const Vertex v : mesh.row<0>(f))
      if (!below(v, f)) return false;
  }
  for (const Edge e : mesh.edges()) {
    if (c.of(e).dimension() < 1) return false;
    for (const Vertex v : mesh.edge_vertices(e))
      if (!below(v, e)) return false;
    if (c.of(e).dimension() == 2 && mesh.row<2>(e).size() != 2) return false;
  }
  for (const Vertex v : mesh.vertices()) {
    if (c.of(v).dimension() == 0 && ++points[c.of(v).bits()] > 1) return false;
    int curves = 0;
    for (const Edge e : mesh.row<1>(v)) curves += c.of(e).dimension() == 1;
    if (c.of(v).dimension() == 1 && curves != 2) return false;
  }
  return true;
}

class ClassProgram {
 public:
  ClassProgram(const MeshData& data, unsigned seed) : random_(seed), mesh_(data) {
    for (const auto& [i, j] : {std::pair{2, 1}, {1, 2}, {0, 1}, {0, 2}}) mesh_.set(i, j);
    classify(mesh_);
    mesh_.keep_class_lists(seed % 2 == 0);
    mesh_.attach(&journal_);
  }

  std::uint32_t below(std::uint32_t n) {
    return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random_);
  }
  EntityRef any(int dim) { return {dim, below(mesh_.count(dim))}; }

  std::vector<EntityRef> some() {
    std::vector<EntityRef> result;
    const int dim = static_cast<int>(below(3));
    for (std::uint32_t n = 1 + below(4); n > 0; --n) result.push_back(any(dim));
    if (dim == 1 && below(2) == 0) {  // a path
      Vertex v = mesh_.edge_vertices(Edge(result[0].index))[0];
      for (int i = 0; i < 5; ++i) {
        const auto edges = mesh_.row<1>(v);
        const Edge e = edges[below(static_cast<std::uint32_t>(edges.size()))];
        result.push_back(e);
        v = mesh_.other_end(e, v);
      }
    }
    return result;
  }

  ClassOverlay edit() {
    switch (below(6)) {
      case 0:
        return demote(mesh_, some());
      case 1:
        return assign(mesh_, some(),
                      ModelRef(static_cast<int>(below(3)), 1 + static_cast<int>(below(9))),
                      below(2) == 0);
      case 2:
        return split_face(mesh_, mesh_.classification(any(2)));
      case 3: {
        ClassOverlay few(mesh_);
        for (std::uint32_t n = 1 + below(3); n > 0; --n)
          few.set(any(static_cast<int>(below(3))),
                  ModelRef(static_cast<int>(below(3)), 1 + static_cast<int>(below(4))));
        return few;
      }
      default:
        return promote(mesh_, some());
    }
  }

  void step() {
    const ClassOverlay classes = edit();
    const ClassVerdict verdict = judge_classes(classes);
    if (verdict.rule == ClassRule::Nothing) return;
    ASSERT_EQ(verdict.accepted(), sound(classes)) << class_words(verdict);
    ++(verdict.accepted() ? accepted : refused);
    if (verdict.accepted()) apply_classes(mesh_, classes);
    ASSERT_TRUE(verify(mesh_).empty());
    if (below(8) == 0) journal_.seek(mesh_, below(static_cast<std::uint32_t>(journal_.size()) + 1));
  }

  [[nodiscard]] std::vector<ModelRef> classes() const {
    std::vector<ModelRef> all;
    for (int dim = 0; dim < 3; ++dim)
      for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
        all.push_back(mesh_.classification({dim, id}));
    return all;
  }
  void undo_all() { journal_.seek(mesh_, 0); }

  int accepted = 0, refused = 0;

 private:
  std::mt19937 random_;
  Mesh mesh_;
  Journal journal_;
};

TEST(ClassProgramTest, WhatIsAcceptedIsSoundAndWhatIsRefusedIsNot) {
  int accepted = 0, refused = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    ClassProgram program(seed % 3 == 0   ? zoo::grid(4)
                         : seed % 3 == 1 ? zoo::octahedron()
                                         : zoo::torus(7, 6),
                         seed);
    const auto start = program.classes();
    for (int i = 0; i < 120; ++i)
      ASSERT_NO_FATAL_FAILURE(program.step()) << "seed " << seed << " step " << i;
    program.undo_all();
    EXPECT_EQ(program.classes(), start);
    accepted += program.accepted;
    refused += program.refused;
  }
  EXPECT_GT(accepted, 400);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace aomd::class_edits_test
