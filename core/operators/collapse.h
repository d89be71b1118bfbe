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
  /// For each vertex the normal of the original surface around it, of any length, or 0. Where
  /// given, contractions hold the faces that they stretch against the sum at their corners too:
  /// small turns add up.
  const Column<Vertex, glm::vec3>* original_normals = nullptr;
  TurnLimit max_away{60.0};   ///< from the sum of original normals
  LeastAngle least_angle{0};  ///< no stretched face gets a smaller one, unless it had one
  /// No stretched face gets a smaller angle than this either, unless some face around the same end
  /// had one: slivers may go by way of others.
  LeastAngle least_around{0};
};

/// A collapse that may also move the vertex it keeps.
struct Contraction {
  Vertex deleted, kept;
  glm::dvec3 position;  ///< where the kept one goes
};

/// A collapse that was judged: what the verdict says, and what making it needs. Belongs to who
/// asks, and is reused from one judgement to the next: then it allocates nothing.
struct CollapsePlan {
  Verdict verdict;
  Contraction contraction;    ///< where it is accepted
  Edge edge;                  ///< that was judged; invalid where it was named by its ends
  std::array<Star, 2> stars;  ///< accepted: around the end that goes (0) and the one that stays (1)
  std::uint64_t revision = 0;  ///< of the mesh that was judged

  [[nodiscard]] const Star& around_deleted() const { return stars[0]; }
  [[nodiscard]] const Star& around_kept() const { return stars[1]; }
};

/// Judges and applies edge collapses on one mesh; holds marks, so that a sweep allocates nothing,
/// and nothing else from one call to the next. The mesh must store T(0,2) and T(2,0), and hold
/// triangles only. T(0,1) must be stored too unless its edges are those on model edges and no
/// others; judging and applying by an Edge needs T(0,1).
class Collapser {
 public:
  explicit Collapser(const Mesh& mesh);

  /// What collapsing `edge` would do, by deleting one of the ends that `may_go` names (in the
  /// edge's order): the first that is accepted, else the refusal that got furthest. O(faces around
  /// both ends). Checks in this order: classification, topology, flat faces, turned normals.
  /// Topology also where an end is crowded. The plan receives the verdict too.
  Verdict judge(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go, const CollapseRules& rules,
                CollapsePlan& plan);
  /// What collapsing `edge` by deleting its end `deleted` would do, judged in the same way.
  Verdict judge(const Mesh& mesh, Edge edge, Vertex deleted, const CollapseRules& rules,
                CollapsePlan& plan);

  /// Another look at an edge, by its ends and with a place for the kept one: `kept` moves to
  /// `position` and the faces of both stretch. Classification: the edge lies on what the deleted
  /// end lies on, and on what the kept one lies on if that moves. Then topology, flat faces, turned
  /// normals, and with Safe the turn of a model edge. The edges of the mesh may be entities, or
  /// only those on model edges (see for_edges_at).
  Verdict judge(const Mesh& mesh, const Contraction& contraction, const CollapseRules& rules,
                CollapsePlan& plan);

  /// Makes what was accepted. The mesh must not have changed since. One journal step.
  void apply(Mesh& mesh, const CollapsePlan& plan);

  /// Makes the collapse, whatever a verdict would say, provided the result is a mesh at all: the
  /// faces of the edge go, the others around `deleted` are stretched to the kept end, and edges
  /// that fall together become one that keeps the lower classification. One journal step.
  void apply(Mesh& mesh, Edge edge, Vertex deleted);

 private:
  using Ends = std::array<Vertex, 2>;
  using Stars = std::array<Star, 2>;
  void next_stamp(const Mesh& mesh);
  void mark_neighbours(Vertex kept, const Star& star);
  void mark_edges(const Mesh& mesh, Vertex kept, const Star& star);
  [[nodiscard]] bool marked(Vertex v) const { return mark_[v] == stamp_; }
  [[nodiscard]] Verdict judge_either(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                                     const CollapseRules& rules, CollapsePlan& plan);
  [[nodiscard]] Verdict judge_contraction(const Mesh& mesh, const Contraction& contraction,
                                          const CollapseRules& rules, Stars& stars);
  [[nodiscard]] Verdict judge_topology(const Mesh& mesh, EntityRef edge, const Ends& ends,
                                       const Stars& stars);
  [[nodiscard]] bool gather_apexes(const Star& star, Vertex other_end);
  [[nodiscard]] std::uint64_t apex_bit(Vertex v) const;
  [[nodiscard]] bool stay_together(const Ends& ends, const Stars& stars) const;
  [[nodiscard]] bool keeps_fans(const Ends& ends, const Stars& stars) const;
  [[nodiscard]] static bool leaves_bare_edge(const Ends& ends, const Stars& stars, Vertex apex);
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
  void make(Mesh& mesh, const Contraction& contraction, const Stars& stars);
  void find_edits(const Mesh& mesh, const Contraction& contraction, const Stars& stars);
  void merge_edges(Mesh& mesh);
  void destroy_bare_edges(Mesh& mesh, Vertex kept);

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
