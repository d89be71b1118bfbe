#pragma once
// Values at the vertices of a result that come closest to those of its original in between too.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::fields {

/// A point of the original on a triangle of the result, and the area that it stands for.
struct FitPoint {
  std::array<std::uint32_t, 3> corners;
  glm::vec3 weights;
  float area;
};

/// How much a vertex is held at the value that it starts from, by what the points around it weigh:
/// they may leave it open.
inline constexpr double fit_hold = 0.05;

/// Moves values at vertices from a good start towards what is wanted at points: least squares of
/// the linear functions in the triangles. `wanted` and `values` have `components` numbers for each.
/// Those of a vertex change where `is_free` has it, and stay within the range of what is wanted on
/// the triangles around it and of its start. A point has no say where it, or a corner of its
/// triangle, has something that is no finite number. O(points + vertices).
void fit_values(std::size_t components, std::span<const FitPoint> points,
                const std::vector<bool>& is_free, std::span<const double> wanted,
                std::span<double> values);

}  // namespace aomd::fields
