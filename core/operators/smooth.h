#pragma once
// Vertex smoothing (paper, section 3; there V_smooth_).

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Where smoothing would put a vertex, and whether it may: the average of its neighbours; on a model edge, of
/// the neighbours along that model edge. Refusals: Classification (on a model vertex, unclassified ends of
/// curves, or no neighbour), Flat, Angle (a normal around the vertex would turn by more than `max_turn`). The
/// mesh must store T(0,1), T(0,2), T(2,0). O(faces around the vertex).
[[nodiscard]] Verdict judge_smooth(const Mesh& mesh, Vertex v, const TurnLimit& max_turn, glm::dvec3& target);

/// Moves the vertex. One journal step.
void apply_smooth(Mesh& mesh, Vertex v, const glm::dvec3& target);

}  // namespace aomd
