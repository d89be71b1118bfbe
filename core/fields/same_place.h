#pragma once
// What of a result lies exactly where something of its original lay.

#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/cells.h"
#include "core/mesh/handle.h"

namespace aomd::fields {

/// The vertices of a result, and those of its original that lie exactly there.
class SameVertices {
 public:
  /// O(n log n).
  SameVertices(const MeshData& original, const MeshData& result);

  /// All of the original at the place of a vertex of the result, ascending: several where parts
  /// touch without being joined.
  [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t vertex) const {
    return std::span(sorted_).subspan(first_[vertex], count_[vertex]);
  }
  /// The only one, or no_index.
  [[nodiscard]] std::uint32_t only(std::uint32_t vertex) const {
    return count_[vertex] == 1 ? sorted_[first_[vertex]] : no_index;
  }

 private:
  std::vector<std::uint32_t> sorted_;         ///< the original's that may have one there, by place
  std::vector<std::uint32_t> first_, count_;  ///< of each vertex of the result
};

/// For each entity of the result the one of the original that has its vertices and its shape, or
/// no_index. Expected O(n).
[[nodiscard]] std::vector<std::uint32_t> same_cells(const Cells& original, const Cells& result,
                                                    const SameVertices& vertices);

}  // namespace aomd::fields
