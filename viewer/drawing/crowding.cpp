#include "viewer/drawing/crowding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr std::size_t most_a_cell = 48;
using Cell = std::array<std::int64_t, 3>;

}  // namespace

std::vector<float> rooms(std::span<const glm::vec3> places, float limit) {
  std::vector<float> result(places.size(), 0);
  if (!(limit > 0)) return result;
  std::map<Cell, std::vector<std::size_t>> cells;
  const auto cell_of = [&](glm::vec3 p) {
    const glm::vec3 at = glm::floor(p / limit);
    return Cell{std::int64_t(at.x), std::int64_t(at.y), std::int64_t(at.z)};
  };
  for (std::size_t i = 0; i < places.size(); ++i)
    if (auto& cell = cells[cell_of(places[i])]; cell.size() < most_a_cell) cell.push_back(i);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Cell own = cell_of(places[i]);
    float nearest = limit;
    for (int n = 0; n < 27; ++n) {
      const auto found =
          cells.find({own[0] + n % 3 - 1, own[1] + n / 3 % 3 - 1, own[2] + n / 9 - 1});
      if (found == cells.end()) continue;
      for (const std::size_t other : found->second)
        if (other != i) nearest = std::min(nearest, glm::distance(places[i], places[other]));
    }
    if (nearest < limit) result[i] = std::max(nearest, 1e-6f * limit);
  }
  return result;
}

}  // namespace aomd::scene
