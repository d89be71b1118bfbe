#include "core/model/analytic_model.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/model/analytic_shapes.h"

namespace aomd {
namespace {

ModelRef ref_of(const AnalyticEntity& e) { return {analytic::dimension_of(e.shape), e.tag}; }

std::vector<Model::Entry> entries_of(const std::vector<AnalyticEntity>& entities) {
  std::vector<Model::Entry> entries;
  for (const AnalyticEntity& e : entities) {
    if (const char* what = analytic::defect(e.shape))
      throw std::invalid_argument(name_of(ref_of(e)) + " " + what);
    entries.push_back({ref_of(e), e.boundary});
  }
  return entries;
}

}  // namespace

Frame Frame::around(const glm::dvec3& origin, const glm::dvec3& axis, const glm::dvec3& toward) {
  const glm::dvec3 z = glm::normalize(axis);
  glm::dvec3 x = toward - glm::dot(toward, z) * z;
  if (glm::length(x) < 1e-9 * glm::length(toward)) {
    const glm::dvec3 other = std::abs(z.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    x = other - glm::dot(other, z) * z;
  }
  x = glm::normalize(x);
  return {origin, x, glm::cross(z, x), z};
}

glm::dvec3 Frame::on_circle(double radius, double angle) const {
  return origin + radius * (std::cos(angle) * x + std::sin(angle) * y);
}

AnalyticModel::AnalyticModel(const std::vector<AnalyticEntity>& entities)
    : Model(entries_of(entities)) {
  shapes_.resize(size());
  for (const AnalyticEntity& e : entities) shapes_[index_of(ref_of(e))] = e.shape;
}

ClosestPoint AnalyticModel::closest_on(std::size_t index, const glm::dvec3& point) const {
  return analytic::closest(shapes_[index], point);
}
glm::dvec3 AnalyticModel::normal_of(std::size_t index, const glm::dvec3& point) const {
  return analytic::normal(shapes_[index], point);
}
std::optional<ParameterRange> AnalyticModel::range_of(std::size_t index) const {
  return analytic::range(shapes_[index]);
}
glm::dvec3 AnalyticModel::evaluate_at(std::size_t index, const glm::dvec2& parameters) const {
  return analytic::evaluate(shapes_[index], parameters);
}
Box AnalyticModel::box_of(std::size_t index) const { return analytic::box(shapes_[index]); }

}  // namespace aomd
