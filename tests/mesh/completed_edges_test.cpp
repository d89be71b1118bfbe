// T(2,1) that comes with the edges that faces lack is the one that is built once these are there.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/mesh/verify.h"
#include "tests/support/zoo.h"

namespace aomd::completed_edges_test {
namespace {

struct Side {
  std::uint32_t edge;
  bool along;  // the edge's own direction
  friend bool operator==(const Side&, const Side&) = default;
};

std::vector<std::vector<Side>> sides_of(const Mesh& mesh) {
  std::vector<std::vector<Side>> all(mesh.capacity(2));
  for (const Face f : mesh.faces())
    for (const Edge e : mesh.row<1>(f)) all[f.index].push_back({e.index, mesh.use_direction(f, e)});
  return all;
}

std::vector<std::array<Vertex, 2>> ends_of(const Mesh& mesh) {
  std::vector<std::array<Vertex, 2>> ends;
  for (const Edge e : mesh.edges()) ends.push_back(mesh.edge_vertices(e));
  return ends;
}

void expect_the_same(Mesh at_once, Mesh later) {
  at_once.set(2, 1);
  later.set(0, 2);
  later.set(0, 1);
  later.set(2, 1);
  EXPECT_EQ(ends_of(at_once), ends_of(later));
  EXPECT_EQ(sides_of(at_once), sides_of(later));
  for (const Edge e : at_once.edges())
    ASSERT_EQ(at_once.classification(e), later.classification(e));
  EXPECT_TRUE(verify(at_once).empty());
  EXPECT_EQ(at_once.representation().record(2, 1).builds, 1u);
}

// A triangle, a quad that uses two of its corners the same way round, a pair on the same three
// vertices that look to opposite sides, and a wire.
MeshData mixed() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {0, 2, 0}};
  data.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 4));
  data.faces.add(Shape::Quad, {2, 5, 3, 1}, ModelRef(2, 5));
  data.faces.add(Shape::Triangle, {0, 1, 4}, ModelRef(2, 6));
  data.faces.add(Shape::Triangle, {1, 0, 4}, ModelRef(2, 7));
  data.edges.add(Shape::Line, {4, 0}, ModelRef(1, 3));
  data.edges.add(Shape::Line, {5, 4});
  return data;
}

TEST(CompletedEdgesTest, AreNumberedByTheirSmallerVertexBehindTheListedOnes) {
  Mesh mesh(mixed());
  mesh.set(2, 1);
  using V = Vertex;
  const std::vector<std::array<Vertex, 2>> ends{{V(4), V(0)}, {V(5), V(4)}, {V(0), V(1)},
                                                {V(2), V(0)}, {V(1), V(2)}, {V(3), V(1)},
                                                {V(1), V(4)}, {V(2), V(5)}, {V(5), V(3)}};
  EXPECT_EQ(ends_of(mesh), ends);
  const std::vector<std::vector<Side>> sides{{{2, true}, {4, true}, {3, true}},
                                             {{7, true}, {8, true}, {5, true}, {4, true}},
                                             {{2, true}, {6, true}, {0, true}},
                                             {{2, false}, {0, false}, {6, false}}};
  EXPECT_EQ(sides_of(mesh), sides);
  EXPECT_EQ(mesh.classification(Edge(0)), ModelRef(1, 3));
  EXPECT_EQ(mesh.classification(Edge(1)), ModelRef());
  EXPECT_EQ(mesh.classification(Edge(2)), ModelRef(2, 4));
  EXPECT_EQ(mesh.classification(Edge(5)), ModelRef(2, 5));
}

TEST(CompletedEdgesTest, AreTheSameAtOnceAndLater) {
  for (const MeshData& data :
       {zoo::triangle(), zoo::square(), zoo::tetrahedron(), zoo::octahedron(), zoo::book(),
        zoo::bow_tie(), zoo::grid(5), zoo::torus(5, 4), mixed(), make_sample("box", 3),
        make_sample("nonmanifold", 4)})
    expect_the_same(Mesh(data), Mesh(data));
}

TEST(CompletedEdgesTest, OfAVolumeComeFromFacesAndRegions) {
  for (const char* sample : {"tet-ball", "mixed", "ball-in-box"}) {
    const MeshData data = make_sample(sample, 3);
    expect_the_same(Mesh(data), Mesh(data));
  }
}

TEST(CompletedEdgesTest, AreThoseOfTheFacesThatAreLeft) {
  const auto with_holes = [] {
    Mesh mesh(mixed());
    mesh.destroy_unused(Face(1));
    mesh.destroy_unused(Edge(0));
    return mesh;
  };
  expect_the_same(with_holes(), with_holes());
  Mesh mesh = with_holes();
  mesh.set(2, 1);
  EXPECT_EQ(mesh.count(1), 6u);
}

TEST(CompletedEdgesTest, AreNoneWhereAllAreListed) {
  MeshData data = zoo::triangle();
  for (const auto& [a, b] : {std::pair(1u, 0u), {1u, 2u}, {0u, 2u}})
    data.edges.add(Shape::Line, {a, b});
  Mesh mesh(data);
  mesh.set(2, 1);
  EXPECT_EQ(mesh.count(1), 3u);
  EXPECT_EQ(sides_of(mesh)[0], (std::vector<Side>{{0, false}, {1, true}, {2, false}}));
}

TEST(CompletedEdgesTest, AreNoneWithoutFaces) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}};
  data.edges.add(Shape::Line, {0, 1});
  Mesh mesh(data);
  mesh.set(2, 1);
  EXPECT_TRUE(mesh.complete(1));
  EXPECT_EQ(mesh.count(1), 1u);
  EXPECT_TRUE(verify(mesh).empty());
}

}  // namespace
}  // namespace aomd::completed_edges_test
