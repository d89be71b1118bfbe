#include "core/mesh/mesh.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/mesh/verify.h"
#include "tests/support/message.h"
#include "tests/support/zoo.h"

namespace aomd::mesh_test {
namespace {

template <typename Row>
std::vector<std::uint32_t> ids(const Row& row) {
  return {row.indices().begin(), row.indices().end()};
}
using Ids = std::vector<std::uint32_t>;

template <typename A, typename B>
concept Comparable = requires(A a, B b) {
  a == b;
};
static_assert(Comparable<Vertex, Vertex>);
static_assert(!Comparable<Vertex, Face>, "handles of two kinds must not compare");
static_assert(sizeof(Vertex) == 4 && sizeof(ModelRef) == 4);

TEST(ModelRefTest, PacksDimensionAndTag) {
  for (const std::int32_t tag : {0, 1, -1, 12345, ModelRef::min_tag, ModelRef::max_tag})
    for (int dim = 0; dim <= 3; ++dim) {
      EXPECT_EQ(ModelRef(dim, tag).dimension(), dim);
      EXPECT_EQ(ModelRef(dim, tag).tag(), tag);
    }
  EXPECT_FALSE(ModelRef().valid());
  EXPECT_TRUE(ModelRef(2, 1).may_classify(1));
  EXPECT_FALSE(ModelRef(1, 1).may_classify(2));  // M^2 on G^1 breaks J >= I
}

TEST(MeshTest, ReadingStoresNoMoreThanTheFileHolds) {
  const Mesh mesh(zoo::square());
  EXPECT_EQ(mesh.count(0), 4u);
  EXPECT_EQ(mesh.count(1), 0u);  // "E = 0" until T asks for edges
  EXPECT_EQ(mesh.count(2), 2u);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_EQ(mesh.stored(i, j), i == 2 && j == 0) << i << j;
}

//  3--2      edges by smaller vertex, then by the first face that uses them:
//  | /|      0: 0-1   1: 2-0   2: 3-0   3: 1-2   4: 2-3
//  |/ |      (each in the direction of its first face)
//  0--1
TEST(MeshTest, SettingARelationCreatesTheEdgesThatItNeeds) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  ASSERT_EQ(mesh.count(1), 5u);
  const std::uint32_t expected[5][2] = {{0, 1}, {2, 0}, {3, 0}, {1, 2}, {2, 3}};
  for (std::uint32_t e = 0; e < 5; ++e) {
    EXPECT_EQ(mesh.edge_vertices(Edge(e))[0].index, expected[e][0]) << e;
    EXPECT_EQ(mesh.edge_vertices(Edge(e))[1].index, expected[e][1]) << e;
  }
  EXPECT_EQ(ids(mesh.row<1>(Vertex(0))), (Ids{0, 1, 2}));
  EXPECT_EQ(ids(mesh.row<1>(Vertex(1))), (Ids{0, 3}));
}

TEST(MeshTest, AllRelationsOfTheSquare) {
  Mesh mesh(zoo::square());
  for (const auto& [i, j] : {std::pair{1, 2}, {0, 2}, {2, 1}, {0, 1}, {1, 0}}) mesh.set(i, j);
  EXPECT_EQ(ids(mesh.row<2>(Vertex(0))), (Ids{0, 1}));
  EXPECT_EQ(ids(mesh.row<2>(Vertex(3))), (Ids{1}));
  EXPECT_EQ(ids(mesh.row<1>(Face(0))), (Ids{0, 3, 1}));  // 0-1, 1-2, 2-0
  EXPECT_EQ(ids(mesh.row<1>(Face(1))), (Ids{1, 4, 2}));  // 0-2, 2-3, 3-0
  EXPECT_EQ(ids(mesh.row<2>(Edge(1))), (Ids{0, 1}));     // the diagonal
  EXPECT_TRUE(mesh.use_direction(
      Face(0), Edge(1)));  // face 0 made it, face 1 uses it the other way (figure 3)
  EXPECT_FALSE(mesh.use_direction(Face(1), Edge(1)));
}

TEST(MeshTest, FacesMayBeHeldByTheirEdgesAlone) {
  for (const zoo::Animal& animal : zoo::all()) {
    Mesh mesh(animal.data);
    mesh.set(2, 1);
    const std::string before = zoo::fingerprint(mesh);
    mesh.unset(2, 0);
    EXPECT_FALSE(mesh.stored(2, 0));
    EXPECT_EQ(zoo::fingerprint(mesh), before)
        << animal.name;  // vertices derived from edges and directions
    mesh.set(0, 2);
    mesh.set(1, 2);
    EXPECT_TRUE(verify(mesh).empty()) << animal.name;
    mesh.set(2, 0);
    mesh.unset(2, 1);
    EXPECT_EQ(zoo::fingerprint(mesh), before) << animal.name;
  }
}

TEST(MeshTest, NamesTheTriangleThatIsNone) {
  const auto refused = [](const std::function<void(MeshData&)>& spoil) {
    MeshData data = zoo::square();
    spoil(data);
    return test::message([&] { Mesh mesh(data); });
  };
  EXPECT_EQ(refused([](MeshData&) {}), "");
  EXPECT_EQ(refused([](MeshData& data) { data.faces.vertices[5] = 4; }),
            "mesh data: face 1 uses a vertex that does not exist");
  for (const std::size_t same : {4, 5})
    EXPECT_EQ(refused([&](MeshData& data) { data.faces.vertices[same] = data.faces.vertices[3]; }),
              "mesh data: face 1 uses a vertex twice");
  EXPECT_EQ(refused([](MeshData& data) { data.faces.vertices[5] = data.faces.vertices[4]; }),
            "mesh data: face 1 uses a vertex twice");
  EXPECT_EQ(refused([](MeshData& data) { data.faces.vertices.pop_back(); }),
            "mesh data: face 1 lacks vertices");
  EXPECT_EQ(refused([](MeshData& data) { data.faces.shapes[1] = Shape::Line; }),
            "mesh data: face 1 has a wrong shape");
  EXPECT_EQ(refused([](MeshData& data) {
              data.faces.classes = {{}, ModelRef(1, 1)};
            }),
            "mesh data: face 1 is on a model entity of lower dimension");
}

TEST(MeshTest, RefusesWhatTCannotSay) {
  Mesh mesh(zoo::square());
  EXPECT_THROW(mesh.set(1, 1), std::invalid_argument);
  EXPECT_THROW(mesh.set(0, 4), std::invalid_argument);
  try {
    mesh.unset(2, 0);
    FAIL() << "T(2,0) alone defines the faces";
  } catch (const std::logic_error& e) {
    EXPECT_STREQ(e.what(), "T(2,0) defines the faces: set T(2,1) first");
  }
  mesh.set(1, 0);
  EXPECT_THROW(mesh.unset(1, 0), std::logic_error);
}

TEST(MeshTest, RefusesWhatIsNoEntity) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  const Vertex twice[] = {Vertex(0), Vertex(1), Vertex(1)};
  EXPECT_THROW(mesh.create_face(twice), std::invalid_argument);
  EXPECT_THROW(mesh.create_edge(Vertex(1), Vertex(1)), std::invalid_argument);
  EXPECT_THROW(mesh.create_edge(Vertex(1), Vertex(0)), std::invalid_argument);
  EXPECT_THROW(mesh.set_classification(Face(0), ModelRef(1, 1)), std::invalid_argument);
  EXPECT_EQ(mesh.count(1), 5u);
  EXPECT_EQ(mesh.count(2), 2u);
}

