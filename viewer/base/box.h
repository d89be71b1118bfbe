#pragma once
// An axis-parallel box that a view can be fitted to.

#include <algorithm>
#include <array>
#include <limits>

#include <glm/vec3.hpp>

#include "core/base/box.h"

namespace aomd::scene {

/// The box of core, and what fitting a view asks of it. Empty until something is added.
struct Box : aomd::Box {
  /// Tells how far from center() the content reaches: fitting a view can then come nearer to round
  /// things.
  void set_radius(double r) { radius_ = r; }
  /// The middle; the origin for an empty box.
  [[nodiscard]] glm::dvec3 center() const { return empty() ? glm::dvec3(0) : 0.5 * (low + high); }
  /// Of a sphere around center() that encloses the content: half the diagonal, or what set_radius()
  /// said.
  [[nodiscard]] double radius() const { return std::min(radius_, 0.5 * diagonal()); }
  /// The eight corners; eight times the origin for an empty box.
  [[nodiscard]] std::array<glm::dvec3, 8> corners() const {
    std::array<glm::dvec3, 8> result{};
    if (empty()) return result;
    for (unsigned i = 0; i < 8; ++i) {
      result[i] = {(i & 1u) != 0 ? high.x : low.x, (i & 2u) != 0 ? high.y : low.y,
                   (i & 4u) != 0 ? high.z : low.z};
    }
    return result;
  }

 private:
  double radius_ = std::numeric_limits<double>::infinity();
};

}  // namespace aomd::scene
