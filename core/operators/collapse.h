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

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/star.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Safe: a collapse must keep the topology (link condition). Paper: as printed, without that check.
enum class TopologyRule : std::uint8_t { Safe, Paper };

struct CollapseRules {
  TurnLimit max_turn{10.0};  ///< how far the normal of a stretched face may turn
  TopologyRule topology = TopologyRule::Safe;
  /// How far a model edge may turn where it is collapsed along itself; no part of the paper's loop,
  /// so for Safe only. On a flat sheet no normal would ever stop a round hole from becoming a
  /// triangle.
  TurnLimit max_curve_turn{45.0};
  /// By vertex, what the original surface around it looked like, any length, or 0; where given,
  /// contractions hold the faces that they stretch against the sum at their corners too: small
  /// turns add up.
  const Column<Vertex, glm::vec3>* original_normals = nullptr;
  TurnLimit max_away{60.0};   ///< from that sum
  LeastAngle least_angle{0};  ///< no stretched face gets a smaller one, unless it had one
  /// Nor a smaller one than this, unless some face around the same end had: slivers may go by way
  /// of others.
  LeastAngle least_around{0};
};

/// A collapse that may also move the vertex it keeps.
struct Contraction {
  Vertex deleted, kept;
  glm::dvec3 position;  ///< where the kept one goes
};

/// Judges and applies edge collapses on one mesh; holds the scratch space, so that a sweep
/// allocates nothing. The mesh must store T(0,2) and T(2,0), and hold triangles only. T(0,1) must
/// be stored too unless its edges are those on model edges and no others; judging and applying by
/// an Edge needs T(0,1).
class Collapser {
 public:
  explicit Collapser(const Mesh& mesh);

  /// What collapsing `edge` by deleting its end `deleted` would do. O(faces around both ends).
  /// Checks in this order: classification, topology, flat faces, turned normals. Topology also
  /// where an end is crowded.
  [[nodiscard]] Verdict judge(const Mesh& mesh, Edge edge, Vertex deleted,
                              const CollapseRules& rules);

  /// The same for both ends that `may_go` names (in the edge's order), with the work that they
  /// share done once. Returns the first acceptance, whose end is put in `deleted`, else the refusal
  /// that got furthest.
  [[nodiscard]] Verdict judge_either(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                                     const CollapseRules& rules, Vertex& deleted);

  /// Makes the collapse, whatever a verdict would say, provided the result is a mesh at all: the
  /// faces of the edge go, the others around `deleted` are stretched to the kept end, and edges
  /// that fall together become one that keeps the lower classification. One journal step.
  void apply(Mesh& mesh, Edge edge, Vertex deleted);

  /// The same right after judge_either() has accepted, on a mesh that has not changed since: saves
  /// looking again.
  void apply_accepted(Mesh& mesh, Edge edge, Vertex deleted);

  /// Another look at an edge, by its ends and with a place for the kept one: `kept` moves to
  /// `position` and the faces of both stretch. Classification: the edge lies on what the deleted
  /// end lies on, and on what the kept one lies on if that moves. Then topology, flat faces, turned
  /// normals, and with Safe the turn of a model edge. The edges of the mesh may be entities, or
  /// only those on model edges (see for_edges_at).
  [[nodiscard]] Verdict judge(const Mesh& mesh, const Contraction& contraction,
                              const CollapseRules& rules);

  /// Makes it, right after judge() has accepted it on a mesh that has not changed since. One
  /// journal step.
  void apply_accepted(Mesh& mesh, const Contraction& contraction);

  /// The faces around the vertex that the last apply() deleted, as they were before; after judging
  /// a contraction, those around the end that would go (0) and the end that would stay (1).
  [[nodiscard]] const Star& star(std::size_t end = 0) const { return stars_[end]; }

 private:
  void next_stamp(const Mesh& mesh);
  void mark_neighbours(Vertex kept, const Star& star);
  void mark_edges(const Mesh& mesh, Vertex kept);
  [[nodiscard]] bool marked(Vertex v) const { return mark_[v] == stamp_; }
  [[nodiscard]] Verdict judge_topology(const Mesh& mesh, EntityRef edge,
                                       const std::array<Vertex, 2>& ends);
  [[nodiscard]] bool gather_apexes(const Star& star, Vertex other_end);
  [[nodiscard]] std::uint64_t apex_bit(Vertex v) const;
  [[nodiscard]] bool stay_together(const std::array<Vertex, 2>& ends) const;
  [[nodiscard]] bool keeps_fans(const std::array<Vertex, 2>& ends) const;
  [[nodiscard]] bool leaves_bare_edge(const std::array<Vertex, 2>& ends, Vertex apex) const;
  /// One end of the edge on its way; the faces that also use the other end fall away.
  struct Move {
    Vertex vertex, other;
    glm::dvec3 to;
  };
  [[nodiscard]] static Verdict judge_geometry(const Mesh& mesh, const Star& star, const Move& move,
                                              const CollapseRules& rules);
  [[nodiscard]] static Verdict judge_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                           const Contraction& contraction, const TurnLimit& limit);
  [[nodiscard]] static Verdict judge_rest_of_curve(const Mesh& mesh, const Star& star,
                                                   ModelRef model, const Contraction& contraction,
                                                   const TurnLimit& limit);
  void make(Mesh& mesh, Vertex deleted, Vertex kept);
  void plan(const Mesh& mesh, Vertex deleted, Vertex kept);
  void merge_edges(Mesh& mesh);
  void destroy_bare_edges(Mesh& mesh, Vertex kept);

  std::array<Star, 2> stars_;           ///< of the edge's two ends
  std::vector<Vertex> apexes_;          ///< third vertices of the edge's faces
  Column<Vertex, std::uint32_t> mark_;  ///< == stamp_ for the neighbours of the kept vertex
  Column<Vertex, Edge> edge_to_kept_;   ///< of vertices marked by mark_edges()
  std::uint32_t stamp_ = 0;
  struct Merge {
    Edge gone, survivor;
  };
  Edge collapsed_;  ///< the edge between the ends, where it is an entity
  std::vector<Merge> merges_;
  std::vector<Rebinding> rebindings_;
  std::vector<Vertex> bare_;  ///< apexes whose merged edge is left without a face
};

}  // namespace aomd
