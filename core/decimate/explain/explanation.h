#pragma once
// Verdicts in words: one sentence that names the number and the entity that decided.

#include <string>
#include <vector>

#include "core/decimate/explain/outlook.h"
#include "core/decimate/options.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// A reason as people say it: "Spacing", and what it means in a sentence.
struct ReasonWords {
  const char* name;
  const char* help;
};
[[nodiscard]] ReasonWords reason_words(Reason reason);

/// "Face 812 would turn by 23.4 degrees; the limit is 10." The outlook must be that of the mesh as
/// it is. O(faces around the edge).
[[nodiscard]] std::string explain_collapse(const Mesh& mesh, const CollapseOutlook& outlook,
                                           const DecimationOptions& options);
[[nodiscard]] std::string explain_swap(const Mesh& mesh, Edge edge, const SwapOutlook& outlook);
[[nodiscard]] std::string explain_move(const Mesh& mesh, const MoveOutlook& outlook);

/// One of the checks that a collapse goes through.
struct CheckResult {
  enum class State { Passed, Failed, NotReached };
  const char* name;
  State state;
};
/// The checks in the order in which they run, as far as the options ask for them, and what became
/// of each.
[[nodiscard]] std::vector<CheckResult> collapse_checks(const CollapseOutlook& outlook,
                                                       const DecimationOptions& options);

}  // namespace aomd
