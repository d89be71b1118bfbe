#pragma once
// How fast a history is played.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "viewer/base/text.h"

namespace aomd::scene {

/// Either so many operations a second, or as many as the whole history takes in a given time.
struct PlaySpeed {
  static constexpr double slowest = 0.5, fastest = 1e6;  ///< operations a second
  static constexpr double shortest_s = 0.5, longest_s = 3600;

  double per_s =
      0;  ///< 0: as `whole_s` asks for, but slow enough to follow each of a few operations
  double whole_s = 12;  ///< seconds for the whole history

  /// Operations a second in a history of `size` operations.
  [[nodiscard]] double in(std::size_t size) const {
    constexpr double followed_per_s = 4;
    return per_s > 0 ? per_s : std::max(followed_per_s, static_cast<double>(size) / whole_s);
  }
  /// The next faster (or slower) one of 0.5, 1, 2, 5, 10 ... operations a second.
  [[nodiscard]] PlaySpeed beside(std::size_t size, bool faster) const {
    double below = slowest;
    const double now = in(size);
    for (double decade = 0.1; decade < fastest; decade *= 10)
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double next = std::clamp(digit * decade, slowest, fastest);
        if (faster && next > 1.01 * now) return {next, whole_s};
        if (next < 0.99 * now) below = next;
      }
    return {faster ? fastest : below, whole_s};
  }
  /// "20 operations/s", "whole history in 12 s"
  [[nodiscard]] std::string words() const {
    return per_s > 0 ? short_number(per_s, 7) + " operations/s"
                     : "whole history in " + short_number(whole_s, 4) + " s";
  }
  friend bool operator==(const PlaySpeed&, const PlaySpeed&) = default;
};

}  // namespace aomd::scene
