// Mesh::keep_model_edges_only: level 1 without the edges that lie on the same model entity as what
// is around them, and back.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/classify_volume.h"
#include "core/samples/samples.h"
#include "tests/support/message.h"
#include "tests/support/zoo.h"

namespace aomd::model_edges_test {
namespace {

using test::message;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

// The class of every edge that is an entity, by its ends: what is left of a mesh's edges without
// their ids.
std::map<Ends, ModelRef> classes_of_edges(const Mesh& mesh) {
  std::map<Ends, ModelRef> all;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    all[std::minmax(a.index, b.index)] = mesh.classification(e);
  }
  return all;
}

// What level 1 would be after completing it again, on a mesh of its own so that this one stays as
// it is.
std::map<Ends, ModelRef> completed(Mesh& mesh) {
  const Request edges = mesh.request(0, 1);
  EXPECT_TRUE(mesh.complete(1));
  EXPECT_TRUE(verify(mesh).empty());
  return classes_of_edges(mesh);
}

void expect_silent(const Mesh& mesh, const std::string& what) {
  const auto findings = verify(mesh);
  EXPECT_TRUE(findings.empty()) << what << ": " << findings[0].name << ": " << findings[0].text;
}

//  6--7--8      24 sides become entities; the 8 of the border lie on model edges, 0 2 8 6 being
//  | /| /|      model vertices, and the 8 inside on the model face
//  3--4--5
//  | /| /|
//  0--1--2
TEST(ModelEdgesTest, OfASheetTheBorderIsLeft) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  const auto before = completed(mesh);
  ASSERT_EQ(before.size(), 16u);
  mesh.keep_model_edges_only();
  const auto left = classes_of_edges(mesh);
  EXPECT_EQ(mesh.count(1), 8u);
  for (const Ends& side : {Ends{0, 1}, {1, 2}, {2, 5}, {5, 8}, {7, 8}, {6, 7}, {3, 6}, {0, 3}}) {
    ASSERT_EQ(left.count(side), 1u) << side.first << ' ' << side.second;
    EXPECT_EQ(left.at(side), before.at(side));
    EXPECT_EQ(left.at(side).dimension(), 1);
  }
  EXPECT_FALSE(mesh.find_edge(Vertex(0), Vertex(4)).valid());
  EXPECT_TRUE(mesh.find_edge(Vertex(5), Vertex(2)).valid());
  EXPECT_FALSE(mesh.complete(1));
  expect_silent(mesh, "sheet");
}

TEST(ModelEdgesTest, IdsBecomeConsecutiveInTheirOldOrder) {
  Mesh mesh(zoo::grid(3));
  classify(mesh);
  std::vector<Ends> order;
  for (const Edge e : mesh.edges())
    if (mesh.classification(e).dimension() <= 1) {
      const auto [a, b] = mesh.edge_vertices(e);
      order.emplace_back(a.index, b.index);
    }
  mesh.keep_model_edges_only();
  ASSERT_EQ(mesh.capacity(1), order.size());
  EXPECT_EQ(mesh.count(1), mesh.capacity(1));
  EXPECT_TRUE(mesh.ids(1).free_ids().empty());
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    EXPECT_EQ(Ends(a.index, b.index), order[e.index]);
  }
}

TEST(ModelEdgesTest, FreesTheRelationsOfEdgesAndNoOthers) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 1}, {0, 2}}) mesh.set(i, j);
  mesh.keep_model_edges_only();
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 1}})
    EXPECT_FALSE(mesh.stored(i, j)) << i << j;
  EXPECT_TRUE(mesh.stored(0, 2) && mesh.stored(2, 0) && mesh.stored(1, 0));
  {
    const Request faces = mesh.request(1, 2);
    EXPECT_TRUE(mesh.stored(1, 2));
  }
  EXPECT_FALSE(mesh.stored(1, 2)) << "the user's wish for it went too";
}

