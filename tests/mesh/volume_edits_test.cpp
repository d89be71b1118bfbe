// Regions that are created and deleted, and what becomes of the levels below them.

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "core/mesh/derive.h"
#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "tests/support/message.h"
#include "tests/support/volume_mesh.h"
#include "tests/support/zoo.h"

namespace aomd::volume_edits_test {
namespace {

using test::message;
using test::set_all;
using test::vertices;

// Creation

TEST(VolumeTest, RegionsFromVerticesEdgesAndFacesAreTheSame) {
  for (const Shape shape : {Shape::Tetrahedron, Shape::Pyramid, Shape::Prism, Shape::Hexahedron}) {
    Mesh mesh;
    set_all(mesh);
    std::vector<Vertex> v;
    for (int k = 0; k < shape_template(shape).vertex_count; ++k)
      v.push_back(mesh.create_vertex({k, k * k, 1}));
    const Region first = mesh.create_region(shape, v, ModelRef(3, 5));
    const auto edge_row = mesh.row<1>(first);
    const auto face_row = mesh.row<2>(first);
    const std::vector<Edge> edges(edge_row.begin(), edge_row.end());
    const std::vector<Face> faces(face_row.begin(), face_row.end());
    for (int from = 0; from < 2; ++from) {
      mesh.destroy(first);
      const Region again = from == 0 ? mesh.create_region(shape, edges)
                                     : mesh.create_region(shape, std::span<const Face>(faces));
      EXPECT_EQ(again, first);
      EXPECT_EQ(mesh.shape(again), shape);
      for (std::size_t k = 0; k < v.size(); ++k) EXPECT_EQ(mesh.row<0>(again)[k], v[k]) << k;
      EXPECT_EQ(mesh.count(1), edges.size());
      EXPECT_EQ(mesh.count(2), faces.size());
    }
    EXPECT_TRUE(verify(mesh).empty());
    std::vector<Edge> shuffled = edges;
    std::swap(shuffled[0], shuffled[1]);
    EXPECT_THROW((void)mesh.create_region(shape, shuffled), std::invalid_argument);
    std::vector<Face> twice = faces;
    twice[0] = twice[1];
    EXPECT_THROW((void)mesh.create_region(shape, std::span<const Face>(twice)),
                 std::invalid_argument);
  }
}

TEST(VolumeTest, CreationThatIsRefused) {
  Mesh mesh(zoo::one_tet());
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2})),
               std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2, 2})),
               std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2, 9})),
               std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Quad, vertices({0, 1, 2, 3})),
               std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({3, 1, 2, 0}), ModelRef(2, 1)),
               std::invalid_argument);
  EXPECT_EQ(mesh.count(3), 1u);
}

TEST(VolumeTest, ImplicitEntitiesTakeTheClassOfTheirCreator) {
  Mesh mesh(zoo::one_tet());
  mesh.set(2, 3);
  mesh.set(1, 3);
  const Face shared = mesh.find_face(vertices({1, 2, 3}));
  ASSERT_TRUE(shared.valid());
  mesh.set_classification(shared, ModelRef(2, 9));
  const Vertex top = mesh.create_vertex({1, 1, 1});
  (void)mesh.create_region(Shape::Tetrahedron, std::array{Vertex(1), Vertex(2), Vertex(3), top},
                           ModelRef(3, 4));
  EXPECT_EQ(mesh.count(2), 7u);
  EXPECT_EQ(mesh.count(1), 9u);
  EXPECT_EQ(mesh.classification(shared), ModelRef(2, 9)) << "it was there";
  EXPECT_EQ(mesh.classification(mesh.find_face(vertices({1, 2, 4}))), ModelRef(3, 4));
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(3), top)), ModelRef(3, 4));
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(1), Vertex(2))), ModelRef());
}

