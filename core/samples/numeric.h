#pragma once
// Arithmetic whose results do not depend on the machine's mathematical library.

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aomd::sample {

/// (cos, sin) of a whole turn's fraction; exact at quarters of a turn, else within two units in the
/// last place.
[[nodiscard]] glm::dvec2 on_circle(double turns);

/// A well-mixed number in [-1, 1) for an index.
[[nodiscard]] double hashed(std::uint64_t index);

/// Smooth noise in [-1, 1] that varies over a length of about 1.
[[nodiscard]] double noise(const glm::dvec3& p);

}  // namespace aomd::sample
