#pragma once
// Edge collapse among tetrahedra (paper, section 3; there E_3Dcollapse_).
//
//  The tetrahedra around the edge v-w go; all others around v are stretched to w. Of each that
//  goes, the two sides beside the edge fall together:
//
//        x                x
//       /|\               |
//      / | \              |        (x y) stands for a ring of 3 to 8 such edges around v-w
//     v--|--w   ------->  w
//      \ | /              |
//       \|/               |
//        y                y

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/operators/ball.h"
#include "core/operators/collapse.h"
#include "core/operators/region_checks.h"

#pragma GCC visibility push(default)

namespace aomd {

class SharedEdits;

/// A collapse among tetrahedra that was judged: as on surfaces, with the tetrahedra around both
/// ends. Its stars are of model faces, and empty where the end that goes lies inside a region.
struct VolumeCollapsePlan : CollapsePlan {
  std::array<Ball, 2> balls;  ///< accepted: around the end that goes (0) and the one that stays (1)

  /// How many regions it takes away.
  [[nodiscard]] std::size_t regions_gone() const {
    return static_cast<std::size_t>(
        std::count_if(balls[0].begin(), balls[0].end(),
                      [&](const BallRegion& r) { return r.uses(contraction.kept); }));
  }
};

/// Judges and applies collapses on one mesh of tetrahedra that is classified: every side of one
/// region, and between regions on different model regions, is a face entity on a model face, and
/// the edges between model faces are edge entities on model edges (classify()). Faces and edges
/// inside may be entities or not; the result is the same. T(3,0), T(0,3), T(2,0), T(0,2) and T(0,1)
/// must be stored, as listed or complete (Mesh::request_listed). Around both ends every face and
/// edge is a side of a region. Holds marks, so that a sweep allocates nothing, and nothing else
/// from one call to the next.
class RegionCollapser {
 public:
  explicit RegionCollapser(const Mesh& mesh) : marks_(mesh), edges_(mesh) {}

  /// What collapsing `edge` would do, by deleting one of the ends that `may_go` names (in the
  /// edge's order): the first that is accepted, else the refusal that got furthest. O(regions
  /// around both ends). Checks in this order: classification, topology, model faces (flat, turned,
  /// shape) and model edges, then by tetrahedron inverted, overshoot, shape. Kept where
  /// a region around an end is no tetrahedron, Topology also where an end is crowded. The plan
  /// receives the verdict too.
  Verdict judge(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go, const VolumeRules& rules,
                VolumeCollapsePlan& plan);

  /// Judges an edge named by its ends, which need not be an entity, with a place for the kept end:
  /// where that moves, the edge lies on what it lies on too, and what is around it stretches.
  Verdict judge(const Mesh& mesh, const Contraction& contraction, const VolumeRules& rules,
                VolumeCollapsePlan& plan);

  /// Makes what was accepted. The mesh must not have changed since. One journal step. Faces and
  /// edges that fall together become one with the lower classification.
  void apply(Mesh& mesh, const VolumeCollapsePlan& plan);
  /// The same by edits that others make too, elsewhere; both ends lie inside a model region.
  void apply(const Mesh& mesh, SharedEdits& edits, const VolumeCollapsePlan& plan);

 private:
  using Balls = std::array<Ball, 2>;
  [[nodiscard]] Verdict judge_either(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                                     const VolumeRules& rules, VolumeCollapsePlan& plan);
  [[nodiscard]] Verdict judge_contraction(const Mesh& mesh, const Contraction& c,
                                          const VolumeRules& rules, VolumeCollapsePlan& plan);
  [[nodiscard]] Verdict judge_topology(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                                       ModelRef model, const VolumeCollapsePlan& plan);
  [[nodiscard]] Verdict judge_balls(const Mesh& mesh, const EdgeEnds& ends, const Balls& balls);
  [[nodiscard]] Verdict judge_sides(const BallRegion& r, const Ball& kept) const;
  [[nodiscard]] bool at_edge(Vertex v) const;
  [[nodiscard]] bool at_edge(Vertex a, Vertex b) const;
  void find_edits(const Mesh& mesh, const VolumeCollapsePlan& plan);
  void find_regions(const VolumeCollapsePlan& plan);
  void find_faces(const Mesh& mesh, const Contraction& c, const Balls& balls);
  void merge_sides(const Mesh& mesh, const Contraction& c, const EdgeEnds& side, const Ball& kept);

  VertexMarks marks_;
  LinkCondition link_;
  EdgeMerges edges_;
  std::vector<EdgeEnds> ring_;  ///< the edges opposite to the collapsed one, of its tetrahedra
  std::vector<Rebinding> rebindings_, regions_;
  std::vector<Face> at_edge_;  ///< faces of the edge: they go first
  std::vector<Face> doubles_;  ///< faces that fell together with others: they go last
};

}  // namespace aomd

#pragma GCC visibility pop
