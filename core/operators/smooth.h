#pragma once
// Vertex smoothing (paper, section 3; there V_smooth_).

#include <span>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/operators/verdict.h"

namespace aomd {

/// What smoothing has to respect.
struct SmoothRules {
  // NOLINTNEXTLINE(google-explicit-constructor): a limit of turning alone is a rule, too
  SmoothRules(const TurnLimit& turn, const Model* snap_to = nullptr, double least_angle_deg = 0)
      : max_turn(turn), model(snap_to), least_angle(least_angle_deg) {}

  TurnLimit max_turn;
  const Model*
      model;  ///< new positions are snapped to it; none: they stay where averaging puts them
  LeastAngle least_angle;  ///< no face gets a smaller one, unless it had one
};

/// Where smoothing would put a vertex, and whether it may: the average of its neighbours; on a
/// model edge, of the neighbours along that model edge; then, where there is a model, the nearest
/// point of the entity that the vertex lies on (paper: G_snapVertex_), so that the verdict is on
/// the final position. Refusals: Classification (on a model vertex, unclassified ends of curves, or
/// no neighbour), Flat, Angle (a normal around the vertex would turn by more than `max_turn`). The
/// mesh must store T(0,1), T(0,2), T(2,0). Throws as Model::closest. O(faces around the vertex),
/// and one closest point.
[[nodiscard]] Verdict judge_smooth(const Mesh& mesh, Vertex v, const SmoothRules& rules,
                                   glm::dvec3& target);

/// The same where the vertices at the other ends of the edges are known: they are averaged in this
/// order. T(0,2) and T(2,0) must be stored; edges need not be entities (see for_edges_at).
[[nodiscard]] Verdict judge_smooth(const Mesh& mesh, Vertex v, std::span<const Vertex> neighbours,
                                   const SmoothRules& rules, glm::dvec3& target);

/// Moves the vertex. One journal step.
void apply_smooth(Mesh& mesh, Vertex v, const glm::dvec3& target);

}  // namespace aomd
