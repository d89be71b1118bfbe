#pragma once
// Some edges of a mesh, looked up from their vertices: where few are meant, T(0,1) costs more.

#include <span>
#include <vector>

#include "core/base/buckets.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// Answers as the mesh does, as if there were no other edges. Valid until the next edit.
class SomeEdges {
 public:
  /// `edges` ascending. O(edges + vertices).
  SomeEdges(const Mesh& mesh, std::vector<Edge> edges)
      : mesh_(&mesh), edges_(std::move(edges)), at_(mesh.capacity(0), [&](auto&& file) {
          for (const Edge e : edges_)
            for (const Vertex v : mesh.edge_vertices(e)) file(v.index, e);
        }) {}

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  template <int J>
  [[nodiscard]] std::span<const Edge> row(Vertex v) const {
    static_assert(J == 1);
    return at_[v.index];
  }
  [[nodiscard]] Vertex other_end(Edge e, Vertex v) const { return mesh_->other_end(e, v); }
  [[nodiscard]] const glm::dvec3& position(Vertex v) const { return mesh_->position(v); }

 private:
  const Mesh* mesh_;
  std::vector<Edge> edges_;
  Buckets<Edge> at_;
};

}  // namespace aomd
