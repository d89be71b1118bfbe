// T(0,2) of a volume with the faces that are listed, and no others (Mesh::request_listed).

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "tests/support/message.h"
#include "tests/support/volume_mesh.h"
#include "tests/support/zoo.h"

namespace aomd::listed_level_test {
namespace {

using test::vertices;

// Two tetrahedra above and below the triangle 0 1 2; only that one and one of the outside are
// listed.
MeshData two_tets_and_two_faces() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, ModelRef(3, 1));
  data.regions.add(Shape::Tetrahedron, {0, 2, 1, 4}, ModelRef(3, 2));
  data.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 7));
  data.faces.add(Shape::Triangle, {0, 1, 3}, ModelRef(2, 8));
  return data;
}

std::vector<std::uint32_t> faces_at(const Mesh& mesh, std::uint32_t v) {
  const auto row = mesh.row<2>(Vertex(v)).indices();
  return {row.begin(), row.end()};
}

using Ids = std::vector<std::uint32_t>;

TEST(ListedLevelTest, HasTheFacesThatAreListed) {
  Mesh mesh(two_tets_and_two_faces());
  const Request rows = mesh.request_listed(0, 2);
  EXPECT_EQ(mesh.count(2), 2u);
  EXPECT_FALSE(mesh.complete(2));
  EXPECT_EQ(faces_at(mesh, 0), (Ids{0, 1}));
  EXPECT_EQ(faces_at(mesh, 2), (Ids{0}));
  EXPECT_EQ(faces_at(mesh, 4), Ids{});
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(ListedLevelTest, FollowsEdits) {
  Mesh mesh(two_tets_and_two_faces());
  const Request rows = mesh.request_listed(0, 2), regions = mesh.request(0, 3);
  const Face made = mesh.create_face(vertices({0, 1, 4}), ModelRef(2, 9));
  EXPECT_EQ(faces_at(mesh, 4), Ids{made.index});
  mesh.destroy_unused(Face(0));
  EXPECT_EQ(faces_at(mesh, 0), (Ids{1, made.index}));
  const Vertex far = mesh.create_vertex({0, 0, -2});
  const std::vector<Rebinding> stretched{{made, 2, Vertex(4), far}, {Region(1), 3, Vertex(4), far}};
  mesh.rebind(stretched);
  EXPECT_EQ(faces_at(mesh, 4), Ids{});
  EXPECT_EQ(faces_at(mesh, far.index), Ids{made.index});
  EXPECT_EQ(mesh.row<3>(far).size(), 1u);
  EXPECT_EQ(mesh.tetrahedron(Region(1))[3], far);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(ListedLevelTest, GrowsWhenTheLevelIsCompleted) {
  Mesh mesh(two_tets_and_two_faces());
  const Request rows = mesh.request_listed(0, 2);
  mesh.set(3, 2);
  EXPECT_TRUE(mesh.complete(2));
  EXPECT_EQ(mesh.count(2), 7u);
  EXPECT_EQ(faces_at(mesh, 0).size(), 5u);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(ListedLevelTest, IsOfRelationsWithVerticesOnly) {
  Mesh mesh(two_tets_and_two_faces());
  EXPECT_EQ(test::message([&] { (void)mesh.request_listed(1, 2); }),
            "T(1,2) is between sides, of which levels must be complete");
}

TEST(ListedLevelTest, UndoRestoresIt) {
  Mesh mesh(two_tets_and_two_faces());
  const Request rows = mesh.request_listed(0, 2), regions = mesh.request(0, 3);
  Journal journal;
  mesh.attach(&journal);
  const std::string before = zoo::fingerprint(mesh);
  mesh.destroy_unused(Face(0));
  const std::vector<Rebinding> stretched{{Region(1), 3, Vertex(4), Vertex(3)}};
  mesh.rebind(stretched);
  journal.undo(mesh);
  journal.undo(mesh);
  EXPECT_EQ(zoo::fingerprint(mesh), before);
  EXPECT_EQ(faces_at(mesh, 2), Ids{0});
  mesh.attach(nullptr);
}

TEST(ListedLevelTest, IsNotCompletedUnderAHistoryThatWouldNotKnowIt) {
  Mesh mesh(two_tets_and_two_faces());
  Journal journal;
  mesh.attach(&journal);
  mesh.move(Vertex(4), {0, 0, -2});
  EXPECT_EQ(test::message([&] { mesh.set(3, 2); }),
            "the faces that this relation needs would not be part of the journal's history: "
            "request it before the first edit, or clear the journal");
  EXPECT_EQ(mesh.count(2), 2u);
  mesh.attach(nullptr);
}

TEST(ListedLevelTest, FacesInsideRegionsAreLetGoOf) {
  MeshData data = two_tets_and_two_faces();
  data.faces.classes[0] = ModelRef(3, 1);
  Mesh mesh(data);
  mesh.set(3, 2);
  mesh.set(0, 2);
  ASSERT_EQ(mesh.count(2), 7u);
  mesh.keep_model_faces_only();
  EXPECT_FALSE(mesh.complete(2) || mesh.stored(3, 2) || mesh.stored(0, 2));
  ASSERT_EQ(mesh.count(2), 1u);
  EXPECT_EQ(mesh.classification(Face(0)), ModelRef(2, 8));
  EXPECT_EQ(mesh.triangle(Face(0)), (std::array{Vertex(0), Vertex(1), Vertex(3)}));
  EXPECT_TRUE(verify(mesh).empty());
  mesh.set(3, 2);
  EXPECT_EQ(mesh.count(2), 7u) << "they come back when T asks for them";
}

}  // namespace
}  // namespace aomd::listed_level_test
