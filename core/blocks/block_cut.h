#pragma once
// A surface that need not fit into memory, cut into blocks that do.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/io/streamed_surface.h"

namespace aomd {

/// Vertices belong to blocks: pieces, of about equal numbers of them, of a Hilbert curve through
/// the box of the surface. A face with all corners in one block is that block's; all others make up
/// the strip between blocks, whose vertices lie on the seam. Faces with a corner twice belong to
/// nobody: whole readers drop them. It follows from the surface alone.
class BlockCut {
 public:
  static constexpr std::size_t most_blocks = 1 << 15;

  /// Three times through the vertices, once through the faces. Holds two bytes a vertex.
  BlockCut(const io::StreamedSurface& surface, std::size_t blocks);

  using Triangle = io::StreamedSurface::Triangle;
  [[nodiscard]] std::size_t count() const { return faces_.size(); }
  [[nodiscard]] std::size_t block_of(std::uint32_t vertex) const { return place_[vertex] >> 1; }
  [[nodiscard]] bool on_seam(std::uint32_t vertex) const { return (place_[vertex] & 1u) != 0; }
  [[nodiscard]] bool is_of(std::size_t block, const Triangle& t) const {
    return block_of(t[0]) == block && is_inside(t) && has_three_corners(t);
  }
  [[nodiscard]] bool is_of_strip(const Triangle& t) const {
    return !is_inside(t) && has_three_corners(t);
  }
  /// How many faces a block has.
  [[nodiscard]] std::size_t faces(std::size_t block) const { return faces_[block]; }

 private:
  void share_out(const io::StreamedSurface& surface, std::size_t blocks);
  void find_seams(const io::StreamedSurface& surface);
  [[nodiscard]] static bool has_three_corners(const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  }
  [[nodiscard]] bool is_inside(const Triangle& t) const {
    return block_of(t[0]) == block_of(t[1]) && block_of(t[1]) == block_of(t[2]);
  }

  std::vector<std::uint16_t> place_;  ///< by vertex: twice the block, plus one on the seam
  std::vector<std::size_t> faces_;
};

}  // namespace aomd
