// Existence queries against ids chosen to hurt them.

#include "core/mesh/entity_hash.h"

#include <gtest/gtest.h>

#include <array>

#include "core/mesh/verify.h"
#include "tests/support/zoo.h"

namespace aomd::entity_hash_test {
namespace {

using Ids = std::vector<std::uint32_t>;

TEST(EntityHashTest, KeysAreTheSameOnEveryPlatform) {
  EXPECT_EQ(EntityHash::mix(0), 0xe220a8397b1dcdafull);
  EXPECT_EQ(EntityHash::mix(1), 0x6e789e6aa1b965f4ull);
  EXPECT_EQ(EntityHash::mix(0xfffffffeu), 0xfbd912d21ced44a9ull);
  EXPECT_EQ(EntityHash::key(Ids{0, 1}), 0x509946a41cd733a3ull);
  EXPECT_EQ(EntityHash::key(Ids{7, 3, 5}), 0x11db6aefafe1d012ull);
  EXPECT_EQ(EntityHash::key(Ids{5, 7, 3}), EntityHash::key(Ids{3, 5, 7}));
  EXPECT_EQ(EntityHash::key(Ids{1, 2, 3, 4}), 0x89023d95e5b7a1caull);
}

/// Pairs of vertices whose edges would all lie in one bucket of a table of this size.
std::vector<std::array<Vertex, 2>> colliding(std::uint32_t vertex_count, std::uint32_t buckets,
                                             std::size_t n) {
  std::vector<std::array<Vertex, 2>> pairs;
  for (std::uint32_t a = 0; a < vertex_count && pairs.size() < n; ++a)
    for (std::uint32_t b = a + 1; b < vertex_count && pairs.size() < n; ++b)
      if (EntityHash::key(Ids{a, b}) % buckets == 7) pairs.push_back({Vertex(a), Vertex(b)});
  return pairs;
}

TEST(EntityHashTest, EdgesMadeToCollideAreFoundAllTheSame) {
  Mesh mesh;
  mesh.set(1, 0);
  constexpr std::uint32_t vertex_count = 600;  // the last two are left out
  for (std::uint32_t k = 0; k < vertex_count; ++k) (void)mesh.create_vertex({k, 0, 0});
  (void)mesh.create_edge(Vertex(598), Vertex(599));
  (void)mesh.find_edge(Vertex(0), Vertex(1));
  const std::uint32_t first_size = mesh.hash(1).statistics().buckets;
  const auto pairs = colliding(vertex_count - 2, first_size, 2000);
  ASSERT_EQ(pairs.size(), 2000u);
  std::vector<Edge> made;
  for (const auto& [a, b] : pairs) made.push_back(mesh.create_edge(a, b));
  const EntityHash::Statistics after = mesh.hash(1).statistics();
  EXPECT_GE(after.rehashes, 1u);
  EXPECT_GE(after.buckets, 10 * first_size);
  EXPECT_LE(10 * after.crowded, after.used);
  EXPECT_GT(after.used, 100u);
  EXPECT_LT(after.worst, 40u);
  for (const Edge e : made) {
    const auto [a, b] = mesh.edge_vertices(e);
    ASSERT_EQ(mesh.find_edge(b, a), e);
  }
  for (std::size_t k = 0; k < made.size(); k += 2) mesh.destroy(made[k]);
  for (std::size_t k = 0; k < made.size(); ++k) {
    const auto& [a, b] = pairs[k];
    ASSERT_EQ(mesh.find_edge(a, b), k % 2 ? made[k] : Edge()) << k;
  }
  EXPECT_TRUE(verify(mesh).empty());
  for (const Edge e : mesh.edges()) mesh.destroy(e);
  EXPECT_EQ(mesh.hash(1).statistics().used, 0u);
  EXPECT_EQ(mesh.hash(1).statistics().worst, 0u);
}

TEST(EntityHashTest, EqualKeysDoNotFillTheMemory) {
  MeshData data = zoo::triangle();
  for (int k = 0; k < 50; ++k)
    data.faces.add(Shape::Triangle, {0, 1, 2});  // as dirty files have them
  const Mesh mesh(data);
  EXPECT_EQ(mesh.find_face(std::array{Vertex(2), Vertex(1), Vertex(0)}), Face(0))
      << "the smallest id of several";
  EXPECT_LT(mesh.hash(2).bytes(), 1u << 20) << "no table helps against equal keys";
}

}  // namespace
}  // namespace aomd::entity_hash_test
