// Regions: exact answers on the tiny volumes of the zoo.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/support/message.h"
#include "tests/support/oracle.h"
#include "tests/support/volume_mesh.h"
#include "tests/support/zoo.h"

namespace aomd::volume_test {
namespace {

using Ids = std::vector<std::uint32_t>;
using test::message;
using test::set_all;
using test::vertices;

template <int J, int I>
std::vector<Ids> rows(const Mesh& mesh) {
  std::vector<Ids> result;
  for (std::uint32_t id = 0; id < mesh.capacity(I); ++id) {
    const auto row = mesh.row<J>(Handle<I>(id)).indices();
    result.emplace_back(row.begin(), row.end());
  }
  return result;
}

//      3            region 0 = 0 1 2 3, region 1 = 1 2 3 4
//     /|\           edges by smaller vertex, then by the first region that has them:
//    / | \            0: 0-1  1: 2-0  2: 0-3  3: 1-2  4: 1-3  5: 1-4  6: 2-3  7: 2-4  8: 3-4
//   0--|--2--4      faces, region by region, outward:
//    \ | /            0: 0 2 1  1: 0 1 3  2: 1 2 3  3: 2 0 3  4: 1 2 4  5: 2 3 4  6: 3 1 4
//      1
TEST(VolumeTest, AllRelationsOfTwoTetrahedra) {
  Mesh mesh(zoo::two_tets());
  set_all(mesh);
  EXPECT_EQ(
      (rows<0, 1>(mesh)),
      (std::vector<Ids>{{0, 1}, {2, 0}, {0, 3}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}));
  EXPECT_EQ((rows<0, 2>(mesh)),
            (std::vector<Ids>{
                {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}));
  EXPECT_EQ((rows<0, 3>(mesh)), (std::vector<Ids>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ((rows<1, 0>(mesh)),
            (std::vector<Ids>{{0, 1, 2}, {0, 3, 4, 5}, {1, 3, 6, 7}, {2, 4, 6, 8}, {5, 7, 8}}));
  EXPECT_EQ(
      (rows<2, 0>(mesh)),
      (std::vector<Ids>{{0, 1, 3}, {0, 1, 2, 4, 6}, {0, 2, 3, 4, 5}, {1, 2, 3, 5, 6}, {4, 5, 6}}));
  EXPECT_EQ((rows<3, 0>(mesh)), (std::vector<Ids>{{0}, {0, 1}, {0, 1}, {0, 1}, {1}}));
  EXPECT_EQ((rows<1, 2>(mesh)),
            (std::vector<Ids>{
                {1, 3, 0}, {0, 4, 2}, {3, 6, 4}, {1, 2, 6}, {3, 7, 5}, {6, 8, 7}, {4, 5, 8}}));
  EXPECT_EQ((rows<2, 1>(mesh)),
            (std::vector<Ids>{
                {0, 1}, {0, 3}, {1, 3}, {0, 2, 4}, {1, 2, 6}, {4, 6}, {2, 3, 5}, {4, 5}, {5, 6}}));
  EXPECT_EQ((rows<1, 3>(mesh)), (std::vector<Ids>{{0, 3, 1, 2, 4, 6}, {3, 6, 4, 5, 7, 8}}));
  EXPECT_EQ((rows<3, 1>(mesh)),
            (std::vector<Ids>{{0}, {0}, {0}, {0, 1}, {0, 1}, {1}, {0, 1}, {1}, {1}}));
  EXPECT_EQ((rows<2, 3>(mesh)), (std::vector<Ids>{{0, 1, 2, 3}, {2, 4, 5, 6}}));
  EXPECT_EQ((rows<3, 2>(mesh)), (std::vector<Ids>{{0}, {0}, {0, 1}, {0}, {1}, {1}, {1}}));
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(VolumeTest, TwoRegionsUseTheirFaceInOppositeDirections) {
  Mesh mesh(zoo::two_tets());
  set_all(mesh);
  EXPECT_TRUE(mesh.use_direction(Region(0), Face(2)));
  EXPECT_FALSE(mesh.use_direction(Region(1), Face(2)));
  for (const std::uint32_t f : {4u, 5u, 6u}) EXPECT_TRUE(mesh.use_direction(Region(1), Face(f)));
  EXPECT_FALSE(mesh.use_direction(Face(0), Edge(1)));  // 0-2, and the edge is 2-0
  EXPECT_TRUE(mesh.use_direction(Face(3), Edge(1)));
}

TEST(VolumeTest, ReadingStoresNoMoreThanTheFileHolds) {
  const Mesh mesh(zoo::hybrid());
  EXPECT_EQ(mesh.count(1), 0u);
  EXPECT_EQ(mesh.count(2), 1u);
  EXPECT_EQ(mesh.count(3), 5u);
  EXPECT_EQ(mesh.dimension(), 3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      EXPECT_EQ(mesh.stored(i, j), (i == 3 || i == 2) && j == 0) << i << j;
}

struct Counts {
  const char* name;
  std::uint32_t edges, faces;
};

TEST(VolumeTest, EntitiesThatTCreates) {
  constexpr Counts expected[] = {{"one_tet", 6, 4},          {"two_tets", 9, 7},
                                 {"tets_on_an_edge", 11, 8}, {"tets_on_a_vertex", 12, 8},
                                 {"hybrid", 27, 20},         {"fan", 13, 10},
                                 {"glued", 19, 11}};
  const auto animals = zoo::volumes();
  for (std::size_t k = 0; k < animals.size(); ++k) {
    Mesh mesh(animals[k].data);
    set_all(mesh);
    ASSERT_EQ(animals[k].name, expected[k].name);
    EXPECT_EQ(mesh.count(1), expected[k].edges) << animals[k].name;
    EXPECT_EQ(mesh.count(2), expected[k].faces) << animals[k].name;
    EXPECT_TRUE(verify(mesh).empty()) << animals[k].name;
  }
}

// Numbering

using Table = std::vector<Ids>;

/// Faces with their smallest vertex first, sorted: the same for two tables with the same
/// orientations.
Table faces_of(Table table) {
  for (Ids& f : table) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(table.begin(), table.end());
  return table;
}

Table edges_of(Table table) {
  for (Ids& e : table) std::sort(e.begin(), e.end());
  std::sort(table.begin(), table.end());
  return table;
}

Table table_of(Shape shape, int dim) {
  Ids numbers(max_shape_vertices);
  for (std::uint32_t k = 0; k < numbers.size(); ++k) numbers[k] = k;
  Table table;
  for (int i = 0; i < shape_template(shape).count(dim); ++i)
    table.push_back(oracle::side({shape, numbers, {}}, dim, i));
  return table;
}

struct Numbering {
  Shape shape;
  Table edges, faces;
};

// As in Gmsh's sources (MTetrahedron.h and so on): edges_tetra, faces_tetra, ...
const std::vector<Numbering> gmsh{
    {Shape::Tetrahedron,
     {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}},
     {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {3, 1, 2}}},
    {Shape::Pyramid,
     {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}},
     {{0, 1, 4}, {3, 0, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 2, 1}}},
    {Shape::Prism,
     {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
     {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}}},
    {Shape::Hexahedron,
     {{0, 1},
      {0, 3},
      {0, 4},
      {1, 2},
      {1, 5},
      {2, 3},
      {2, 6},
      {3, 7},
      {4, 5},
      {4, 7},
      {5, 6},
      {6, 7}},
     {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}}};

// As in VTK's sources (vtkTetra.cxx and so on); its wedge is the other way round and left out.
const std::vector<Numbering> vtk{
    {Shape::Tetrahedron,
     {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
     {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}}},
    {Shape::Pyramid,
     {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}},
     {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
    {Shape::Hexahedron,
     {{0, 1},
      {1, 2},
      {3, 2},
      {0, 3},
      {4, 5},
      {5, 6},
      {7, 6},
      {4, 7},
      {0, 4},
      {1, 5},
      {3, 7},
      {2, 6}},
     {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}}};

TEST(VolumeTest, FacesLookOutwardAsInGmshAndVtk) {
  for (const auto* numberings : {&gmsh, &vtk})
    for (const Numbering& n : *numberings) {
      EXPECT_EQ(faces_of(table_of(n.shape, 2)), faces_of(n.faces)) << shape_template(n.shape).name;
      EXPECT_EQ(edges_of(table_of(n.shape, 1)), edges_of(n.edges)) << shape_template(n.shape).name;
    }
}

// What holds the regions

/// Every built-in shape with its vertices named in an order of its own, and the mixed meshes.
std::vector<MeshData> all_shapes() {
  std::vector<MeshData> list{zoo::hybrid(), make_sample("mixed", 2), make_sample("tet-ball", 2)};
  for (const Shape shape : {Shape::Tetrahedron, Shape::Pyramid, Shape::Prism, Shape::Hexahedron}) {
    MeshData data;
    const auto n = static_cast<std::uint32_t>(shape_template(shape).vertex_count);
    data.regions.shapes = {shape, shape};
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      data.positions.emplace_back(k, k * k, k * k * k);
      data.regions.vertices.push_back((7 * k + 3) %
                                      (2 * n));  // 7 has no divisor in common with 2 n
    }
    list.push_back(data);
  }
  return list;
}

TEST(VolumeTest, RegionsMayBeHeldByTheirEdgesOrTheirFacesAlone) {
  ASSERT_EQ(all_shapes().size(), 7u);
  for (const MeshData& data : all_shapes()) {
    Mesh mesh(data);
    mesh.set(3, 1);
    mesh.set(3, 2);
    const std::string before = zoo::fingerprint(mesh);
    mesh.unset(3, 0);
    mesh.unset(3, 2);
    EXPECT_EQ(zoo::fingerprint(mesh), before) << "by edges";
    EXPECT_TRUE(verify(mesh).empty());
    EXPECT_EQ(message([&] { mesh.unset(3, 1); }),
              "T(3,1) defines the regions: set T(3,0) or T(3,2) first");
    mesh.set(3, 2);
    mesh.unset(3, 1);
    mesh.set(2, 1);
    mesh.unset(2, 0);
    EXPECT_EQ(zoo::fingerprint(mesh), before) << "by faces, which are held by edges";
    EXPECT_TRUE(verify(mesh).empty());
    mesh.set(3, 0);
    mesh.unset(3, 2);
    EXPECT_EQ(zoo::fingerprint(mesh), before);
  }
}

// Existence

TEST(VolumeTest, TheHashSetFindsWhatAdjacencyFinds) {
  for (const char* name : {"tet-box", "mixed", "tet-drilled"}) {
    Mesh by_hash(make_sample(name, 3)), by_adjacency(make_sample(name, 3));
    for (int j = 1; j <= 3; ++j) by_adjacency.set(0, j);
    for (int j = 1; j <= 3; ++j) by_hash.set(0, j);
    for (int j = 1; j <= 3; ++j) by_hash.unset(0, j);
    VertexBuffer buffer;
    for (int dim = 1; dim <= 3; ++dim)
      for (std::uint32_t id = 0; id < by_hash.capacity(dim); ++id) {
        std::vector<Vertex> v;
        for (const std::uint32_t k : by_hash.vertices_of(EntityRef(dim, id), buffer))
          v.emplace_back(k);
        std::reverse(v.begin(), v.end());
        for (const bool other : {false, true}) {
          if (other) v.back() = Vertex((v.back().index + 5) % by_hash.count(0));
          const auto find = [&](const Mesh& m) {
            return dim == 1   ? m.find_edge(v[0], v[1]).index
                   : dim == 2 ? m.find_face(v).index
                              : m.find_region(v).index;
          };
          ASSERT_EQ(find(by_hash), find(by_adjacency)) << name << dim << ' ' << id;
          if (!other) {
            ASSERT_EQ(find(by_hash), id);
          }
        }
      }
    for (int dim = 1; dim <= 3; ++dim) {
      EXPECT_TRUE(by_hash.hash(dim).built());
      EXPECT_FALSE(by_adjacency.hash(dim).built());
      by_hash.drop_hash(dim);
      EXPECT_FALSE(by_hash.hash(dim).built());
    }
  }
}

TEST(VolumeTest, WhatDoesNotExistIsNotFound) {
  const Mesh mesh(zoo::two_tets());
  EXPECT_FALSE(mesh.find_edge(Vertex(0), Vertex(1)).valid()) << "no edges yet";
  EXPECT_TRUE(mesh.find_region(vertices({4, 3, 2, 1})).valid());
  EXPECT_FALSE(mesh.find_region(vertices({0, 1, 2, 4})).valid());
  EXPECT_FALSE(mesh.find_region(vertices({0, 1, 2})).valid());
  EXPECT_FALSE(mesh.find_region(vertices({0, 1, 2, 99})).valid());
  EXPECT_FALSE(mesh.find_region(vertices({})).valid());
}

}  // namespace
}  // namespace aomd::volume_test
