#pragma once
// Why a run has come to its end, in words.

#include <array>
#include <string>

#include "core/decimate/decimation.h"

namespace aomd::scene {

/// How many edges each reason keeps, by Reason; None: nothing is against them.
using EdgesByReason = std::array<std::int64_t, reason_count>;

/// Of a decimation that has just run to its end: what it says about each edge, which takes a few
/// microseconds an edge. For Paper on large meshes what its last sweep counted, before swaps and
/// smoothing.
[[nodiscard]] EdgesByReason edges_left(Decimation& decimation, const Mesh& mesh);

/// "Stopped, mostly by length: of 9,210 edges left, 7,030 are long enough for the spacing, 1,950
/// would turn a face by more than 10 degrees and 230 would leave the model entity that they lie
/// on."
[[nodiscard]] std::string why_stopped(const EdgesByReason& edges, const DecimationOptions& options,
                                      std::int64_t faces);

}  // namespace aomd::scene
