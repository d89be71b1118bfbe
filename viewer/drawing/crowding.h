#pragma once
// How near dots are to each other.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::scene {

/// From each place to the nearest other one; 0 where there is none within `limit`. Where more than
/// a few dozen lie in a cube of that size, only so many are looked at.
[[nodiscard]] std::vector<float> rooms(std::span<const glm::vec3> places, float limit);

}  // namespace aomd::scene
