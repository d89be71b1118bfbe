#pragma once
// The normals of all corners of a surface at once.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// pack_normal() of what CornerNormals says of each corner: three for each face id. The mesh must
/// store T(0,1), T(0,2) and T(2,0). On several threads, in pieces of `items_a_piece` entities.
[[nodiscard]] std::vector<std::uint32_t> pack_normals(const Mesh& mesh, std::size_t items_a_piece);

}  // namespace aomd::scene
