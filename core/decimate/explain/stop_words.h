#pragma once
// Why a run has come to its end, in words.

#include <string>
#include <vector>

#include "core/decimate/options.h"

namespace aomd {

/// How many edges one reason keeps.
struct ReasonCount {
  Reason reason;
  std::int64_t edges;
};

/// The reasons that keep any edge, those that keep most first.
[[nodiscard]] std::vector<ReasonCount> by_number(const EdgesByReason& edges);

/// "of 9,210 edges left, 7,030 are long enough for the spacing, 1,950 would turn a face by more
/// than 10 degrees and 230 would cut a corner off the model"; "no edge is left" where that is so.
/// At most six parts, so that what is said behind them is read: the last is then "230 stay for
/// other reasons".
[[nodiscard]] std::string words_of_edges_left(const EdgesByReason& edges,
                                              const DecimationOptions& options,
                                              bool volume = false);

/// "Stopped, mostly by length: of 9,210 edges left, 7,030 are long enough for the spacing, ...";
/// "Stopped at the aim of 2,000 faces." `cells` is how many there are now: faces, or of a volume
/// tetrahedra.
[[nodiscard]] std::string stop_words(const EdgesByReason& edges, const DecimationOptions& options,
                                     std::int64_t cells, bool volume = false);

}  // namespace aomd
