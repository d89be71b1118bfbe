#include "core/decimate/error_search.h"

#include <algorithm>
#include <cmath>

namespace aomd {

std::optional<double> ErrorSearch::next() const {
  constexpr double first = 0.95, aim = 0.985, most_at_once = 4, widest = 16, narrowest = 1.01;
  constexpr int most_tries = 12;
  if (met_ || tries_ == most_tries || fails_ < narrowest * fits_) return {};
  if (tries_ == 0) return first * limit_;
  const bool both = fits_ > 0 && fails_ < std::numeric_limits<double>::infinity();
  if (both) return std::sqrt(fits_ * fails_);
  const double ratio = error_ > 0 ? aim * limit_ / error_ : most_at_once;
  const double wanted = guard_ * std::clamp(ratio, 1 / most_at_once, most_at_once);
  return wanted <= widest * limit_ ? std::optional(wanted) : std::nullopt;
}

void ErrorSearch::tried(double guard, std::uint32_t faces, double error) {
  constexpr double close_enough = 0.97;  // of the limit
  ++tries_;
  guard_ = guard;
  error_ = error;
  if (!(error <= limit_)) {
    fails_ = std::min(fails_, guard);
    return;
  }
  fits_ = std::max(fits_, guard);
  met_ = error >= close_enough * limit_ || (best_ && faces == best_faces_);
  if (best_ && faces >= best_faces_) return;
  best_ = guard;
  best_faces_ = faces;
}

}  // namespace aomd
