#include "core/blocks/block_cut.h"

#include "core/base/box.h"
#include "core/parts/hilbert_grid.h"

namespace aomd {

BlockCut::BlockCut(const io::StreamedSurface& surface, std::size_t blocks)
    : place_(surface.vertices(), 0), faces_(blocks, 0) {
  if (blocks > 1) share_out(surface, blocks);
  find_seams(surface);
}

void BlockCut::share_out(const io::StreamedSurface& surface, std::size_t blocks) {
  constexpr int bits = 7;  // a side has 128 cells: some thousands of them for each of many blocks
  Box box;
  surface.each_vertices([&](std::uint32_t, std::span<const glm::dvec3> positions) {
    for (const glm::dvec3& p : positions) box.add(p);
  });
  const HilbertGrid grid(box, bits);
  std::vector<std::uint32_t> block(grid.cells(), 0);
  surface.each_vertices([&](std::uint32_t, std::span<const glm::dvec3> positions) {
    for (const glm::dvec3& p : positions) ++block[grid.place(p)];
  });
  cut_into_pieces(block, surface.vertices(), blocks);
  surface.each_vertices([&](std::uint32_t first, std::span<const glm::dvec3> positions) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      place_[first + i] = static_cast<std::uint16_t>(2 * block[grid.place(positions[i])]);
  });
}

void BlockCut::find_seams(const io::StreamedSurface& surface) {
  surface.each_faces([&](std::uint32_t, std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles) {
      if (is_of(block_of(t[0]), t)) ++faces_[block_of(t[0])];
      if (!is_of_strip(t)) continue;
      for (const std::uint32_t v : t) place_[v] |= 1;
    }
  });
}

}  // namespace aomd