TEST(MeshTest, ATriangleIsNotFoundByFourVertices) {
  Mesh mesh(zoo::square());
  mesh.set(0, 2);
  const Vertex four[] = {Vertex(0), Vertex(1), Vertex(2), Vertex(3)};
  EXPECT_EQ(mesh.find_face(std::span(four).first(3)), Face(0));
  EXPECT_FALSE(mesh.find_face(four).valid());
}

TEST(MeshTest, RequestsAreCountedAndFreeTheirMemory) {
  Mesh mesh(zoo::torus(12, 9));
  {
    const Request first = mesh.request(0, 2);
    {
      Request second = mesh.request(0, 2);
      Request moved = std::move(second);
    }
    EXPECT_TRUE(mesh.stored(0, 2));
    EXPECT_GT(mesh.representation().bytes(0, 2), 108u * 6 * 4);
  }
  EXPECT_FALSE(mesh.stored(0, 2));
  EXPECT_EQ(mesh.representation().bytes(0, 2), 0u);
  mesh.set(0, 2);
  { const Request request = mesh.request(0, 2); }
  EXPECT_TRUE(mesh.stored(0, 2)) << "the user set it too";
  mesh.unset(0, 2);
  EXPECT_FALSE(mesh.stored(0, 2));
}

TEST(MeshTest, CreatingAFaceCreatesItsEdgesOnceTAsks) {
  Mesh mesh;
  mesh.set(1, 2);
  std::vector<Vertex> v;
  for (const glm::dvec3& p : zoo::square().positions) v.push_back(mesh.create_vertex(p));
  const ModelRef model(2, 7);
  const Face f = mesh.create_face(std::array{v[0], v[1], v[2]}, model);
  const Face g = mesh.create_face(std::array{v[0], v[2], v[3]}, model);
  EXPECT_EQ(mesh.count(1), 5u);
  const Edge diagonal = mesh.find_edge(v[0], v[2]);  // paper, fragment (2)
  ASSERT_TRUE(diagonal.valid());
  EXPECT_EQ(ids(mesh.row<2>(diagonal)), (Ids{f.index, g.index}));
  EXPECT_EQ(mesh.classification(diagonal), model);
  EXPECT_FALSE(mesh.find_edge(v[1], v[3]).valid());
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, QuadsAndTrianglesTogether) {
  Mesh mesh;
  mesh.set(2, 1);
  std::vector<Vertex> v;
  for (const glm::dvec3& p : zoo::octahedron().positions) v.push_back(mesh.create_vertex(p));
  const Face t = mesh.create_face(std::array{v[0], v[1], v[4]});
  const Face q = mesh.create_face(std::array{v[0], v[3], v[2], v[1]});
  EXPECT_EQ(mesh.shape(t), Shape::Triangle);
  EXPECT_EQ(mesh.shape(q), Shape::Quad);
  EXPECT_EQ(mesh.row<1>(t).size(), 3u);
  EXPECT_EQ(mesh.row<1>(q).size(), 4u);
  mesh.set(0, 2);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, IdsComeFromTheStackLastFreedFirst) {
  Mesh mesh(zoo::bow_tie());
  mesh.destroy(Face(0));
  mesh.destroy(Face(1));
  EXPECT_EQ(mesh.create_face(std::array{Vertex(0), Vertex(3), Vertex(4)}).index, 1u);
  EXPECT_EQ(mesh.create_face(std::array{Vertex(0), Vertex(2), Vertex(1)}).index, 0u);
  EXPECT_EQ(mesh.create_face(std::array{Vertex(0), Vertex(1), Vertex(5)}).index, 2u);
}

