#pragma once
// The geometric checks of a collapse on the faces and the model edge around its ends.

#include "core/operators/collapse_rules.h"
#include "core/operators/star.h"
#include "core/operators/verdict.h"

namespace aomd {

/// The faces around an end that stretch with it: Flat, Angle (turned, or away from the original) or
/// Shape (an angle below the limit), with the first face that is refused.
[[nodiscard]] Verdict judge_faces(const Mesh& mesh, const Star& star, const EndMove& move,
                                  const CollapseRules& rules);

/// A model edge that is collapsed along itself: none of its old directions around the deleted end
/// may turn too far. `star` is around that end.
[[nodiscard]] Verdict judge_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                  const Contraction& contraction, const TurnLimit& limit);
/// The same beyond the kept end, where that moves; `star` is around it.
[[nodiscard]] Verdict judge_rest_of_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                          const Contraction& contraction, const TurnLimit& limit);

}  // namespace aomd
