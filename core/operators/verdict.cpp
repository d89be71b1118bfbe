#include "core/operators/verdict.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aomd {

const char* reason_name(Reason reason) {
  constexpr const char* names[] = {"None",  "Spacing",  "Classification", "Topology",
                                   "Flat",  "Angle",    "Quality",        "Kept",
                                   "Shape", "Distance", "Intersection"};
  return names[static_cast<int>(reason)];
}

double Verdict::number() const {
  if (reason != Reason::Angle && reason != Reason::Quality && reason != Reason::Shape)
    return measure_;
  return std::acos(std::clamp(measure_, -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace aomd