TEST(MeshTest, FindsEdgesByHashSetWithoutAdjacency) {
  Mesh mesh(zoo::torus(40, 30));
  mesh.set(1, 0);
  ASSERT_FALSE(mesh.stored(0, 1));
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    EXPECT_EQ(mesh.find_edge(b, a), e);
  }
  EXPECT_FALSE(mesh.find_edge(Vertex(0), Vertex(600)).valid());
  EXPECT_LT(mesh.hash(1).statistics().worst, 12u);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(EntityHashTest, GrowsTenfoldWhenCrowdedAndStaysConsistent) {
  EntityHash hash;
  hash.build(0);
  const std::uint32_t n = 5000;
  for (std::uint32_t i = 0; i < n; ++i) hash.insert(EntityHash::mix(i) + EntityHash::mix(i + 1), i);
  EXPECT_GE(hash.statistics().rehashes, 1u);
  EXPECT_LE(hash.statistics().crowded * 10, hash.statistics().used);
  for (std::uint32_t i = 0; i < n; i += 2) hash.erase(i);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t found = hash.find(EntityHash::mix(i) + EntityHash::mix(i + 1),
                                          [&](std::uint32_t e) { return e == i; });
    EXPECT_EQ(found, i % 2 ? i : no_index);
  }
  EXPECT_EQ(EntityHash::mix(1), 0x6e789e6aa1b965f4ull) << "keys must be the same on every platform";
}

