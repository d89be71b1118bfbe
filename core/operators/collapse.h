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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/operators/collapse_rules.h"
#include "core/operators/edge_merges.h"
#include "core/operators/link_condition.h"
#include "core/operators/star.h"
#include "core/operators/verdict.h"
#include "core/operators/vertex_marks.h"

#pragma GCC visibility push(default)

namespace aomd {

class SharedEdits;

/// A collapse that was judged: what the verdict says, and what making it needs. Belongs to who
/// asks, and is reused from one judgement to the next: then it allocates nothing.
struct CollapsePlan {
  Verdict verdict;
  Contraction contraction;  ///< where it is accepted
  Edge edge;                ///< that was judged; invalid where it was named by its ends
  StarPair stars;           ///< accepted: around the end that goes (0) and the one that stays (1)
  std::uint64_t revision = 0;  ///< of the mesh that was judged

  [[nodiscard]] const Star& around_deleted() const { return stars[0]; }
  [[nodiscard]] const Star& around_kept() const { return stars[1]; }
  /// How many faces it takes away.
  [[nodiscard]] std::size_t faces_gone() const {
    return static_cast<std::size_t>(
        std::count_if(stars[0].begin(), stars[0].end(),
                      [&](const StarFace& f) { return f.uses(contraction.kept); }));
  }
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
  /// The same for an edge that is known by its ends, which faces join: of the edges of the mesh
  /// those on model edges may be the only entities.
  Verdict judge(const Mesh& mesh, const EdgeEnds& ends, std::array<bool, 2> may_go,
                const CollapseRules& rules, CollapsePlan& plan);
  /// What collapsing `edge` would do by deleting its end `deleted`: the checks and the cost of the
  /// function above.
  Verdict judge(const Mesh& mesh, Edge edge, Vertex deleted, const CollapseRules& rules,
                CollapsePlan& plan);

  /// What a collapse named by its ends would do, with a place for the kept one: `kept` moves to
  /// `position` and the faces of both stretch. Checks in this order: classification (the edge lies
  /// on what the deleted end lies on, and on what the kept one lies on if that moves), topology,
  /// flat faces, turned normals, and with Safe the turn of a model edge. The edges of the mesh may
  /// be entities, or only those on model edges (see for_edges_at).
  Verdict judge(const Mesh& mesh, const Contraction& contraction, const CollapseRules& rules,
                CollapsePlan& plan);

  /// Makes what was accepted. The mesh must not have changed since. One journal step.
  void apply(Mesh& mesh, const CollapsePlan& plan);
  /// The same for one of several threads that edit at once: no edge at the ends may be an entity.
  void apply(const Mesh& mesh, SharedEdits& edits, const CollapsePlan& plan);

  /// Makes the collapse, whatever a verdict would say, provided the result is a mesh at all: the
  /// faces of the edge go, the others around `deleted` are stretched to the kept end, and edges
  /// that fall together become one that keeps the lower classification. One journal step.
  void apply(Mesh& mesh, Edge edge, Vertex deleted);

 private:
  [[nodiscard]] Verdict judge_either(const Mesh& mesh, const EdgeEnds& ends, ModelRef model,
                                     std::array<bool, 2> may_go, const CollapseRules& rules,
                                     CollapsePlan& plan);
  [[nodiscard]] Verdict judge_topology(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                                       ModelRef model, const StarPair& stars);
  [[nodiscard]] Verdict judge_contraction(const Mesh& mesh, const Contraction& contraction,
                                          const CollapseRules& rules, StarPair& stars);
  void make(Mesh& mesh, const Contraction& contraction, const StarPair& stars);
  void find_edits(const Mesh& mesh, const Contraction& contraction, const StarPair& stars);
  void destroy_bare_edges(Mesh& mesh, Vertex kept);

  VertexMarks marks_;
  LinkCondition link_;
  EdgeMerges edges_;
  std::vector<Rebinding> rebindings_;
  std::vector<Vertex> bare_;  ///< apexes whose merged edge is left without a face
};

}  // namespace aomd

#pragma GCC visibility pop
