// Vertices of the boundary that lie on sides which they do not bound.

#include <gtest/gtest.h>

#include "core/measure/hanging_vertices.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::test::hanging_vertices_test {
namespace {

using measure::hanging_vertices;
using measure::Skin;

// One tetrahedron below the plane z = 0 and two above, which meet in the middle of an edge of its
// upper face.
//
//   2
//   | \          seen from above: the lower one has 0 1 2, the upper ones 0 1 3 and 0 3 2
//   |  3
//   | / \        split: so has the lower side
//   0----1
MeshData halves(bool split) {
  MeshData data;
  data.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 0, 2}, {0, 0, -2}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t tip) {
    data.regions.add(Shape::Tetrahedron, {a, b, c, tip});
  };
  add(0, 1, 3, 4);
  add(0, 3, 2, 4);
  if (split) {
    add(0, 3, 1, 5);
    add(0, 2, 3, 5);
  } else {
    add(0, 2, 1, 5);
  }
  return data;
}

std::vector<Vertex> both_ways(const MeshData& data) {
  const std::vector<Vertex> found = hanging_vertices(Mesh(data));
  Mesh mesh(data);
  classify(mesh);
  EXPECT_EQ(hanging_vertices(mesh, 3, Skin::Listed), found);
  return found;
}

TEST(HangingVertices, AreFoundWhereAFinerSideMeetsACoarserOne) {
  EXPECT_EQ(both_ways(halves(false)), std::vector<Vertex>{Vertex(3)});
  EXPECT_TRUE(both_ways(halves(true)).empty());
}

TEST(HangingVertices, LieOnASideWithinAMillionthOfItsDiameter) {
  MeshData data = halves(false);
  for (const auto& [off, hangs] : {std::pair{1e-6, true}, std::pair{1e-5, false}}) {
    data.positions[3].z = off;
    EXPECT_EQ(hanging_vertices(Mesh(data)).size(), hangs ? 1u : 0u) << off;
  }
}

TEST(HangingVertices, BodiesThatTouchWithVerticesOfTheirOwnAreNotJoined) {
  MeshData data = halves(true);
  const auto doubled = static_cast<std::uint32_t>(data.positions.size());
  for (std::uint32_t v = 0; v < 4; ++v) data.positions.push_back(data.positions[v]);
  for (std::size_t i = 8; i < 16; ++i)  // the lower two
    if (std::uint32_t& v = data.regions.vertices[i]; v < 4) v += doubled;
  EXPECT_EQ(both_ways(data).size(), 8u);
}

// Welding is told by itself: the doubled corners of the edge do not count.
TEST(HangingVertices, OfSurfacesAreThoseInsideOfBorderEdges) {
  const MeshData joined = zoo::make({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {2, 2, 0}},
                                    {{0, 1, 2}, {1, 4, 3}, {3, 4, 2}});
  EXPECT_EQ(hanging_vertices(Mesh(joined)), std::vector<Vertex>{Vertex(3)});
  const MeshData soup = zoo::make(
      {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_TRUE(hanging_vertices(Mesh(soup)).empty());
}

TEST(HangingVertices, NoSampleHasAny) {
  for (const SampleInfo& sample : samples()) {
    const MeshData data = make_sample(sample.name, sample.name == "scan" ? 2000 : 4);
    EXPECT_TRUE(both_ways(data).empty()) << sample.name;
  }
}

}  // namespace
}  // namespace aomd::test::hanging_vertices_test
