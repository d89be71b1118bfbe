// Faults planted one at a time, and found by name and entity.

#include "core/mesh/verify.h"

#include <gtest/gtest.h>

#include "core/model/classify.h"
#include "zoo.h"

namespace aomd {
namespace {

bool found(const std::vector<Finding>& findings, const std::string& name, EntityRef e) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Finding& f) { return f.name == name && f.entity == e; });
}

Mesh full(const MeshData& data) {
  Mesh mesh(data);
  for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {1, 2}, {2, 1}}) mesh.set(i, j);
  return mesh;
}

// The rows of a mesh, to be spoilt: what no edit of Mesh would do.
Representation& rows_of(Mesh& mesh) { return const_cast<Representation&>(mesh.representation()); }

TEST(VerifyTest, FindsNothingWrongInTheZoo) {
  for (const zoo::Animal& animal : zoo::all()) {
    Mesh mesh = full(animal.data);
    EXPECT_TRUE(verify(mesh).empty()) << animal.name;
    classify(mesh);
    EXPECT_TRUE(verify(mesh).empty()) << animal.name;
  }
}

TEST(VerifyTest, UpwardListThatMissesAFace) {
  Mesh mesh = full(zoo::octahedron());
  rows_of(mesh).up(0, 2).erase(4, 2);
  EXPECT_TRUE(found(verify(mesh), "upward list", Vertex(4)));
  EXPECT_EQ(verify(mesh).size(), 1u);
}

TEST(VerifyTest, WrongSideAndWrongUseDirection) {
  Mesh mesh = full(zoo::octahedron());
  DownRows& sides = rows_of(mesh).down(2, 1);
  sides.set_directions(3, static_cast<std::uint16_t>(sides.directions(3) ^ 2u));
  EXPECT_TRUE(found(verify(mesh), "wrong use direction", Face(3)));
  sides.row(5)[0] = sides.row(6)[1];
  EXPECT_TRUE(found(verify(mesh), "wrong side", Face(5)));
}

TEST(VerifyTest, DeadReferenceAndRepeatedVertex) {
  Mesh mesh(zoo::square());
  rows_of(mesh).down(2, 0).row(1)[2] = 17;
  EXPECT_TRUE(found(verify(mesh), "dead reference", Face(1)));
  rows_of(mesh).down(2, 0).row(1)[2] = 0;
  EXPECT_TRUE(found(verify(mesh), "repeated vertex", Face(1)));
}

TEST(VerifyTest, DuplicateAndMissingEdge) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  std::copy_n(rows_of(mesh).down(1, 0).row(0), 2, rows_of(mesh).down(1, 0).row(4));
  EXPECT_TRUE(found(verify(mesh), "duplicate edge", Edge(4)));
  Mesh bare(zoo::square());
  bare.set(1, 0);
  bare.destroy_unused(Edge(0));
  EXPECT_TRUE(found(verify(bare), "missing edge", Face(0)));
}

TEST(VerifyTest, HashSetThatPointsNowhere) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  ASSERT_TRUE(mesh.find_edge(Vertex(0), Vertex(1)).valid());
  const_cast<EntityHash&>(mesh.hash(1)).erase(2);
  EXPECT_TRUE(found(verify(mesh), "hash set", Edge(2)));
}

TEST(VerifyTest, ClassificationThatBreaksTheClosure) {
  Mesh mesh = full(zoo::square());
  mesh.set_classification(Edge(0), ModelRef(1, 1));
  mesh.set_classification(Vertex(0), ModelRef(2, 1));  // bounds an edge on a model edge
  EXPECT_TRUE(found(verify(mesh), "classification closure", Vertex(0)));
}

TEST(VerifyTest, CoordinateThatIsNoNumber) {
  Mesh mesh(zoo::square());
  mesh.move(Vertex(3), {0, std::nan(""), 0});
  EXPECT_TRUE(found(verify(mesh), "not finite", Vertex(3)));
}

TEST(VerifyTest, LeakInTheIdStack) {
  Mesh mesh(zoo::square());
  mesh.destroy(Face(0));
  const_cast<std::vector<std::uint32_t>&>(mesh.ids(2).free_ids()).push_back(1);
  EXPECT_TRUE(found(verify(mesh), "id stack", Face(1)));
  const_cast<std::vector<std::uint32_t>&>(mesh.ids(2).free_ids()).clear();
  EXPECT_TRUE(found(verify(mesh), "id stack", Face(0)));
}

}  // namespace
}  // namespace aomd
