// Faults planted one at a time, and found by name and entity.

#include "core/mesh/verify.h"

#include <gtest/gtest.h>

#include "core/model/classify.h"
#include "tests/support/zoo.h"

namespace aomd::verify_test {
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

TEST(VerifyTest, TheFirstThatIsMisclassifiedIsFoundFromVerticesAlone) {
  Mesh mesh(zoo::square());
  EXPECT_FALSE(first_misclassified(mesh));
  mesh.set_classification(Face(0), ModelRef(2, 1));
  mesh.set_classification(Vertex(0), ModelRef(2, 3));
  EXPECT_FALSE(first_misclassified(mesh)) << "another model face is for others to judge";
  mesh.set_classification(Vertex(0), ModelRef(3, 1));
  const auto finding = first_misclassified(mesh);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->name, "classification closure");
  EXPECT_EQ(finding->entity, EntityRef(Vertex(0)));
  EXPECT_EQ(finding->text, verify(mesh).front().text);
  Mesh with_edges = full(zoo::square());
  with_edges.set_classification(Edge(2), ModelRef(1, 1));
  EXPECT_FALSE(first_misclassified(with_edges));
  with_edges.set_classification(with_edges.edge_vertices(Edge(2))[1], ModelRef(2, 1));
  EXPECT_TRUE(first_misclassified(with_edges));
}

TEST(VerifyTest, CoordinateThatIsNoNumber) {
  for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (int axis = 0; axis < 3; ++axis) {
      Mesh mesh(zoo::square());
      glm::dvec3 p(0.0);
      p[axis] = none;
      mesh.move(Vertex(3), p);
      EXPECT_TRUE(found(verify(mesh), "not finite", Vertex(3))) << none << ' ' << axis;
    }
}

TEST(VerifyTest, ClassListsThatMissAFace) {
  Mesh mesh(zoo::square());
  mesh.set_classification(Face(1), ModelRef(2, 1));
  mesh.keep_class_lists(true);
  EXPECT_TRUE(verify(mesh).empty());
  const_cast<ClassLists*>(mesh.class_lists())->erase(2, 1, ModelRef(2, 1));
  EXPECT_TRUE(found(verify(mesh), "class list", EntityRef(2, no_index)));
  EXPECT_EQ(verify(mesh).size(), 1u);
}

TEST(VerifyTest, LeakInTheIdStack) {
  Mesh mesh(zoo::square());
  mesh.destroy(Face(0));
  const_cast<std::vector<std::uint32_t>&>(mesh.ids(2).free_ids()).push_back(1);
  EXPECT_TRUE(found(verify(mesh), "id stack", Face(1)));
  const_cast<std::vector<std::uint32_t>&>(mesh.ids(2).free_ids()).clear();
  EXPECT_TRUE(found(verify(mesh), "id stack", Face(0)));
}

// Volumes: two tetrahedra that share the face 1 2 3 (see zoo.h), with all twelve relations.
Mesh full_volume() {
  Mesh mesh(zoo::two_tets());
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j) mesh.set(i, j);
  return mesh;
}

TEST(VerifyTest, FindsNothingWrongInVolumes) {
  for (const zoo::Animal& animal : zoo::volumes()) {
    Mesh mesh(animal.data);
    EXPECT_TRUE(verify(mesh).empty()) << animal.name;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j) mesh.set(i, j);
    EXPECT_TRUE(verify(mesh).empty()) << animal.name;
  }
}

TEST(VerifyTest, ARegionThatNamesAWrongFaceOrUsesItTheOtherWayRound) {
  Mesh mesh = full_volume();
  DownRows& sides = rows_of(mesh).down(3, 2);
  sides.set_directions(1, static_cast<std::uint16_t>(sides.directions(1) ^ 4u));
  EXPECT_TRUE(found(verify(mesh), "wrong use direction", Region(1)));
  EXPECT_EQ(verify(mesh).size(), 1u);
  sides.row(0)[1] = sides.row(1)[2];
  EXPECT_TRUE(found(verify(mesh), "wrong side", Region(0)));
}