// Faces that only their edges define get their vertices first.
TEST(ModelEdgesTest, FacesKnownByTheirEdgesKeepTheirVertices) {
  Mesh mesh(zoo::grid(3));
  classify(mesh);
  std::vector<std::array<Vertex, 3>> before;
  for (const Face f : mesh.faces()) before.push_back(mesh.triangle(f));
  mesh.set(2, 1);
  mesh.unset(2, 0);
  ASSERT_FALSE(mesh.stored(2, 0));
  mesh.keep_model_edges_only();
  ASSERT_TRUE(mesh.stored(2, 0));
  EXPECT_FALSE(mesh.stored(2, 1));
  for (const Face f : mesh.faces()) {
    auto t = mesh.triangle(f);
    std::rotate(t.begin(), std::find(t.begin(), t.end(), before[f.index][0]), t.end());
    EXPECT_EQ(t, before[f.index]);
  }
  expect_silent(mesh, "by edges");
}

TEST(ModelEdgesTest, IsRefusedWhileSomethingNeedsTheEdges) {
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 1}}) {
    Mesh mesh(zoo::square());
    classify(mesh);
    mesh.set(0, 1);
    const std::string before = zoo::fingerprint(mesh);
    {
      const Request wanted = mesh.request(i, j);
      EXPECT_EQ(message([&] { mesh.keep_model_edges_only(); }),
                "an algorithm has requested edges, and would lose them");
    }
    EXPECT_EQ(zoo::fingerprint(mesh), before);
    EXPECT_TRUE(mesh.complete(1) && mesh.stored(0, 1)) << "a refusal changes nothing";
    EXPECT_NO_THROW(mesh.keep_model_edges_only());
  }
}

TEST(ModelEdgesTest, IsRefusedWhileAJournalIsAttached) {
  Mesh mesh(zoo::square());
  classify(mesh);
  Journal journal;
  mesh.attach(&journal);
  EXPECT_EQ(message([&] { mesh.keep_model_edges_only(); }),
            "a journal is attached, and its records name the present edges");
  EXPECT_EQ(mesh.count(1), 5u);
  mesh.attach(nullptr);
  mesh.keep_model_edges_only();
  EXPECT_EQ(mesh.count(1), 4u);
}

// Afterwards a history cannot bring the level back.
TEST(ModelEdgesTest, AHistoryStandsAgainstCompletingTheLevel) {
  Mesh mesh(zoo::square());
  classify(mesh);
  mesh.keep_model_edges_only();
  Journal journal;
  mesh.attach(&journal);
  mesh.move(Vertex(0), {-1, -1, 0});
  EXPECT_THROW(mesh.set(0, 1), std::logic_error);
  EXPECT_EQ(mesh.count(1), 4u);
  EXPECT_FALSE(mesh.complete(1));
  journal.undo(mesh);
  journal.clear();
  mesh.set(0, 1);
  EXPECT_EQ(mesh.count(1), 5u);
}

TEST(ModelEdgesTest, ClassListsAndAttachedColumnsFollow) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  mesh.keep_class_lists(true);
  auto& number = mesh.attached<Edge, int>("number", -1);
  std::map<Ends, int> before;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    before[std::minmax(a.index, b.index)] = number[e] = 10 * static_cast<int>(e.index) + 3;
  }
  mesh.keep_model_edges_only();
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    EXPECT_EQ(number[e], before.at(std::minmax(a.index, b.index)));
  }
  expect_silent(mesh, "lists");
  mesh.set(0, 1);
  const Edge again = mesh.find_edge(Vertex(0), Vertex(4));
  EXPECT_EQ(number[again], -1) << "an edge that came back is a new one";
  expect_silent(mesh, "lists, completed");
}

TEST(ModelEdgesTest, DeletedEdgesLeaveNoHole) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  mesh.destroy_with_users(mesh.find_edge(Vertex(0), Vertex(1)));
  ASSERT_LT(mesh.count(1), mesh.capacity(1));
  mesh.keep_model_edges_only();
  EXPECT_EQ(mesh.count(1), mesh.capacity(1));
  EXPECT_EQ(mesh.count(1), 7u);
  expect_silent(mesh, "deleted");
}

TEST(ModelEdgesTest, TwiceIsOnce) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  mesh.keep_model_edges_only();
  const std::string once = zoo::fingerprint(mesh);
  mesh.keep_model_edges_only();
  EXPECT_EQ(zoo::fingerprint(mesh), once);
}

