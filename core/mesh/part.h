#pragma once
// Some of a mesh as a mesh of its own.

#include <span>

#include "core/mesh/mesh.h"

namespace aomd {

/// The faces and regions among `entities` as plain arrays, with the vertices that they use and the
/// edges and faces that bound them where those lie on a model entity of their own dimension;
/// everything keeps its class and its order. Attached data stay behind. Edges and faces need
/// complete levels and a way to them (core/mesh/derive.h), else they are left out. O(size of the
/// part, n log n).
[[nodiscard]] MeshData part_of(const Mesh& mesh, std::span<const EntityRef> entities);

}  // namespace aomd
