#pragma once
// Which vertices edges join, without edges: what fields on vertices are smoothed and limited along.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/base/raw_vector.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// The neighbours of every vertex: the other ends of its edges, each once however many faces have
/// the edge. Edges are the sides of faces and regions, and listed ones; whether level 1 holds them
/// makes no difference. A copy: it does not follow edits. O(entities), 4 bytes a side while it is
/// made.
class VertexNeighbours {
 public:
  explicit VertexNeighbours(const Mesh& mesh);

  /// In no particular order.
  [[nodiscard]] std::span<const std::uint32_t> of(Vertex v) const {
    return {all_.data() + begin_[v.index], all_.data() + end_[v.index]};
  }

 private:
  std::vector<std::size_t> begin_, end_;
  RawVector<std::uint32_t> all_;
};

/// The mean length of the edges at each vertex (paper, section 3); 0 where there are none.
/// O(edges).
[[nodiscard]] Column<Vertex, double> average_edge_lengths(const Mesh& mesh,
                                                          const VertexNeighbours& neighbours);

/// The box of the vertices that have edges. O(vertices).
[[nodiscard]] Box box_of_used(const Mesh& mesh, const VertexNeighbours& neighbours);

/// Lowers what grows too fast: afterwards `values[a] <= values[b] + growth * |ab|` holds for each
/// edge, to the last bit, and no field between this one and the old one does. Values are at least 0
/// and may be infinite. The smallest value that is too small for a neighbour goes first (Dijkstra):
/// O(edges + n log n), n the vertices that take part. Throws std::invalid_argument unless growth is
/// at least 0.
void limit_growth(const Mesh& mesh, const VertexNeighbours& neighbours, double growth,
                  Column<Vertex, double>& values);

}  // namespace aomd
