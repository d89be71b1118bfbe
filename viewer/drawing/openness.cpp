#include "viewer/drawing/openness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "viewer/drawing/coarse_surface.h"
#include "viewer/drawing/depth_picture.h"
#include "viewer/drawing/hollows.h"

namespace aomd::scene {
namespace {

constexpr std::size_t directions = 96;
constexpr int picture_px = 384;
constexpr std::size_t most_occluders = 120'000;
constexpr float detail_of_diagonal = 0.06f;
constexpr float strength_of_fold = 1.7f, most_of_fold = 0.4f;

/// Whether something stands before a place. Half a pixel's depth is no obstacle: that is how exact
/// the picture is.
bool hidden(const DepthPicture& picture, glm::vec3 place, glm::vec3 normal) {
  const float pixel = picture.pixel_size();
  const glm::vec3 p = picture.seen(place + 1.5f * pixel * normal);
  return picture.depth_at(p) > p.z + 0.5f * pixel;
}

/// Evenly over the sphere, each the same at every call.
glm::vec3 direction(std::size_t i) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double z = 1 - (2 * static_cast<double>(i) + 1) / directions;
  const double around = golden * static_cast<double>(i), r = std::sqrt(1 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

/// What each vertex has seen of the light that would fall on it, and how much that would be.
struct Light {
  float seen = 0, whole = 0;
};

void look_from(std::size_t side, const OpennessSource& source, float radius,
               std::vector<Light>& lights) {
  const glm::vec3 towards = direction(side);
  DepthPicture picture(towards, radius, picture_px);
  picture.draw(source.occluders);
  for (std::size_t v = 0; v < lights.size(); ++v) {
    const float facing = glm::dot(source.normals[v], towards);
    if (facing <= 0) continue;
    lights[v].whole += facing;
    if (!hidden(picture, source.positions[v], source.normals[v])) lights[v].seen += facing;
  }
}

}  // namespace

OpennessSource openness_source(const Mesh& mesh, std::span<const Corner> corners,
                               const glm::dvec3& origin) {
  OpennessSource source;
  source.positions.resize(mesh.capacity(0));
  source.normals.resize(mesh.capacity(0));
  source.lengths.resize(mesh.capacity(0));
  std::vector<float> sides(mesh.capacity(0));
  for (const Vertex v : mesh.vertices())
    source.positions[v.index] = glm::vec3(mesh.position(v) - origin);
  source.faces.reserve(mesh.count(2));
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    source.faces.push_back({t[0].index, t[1].index, t[2].index});
    const auto at = [&](std::size_t i) { return source.positions[t[i].index]; };
    const glm::vec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t i = 0; i < 3; ++i) {
      source.normals[t[i].index] += normal;
      source.lengths[t[i].index] += glm::length(at((i + 1) % 3) - at(i));
      ++sides[t[i].index];
    }
  }
  for (std::size_t v = 0; v < sides.size(); ++v) {
    const float length = glm::length(source.normals[v]);
    if (length > 0) source.normals[v] /= length;
    if (sides[v] > 0) source.lengths[v] /= sides[v];
  }
  const bool many = corners.size() > 6 * most_occluders;
  source.occluders = many ? coarse_corners(corners, most_occluders)
                          : std::vector<Corner>(corners.begin(), corners.end());
  return source;
}

std::vector<std::uint8_t> openness(const OpennessSource& source, const std::stop_token& stop) {
  float radius = 0;
  for (const glm::vec3& p : source.positions) radius = std::max(radius, glm::length(p));
  std::vector<Light> lights(source.positions.size());
  if (!(radius > 0)) return std::vector<std::uint8_t>(lights.size(), 255);
  for (std::size_t side = 0; side < directions; ++side) {
    if (stop.stop_requested()) return {};
    look_from(side, source, 1.01f * radius, lights);
  }
  const std::vector<float> hollow =
      hollows(source.positions, source.normals, source.lengths, source.faces, 2 * radius);
  std::vector<std::uint8_t> result(lights.size(), 255);
  for (std::size_t v = 0; v < lights.size(); ++v) {
    if (lights[v].whole <= 0) continue;
    const float known = std::min(
        1.0f, 2 * detail_of_diagonal * radius / std::max(source.lengths[v], 1e-6f * radius));
    const float fold = 1 - std::min(most_of_fold, strength_of_fold * hollow[v]);
    const float open = glm::mix(1.0f, fold * lights[v].seen / lights[v].whole, known);
    result[v] = static_cast<std::uint8_t>(std::lround(255 * open));
  }
  return result;
}

}  // namespace aomd::scene
