#pragma once
// The edges of a surface, numbered for the paper's sweeps, where they are no entities.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/raw_vector.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/operators/link_condition.h"
#include "core/operators/swap.h"
#include "core/operators/vertex_marks.h"

namespace aomd {

/// Every edge of a surface of triangles, without wires: its ends, and which edges the sides of each
/// face are. Numbered, and their ends in the order, as completing level 1 of a mesh without listed
/// edges would have it; edits lead to what the entities would be, so that a sweep is the same. That
/// takes 24 bytes a face and little time, where T(1,0) and T(0,1) take 40 and their rows are kept
/// in order. Several threads may edit at once as long as SharedEdits lets them.
class SurfaceEdges {
 private:
  struct Merge {
    std::uint32_t gone, stays;
  };

 public:
  /// What one thread needs for that.
  class Scratch {
   private:
    friend class SurfaceEdges;
    std::vector<Merge> merges_;  ///< of the collapse that is about to be made
    std::optional<VertexMarks> marks_;
    Column<Vertex, std::uint32_t> edge_to_;    ///< of marked ones, the edge to whom they are around
    std::vector<std::uint64_t> edges_around_;  ///< a vertex: the number above, the other end below
    std::vector<Vertex> around_;
    std::vector<Edge> ended_;  ///< whose numbers are still alive
  };

  /// T(0,2) and T(2,0) must be stored. O(faces). The result does not depend on the number of
  /// threads.
  explicit SurfaceEdges(const Mesh& mesh, int threads = 1);

  [[nodiscard]] const IdPool& ids() const { return ids_; }
  /// Invalid ones where it has gone.
  [[nodiscard]] const EdgeEnds& ends(Edge e) const { return ends_[e.index]; }
  /// The edge between two vertices; invalid where no face joins them. O(faces around the one that
  /// has fewer).
  [[nodiscard]] Edge find(const Mesh& mesh, Vertex a, Vertex b) const;
  /// The other ends of the edges at a vertex, in ascending order of these. O(faces around it).
  [[nodiscard]] std::span<const Vertex> neighbours(const Mesh& mesh, Vertex v,
                                                   Scratch& scratch) const;
  /// The mean length of the edges at each vertex; 0 where there are none. O(edges).
  [[nodiscard]] Column<Vertex, double> average_lengths(const Mesh& mesh) const;

  /// A collapse that this rule allows, with these faces around the ends, is about to be made, or a
  /// swap. The numbers of edges that go stay alive until settle().
  void collapse(const Mesh& mesh, const Contraction& contraction, const StarPair& stars,
                TopologyRule topology, Scratch& scratch);
  void swap(const Mesh& mesh, const EdgePair& pair);
  void settle(Scratch& scratch);

 private:
  [[nodiscard]] std::uint32_t* sides(Face f) { return sides_.data() + 3 * std::size_t{f.index}; }
  [[nodiscard]] const std::uint32_t* sides(Face f) const {
    return sides_.data() + 3 * std::size_t{f.index};
  }
  [[nodiscard]] std::vector<EdgeEnds> number(const Mesh& mesh, std::size_t begin, std::size_t end);
  void join(const Mesh& mesh, const std::vector<std::vector<EdgeEnds>>& pieces, int threads);
  void merge_beside(const StarFace& gone, Vertex kept, Scratch& scratch);
  void merge_others(const Contraction& contraction, const Mesh& mesh, const StarPair& stars,
                    Scratch& scratch);
  void add_merge(Merge merge, Scratch& scratch);
  void stretch(std::uint32_t& side, const Contraction& contraction, const Scratch& scratch);
  void end(Edge e, Scratch& scratch);

  IdPool ids_;
  std::vector<EdgeEnds> ends_;
  RawVector<std::uint32_t> sides_;  ///< three a face; the k-th one joins its corners k and k + 1
};

}  // namespace aomd