TEST(VerifyTest, UpwardListsOfVolumesThatDisagree) {
  for (int i = 0; i < 3; ++i) {
    Mesh mesh = full_volume();
    const std::uint32_t id = mesh.representation().down(3, i).row(0)[0];
    ASSERT_TRUE(rows_of(mesh).up(i, 3).erase(id, 0));
    EXPECT_TRUE(found(verify(mesh), "upward list", EntityRef(i, id))) << i;
    EXPECT_EQ(verify(mesh).size(), 1u);
  }
}

TEST(VerifyTest, DuplicateRegionAndFaceAndAMissingFace) {
  MeshData data = zoo::two_tets();
  data.regions.add(Shape::Tetrahedron, {3, 2, 1, 0});
  EXPECT_TRUE(found(verify(Mesh(data)), "duplicate region", Region(2)));
  data = zoo::two_tets();
  data.faces.add(Shape::Triangle, {1, 2, 3});
  data.faces.add(Shape::Triangle, {3, 2, 1});
  Mesh twice(data);
  EXPECT_TRUE(verify(twice).empty());  // faces of a file that nothing has been asked about
  twice.set(3, 2);
  EXPECT_TRUE(found(verify(twice), "duplicate face", Face(1)));
  Mesh missing(zoo::two_tets());
  missing.set(2, 0);
  missing.destroy_unused(missing.find_face(std::array{Vertex(1), Vertex(2), Vertex(3)}));
  EXPECT_TRUE(found(verify(missing), "missing face", Region(0)));
  EXPECT_TRUE(found(verify(missing), "missing face", Region(1)));
}

TEST(VerifyTest, ARegionOnADeadVertex) {
  Mesh mesh(zoo::two_tets());
  rows_of(mesh).down(3, 0).row(1)[3] = 99;
  EXPECT_TRUE(found(verify(mesh), "dead reference", Region(1)));
}

TEST(VerifyTest, ClassificationOrderOfARegion) {
  Mesh mesh(zoo::two_tets());
  mesh.keep_class_lists(true);
  mesh.set_classification(Region(0), ModelRef(3, 1));
  EXPECT_TRUE(verify(mesh).empty());
  EXPECT_THROW(mesh.set_classification(Region(0), ModelRef(2, 1)), std::invalid_argument);
  mesh.set_classification(Vertex(0), ModelRef(3, 1));
  MeshData data = zoo::two_tets();
  data.regions.classes = {ModelRef(2, 5), ModelRef(3, 1)};
  EXPECT_THROW(Mesh{data}, std::invalid_argument);
}

TEST(VerifyTest, HashSetsOfFacesAndRegionsThatMissOrMisplaceOne) {
  for (int dim = 2; dim <= 3; ++dim) {
    Mesh mesh(zoo::two_tets());
    mesh.set(2, 0);
    ASSERT_TRUE(mesh.find_face(std::array{Vertex(1), Vertex(2), Vertex(3)}).valid());
    ASSERT_TRUE(mesh.find_region(std::array{Vertex(1), Vertex(2), Vertex(3), Vertex(4)}).valid());
    auto& set = const_cast<EntityHash&>(mesh.hash(dim));
    set.erase(1);
    EXPECT_TRUE(found(verify(mesh), "hash set", EntityRef(dim, 1))) << dim;
    set.insert(12345, 1);
    EXPECT_TRUE(found(verify(mesh), "hash set", EntityRef(dim, 1))) << dim;
  }
}

TEST(VerifyTest, WhatNothingUsesIsNamedWhenAskedFor) {
  const Mesh mesh(zoo::fan());  // a triangle and an edge hang on it
  EXPECT_TRUE(verify(mesh).empty());
  const auto findings = verify(mesh, {.unused = true});
  EXPECT_TRUE(found(findings, "dangling face", Face(0)));
  EXPECT_TRUE(found(findings, "dangling edge", Edge(0)));
  EXPECT_EQ(findings.size(), 2u);
  MeshData lonely = zoo::one_tet();
  lonely.positions.emplace_back(5, 5, 5);
  EXPECT_TRUE(found(verify(Mesh(lonely), {.unused = true}), "isolated vertex", Vertex(4)));
}

}  // namespace
}  // namespace aomd::verify_test
