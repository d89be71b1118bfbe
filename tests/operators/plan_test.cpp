// A plan is a value: it may be kept, others judged in between, and it holds as long as the mesh is
// what was judged.

#include <gtest/gtest.h>

#include "core/mesh/journal.h"
#include "core/model/classify.h"
#include "core/operators/collapse.h"
#include "core/operators/smooth.h"
#include "tests/support/zoo.h"

namespace aomd::plan_test {
namespace {

struct Bench {
  explicit Bench(const MeshData& data) : mesh(data), collapser((prepare(mesh), mesh)) {}
  static void prepare(Mesh& mesh) {
    classify(mesh);
    mesh.set(0, 1), mesh.set(0, 2);
  }
  Edge edge(std::uint32_t a, std::uint32_t b) const { return mesh.find_edge(Vertex(a), Vertex(b)); }
  bool judge(std::uint32_t deleted, std::uint32_t kept, CollapsePlan& plan) {
    return collapser.judge(mesh, edge(deleted, kept), Vertex(deleted), {}, plan).accepted();
  }
  Mesh mesh;
  Collapser collapser;
};

// 12-13-14-15
//  8--9-10-11      5 6 9 10 are inside
//  4--5--6--7
//  0--1--2--3
TEST(PlanTest, OthersMayBeJudgedBeforeItIsMade) {
  Bench kept(zoo::grid(3)), direct(zoo::grid(3));
  CollapsePlan first, other;
  ASSERT_TRUE(kept.judge(5, 6, first));
  EXPECT_TRUE(kept.judge(10, 9, other));
  EXPECT_FALSE(kept.judge(0, 1, other));
  kept.collapser.apply(kept.mesh, first);
  direct.collapser.apply(direct.mesh, direct.edge(5, 6), Vertex(5));
  EXPECT_EQ(zoo::fingerprint(kept.mesh), zoo::fingerprint(direct.mesh));
}

TEST(PlanTest, ItSaysWhatGoesWhereAndWhatLiesAround) {
  Bench b(zoo::grid(3));
  CollapsePlan plan;
  const Edge e = b.edge(5, 6);
  const bool second_is_6 = b.mesh.edge_vertices(e)[1] == Vertex(6);
  ASSERT_TRUE(b.collapser.judge(b.mesh, e, {!second_is_6, second_is_6}, {}, plan).accepted());
  EXPECT_EQ(plan.contraction.deleted, Vertex(6));
  EXPECT_EQ(plan.contraction.kept, Vertex(5));
  EXPECT_EQ(plan.contraction.position, b.mesh.position(Vertex(5)));
  EXPECT_EQ(plan.edge, e);
  ASSERT_EQ(plan.around_deleted().size(), b.mesh.row<2>(Vertex(6)).size());
  ASSERT_EQ(plan.around_kept().size(), b.mesh.row<2>(Vertex(5)).size());
  EXPECT_EQ(plan.around_deleted()[0].face, b.mesh.row<2>(Vertex(6))[0]);
  EXPECT_EQ(plan.around_kept()[0].face, b.mesh.row<2>(Vertex(5))[0]);
}

using PlanDeathTest = testing::Test;

TEST(PlanDeathTest, OfAnotherMeshOrARefusalItIsNotMade) {
  Bench b(zoo::grid(3));
  CollapsePlan plan;
  ASSERT_FALSE(b.judge(0, 1, plan));
  EXPECT_DEATH(b.collapser.apply(b.mesh, plan), "accepted");
  ASSERT_TRUE(b.judge(5, 6, plan));
  apply_smooth(b.mesh, Vertex(15), {3, 3, 1});
  EXPECT_DEATH(b.collapser.apply(b.mesh, plan), "revision");
}

// Each kind of edit, and the way back and forth.
TEST(PlanTest, EveryEditMakesANewRevision) {
  Bench b(zoo::grid(3));
  Mesh& mesh = b.mesh;
  Journal journal;
  mesh.attach(&journal);
  std::uint64_t last = mesh.revision();
  const auto changed = [&] { return std::exchange(last, mesh.revision()) != mesh.revision(); };
  EXPECT_FALSE(changed());
  const Vertex v = mesh.create_vertex({9, 9, 9});
  EXPECT_TRUE(changed()) << "creation";
  mesh.move(v, {9, 9, 8});
  EXPECT_TRUE(changed()) << "move";
  mesh.set_classification(v, ModelRef(0, 77));
  EXPECT_TRUE(changed()) << "classification";
  mesh.destroy(v);
  EXPECT_TRUE(changed()) << "deletion";
  const auto t = mesh.triangle(Face(0));
  const Vertex w = mesh.create_vertex({0, 0, 1});
  changed();
  const Rebinding rebinding{Face(0), 0, t[0], w};
  mesh.rebind({&rebinding, 1});
  EXPECT_TRUE(changed()) << "rebinding";
  journal.undo(mesh);
  EXPECT_TRUE(changed()) << "undo";
  journal.redo(mesh);
  EXPECT_TRUE(changed()) << "redo";
  journal.seek(mesh, 0);
  EXPECT_TRUE(changed()) << "seeking";
  mesh.set(1, 2);
  EXPECT_FALSE(changed()) << "what T stores is no edit";
}

}  // namespace
}  // namespace aomd::plan_test