TEST(VolumeTest, EntitiesThatTCreatesTakeTheClassOfTheFirstThatHasThem) {
  Mesh mesh(zoo::hybrid());
  mesh.set(0, 1);
  mesh.set(0, 2);
  const auto edge = [&](std::uint32_t a, std::uint32_t b) {
    return mesh.classification(mesh.find_edge(Vertex(a), Vertex(b)));
  };
  EXPECT_EQ(edge(1, 5), ModelRef(2, 7)) << "of the listed face, before any region";
  EXPECT_EQ(edge(0, 1), ModelRef(3, 1));
  EXPECT_EQ(edge(9, 12), ModelRef(3, 2));
  EXPECT_EQ(mesh.classification(mesh.find_face(vertices({1, 2, 6, 5}))), ModelRef(2, 7));
  EXPECT_EQ(mesh.classification(mesh.find_face(vertices({4, 5, 6, 7}))), ModelRef(3, 1));
  EXPECT_EQ(mesh.classification(mesh.find_face(vertices({5, 6, 8}))), ModelRef(3, 1))
      << "the pyramid comes first";
}

// Deletion

TEST(VolumeTest, WhatIsUsedStaysAndTheUsersAreNamed) {
  Mesh mesh(zoo::two_tets());
  set_all(mesh);
  EXPECT_EQ(message([&] { mesh.destroy(Face(2)); }),
            "face 2 is used by region 0, region 1: delete them first, or with it");
  EXPECT_EQ(message([&] { mesh.destroy(Edge(8)); }),
            "edge 8 is used by face 5, face 6, region 1: delete them first, or with it");
  EXPECT_EQ(message([&] { mesh.destroy(Vertex(0)); }),
            "vertex 0 is used by edge 0, edge 1, edge 2, face 0, face 1, face 3 and 1 more: delete "
            "them first, "
            "or with it");
  EXPECT_EQ(mesh.count(0), 5u);
  mesh.destroy(Region(0));
  EXPECT_EQ(mesh.count(2), 7u) << "lower entities stay";
  mesh.destroy(Face(0));
  EXPECT_EQ(message([&] { mesh.destroy(Face(2)); }),
            "face 2 is used by region 1: delete them first, or with it");
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(VolumeTest, UsersAreFoundWithoutAnyRelation) {
  Mesh mesh(zoo::two_tets());  // regions alone
  EXPECT_EQ(message([&] { mesh.destroy(Vertex(4)); }),
            "vertex 4 is used by region 1: delete them first, or with it");
  mesh.destroy_with_users(Vertex(4));
  EXPECT_EQ(mesh.count(3), 1u);
  EXPECT_EQ(mesh.count(0), 4u);
}

TEST(VolumeTest, DeletionWithUsersTakesTheHighestFirst) {
  Mesh mesh(zoo::two_tets());
  set_all(mesh);
  mesh.destroy_with_users(Edge(8));  // 3-4
  EXPECT_EQ(mesh.count(3), 1u);
  EXPECT_EQ(mesh.count(2), 5u);
  EXPECT_EQ(mesh.count(1), 8u);
  EXPECT_EQ(mesh.count(0), 5u);
  EXPECT_TRUE(verify(mesh).empty());
}

// Levels that come and go

TEST(VolumeTest, RelationsOfALevelWithoutEntitiesAreEmpty) {
  Mesh mesh(zoo::square());
  mesh.set(0, 3);  // and T(3,0) is not stored, for there is nothing to hold
  EXPECT_TRUE(adjacent<3>(mesh, Face(0)).empty());
  EXPECT_TRUE(mesh.row<3>(Vertex(0)).empty());
  EXPECT_TRUE(mesh.users(Face(0)).empty());
}

TEST(VolumeTest, UndoBringsBackALevelThatTHadLetGo) {
  Mesh mesh(zoo::two_tets());
  const std::string before = zoo::fingerprint(mesh);
  Journal journal;
  mesh.attach(&journal);
  for (const Region r : mesh.regions()) mesh.destroy(r);
  mesh.unset(3, 0);  // allowed: there is nothing to define
  journal.seek(mesh, 0);
  EXPECT_EQ(zoo::fingerprint(mesh), before);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(VolumeTest, RegionsComeToASurfaceAndToNothing) {
  Mesh mesh(zoo::tetrahedron());
  mesh.set(2, 3);
  const Region r = mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2, 3}));
  EXPECT_EQ(mesh.count(2), 4u);
  EXPECT_EQ(mesh.row<3>(Face(0))[0], r);
  Mesh nothing;
  for (int k = 0; k < 8; ++k) (void)nothing.create_vertex({k & 1, k >> 1 & 1, k >> 2});
  (void)nothing.create_region(Shape::Hexahedron, vertices({0, 1, 3, 2, 4, 5, 7, 6}));
  EXPECT_TRUE(nothing.stored(3, 0));
  EXPECT_EQ(nothing.count(2), 0u);
  nothing.set(2, 3);
  EXPECT_EQ(nothing.count(2), 6u);
  EXPECT_TRUE(verify(nothing).empty());
}

