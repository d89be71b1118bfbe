#include "core/mesh/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aomd {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

}  // namespace

TurnLimit::TurnLimit(double angle_deg)
    : angle_deg_(angle_deg), cosine_(std::cos(angle_deg / degrees)), square_(cosine_ * cosine_) {}

LeastAngle::LeastAngle(double angle_deg)
    : angle_deg_(angle_deg), cosine_(std::cos(angle_deg / degrees)) {}

double cosine_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double squares = glm::dot(a, a) * glm::dot(b, b);
  return squares > 0 ? glm::dot(a, b) / std::sqrt(squares) : 0;
}

double smallest_angle_deg(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return std::acos(std::clamp(smallest_angle_cosine(a, b, c), -1.0, 1.0)) * degrees;
}

}  // namespace aomd
