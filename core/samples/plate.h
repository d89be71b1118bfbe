#pragma once
// A flat rectangle with round holes, as a conforming triangulation.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace aomd::sample {

/// A hole around (x, y), inside the square block of side 2 around it; blocks must not overlap.
struct Hole {
  int x, y;
  double radius;  ///< below 1
};

struct Plate {
  std::vector<glm::dvec2> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise
  std::vector<int> hole_of;  ///< for each point the hole on whose rim it lies, or -1
};

/// The rectangle [0, width] x [0, height] with n cells a unit of length: squares cut in two, and
/// rings around the holes that lead from their rims to their blocks.
[[nodiscard]] Plate make_plate(int width, int height, int n, std::span<const Hole> holes);

}  // namespace aomd::sample
