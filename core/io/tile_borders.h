#pragma once
// Where tiles of one surface touch.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/vertex_ranks.h"
#include "core/io/streamed_file.h"
#include "core/io/tile_weld.h"

namespace aomd::io::detail {

/// Vertices of tiles are numbered on from tile to tile. Those on borders of several tiles, at the
/// same place or within a tolerance, are one: the first of them stands for all. Two of one tile
/// never are: a place at which one tile has two of them stays as it is.
class TileBorders {
 public:
  TileBorders() : replaced_(0) {}
  /// `first` has the number of each tile's first vertex, and the number of all. Once through each
  /// tile; in memory are 24 B a face of one tile, 40 B a border vertex and 1.5 bits a vertex. With
  /// a tolerance the nearest two go first, and no vertex further than that to the one that stands
  /// for it; throws LimitError where hundreds are within it around each.
  TileBorders(const StreamedFiles& tiles, std::span<const std::uint32_t> first, double tolerance);

  /// Which vertex stands for one.
  [[nodiscard]] std::uint32_t of(std::uint32_t v) const {
    return by_.empty() || !replaced_.has(v) ? v : by_[replaced_.rank(v)];
  }

 private:
  using Places = std::vector<TilePlace>;
  using Replacements = TileReplacements;
  static void add_borders(const StreamedFile& tile, std::uint32_t number, std::uint32_t first,
                          Places& places);

  VertexRanks replaced_;
  std::vector<std::uint32_t> by_;  ///< by rank
};

}  // namespace aomd::io::detail