TEST(VolumeTest, UndoBringsNothingWithoutSidesToACompleteLevel) {
  Mesh mesh(zoo::one_tet());
  Journal journal;
  mesh.attach(&journal);
  mesh.destroy(Region(0));
  try {
    mesh.set(0, 1);  // nothing lacks its edges now, but the past does
  } catch (const std::logic_error&) {
  }
  journal.seek(mesh, 0);
  EXPECT_TRUE(verify(mesh).empty());
}

// A tetrahedron leaves its sides for others that are there: what tells of it follows, though its
// vertices are all that it stores itself.
TEST(VolumeTest, WhatTellsOfARegionFollowsWhenItStretches) {
  for (const int level : {1, 2, 3}) {
    Mesh mesh(zoo::one_tet());
    if (level == 3)
      mesh.build_hash(3);
    else
      mesh.set(level, 3);
    ASSERT_FALSE(mesh.stored(3, 1) || mesh.stored(3, 2));
    const Vertex far = mesh.create_vertex({0, 0, -1});
    for (const std::uint32_t a : {1u, 2u, 3u}) {
      if (mesh.complete(1)) mesh.create_edge(far, Vertex(a));
      if (mesh.complete(2)) mesh.create_face(std::array{far, Vertex(a), Vertex(a % 3 + 1)});
    }
    mesh.rebind(std::array{Rebinding{Region(0), 0, Vertex(0), far}});
    EXPECT_EQ(mesh.tetrahedron(Region(0))[0], far);
    EXPECT_TRUE(verify(mesh).empty()) << level << ": " << verify(mesh)[0].text;
  }
}

TEST(VolumeTest, AnEmptiedLevelHasRoomForRegionsAgain) {
  Mesh mesh(zoo::hybrid());
  for (const Region r : mesh.regions()) mesh.destroy(r);
  mesh.set(3, 1);
  mesh.set(3, 2);
  (void)mesh.compact();
  const Region r = mesh.create_region(Shape::Hexahedron, vertices({0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(mesh.row<1>(r).size(), 12u);
  EXPECT_TRUE(verify(mesh).empty());
}

// A quad and a triangle, and two quads, that share their smallest, second and largest vertex.
TEST(VolumeTest, FacesThatLookAlikeAreToldApart) {
  MeshData data;
  for (int k = 0; k < 12; ++k) data.positions.emplace_back(k, k * k, k * k * k);
  data.faces.add(Shape::Quad, {3, 5, 6, 7});
  data.faces.add(Shape::Quad, {3, 4, 8, 11});
  data.regions.add(Shape::Tetrahedron, {1, 3, 5, 7});
  data.regions.add(Shape::Pyramid, {3, 4, 5, 11, 9});
  Mesh mesh(data);
  for (const auto& [i, j] : {std::pair{3, 2}, {2, 3}, {0, 2}}) mesh.set(i, j);
  EXPECT_EQ(mesh.count(2), 11u);
  for (const std::uint32_t f : {0u, 1u}) EXPECT_TRUE(mesh.row<3>(Face(f)).empty()) << f;
  EXPECT_TRUE(verify(mesh).empty());
  EXPECT_EQ(to_data(mesh).faces.size(), 2u) << "those that no region uses";
}

}  // namespace
}  // namespace aomd::volume_edits_test
