#pragma once
// The checks of a collapse that surfaces and volumes share: the classes of its ends, the geometry
// of the faces and the model edge around them.

#include "core/operators/collapse_rules.h"
#include "core/operators/star.h"
#include "core/operators/verdict.h"

namespace aomd {

/// True where a vertex may go along an edge, or move on it, with this class: it lies on what the
/// edge lies on, and is no model vertex.
[[nodiscard]] inline bool lies_along(const Mesh& mesh, Vertex v, ModelRef edge) {
  const ModelRef own = mesh.classification(v);
  return own == edge && own.dimension() != 0;
}

/// Takes out of `may_go` the ends that do not lie along the edge; Classification with the first of
/// them.
[[nodiscard]] inline Verdict judge_classes(const Mesh& mesh, const EdgeEnds& ends, ModelRef edge,
                                           std::array<bool, 2>& may_go) {
  Verdict verdict;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!may_go[i]) continue;
    may_go[i] = lies_along(mesh, ends[i], edge);
    if (!may_go[i] && verdict.accepted()) verdict = {Reason::Classification, ends[i]};
  }
  return verdict;
}

/// The end that goes must lie along the edge, and the one that stays where it moves.
[[nodiscard]] inline Verdict judge_classes(const Mesh& mesh, const Contraction& c, ModelRef edge,
                                           bool moves) {
  if (!lies_along(mesh, c.deleted, edge)) return {Reason::Classification, c.deleted};
  if (moves && !lies_along(mesh, c.kept, edge)) return {Reason::Classification, c.kept};
  return {};
}

/// The faces around an end that stretch with it: Flat, Angle (turned, or away from the original) or
/// Shape (an angle below the limit), with the first face that is refused.
[[nodiscard]] Verdict judge_faces(const Mesh& mesh, const Star& star, const EndMove& move,
                                  const CollapseRules& rules);

/// A model edge that is collapsed along itself: none of its old directions around the deleted end
/// may turn too far. `star` is around that end.
[[nodiscard]] Verdict judge_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                  const Contraction& contraction, const TurnLimit& limit);
/// A model edge whose kept end moves: none of its old directions around that end may turn too far.
/// `star` is around it.
[[nodiscard]] Verdict judge_rest_of_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                          const Contraction& contraction, const TurnLimit& limit);

}  // namespace aomd
