// A file cut into blocks: what belongs to whom follows from the file alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/vertex_ranks.h"
#include "core/blocks/block_cut.h"
#include "core/io/io.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::block_cut_test {
namespace {

TEST(BlockCutTest, EqualBlocksAndTheStripBetweenThem) {
  const test::TemporaryFolder folder;
  const MeshData mesh = make_sample("scan", 20'000);
  io::write(folder / "a.ply", mesh);
  const io::StreamedSurface surface(folder / "a.ply");
  const BlockCut cut(surface, 8);
  ASSERT_EQ(cut.count(), 8u);

  std::vector<std::size_t> vertices(8, 0), faces(8, 0);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) ++vertices.at(cut.block_of(v));
  for (const std::size_t n : vertices) EXPECT_NEAR(double(n), mesh.positions.size() / 8.0, 100);

  std::set<std::uint32_t> seam;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto* t = &mesh.faces.vertices[3 * f];
    const BlockCut::Triangle triangle{t[0], t[1], t[2]};
    const std::set<std::size_t> blocks{cut.block_of(t[0]), cut.block_of(t[1]), cut.block_of(t[2])};
    const bool inside = blocks.size() == 1;
    EXPECT_EQ(cut.is_of_strip(triangle), !inside);
    for (std::size_t b = 0; b < 8; ++b)
      EXPECT_EQ(cut.is_of(b, triangle), inside && blocks.contains(b));
    if (inside)
      ++faces[*blocks.begin()];
    else
      seam.insert(t, t + 3);
  }
  EXPECT_FALSE(seam.empty());
  for (std::size_t b = 0; b < 8; ++b) EXPECT_EQ(cut.faces(b), faces[b]);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(cut.on_seam(v), seam.contains(v)) << v;
}

TEST(BlockCutTest, OneBlockHasNoSeam) {
  const test::TemporaryFolder folder;
  io::write(folder / "a.ply", make_sample("torus", 20));
  const BlockCut cut(io::StreamedSurface(folder / "a.ply"), 1);
  EXPECT_FALSE(cut.is_of_strip({0, 1, 2}));
  EXPECT_FALSE(cut.on_seam(0));
  EXPECT_EQ(cut.faces(0), make_sample("torus", 20).faces.size());
}

// Two corners in one block, and the third again one of them: no face, and no seam.
TEST(BlockCutTest, AFaceWithACornerTwiceIsNobodys) {
  const test::TemporaryFolder folder;
  const std::string faces = {3, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  std::ofstream(folder / "a.ply", std::ios::binary)
      << "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty uchar x\n"
         "property uchar y\nproperty uchar z\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n"
      << std::string{0, 0, 0, 9, 9, 9} << faces;
  const BlockCut cut(io::StreamedSurface(folder / "a.ply"), 2);
  ASSERT_NE(cut.block_of(0), cut.block_of(1));
  EXPECT_FALSE(cut.is_of_strip({0, 1, 1}));
  EXPECT_FALSE(cut.is_of(cut.block_of(1), {1, 1, 1}));
  EXPECT_FALSE(cut.on_seam(0) || cut.on_seam(1));
  EXPECT_EQ(cut.faces(0) + cut.faces(1), 0u);
}

TEST(VertexRanksTest, NumbersItsMembersInOrder) {
  VertexRanks ranks(200);
  const std::vector<std::uint32_t> members{0, 5, 63, 64, 127, 130, 199};
  for (const std::uint32_t v : members) ranks.add(v), ranks.add(v);
  ranks.finish();
  EXPECT_EQ(ranks.count(), members.size());
  for (std::uint32_t v = 0, n = 0; v < 200; ++v) {
    const bool member = std::binary_search(members.begin(), members.end(), v);
    EXPECT_EQ(ranks.has(v), member) << v;
    if (member) {
      EXPECT_EQ(ranks.rank(v), n++) << v;
    }
  }
}

}  // namespace
}  // namespace aomd::block_cut_test
