#pragma once
// A set of vertices that is emptied in no time.

#include <cstdint>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Marks that operators put on the neighbours of a vertex; emptied between any two uses, without
/// touching the vertices that had one.
class VertexMarks {
 public:
  explicit VertexMarks(const Mesh& mesh) : stamps_(mesh.capacity(0), 0) {}

  /// Nothing is marked any more; there is room for every vertex of the mesh.
  void clear(const Mesh& mesh) {
    if (stamps_.size() < mesh.capacity(0)) stamps_.resize(mesh.capacity(0), 0);
    if (++now_ != 0) return;
    stamps_.assign(stamps_.size(), 0);
    now_ = 1;
  }
  void set(Vertex v) { stamps_[v] = now_; }
  [[nodiscard]] bool has(Vertex v) const { return stamps_[v] == now_; }

 private:
  Column<Vertex, std::uint32_t> stamps_;  ///< == now_ for those that are marked
  std::uint32_t now_ = 0;
};

}  // namespace aomd

#pragma GCC visibility pop
