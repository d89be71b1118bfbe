#pragma once
// Vertices in colours, of which no two with the same share a face: each colour can be looked at as a whole.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd {

/// Some vertices of a mesh, by colour and in each by id. Greedy: the vertices have their turn in the order of
/// ids, and each takes the first colour that no vertex beside it has; about seven on a surface.
class Colouring {
 public:
  Colouring() = default;
  /// The vertices that `wanted` names. T(0,2) and T(2,0) must be stored, all faces be triangles. O(vertices +
  /// faces).
  Colouring(const Mesh& mesh, const std::function<bool(Vertex)>& wanted);

  [[nodiscard]] std::size_t colours() const { return ends_.size(); }
  [[nodiscard]] std::span<const Vertex> vertices(std::size_t colour) const {
    const std::size_t begin = colour > 0 ? ends_[colour - 1] : 0;
    return std::span(vertices_).subspan(begin, ends_[colour] - begin);
  }

 private:
  std::vector<Vertex> vertices_;
  std::vector<std::size_t> ends_;  ///< by colour
};

}  // namespace aomd
