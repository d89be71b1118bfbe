#pragma once
// How far a mesh reaches, and whether products of its lengths are numbers.

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_data.h"

namespace aomd {

/// Whether the box around what faces and regions use is from 1e-20 to 1e+18 across, or a point:
/// beyond, squared distances times areas are no numbers, some in single precision. Vertices that
/// nothing uses have no say. O(entities).
[[nodiscard]] bool has_usual_extent(const Mesh& mesh);

/// The diagonal of the box around what faces and regions use, as a length; 0 where there are none.
[[nodiscard]] double diagonal_of(const MeshData& mesh);

}  // namespace aomd
