#pragma once
// Which regions have given vertices: whether a face lies between two, outside, or is none's side.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/mesh/mesh.h"

namespace aomd {

/// How many regions have all of these vertices; stops at `most`. T(0,3) must be stored. O(regions
/// at the vertex that has fewest).
[[nodiscard]] std::size_t count_regions_with(const Mesh& mesh,
                                             std::span<const std::uint32_t> vertices,
                                             std::size_t most);

}  // namespace aomd
