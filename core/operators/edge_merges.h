#pragma once
// What becomes of the edges around the vertex that a collapse deletes.

#include <vector>

#include "core/operators/collapse_rules.h"
#include "core/operators/star.h"
#include "core/operators/vertex_marks.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Finds which edges at a deleted vertex stretch to the kept one and which fall together with an
/// edge there, and ends those. Holds scratch, so that a sweep allocates nothing.
class EdgeMerges {
 public:
  explicit EdgeMerges(const Mesh& mesh) : edge_to_kept_(mesh.capacity(0)) {}

  /// Looks at the edges of both ends and appends those that stretch to `rebindings`, in descending
  /// order: rows are sorted, so that each leaves the deleted vertex's row at its end. `stars` are
  /// of use where T(0,1) is not stored.
  void find(const Mesh& mesh, const Contraction& c, const std::array<Star, 2>& stars,
            VertexMarks& marks, std::vector<Rebinding>& rebindings);
  /// Destroys the edges that fell together with others, which take the lower classification.
  /// Nothing may use them any more.
  void merge(Mesh& mesh) const;
  /// The edge between the ends, where it is an entity.
  [[nodiscard]] Edge collapsed() const { return collapsed_; }

 private:
  struct Merge {
    Edge gone, survivor;
  };
  void mark_edges(const Mesh& mesh, Vertex kept, const Star& star, VertexMarks& marks);

  Column<Vertex, Edge> edge_to_kept_;  ///< of marked vertices
  std::vector<Merge> merges_;
  Edge collapsed_;
};

}  // namespace aomd

#pragma GCC visibility pop
