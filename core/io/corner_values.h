#pragma once
// Values on the corners of faces, where they are one for each vertex and where they are not.

#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// Appends an array on corners to those on vertices where all corners of each vertex have the same
/// bits; vertices without corners then have NaN. Returns whether it did. Linear.
bool move_to_vertices(const Attribute& on_corners, MeshData& mesh);

/// An array on corners as a list without repetitions, and which of it each corner has: no_index
/// where it has NaN.
struct IndexedValues {
  int components = 0;
  std::vector<double> numbers;
  std::vector<std::uint32_t> corners;
};

/// Of an array on corners, or on vertices, whose order then is that of the list.
[[nodiscard]] IndexedValues indexed(const Attribute& array, bool on_corners, const MeshData& mesh);

}  // namespace aomd::io::detail
