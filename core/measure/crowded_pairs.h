#pragma once
// Pairs of triangles that may meet, in about O(n log n) also where thousands have a corner in
// common.

#include <cstdint>
#include <functional>
#include <span>

#include "core/model/triangle_tree.h"

namespace aomd::measure {

/// True where more than 256 of the triangles may have a corner in common, so that most pairs of
/// boxes touch there. O(n); places are told apart by a hash, so that it may err on the safe side.
[[nodiscard]] bool crowded(std::span<const Triangle> triangles);

/// Calls visit(i, j) once for every pair that may have more in common than a corner or an edge, and
/// for some others; on several threads at once where `threads` allows. Triangles at a crowded
/// corner are told apart by the directions in which they leave it, and those at a crowded edge by
/// the half plane in which they lie. Coordinates must be finite, all triangles have area. Quadratic
/// in the copies of one triangle: leave only one of them.
void crowded_pairs(std::span<const Triangle> triangles, int threads,
                   const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace aomd::measure