TEST(AttachedTest, OneColumnGoesAndTheOthersStay) {
  Mesh mesh(zoo::square());
  mesh.attached<Vertex, double>("heat", 1.0);
  mesh.attached<Vertex, double>("mass", 2.0);
  EXPECT_TRUE(mesh.drop_attached(0, "heat"));
  ASSERT_EQ(mesh.attached(0).size(), 1u);
  EXPECT_EQ(mesh.attached(0)[0]->name(), "mass");
}

TEST(AttachedTest, ValuesGoWithTheirEntitiesWhenIdsAreClosedUp) {
  Mesh mesh(zoo::square());
  auto& heat = mesh.attached<Vertex, double>("heat", 0.0);
  for (const Vertex v : mesh.vertices()) heat[v] = 10.0 + v.index;
  mesh.destroy(Face(0));
  mesh.destroy(Vertex(1));
  (void)mesh.compact();
  ASSERT_EQ(mesh.capacity(0), 3u);
  EXPECT_EQ(heat[Vertex(0)], 10);
  EXPECT_EQ(heat[Vertex(1)], 12);
  EXPECT_EQ(heat[Vertex(2)], 13);
}

TEST(EntityHashTest, CountsWhatIsLeft) {
  EntityHash set;
  set.build(61);
  for (std::uint32_t id = 0; id < 20; ++id) set.insert(7, id);
  EXPECT_GT(set.statistics().crowded, 0u);
  for (std::uint32_t id = 0; id < 20; ++id) set.erase(id);
  EXPECT_EQ(set.statistics().used, 0u);
  EXPECT_EQ(set.statistics().crowded, 0u);
}

TEST(ClassListsTest, NameNoModelEntityThatNothingLiesOn) {
  Mesh mesh(zoo::square());
  mesh.set_classification(Face(0), ModelRef(2, 1));
  mesh.keep_class_lists(true);
  mesh.set_classification(Face(0), ModelRef(2, 2));
  EXPECT_EQ(mesh.class_lists()->models(2), (std::vector<ModelRef>{ModelRef(2, 2), ModelRef()}));
}

TEST(ClassListsTest, FollowEveryEdit) {
  Mesh mesh(zoo::grid(3));
  mesh.keep_class_lists(true);
  mesh.set_classification(Face(0), ModelRef(2, 1));
  mesh.set_classification(Face(5), ModelRef(2, 1));
  EXPECT_EQ(mesh.class_lists()->entities(2, ModelRef(2, 1)).size(), 2u);
  EXPECT_EQ(mesh.class_lists()->entities(2, ModelRef()).size(), 16u);
  mesh.destroy(Face(0));
  EXPECT_EQ(ids(Row<2>(mesh.class_lists()->entities(2, ModelRef(2, 1)))), (Ids{5}));
  mesh.set(1, 0);
  EXPECT_EQ(mesh.class_lists()->models(1), (std::vector<ModelRef>{ModelRef(2, 1), ModelRef()}));
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, OfAnEdgeThatIsListedTwiceTheLastClassCounts) {
  MeshData data = zoo::square();
  data.edges.add(Shape::Line, {0, 1}, ModelRef(1, 1));
  data.edges.add(Shape::Line, {1, 0}, ModelRef(1, 2));
  data.edges.add(Shape::Line, {0, 1}, ModelRef());
  Mesh mesh(data);
  mesh.set(1, 0);
  EXPECT_EQ(mesh.count(1), 5u);
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(1))), ModelRef(1, 2));
}

