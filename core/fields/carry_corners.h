#pragma once
// Values on the corners of faces go along with operations on a surface.

#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::fields {

/// The arrays of the original's corners at those of the result. A face that has not changed keeps
/// its values; another one lies on the chart of the original (the faces that hang together without
/// a seam) on which its middle lies, and each of its corners has the value at the nearest place of
/// that chart which can be reached from beside the corner, inside the face, without crossing a
/// seam. The same for any number of threads. O(n log n).
[[nodiscard]] std::vector<Attribute> carried_corners(const MeshData& original,
                                                     const MeshData& result, int threads);

}  // namespace aomd::fields
