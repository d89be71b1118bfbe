#pragma once
// An axis-parallel box.

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#pragma GCC visibility push(default)

namespace aomd {

/// An axis-parallel box; an empty one holds nothing.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  [[nodiscard]] bool empty() const {
    return !(low.x <= high.x && low.y <= high.y && low.z <= high.z);
  }
  /// Length from corner to corner; 0 when empty.
  [[nodiscard]] double diagonal() const { return empty() ? 0 : glm::length(high - low); }
  /// True when the closed boxes have a point in common.
  [[nodiscard]] bool touches(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
  }
  /// Squared distance of a point; 0 inside.
  [[nodiscard]] double distance2(const glm::dvec3& p) const {
    const glm::dvec3 d = glm::max(glm::max(low - p, p - high), glm::dvec3(0));
    return glm::dot(d, d);
  }
  [[nodiscard]] bool operator==(const Box&) const = default;
};

}  // namespace aomd

#pragma GCC visibility pop
