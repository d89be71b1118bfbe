#pragma once
// An axis-parallel box.

#include <algorithm>
#include <array>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace aomd::scene {

/// Empty until something is added.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  /// Tells how far from center() the content reaches: fitting a view can then come nearer to round things.
  void set_radius(double r) { radius_ = r; }
  [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
  /// The middle; the origin for an empty box.
  [[nodiscard]] glm::dvec3 center() const { return empty() ? glm::dvec3(0) : 0.5 * (low + high); }
  /// The length of the diagonal; 0 for an empty box.
  [[nodiscard]] double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
  /// Of a sphere around center() that encloses the content: half the diagonal, or what set_radius() said.
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
