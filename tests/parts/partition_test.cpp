// A surface in parts: what follows from the mesh alone, and where the seams are.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/operators/collapse.h"
#include "core/parts/hilbert.h"
#include "core/parts/partition.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::partition_test {
namespace {

TEST(HilbertTest, GoesThroughAllCellsStepByStep) {
  constexpr int bits = 4;
  constexpr std::uint32_t side = 1u << bits;
  std::vector<std::array<int, 3>> cells(side * side * side, {-1, -1, -1});
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z)
        cells.at(hilbert_place({x, y, z}, bits)) = {int(x), int(y), int(z)};
  EXPECT_EQ(cells[0], (std::array<int, 3>{0, 0, 0}));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    int steps = 0;
    for (std::size_t k = 0; k < 3; ++k) steps += std::abs(cells[i][k] - cells[i - 1][k]);
    ASSERT_EQ(steps, 1) << i;
  }
}

Mesh torus(std::uint32_t n = 90, std::uint32_t m = 60) {
  Mesh mesh(zoo::torus(n, m));
  mesh.set(2, 0), mesh.set(0, 2);
  return mesh;
}

std::set<std::size_t> parts_around(const Mesh& mesh, const Partition& parts, Vertex v) {
  std::set<std::size_t> all;
  for (const Face f : mesh.row<2>(v))
    for (const Vertex w : mesh.triangle(f)) all.insert(parts.part_of(w));
  return all;
}

TEST(PartitionTest, EqualPartsAndTheirSeams) {
  const Mesh mesh = torus();
  for (const int cut : {0, 1, 2}) {
    const Partition parts(mesh, 8, cut);
    std::array<int, 8> sizes{};
    for (const Vertex v : mesh.vertices()) {
      ++sizes.at(parts.part_of(v));
      EXPECT_EQ(parts.on_seam(v), parts_around(mesh, parts, v).size() > 1) << v.index;
    }
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    EXPECT_GT(*least, 640) << cut;  // of 675
    EXPECT_LT(*most, 710) << cut;
  }
}

// Two vertices of one tetrahedron are neighbours, whether a face lists them or not.
TEST(PartitionTest, SeamsOfAVolumeRunThroughItsRegions) {
  Mesh mesh(make_sample("tet-ball", 10));
  mesh.set(3, 0), mesh.set(0, 3);
  Partition parts(mesh, 6);
  int inside = 0;
  for (const Vertex v : mesh.vertices()) {
    std::set<std::size_t> around;
    for (const Region r : mesh.row<3>(v))
      for (const Vertex w : mesh.tetrahedron(r)) around.insert(parts.part_of(w));
    ASSERT_EQ(parts.on_seam(v), around.size() > 1) << v.index;
    inside += around.size() == 1;
  }
  EXPECT_GT(inside, int(mesh.count(0)) / 4);
  EXPECT_LT(inside, int(mesh.count(0)));
}

// So that what lies on the seams of one cut lies inside the parts of the next.
TEST(PartitionTest, SeamsOfTwoCutsHaveLittleInCommon) {
  const Mesh mesh = torus(300, 200);
  const Partition first(mesh, 8, 0), second(mesh, 8, 1);
  int seam = 0, both = 0;
  for (const Vertex v : mesh.vertices()) {
    seam += first.on_seam(v);
    both += first.on_seam(v) && second.on_seam(v);
  }
  EXPECT_LT(8 * both, seam);
}

TEST(PartitionTest, OnePartHasNoSeam) {
  const Mesh mesh = torus();
  const Partition one(mesh, 1);
  for (const Vertex v : mesh.vertices()) {
    EXPECT_EQ(one.part_of(v), 0u);
    EXPECT_FALSE(one.on_seam(v));
  }
  EXPECT_EQ(Partition().count(), 1u);
}

TEST(PartitionTest, ThreadsMakeNoDifference) {
  const Mesh mesh(zoo::torus(300, 200));
  const Partition one(mesh, 5, 1, 1), many(mesh, 5, 1, 7);
  for (const Vertex v : mesh.vertices()) {
    ASSERT_EQ(one.part_of(v), many.part_of(v));
    ASSERT_EQ(one.on_seam(v), many.on_seam(v));
  }
}

TEST(PartitionTest, AMeshInOnePointAndAnEmptyOneHaveParts) {
  MeshData data = zoo::octahedron();
  for (glm::dvec3& p : data.positions) p = {1, 2, 3};
  const Mesh point(data);
  const Partition parts(point, 4);
  for (const Vertex v : point.vertices()) EXPECT_LT(parts.part_of(v), 4u);
  EXPECT_EQ(Partition(Mesh(), 4).count(), 4u);
}

TEST(PartitionTest, ACollapseAcrossASeamMovesIt) {
  Mesh mesh = torus();
  Partition parts(mesh, 8);
  mesh.set(0, 1);
  Collapser collapser(mesh);
  int across = 0;
  for (std::uint32_t id = 0; id < mesh.capacity(1); id += 7) {
    const Edge e(id);
    if (!mesh.alive(e)) continue;
    const auto [deleted, kept] = mesh.edge_vertices(e);
    if (parts.part_of(deleted) == parts.part_of(kept)) continue;
    CollapsePlan plan;
    if (!collapser.judge(mesh, e, deleted, {.max_turn = TurnLimit(90)}, plan).accepted()) continue;
    collapser.apply(mesh, plan);
    parts.joined(mesh, kept);
    ++across;
  }
  EXPECT_GT(across, 20);
  for (const Vertex v : mesh.vertices())
    EXPECT_TRUE(parts.on_seam(v) || parts_around(mesh, parts, v).size() == 1) << v.index;
}

TEST(PartitionTest, HowManyPartsAMeshIsWorth) {
  EXPECT_EQ(part_count(Mesh(zoo::torus(200, 499))), 1u);  // 199,600 faces
  EXPECT_EQ(part_count(Mesh(zoo::torus(200, 500))), 4u);  // 200,000
  EXPECT_EQ(part_count(Mesh(zoo::torus(300, 500))), 6u);  // 300,000
}

}  // namespace
}  // namespace aomd::partition_test
