// The normals of all corners at once are those of each vertex, bit by bit.

#include <gtest/gtest.h>

#include "core/samples/samples.h"
#include "tests/support/session_helpers.h"
#include "viewer/drawing/corner_normals.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/packed_normals.h"

namespace aomd::scene::packed_normals_test {
namespace {

using test::drive;

/// At how many corners the normals stand that the vertices there have, one by one.
void expect_those_of_each_vertex(const Mesh& mesh, const std::string& what) {
  const std::vector<std::uint32_t> packed = pack_normals(mesh, 64);
  ASSERT_EQ(packed.size(), 3 * std::size_t{mesh.capacity(2)});
  CornerNormals normals;
  std::size_t corners = 0;
  for (const Vertex v : mesh.vertices())
    for (const CornerNormals::Corner& c : normals.at(mesh, v)) {
      ++corners;
      ASSERT_EQ(packed[3 * std::size_t{c.face.index} + c.slot], pack_normal(c.normal))
          << what << ": face " << c.face.index << ", corner " << c.slot;
    }
  EXPECT_EQ(corners, 3 * std::size_t{mesh.count(2)}) << what;
}

TEST(PackedNormals, AreThoseOfEachVertex) {
  for (const SampleInfo& sample : samples()) {
    Session s;
    drive(s, {"sample " + std::string(sample.name)});
    if (s.document().content().skin) continue;
    expect_those_of_each_vertex(s.document().mesh(), std::string(sample.name));
    drive(s, {"step 40"});
    expect_those_of_each_vertex(s.document().mesh(), std::string(sample.name) + " with gaps");
  }
}

TEST(PackedNormals, ThreeFacesAtAnEdgeAndFacesWithoutAreaAreNoExceptions) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0.1}, {0, 0, 1}, {2, 0, 0}};
  for (const auto& [a, b, c] : std::initializer_list<std::array<std::uint32_t, 3>>{
           {0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 1, 5}})
    mesh.faces.add(Shape::Triangle, {a, b, c});
  const auto loaded = make_loaded(mesh, "fan");
  expect_those_of_each_vertex(loaded->mesh, "fan");
}

}  // namespace
}  // namespace aomd::scene::packed_normals_test
