#pragma once
// What --reach lets go of, and in which order, until a target is met.

#include <array>
#include <cstdint>

#include "core/decimate/options.h"
#include "core/model/classify.h"

namespace aomd::cli {

/// Guards of a result that stand between a run and its target. Topology and what the user asks for
/// by name (distances, intersections, vertices to keep) are none of them.
enum class Guard : std::uint8_t {
  Shape,     ///< the smallest angles asked for
  Facing,    ///< that no face turns by more than the angle, or away from the original
  Features,  ///< edges that the angle made model edges
  Corners,   ///< model vertices where a border, or another model edge, turns sharply
};
inline constexpr std::array guards_in_order = {Guard::Shape, Guard::Facing, Guard::Features,
                                               Guard::Corners};
/// "shape", "facing", "features", "corners".
[[nodiscard]] const char* guard_name(Guard guard);

/// Takes a guard out of what a run is told. False where it was not in force: then nothing changes.
[[nodiscard]] bool let_go(Guard guard, DecimationOptions& steps, ClassifyOptions& how);

}  // namespace aomd::cli
