#include "core/io/vtk_structured.h"

namespace aomd::io::detail {
namespace {

/// Visits the first corner of each cell, x fastest.
template <class Visit>
void each_cell(const GridSize& size, Visit&& visit) {
  const auto cells = [&](int axis) {
    const std::uint64_t n = size[static_cast<std::size_t>(axis)];
    return n > 1 ? n - 1 : n;
  };
  for (std::uint64_t k = 0; k < cells(2); ++k)
    for (std::uint64_t j = 0; j < cells(1); ++j)
      for (std::uint64_t i = 0; i < cells(0); ++i)
        visit(static_cast<std::int64_t>(i + size[0] * (j + size[1] * k)));
}

/// From the first corner of a cell to each of its corners: around the quad of the first two axes
/// with an extent, then the same one step along the third.
std::vector<std::int64_t> corner_steps(const GridSize& size) {
  std::vector<std::int64_t> steps{0};
  std::int64_t stride = 1;
  for (const std::uint64_t n : size) {
    if (n > 1) {
      const bool around = steps.size() == 2;
      const std::vector<std::int64_t> near = steps;
      if (around) steps.insert(steps.end(), {near[1] + stride, near[0] + stride});
      for (std::size_t i = 0; !around && i < near.size(); ++i) steps.push_back(near[i] + stride);
    }
    stride *= static_cast<std::int64_t>(n);
  }
  return steps;
}

}  // namespace

std::uint64_t points_of(const GridSize& size, std::uint64_t most) {
  std::uint64_t product = 1;
  for (const std::uint64_t n : size) {
    if (n != 0 && product > most / n) return most + 1;
    product *= n;
  }
  return product;
}

std::uint8_t add_cells(const GridSize& size, std::vector<std::int64_t>& connectivity,
                       std::vector<std::int64_t>& ends) {
  const std::vector<std::int64_t> steps = corner_steps(size);
  constexpr std::uint8_t types[] = {1, 3, 9, 12};
  std::size_t dimension = 0;
  for (std::size_t corners = steps.size(); corners > 1; corners /= 2) ++dimension;
  if (dimension == 0) return types[0];
  each_cell(size, [&](std::int64_t first) {
    for (const std::int64_t step : steps) connectivity.push_back(first + step);
    ends.push_back(static_cast<std::int64_t>(connectivity.size()));
  });
  return types[dimension];
}

std::vector<glm::dvec3> points_on(const std::array<std::vector<double>, 3>& axes) {
  std::vector<glm::dvec3> points;
  points.reserve(axes[0].size() * axes[1].size() * axes[2].size());
  for (const double z : axes[2])
    for (const double y : axes[1])
      for (const double x : axes[0]) points.emplace_back(x, y, z);
  return points;
}

}  // namespace aomd::io::detail
