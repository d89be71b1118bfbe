#include "core/operators/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace aomd {

const char* reason_name(Reason reason) {
  constexpr const char* names[] = {
      "None", "Spacing", "Classification", "Topology",     "Flat",     "Angle",     "Quality",
      "Kept", "Shape",   "Distance",       "Intersection", "Inverted", "Overshoot", "Volume"};
  return names[static_cast<int>(reason)];
}

int check_order(Reason reason) {
  constexpr std::array<Reason, reason_count> order = {
      Reason::None,    Reason::Kept,   Reason::Spacing,  Reason::Classification, Reason::Topology,
      Reason::Flat,    Reason::Angle,  Reason::Inverted, Reason::Overshoot,      Reason::Shape,
      Reason::Quality, Reason::Volume, Reason::Distance, Reason::Intersection};
  return static_cast<int>(std::find(order.begin(), order.end(), reason) - order.begin());
}

double Verdict::number() const {
  if (reason != Reason::Angle && reason != Reason::Quality && reason != Reason::Shape)
    return measure_;
  return std::acos(std::clamp(measure_, -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace aomd
