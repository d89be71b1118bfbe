#include "viewer/drawing/hollows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

using Faces = std::span<const std::array<std::uint32_t, 3>>;

constexpr float part_of_diagonal = 0.006f;
constexpr float least_rounds = 2, most_rounds = 12;

/// Of what the faces around each vertex have at their other corners.
template <typename T>
std::vector<T> mean_around(std::span<const T> values, Faces faces) {
  std::vector<T> sums(values.size(), T(0));
  std::vector<float> counts(values.size(), 0);
  for (const auto& t : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      sums[t[i]] += values[t[(i + 1) % 3]] + values[t[(i + 2) % 3]];
      counts[t[i]] += 2;
    }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (counts[v] > 0) sums[v] /= counts[v];
  return sums;
}

/// How often a mean over neighbours must be taken to reach as far as is to be told.
int rounds_for(std::span<const float> lengths, float diagonal) {
  const float sum = std::accumulate(lengths.begin(), lengths.end(), 0.0f);
  const auto used = std::count_if(lengths.begin(), lengths.end(), [](float l) { return l > 0; });
  if (!(sum > 0)) return 0;
  const float steps = part_of_diagonal * diagonal * static_cast<float>(used) / sum;
  return static_cast<int>(std::clamp(steps * steps, least_rounds, most_rounds));
}

}  // namespace

std::vector<float> hollows(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                           std::span<const float> lengths, Faces faces, float diagonal) {
  const std::vector<glm::vec3> around = mean_around(positions, faces);
  std::vector<float> bend(positions.size(), 0);
  for (std::size_t v = 0; v < bend.size(); ++v)
    if (lengths[v] > 0)
      bend[v] = 4 * glm::dot(around[v] - positions[v], normals[v]) / (lengths[v] * lengths[v]);
  for (int i = rounds_for(lengths, diagonal); i > 0; --i)
    bend = mean_around(std::span<const float>(bend), faces);
  for (float& each : bend) each = std::max(0.0f, each * part_of_diagonal * diagonal);
  return bend;
}

}  // namespace aomd::scene
