#pragma once
// Python's Database: a mesh with its history.

#include <memory>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_data.h"

namespace aomd::python {

/// Not movable: the mesh and its journal hold on to each other.
struct HeldMesh {
  explicit HeldMesh(const MeshData& data) : mesh(data) {}

  Mesh mesh;
  Journal journal;

  /// The entity of that id. Throws std::out_of_range where it is not alive.
  [[nodiscard]] EntityRef at(int dimension, std::uint32_t id) const;
  /// The journal. Throws std::logic_error where nothing is recorded.
  [[nodiscard]] Journal& recorded();
};

}  // namespace aomd::python