TEST(MeshTest, NothingTellsOfADeletedFace) {
  Mesh mesh(zoo::square());
  mesh.set(0, 2);
  mesh.build_hash(2);
  mesh.destroy(Face(0));
  for (const std::uint32_t v : {0u, 2u, 3u}) EXPECT_EQ(ids(mesh.row<2>(Vertex(v))), (Ids{1}));
  EXPECT_TRUE(mesh.row<2>(Vertex(1)).empty());
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, RowsThatAreBuiltNameNoDeletedFace) {
  Mesh mesh(zoo::square());
  mesh.destroy(Face(0));
  mesh.set(0, 2);
  EXPECT_EQ(ids(mesh.row<2>(Vertex(0))), (Ids{1}));
  EXPECT_TRUE(mesh.row<2>(Vertex(1)).empty());
}

// The new sides run the other way than those that they replace.
TEST(MeshTest, AFaceThatStretchesUsesItsNewSidesAsTheyRun) {
  Mesh mesh(zoo::triangle());
  mesh.set(2, 1);
  ASSERT_TRUE(mesh.use_direction(Face(0), mesh.find_edge(Vertex(0), Vertex(1))));
  const Vertex far = mesh.create_vertex({2, 0, 0});
  const Edge from = mesh.create_edge(far, Vertex(0)), to = mesh.create_edge(Vertex(2), far);
  mesh.rebind(std::array{Rebinding{Face(0), 1, Vertex(1), far}});
  EXPECT_FALSE(mesh.use_direction(Face(0), from));
  EXPECT_FALSE(mesh.use_direction(Face(0), to));
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, ACompactedMeshKeepsItsRelations) {
  Mesh mesh(zoo::two_tets());
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i != j) mesh.set(i, j);
  (void)mesh.compact();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) EXPECT_EQ(mesh.stored(i, j), i != j) << i << ' ' << j;
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(MeshTest, IterationSurvivesDeletionAndCreation) {
  Mesh mesh(zoo::grid(4));
  int visited = 0;
  for (const Face f : mesh.faces()) {
    ++visited;
    if (f.index + 1 < mesh.capacity(2) && mesh.alive(Face(f.index + 1)))
      mesh.destroy(Face(f.index + 1));
  }
  EXPECT_EQ(visited, 16);
  EXPECT_EQ(mesh.count(2), 16u);
}

TEST(MeshTest, ToDataMakesIdsConsecutiveAndKeepsUnusedVertices) {
  Mesh mesh(zoo::bow_tie());
  mesh.destroy(Face(0));
  mesh.destroy(Vertex(1));
  const MeshData data = to_data(mesh);
  EXPECT_EQ(data.positions.size(), 5u);
  EXPECT_EQ(data.faces.vertices, (Ids{0, 2, 3}));
}

TEST(MeshTest, ToDataListsNoEdgeThatFacesImply) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  const Vertex far = mesh.create_vertex({9, 9, 9});
  mesh.create_edge(Vertex(3), far);
  mesh.set_classification(mesh.find_edge(Vertex(0), Vertex(1)), ModelRef(1, 7));
  EXPECT_EQ(mesh.count(1), 6u);
  const MeshData data = to_data(mesh);
  EXPECT_EQ(data.edges.classes, (std::vector<ModelRef>{ModelRef(1, 7), ModelRef()}));
  EXPECT_EQ((Ids{data.edges.vertices.end() - 2, data.edges.vertices.end()}), (Ids{3, 4}))
      << "one that no face uses is";
}

}  // namespace
}  // namespace aomd::mesh_test
