// A file cut into blocks: what belongs to whom follows from the file alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/blocks/block_cut.h"
#include "core/blocks/vertex_ranks.h"
#include "core/io/io.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd {
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

  std::vector<BlockCut::Triangle> strip;
  std::set<std::uint32_t> seam;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto* t = &mesh.faces.vertices[3 * f];
    const std::set<std::size_t> blocks{cut.block_of(t[0]), cut.block_of(t[1]), cut.block_of(t[2])};
    if (blocks.size() == 1) {
      ++faces[*blocks.begin()];
    } else {
      strip.push_back({t[0], t[1], t[2]});
      seam.insert(t, t + 3);
    }
  }
  EXPECT_EQ(cut.strip(), strip);
  EXPECT_FALSE(strip.empty());
  for (std::size_t b = 0; b < 8; ++b) EXPECT_EQ(cut.faces(b), faces[b]);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(cut.on_seam(v), seam.contains(v)) << v;
}

TEST(BlockCutTest, OneBlockHasNoSeam) {
  const test::TemporaryFolder folder;
  io::write(folder / "a.ply", make_sample("torus", 20));
  const BlockCut cut(io::StreamedSurface(folder / "a.ply"), 1);
  EXPECT_TRUE(cut.strip().empty());
  EXPECT_FALSE(cut.on_seam(0));
  EXPECT_EQ(cut.faces(0), make_sample("torus", 20).faces.size());
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
}  // namespace aomd
