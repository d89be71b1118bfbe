// The faces of edges, and edges at vertices, without stored relations.

#include "core/model/edge_faces.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/model/some_edges.h"
#include "tests/support/zoo.h"

namespace aomd::edge_faces_test {
namespace {

std::vector<Face> all_of(const EdgeFaces& faces, Edge e) {
  std::vector<Face> all;
  faces.each(e, [&](Face f) { all.push_back(f); });
  return all;
}

void expect_as_stored(Mesh mesh) {
  mesh.set(2, 1);
  mesh.set(1, 2);
  const EdgeFaces faces(mesh);
  for (const Edge e : mesh.edges()) {
    const Row<2> row = mesh.row<2>(e);
    const std::vector<Face> stored(row.begin(), row.end());
    ASSERT_EQ(all_of(faces, e), stored);
    ASSERT_EQ(faces.count(e), static_cast<int>(std::min<std::size_t>(row.size(), 3)));
    for (const Face from : stored) {
      std::vector<Face> others;
      faces.each_other(e, from, [&](Face f) { others.push_back(f); });
      ASSERT_EQ(others.size(), stored.size() - 1);
      ASSERT_EQ(std::find(others.begin(), others.end(), from), others.end());
    }
    if (row.size() != 2) continue;
    ASSERT_EQ(faces.across(e, row[0]), row[1]);
    ASSERT_EQ(faces.across(e, row[1]), row[0]);
    ASSERT_EQ(faces.same_direction(e),
              mesh.use_direction(row[0], e) == mesh.use_direction(row[1], e));
  }
}

// The book's spine has three faces, its covers' edges one; a wire has none.
TEST(EdgeFacesTest, AreAsManyAsThereAre) {
  MeshData data = zoo::book();
  data.edges.add(Shape::Line, {2, 3});
  Mesh mesh(data);
  mesh.set(2, 1);
  const EdgeFaces faces(mesh);
  EXPECT_EQ(faces.count(Edge(0)), 0);
  const Edge spine = mesh.find_edge(Vertex(0), Vertex(1)),
             rim = mesh.find_edge(Vertex(1), Vertex(4));
  EXPECT_EQ(faces.count(spine), 3);
  EXPECT_EQ(all_of(faces, spine), (std::vector{Face(0), Face(1), Face(2)}));
  EXPECT_EQ(faces.count(rim), 1);
  EXPECT_EQ(faces.first(rim), Face(2));
}

TEST(EdgeFacesTest, SayWhetherTheyLookToDifferentSides) {
  for (const bool turned : {false, true}) {
    MeshData data = zoo::square();
    if (turned) std::swap(data.faces.vertices[3], data.faces.vertices[4]);
    Mesh mesh(data);
    mesh.set(2, 1);
    const EdgeFaces faces(mesh);
    EXPECT_EQ(faces.same_direction(mesh.find_edge(Vertex(0), Vertex(2))), turned);
  }
}

TEST(EdgeFacesTest, AreWhatTheRelationStores) {
  MeshData pages = zoo::book();  // each page twice
  for (std::uint32_t k = 0; k < 9; ++k) pages.faces.vertices.push_back(pages.faces.vertices[k]);
  pages.faces.shapes.resize(6, Shape::Triangle);
  MeshData mixed = zoo::square();
  mixed.positions.insert(mixed.positions.end(), {{2, 0, 0}, {2, 1, 0}});
  mixed.faces.add(Shape::Quad, {1, 4, 5, 2});
  for (const MeshData& data : {pages, mixed, zoo::tetrahedron(), zoo::bow_tie(), zoo::grid(4)})
    expect_as_stored(Mesh(data));
  Mesh holes(pages);
  holes.destroy_unused(Face(1));
  holes.destroy_unused(Face(4));
  expect_as_stored(std::move(holes));
}

TEST(SomeEdgesTest, AreFoundFromTheirVerticesAlone) {
  Mesh mesh(zoo::grid(3));
  mesh.set(0, 1);
  std::vector<Edge> even;
  for (const Edge e : mesh.edges())
    if (e.index % 2 == 0) even.push_back(e);
  const SomeEdges some(mesh, even);
  EXPECT_EQ(some.edges(), even);
  for (const Vertex v : mesh.vertices()) {
    std::vector<Edge> expected;
    for (const Edge e : mesh.row<1>(v))
      if (e.index % 2 == 0) expected.push_back(e);
    const auto found = some.row<1>(v);
    ASSERT_EQ(std::vector<Edge>(found.begin(), found.end()), expected);
  }
}

TEST(EntityRangeTest, VisitsThoseThatAreLeft) {
  Mesh mesh(zoo::grid(2));
  const auto visited = [&] {
    std::vector<Face> faces;
    mesh.faces().each([&](Face f) { faces.push_back(f); });
    return faces;
  };
  EXPECT_EQ(visited().size(), 8u);
  mesh.destroy_unused(Face(3));
  EXPECT_EQ(visited(), mesh.faces().list());
  EXPECT_EQ(visited().size(), 7u);
}

}  // namespace
}  // namespace aomd::edge_faces_test
