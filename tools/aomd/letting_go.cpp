#include "tools/aomd/letting_go.h"

#include <utility>

namespace aomd::cli {
namespace {

constexpr double widest_turn_deg = 90, no_corner_deg = 180;

bool let_go_of_shape(DecimationOptions& steps) {
  const double angle = std::exchange(steps.min_angle_deg, 0),
               dihedral = std::exchange(steps.min_dihedral_deg, 0);
  return angle > 0 || dihedral > 0;
}

bool let_go_of_facing(DecimationOptions& steps) {
  const bool held = steps.angle_deg < widest_turn_deg || steps.has(Idea::Facing);
  if (steps.angle_deg < widest_turn_deg) steps.angle_deg = widest_turn_deg;
  steps.without |= 1u << static_cast<int>(Idea::Facing);
  return held;
}

}  // namespace

const char* guard_name(Guard guard) {
  constexpr std::array names = {"shape", "facing", "features", "corners"};
  return names[static_cast<std::size_t>(guard)];
}

bool let_go(Guard guard, DecimationOptions& steps, ClassifyOptions& how) {
  switch (guard) {
    case Guard::Shape:
      return let_go_of_shape(steps);
    case Guard::Facing:
      return let_go_of_facing(steps);
    case Guard::Features:
      return std::exchange(how.feature_angle_deg, std::nullopt).has_value();
    case Guard::Corners:
      break;
  }
  return std::exchange(how.corner_angle_deg, no_corner_deg) < no_corner_deg;
}

}  // namespace aomd::cli
