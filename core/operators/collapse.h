#pragma once
// Edge collapse on surfaces (paper, section 3; there E_2Dcollapse_).
//
//        x                        x
//      / | \                      |\          .
//   y /  |  \                   y | \         .
//    | \ |   \     v onto w      \|  \        .
//    |   v----w   ---------->     `---w       .
//    | / |   /                   /|  /
//   z \  |  /                   z | /
//      \ | /                      |/
//        u                        u

#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Safe: a collapse must keep the topology (link condition). Paper: as printed, without that check.
enum class TopologyRule : std::uint8_t { Safe, Paper };

struct CollapseRules {
  TurnLimit max_turn{10.0};  ///< how far the normal of a stretched face may turn
  TopologyRule topology = TopologyRule::Safe;
};

/// Judges and applies edge collapses on one mesh; holds the scratch space, so that a sweep allocates nothing.
/// The mesh must store T(0,1), T(0,2) and T(2,0) (the last two rows of the paper's figure 2 for this loop).
class Collapser {
 public:
  explicit Collapser(const Mesh& mesh);

  /// What collapsing `edge` by deleting its end `deleted` would do. O(faces around both ends).
  /// Checks in this order: classification, topology, flat faces, turned normals.
  [[nodiscard]] Verdict judge(const Mesh& mesh, Edge edge, Vertex deleted, const CollapseRules& rules);

  /// Makes the collapse, whatever a verdict would say, provided the result is a mesh at all: the faces of the
  /// edge go, the others around `deleted` are stretched to the kept end, and edges that fall together become
  /// one that keeps the lower classification. One journal step.
  void apply(Mesh& mesh, Edge edge, Vertex deleted);

  /// The faces that the last judge() or apply() found around the deleted vertex: removed ones and stretched
  /// ones.
  struct StarFace {
    Face face;
    std::uint32_t slot;     ///< where the deleted vertex stands in the face
    Vertex next, previous;  ///< the other two, in the face's order
  };
  [[nodiscard]] const std::vector<StarFace>& removed() const { return removed_; }
  [[nodiscard]] const std::vector<StarFace>& stretched() const { return stretched_; }

 private:
  void gather(const Mesh& mesh, Vertex deleted, Vertex kept);
  void mark_neighbours(const Mesh& mesh, Vertex kept);
  [[nodiscard]] bool marked(Vertex v) const { return mark_[v] == stamp_; }
  [[nodiscard]] bool is_apex(Vertex v) const;
  [[nodiscard]] Verdict judge_topology(const Mesh& mesh, Vertex deleted, Vertex kept) const;
  [[nodiscard]] bool leaves_bare_edge(const Mesh& mesh, const StarFace& face, Vertex deleted,
                                      Vertex kept) const;
  [[nodiscard]] Verdict judge_geometry(const Mesh& mesh, Vertex deleted, Vertex kept,
                                       const TurnLimit& limit) const;
  void destroy_if_bare(Mesh& mesh, Vertex apex, Vertex kept);
  void plan_edges(const Mesh& mesh, Edge edge, Vertex deleted, Vertex kept);

  std::vector<StarFace> removed_, stretched_;
  Column<Vertex, std::uint32_t> mark_;  ///< == stamp_ for the neighbours of the kept vertex
  Column<Vertex, Edge> edge_to_kept_;   ///< of marked vertices
  std::uint32_t stamp_ = 0;
  struct Merge {
    Edge gone, survivor;
  };
  std::vector<Merge> merges_;
  std::vector<Rebinding> rebindings_;
};

}  // namespace aomd
