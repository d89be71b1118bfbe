// What lights up around the selected entity: which entities, on which path, in which look.

#include <gtest/gtest.h>

#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::scene::neighbours_test {
namespace {

using test::drive;
using Entities = std::vector<EntityRef>;

Entities of_level(int level, std::initializer_list<std::uint32_t> ids) {
  Entities result;
  for (const std::uint32_t id : ids) result.emplace_back(level, id);
  return result;
}

Edge edge(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  for (const Edge e : mesh.edges()) {
    const auto ends = mesh.edge_vertices(e);
    if (ends == std::array{Vertex(a), Vertex(b)} || ends == std::array{Vertex(b), Vertex(a)})
      return e;
  }
  return {};
}

TEST(Neighbours, AStoredRowIsOneStep) {
  Mesh mesh(zoo::square());
  mesh.set(0, 2);
  const Neighbours n = find_neighbours(mesh, Vertex(0), 2);
  EXPECT_TRUE(n.known && n.stored());
  EXPECT_EQ(n.entities, of_level(2, {0, 1}));
  EXPECT_TRUE(n.between.empty());
  EXPECT_EQ(n.words, "T(0,2) stored: one row");
  EXPECT_EQ(find_neighbours(mesh, Vertex(1), 2).entities, of_level(2, {0}));
}

TEST(Neighbours, ADerivedOneNamesItsPathAndWhatLiesOnIt) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  mesh.set(1, 2);
  const Neighbours n = find_neighbours(mesh, Vertex(1), 2);
  EXPECT_TRUE(n.known);
  EXPECT_FALSE(n.stored());
  EXPECT_EQ(n.words, "T(0,2) derived: 0 -> 1 -> 2 (union of rows)");
  EXPECT_EQ(n.entities, of_level(2, {0}));
  Entities between{EntityRef(edge(mesh, 0, 1)), EntityRef(edge(mesh, 1, 2))};
  std::sort(between.begin(), between.end());
  EXPECT_EQ(n.between, between);
}

TEST(Neighbours, FacesOfAnEdgeThroughItsVertices) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  mesh.set(0, 2);
  const Edge diagonal = edge(mesh, 0, 2);
  const Neighbours n = find_neighbours(mesh, diagonal, 2);
  EXPECT_EQ(n.entities, of_level(2, {0, 1}));
  EXPECT_EQ(n.between, of_level(0, {0, 2}));
  EXPECT_EQ(n.words, "T(1,2) derived: 1 -> 0 -> 2 (what has it as a side)");
}

TEST(Neighbours, WhereNothingLeadsItSaysWhatToStore) {
  Mesh mesh(zoo::square());
  const Neighbours n = find_neighbours(mesh, Vertex(0), 2);
  EXPECT_FALSE(n.known);
  EXPECT_TRUE(n.entities.empty());
  EXPECT_EQ(n.remedy, "adjacency 0 2 on");
  EXPECT_NE(n.words.find("store T(0,2)"), std::string::npos) << n.words;
  EXPECT_EQ(find_neighbours(mesh, Vertex(0), 3).words, "T(0,3): there are no regions");
  EXPECT_TRUE(find_neighbours(mesh, Vertex(0), 3).remedy.empty());
  EXPECT_FALSE(find_neighbours(mesh, Vertex(0), 0).known) << "T has no diagonal";
}

TEST(Neighbours, LookingBuildsNoHashSet) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  mesh.set(2, 0);
  const Neighbours n = find_neighbours(mesh, Face(0), 1);
  EXPECT_FALSE(n.known);
  EXPECT_FALSE(mesh.hash(1).built());
  EXPECT_NE(n.words.find("hash set of the edges"), std::string::npos) << n.words;
  mesh.build_hash(1);
  const Neighbours now = find_neighbours(mesh, Face(0), 1);
  EXPECT_EQ(now.words, "T(2,1) derived: 2 -> 0 -> 1 (each side looked up by hash)");
  const Entities sides{EntityRef(edge(mesh, 0, 1)), EntityRef(edge(mesh, 1, 2)),
                       EntityRef(edge(mesh, 2, 0))};
  EXPECT_EQ(now.entities, sides);
  EXPECT_EQ(now.between, of_level(0, {0, 1, 2}));
}

TEST(Neighbours, StoredOnesAreSolidAndDerivedOnesAreDashed) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  mesh.set(2, 1);
  const glm::dvec3 origin(0);
  Overlay stored, derived;
  const Edge diagonal = edge(mesh, 0, 2);
  draw_entities(mesh, std::array{EntityRef(diagonal)}, stored_style(), origin, stored);
  draw_entities(mesh, std::array{EntityRef(diagonal)}, derived_style(), origin, derived);
  EXPECT_EQ(stored.lines.size(), 2u) << "a line on its rim";
  EXPECT_EQ(derived.lines.size(), 8u) << "four dashes, each on its rim";
  EXPECT_EQ(derived.lines[4].a, stored.lines[1].a);
  EXPECT_LT(glm::length(derived.lines[7].b - stored.lines[1].b), 1e-6f);
  Overlay all;
  draw_neighbours(mesh, find_neighbours(mesh, Vertex(0), 1), origin, all);
  EXPECT_EQ(all.discs.size(), 1u) << "the vertex itself";
  EXPECT_EQ(all.lines.size(), 6u);
}

TEST(Neighbours, FollowSelectionAndRelations) {
  Session s;
  drive(s, {"sample sphere 8", "neighbours face"});
  EXPECT_EQ(s.sheet().inquiry().neighbours(), nullptr);
  EXPECT_EQ(s.status, "Neighbours: select one entity to see what lies around it");
  drive(s, {"select vertex 30", "expect neighbours = 6"});
  EXPECT_TRUE(s.sheet().inquiry().neighbours()->stored());
  const std::size_t lit = s.sheet().drawing().drawable().preview.faces.size();
  EXPECT_EQ(lit, 18u);
  drive(s, {"neighbours edge", "adjacency 2 1 on", "select face 4"});
  EXPECT_TRUE(s.sheet().inquiry().neighbours()->stored());
  drive(s, {"adjacency 2 1 off", "expect neighbours = 3"});
  EXPECT_FALSE(s.sheet().inquiry().neighbours()->stored()) << "the change of T is seen at once";
  EXPECT_EQ(s.sheet().inquiry().facts()->adjacent[1].stored, false);
  drive(s, {"neighbours off"});
  EXPECT_EQ(s.sheet().inquiry().neighbours(), nullptr);
  EXPECT_EQ(s.sheet().drawing().drawable().preview.faces.size(), 0u);
  EXPECT_THROW(execute(s, "neighbours"), CommandError);
  EXPECT_THROW(execute(s, "neighbours node"), CommandError);
}

TEST(Neighbours, LookingChangesNoResult) {
  Session plain, looking;
  drive(plain, {"sample torus", "sweep", "run"});
  drive(looking, {"sample torus", "select vertex 3", "neighbours face", "sweep", "select edge 40",
                  "neighbours vertex", "run", "neighbours edge"});
  const Mesh &a = plain.document().mesh(), &b = looking.document().mesh();
  ASSERT_EQ(a.count(2), b.count(2));
  for (const Face f : a.faces()) ASSERT_EQ(a.triangle(f), b.triangle(f));
  for (int level = 0; level < 3; ++level) EXPECT_EQ(a.ids(level), b.ids(level));
  EXPECT_EQ(stored_bits(a), stored_bits(b));
}

}  // namespace
}  // namespace aomd::scene::neighbours_test