TEST(ModelEdgesTest, MeshesWithoutEdgesOrFaces) {
  Mesh empty;
  empty.keep_model_edges_only();
  EXPECT_EQ(empty.count(1), 0u);
  expect_silent(empty, "empty");
  Mesh listed(zoo::square());  // no edge is an entity yet
  listed.keep_model_edges_only();
  EXPECT_EQ(listed.count(1), 0u);
  expect_silent(listed, "no edges");
  EXPECT_EQ(completed(listed).size(), 5u);
}

// An edge that is a side of nothing cannot come back from anything.
TEST(ModelEdgesTest, AnEdgeOfNoFaceStays) {
  MeshData data = zoo::square();
  data.positions.emplace_back(2, 2, 0);
  data.edges.add(Shape::Line, {2, 4});
  Mesh mesh(data);
  mesh.set(0, 1);
  ASSERT_EQ(mesh.count(1), 6u);
  mesh.keep_model_edges_only();
  EXPECT_TRUE(mesh.find_edge(Vertex(2), Vertex(4)).valid());
  EXPECT_EQ(completed(mesh).size(), 6u);
}

// An edge on another model face than the face around it breaks no rule that is checked, but is not
// told apart.
TEST(ModelEdgesTest, AnEdgeOnAnotherModelFaceComesBackOnThatOfItsFace) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  for (const Face f : mesh.faces()) mesh.set_classification(f, ModelRef(2, 1));
  for (const Edge e : mesh.edges()) mesh.set_classification(e, ModelRef(2, 1));
  const auto before = classes_of_edges(mesh);
  mesh.set_classification(mesh.find_edge(Vertex(0), Vertex(2)), ModelRef(2, 9));
  mesh.keep_model_edges_only();
  EXPECT_EQ(completed(mesh), before);
}

TEST(ModelEdgesTest, TheLevelComesBackAsItWas) {
  for (const zoo::Animal& animal : zoo::all()) {
    Mesh mesh(animal.data);
    classify(mesh);
    const auto before = completed(mesh);
    mesh.keep_model_edges_only();
    expect_silent(mesh, animal.name);
    for (const auto& [ends, model] : classes_of_edges(mesh)) {
      EXPECT_LE(model.dimension(), 1) << animal.name;
      EXPECT_EQ(model, before.at(ends)) << animal.name;
    }
    EXPECT_EQ(completed(mesh), before) << animal.name;
    expect_silent(mesh, animal.name + ", completed");
  }
}

TEST(ModelEdgesTest, TheLevelComesBackAsItWasInSamples) {
  for (const SampleInfo& sample : samples()) {
    Mesh mesh(make_sample(sample.name, sample.name == "scan" ? 2000 : 4));
    sample.dimension == 2 ? classify(mesh) : classify_volume(mesh, {});
    for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}}) mesh.set(i, j);
    const auto before = classes_of_edges(mesh);
    mesh.keep_model_edges_only();
    expect_silent(mesh, std::string(sample.name));
    EXPECT_LT(mesh.count(1), before.size()) << sample.name;
    EXPECT_EQ(completed(mesh), before) << sample.name;
  }
}

// Editing between: the level that comes back is that of the present faces.
TEST(ModelEdgesTest, AfterEditsTheLevelIsThatOfThePresentFaces) {
  Mesh mesh(zoo::grid(2));
  classify(mesh);
  mesh.keep_model_edges_only();
  mesh.destroy(mesh.find_face(std::array{Vertex(0), Vertex(1), Vertex(4)}));
  const Vertex tip = mesh.create_vertex({1, 1, 1}, ModelRef(2, 1));
  mesh.create_face(std::array{Vertex(0), Vertex(4), tip}, ModelRef(2, 1));
  EXPECT_EQ(mesh.count(1), 8u) << "an incomplete level gets no sides";
  EXPECT_EQ(completed(mesh).size(), 18u);  // 0-1 stays without a face
}

}  // namespace
}  // namespace aomd::model_edges_test
