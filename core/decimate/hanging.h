#pragma once
// What hangs on a volume without being part of it.

#include <cstdint>
#include <memory>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

using KeptVertices = std::shared_ptr<const Column<Vertex, std::uint8_t>>;

/// The vertices that are kept already, none where it is null, and those of faces and edges that are
/// sides of no region: a collapse looks at tetrahedra alone and would lose these. The same pointer
/// where there are no such. T(0,3) must be stored. O(faces and model edges).
[[nodiscard]] KeptVertices keep_hanging(const Mesh& mesh, const KeptVertices& kept);

}  // namespace aomd
