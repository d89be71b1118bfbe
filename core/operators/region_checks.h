#pragma once
// The checks of a collapse on the tetrahedra and model entities around its ends.

#include "core/operators/ball.h"
#include "core/operators/collapse_rules.h"
#include "core/operators/verdict.h"

#pragma GCC visibility push(default)

namespace aomd {

/// What limits a collapse among tetrahedra. None turns inside out and the topology is kept,
/// whatever they say.
struct VolumeRules {
  CollapseRules faces{};   ///< for model faces and model edges; always TopologyRule::Safe
  double least_shape = 0;  ///< no stretched tetrahedron gets a smaller tet_shape, unless one as bad
                           ///< was around the same end; 0: no limit
  LeastAngle least_dihedral{0};  ///< between two faces of a stretched tetrahedron, unless one
                                 ///< around the same end was smaller
  /// No edge becomes longer than this many times the larger size of its ends, unless it was; 0: no
  /// limit.
  double overshoot = 0;
  const Column<Vertex, double>* size = nullptr;  ///< by vertex; needed where overshoot is not 0
};

/// The tetrahedra around an end that stretch with it: Inverted, Overshoot or Shape, with the first
/// that is refused, for Overshoot the vertex at the far end of the edge. Shape: a dihedral angle,
/// or tet_shape.
[[nodiscard]] Verdict judge_regions(const Mesh& mesh, const Ball& ball, const EndMove& move,
                                    const VolumeRules& rules);

/// What the edge between two vertices lies on, from the model faces and the tetrahedra around the
/// first. Edges and faces inside regions need not be entities. Invalid where nothing joins them.
[[nodiscard]] ModelRef class_between(const Mesh& mesh, Vertex a, Vertex b, const Star& star,
                                     const Ball& ball);

}  // namespace aomd

#pragma GCC visibility pop
