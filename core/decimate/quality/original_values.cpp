#include "core/decimate/quality/original_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/geometry.h"
#include "core/model/triangle_tree.h"

namespace aomd {
namespace {

/// The points that vertices are: those inside faces, which are made at a corner, come after them.
Column<Vertex, std::uint32_t> points_of_vertices(const Mesh& mesh,
                                                 const OriginalSurface& original) {
  Column<Vertex, std::uint32_t> point_of(mesh.capacity(0), no_index);
  for (auto i = static_cast<std::uint32_t>(original.points().size()); i-- > 0;)
    point_of[original.vertex_of(i)] = i;
  return point_of;
}

}  // namespace

OriginalValues::OriginalValues(const Mesh& mesh, const OriginalSurface& original,
                               const CountedValues& given)
    : OriginalValues(mesh, original, given, points_of_vertices(mesh, original)) {}

OriginalValues::OriginalValues(const Mesh& mesh, const OriginalSurface& original,
                               const CountedValues& given,
                               const Column<Vertex, std::uint32_t>& point_of)
    : original_(original),
      revision_(mesh.revision()),
      components_(given.components),
      around_(original.points().size(), [&](const auto& file) {
        std::uint32_t number = 0;
        for (const Face f : mesh.faces()) {
          for (const Vertex v : mesh.triangle(f)) file(std::size_t{point_of[v]}, number);
          ++number;
        }
      }) {
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    faces_.push_back({point_of[t[0]], point_of[t[1]], point_of[t[2]]});
  }
  values_.resize(components_ * original.points().size());
  for (std::size_t i = 0; i < original.points().size(); ++i) {
    const Vertex v = original.vertex_of(i);
    home_.push_back(point_of[v]);
    const std::span<float> values = std::span(values_).subspan(components_ * i, components_);
    if (home_[i] == i)
      std::copy_n(given.at(v).begin(), components_, values.begin());
    else
      at(original.points()[i].position, i, values);
  }
}

std::array<glm::dvec3, 3> OriginalValues::positions(const Corners& face) const {
  const auto& points = original_.points();
  return {points[face[0]].position, points[face[1]].position, points[face[2]].position};
}

void OriginalValues::at(const glm::dvec3& p, std::size_t i, std::span<float> values) const {
  double best = std::numeric_limits<double>::infinity();
  const Corners* face = nullptr;
  glm::vec3 weights(0.0f);
  for (const std::uint32_t f : faces_at(i)) {
    const auto [a, b, c] = positions(faces_[f]);
    glm::dvec3 place;
    const double distance2 = nearest_barycentric(p, a, b, c, place);
    if (!(distance2 < best)) continue;
    best = distance2;
    face = &faces_[f];
    weights = place;
  }
  for (std::size_t k = 0; k < components_; ++k) {
    values[k] = 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
      values[k] += weights[static_cast<int>(corner)] * at_point((*face)[corner])[k];
  }
}

void OriginalValues::gradients(std::size_t i, std::span<glm::vec3> gradients) const {
  std::vector<double> areas(components_, 0);
  std::vector<glm::dvec3> sums(components_, glm::dvec3(0.0));
  for (const std::uint32_t f : faces_at(i)) {
    const auto corners = positions(faces_[f]);
    const double area = glm::length(area_normal(corners[0], corners[1], corners[2]));
    for (std::size_t k = 0; k < components_; ++k) {
      const auto value = [&](std::size_t corner) { return double(at_point(faces_[f][corner])[k]); };
      const std::array values{value(0), value(1), value(2)};
      if (std::isnan(values[0] + values[1] + values[2])) continue;
      sums[k] += area * gradient_of(corners, values);
      areas[k] += area;
    }
  }
  for (std::size_t k = 0; k < components_; ++k)
    gradients[k] = areas[k] > 0 ? glm::vec3(sums[k] / areas[k]) : glm::vec3(0.0f);
}

glm::dvec3 gradient_of(const std::array<glm::dvec3, 3>& corners,
                       const std::array<double, 3>& values) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 normal = area_normal(a, b, c);
  const double squares = glm::dot(normal, normal);
  if (!(squares > 0)) return glm::dvec3(0.0);
  const glm::dvec3 side = (values[1] - values[0]) * (a - c) + (values[2] - values[0]) * (b - a);
  return glm::cross(normal, side) / squares;
}

}  // namespace aomd
