// Regions: exact answers on the tiny volumes of the zoo.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/mesh/derive.h"
#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/message.h"
#include "tests/oracle.h"
#include "zoo.h"

namespace aomd {
namespace {

using Ids = std::vector<std::uint32_t>;
using test::message;

void set_all(Mesh& mesh) {
  mesh.set(0, 1);  // edges first: their order is then that of the regions
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j) mesh.set(i, j);
}

template <int J, int I>
std::vector<Ids> rows(const Mesh& mesh) {
  std::vector<Ids> result;
  for (std::uint32_t id = 0; id < mesh.capacity(I); ++id) {
    const auto row = mesh.row<J>(Handle<I>(id)).indices();
    result.emplace_back(row.begin(), row.end());
  }
  return result;
}

std::vector<Vertex> vertices(std::initializer_list<std::uint32_t> ids) { return {ids.begin(), ids.end()}; }

//      3            region 0 = 0 1 2 3, region 1 = 1 2 3 4
//     /|\           edges by smaller vertex, then by the first region that has them:
//    / | \            0: 0-1  1: 2-0  2: 0-3  3: 1-2  4: 1-3  5: 1-4  6: 2-3  7: 2-4  8: 3-4
//   0--|--2--4      faces, region by region, outward:
//    \ | /            0: 0 2 1  1: 0 1 3  2: 1 2 3  3: 2 0 3  4: 1 2 4  5: 2 3 4  6: 3 1 4
//      1
TEST(VolumeTest, AllRelationsOfTwoTetrahedra) {
  Mesh mesh(zoo::two_tets());
  set_all(mesh);
  EXPECT_EQ((rows<0, 1>(mesh)),
            (std::vector<Ids>{{0, 1}, {2, 0}, {0, 3}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}));
  EXPECT_EQ((rows<0, 2>(mesh)),
            (std::vector<Ids>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}));
  EXPECT_EQ((rows<0, 3>(mesh)), (std::vector<Ids>{{0, 1, 2, 3}, {1, 2, 3, 4}}));
  EXPECT_EQ((rows<1, 0>(mesh)),
            (std::vector<Ids>{{0, 1, 2}, {0, 3, 4, 5}, {1, 3, 6, 7}, {2, 4, 6, 8}, {5, 7, 8}}));
  EXPECT_EQ((rows<2, 0>(mesh)),
            (std::vector<Ids>{{0, 1, 3}, {0, 1, 2, 4, 6}, {0, 2, 3, 4, 5}, {1, 2, 3, 5, 6}, {4, 5, 6}}));
  EXPECT_EQ((rows<3, 0>(mesh)), (std::vector<Ids>{{0}, {0, 1}, {0, 1}, {0, 1}, {1}}));
  EXPECT_EQ((rows<1, 2>(mesh)),
            (std::vector<Ids>{{1, 3, 0}, {0, 4, 2}, {3, 6, 4}, {1, 2, 6}, {3, 7, 5}, {6, 8, 7}, {4, 5, 8}}));
  EXPECT_EQ(
      (rows<2, 1>(mesh)),
      (std::vector<Ids>{{0, 1}, {0, 3}, {1, 3}, {0, 2, 4}, {1, 2, 6}, {4, 6}, {2, 3, 5}, {4, 5}, {5, 6}}));
  EXPECT_EQ((rows<1, 3>(mesh)), (std::vector<Ids>{{0, 3, 1, 2, 4, 6}, {3, 6, 4, 5, 7, 8}}));
  EXPECT_EQ((rows<3, 1>(mesh)), (std::vector<Ids>{{0}, {0}, {0}, {0, 1}, {0, 1}, {1}, {0, 1}, {1}, {1}}));
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
    for (int j = 0; j < 4; ++j) EXPECT_EQ(mesh.stored(i, j), (i == 3 || i == 2) && j == 0) << i << j;
}

struct Counts {
  const char* name;
  std::uint32_t edges, faces;
};

TEST(VolumeTest, EntitiesThatTCreates) {
  constexpr Counts expected[] = {
      {"one_tet", 6, 4},  {"two_tets", 9, 7}, {"tets_on_an_edge", 11, 8}, {"tets_on_a_vertex", 12, 8},
      {"hybrid", 27, 20}, {"fan", 13, 10},    {"glued", 19, 11}};
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

/// Faces with their smallest vertex first, sorted: the same for two tables with the same orientations.
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
     {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}},
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
     {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}},
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
      data.regions.vertices.push_back((7 * k + 3) % (2 * n));  // 7 has no divisor in common with 2 n
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
    EXPECT_EQ(message([&] { mesh.unset(3, 1); }), "T(3,1) defines the regions: set T(3,0) or T(3,2) first");
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
    EXPECT_THROW((void)mesh.create_region(shape, std::span<const Face>(twice)), std::invalid_argument);
  }
}

TEST(VolumeTest, CreationThatIsRefused) {
  Mesh mesh(zoo::one_tet());
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2})), std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2, 2})), std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Tetrahedron, vertices({0, 1, 2, 9})), std::invalid_argument);
  EXPECT_THROW((void)mesh.create_region(Shape::Quad, vertices({0, 1, 2, 3})), std::invalid_argument);
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
  EXPECT_EQ(
      message([&] { mesh.destroy(Vertex(0)); }),
      "vertex 0 is used by edge 0, edge 1, edge 2, face 0, face 1, face 3 and 1 more: delete them first, "
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
        for (const std::uint32_t k : by_hash.vertices_of(EntityRef(dim, id), buffer)) v.emplace_back(k);
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
}  // namespace aomd
