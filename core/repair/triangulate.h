#pragma once
// Quads into triangles, for what works on triangles alone.

#include <cstddef>

#include "core/mesh/mesh_data.h"

namespace aomd {

/// Cuts each quad of a surface along the shorter of its diagonals that fold nothing over; both
/// triangles get its class and its values. Returns the number of quads. Linear.
std::size_t triangulate_quads(MeshData& mesh);

}  // namespace aomd
