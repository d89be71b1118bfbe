#pragma once
// Where tiles of one surface touch.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/vertex_ranks.h"
#include "core/io/streamed_file.h"

namespace aomd::io::detail {

/// Vertices of tiles are numbered on from tile to tile. Those on borders of several tiles, at the
/// same place, are one: the first of them stands for all. A place at which one tile has two of them
/// stays as it is.
class TileBorders {
 public:
  TileBorders() : replaced_(0) {}
  /// `first` has the number of each tile's first vertex, and the number of all. Once through each
  /// tile; in memory are 24 B a face of one tile, 40 B a border vertex and 1.5 bits a vertex.
  TileBorders(const StreamedFiles& tiles, std::span<const std::uint32_t> first);

  /// Which vertex stands for one.
  [[nodiscard]] std::uint32_t of(std::uint32_t v) const {
    return by_.empty() || !replaced_.has(v) ? v : by_[replaced_.rank(v)];
  }

 private:
  struct Place {
    glm::dvec3 position;
    std::uint32_t vertex = 0;
    std::uint32_t tile = 0;
  };
  using Replacements = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  static void add_borders(const StreamedFile& tile, std::uint32_t number, std::uint32_t first,
                          std::vector<Place>& places);
  static void join(std::span<const Place> at_one, Replacements& replacements);

  VertexRanks replaced_;
  std::vector<std::uint32_t> by_;  ///< by rank
};

}  // namespace aomd::io::detail
