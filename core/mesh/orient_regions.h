#pragma once
// Regions whose vertices are listed inside out.

#include <cstdint>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd {

/// Lists the vertices of regions that are inside out the other way round, each from the same first
/// one, and returns which regions these were, in ascending order. Two regions at a face are to see
/// it from opposite sides, and all that hang together by such faces as a whole are to have positive
/// volume: what stands inside out although it agrees with its neighbours is tangled, since a vertex
/// lies where it should not, and stays as it is. So does what no numbering would make agree. Faces
/// of three and more regions and of two that lie on one side join nothing. A look at each volume
/// where all are positive; else O(sides), sorted at each vertex.
std::vector<std::uint32_t> orient_regions(MeshData& mesh);

}  // namespace aomd
