#include "viewer/drawing/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr double fit_margin = 1.06;
// A depth buffer of 24 bits resolves about 1/2000 of the eye's distance at this ratio.
constexpr double smallest_near_to_far = 1e-4;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Sine and cosine, exact at multiples of 90 degrees so that standard views have no stray tilt.
glm::dvec2 cos_sin(double degrees) {
  const double turns = degrees / 90.0;
  if (turns == std::floor(turns) && std::abs(turns) < 1e9) {
    constexpr std::array<glm::dvec2, 4> quarter = {glm::dvec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return quarter[static_cast<std::size_t>(((static_cast<long long>(turns) % 4) + 4) % 4)];
  }
  return {std::cos(radians(degrees)), std::sin(radians(degrees))};
}

/// From the turntable's own coordinates (z up, the front looks along +y) to the world's.
glm::dvec3 to_world(const glm::dvec3& v, UpAxis up) {
  return up == UpAxis::Z ? v : glm::dvec3(v.x, v.z, -v.y);
}

}  // namespace

void Camera::orbit(double azimuth_step_deg, double elevation_step_deg) {
  azimuth_deg = std::remainder(azimuth_deg + azimuth_step_deg, 360.0);
  elevation_deg = std::clamp(elevation_deg + elevation_step_deg, -90.0, 90.0);
}

void Camera::pan(glm::dvec2 from, glm::dvec2 to, double aspect) {
  target += on_target_plane(from, aspect) - on_target_plane(to, aspect);
}

void Camera::zoom(double factor, glm::dvec2 ndc, double aspect) {
  const glm::dvec3 fixed = on_target_plane(ndc, aspect);
  target = fixed + (target - fixed) * factor;
  distance *= factor;
}

void Camera::fit(const Box& box, double aspect) {
  if (box.empty()) return;
  target = box.center();
  if (box.diagonal() > 0) distance = fitting_distance(box, aspect);
}

double Camera::fitting_distance(const Box& box, double aspect) const {
  const double tan_y = std::tan(0.5 * radians(fov_deg));
  const double tan_x = tan_y * aspect;
  double needed = 0;
  for (const glm::dvec3& corner : box.corners()) {
    const glm::dvec3 d = corner - box.center();
    const double side =
        std::max(std::abs(glm::dot(d, right())) / tan_x, std::abs(glm::dot(d, up())) / tan_y);
    needed = std::max(needed, side * fit_margin - (orthographic ? 0.0 : glm::dot(d, forward())));
  }
  const double angle = std::atan(std::min(tan_x, tan_y));
  needed = std::min(needed,
                    fit_margin * box.radius() / (orthographic ? std::tan(angle) : std::sin(angle)));
  // A flat box seen from its edge needs no width at all.
  return std::max(needed, 0.05 * box.diagonal());
}

void Camera::turn_to(StandardView view) {
  constexpr double iso_elevation =
      35.26438968275465;  // atan(1/sqrt(2)): the three axes look equally long
  switch (view) {
    case StandardView::Iso:
      azimuth_deg = 45, elevation_deg = iso_elevation;
      break;
    case StandardView::Front:
      azimuth_deg = 0, elevation_deg = 0;
      break;
    case StandardView::Back:
      azimuth_deg = 180, elevation_deg = 0;
      break;
    case StandardView::Left:
      azimuth_deg = -90, elevation_deg = 0;
      break;
    case StandardView::Right:
      azimuth_deg = 90, elevation_deg = 0;
      break;
    case StandardView::Top:
      azimuth_deg = 0, elevation_deg = 90;
      break;
    case StandardView::Bottom:
      azimuth_deg = 0, elevation_deg = -90;
      break;
  }
}

glm::dvec3 Camera::eye() const { return target - forward() * distance; }

glm::dvec3 Camera::right() const {
  const glm::dvec2 a = cos_sin(azimuth_deg);
  return to_world({a.x, a.y, 0}, up_axis);
}

glm::dvec3 Camera::up() const { return glm::cross(right(), forward()); }

glm::dvec3 Camera::forward() const {
  const glm::dvec2 a = cos_sin(azimuth_deg);
  const glm::dvec2 e = cos_sin(elevation_deg);
  return to_world({-e.x * a.y, e.x * a.x, -e.y}, up_axis);
}

double Camera::half_height() const { return distance * std::tan(0.5 * radians(fov_deg)); }

glm::dmat4 Camera::view() const {
  const glm::dvec3 r = right();
  const glm::dvec3 u = up();
  const glm::dvec3 f = forward();
  const glm::dvec3 e = eye();
  return {{r.x, u.x, -f.x, 0},
          {r.y, u.y, -f.y, 0},
          {r.z, u.z, -f.z, 0},
          {-dot(r, e), -dot(u, e), dot(f, e), 1}};
}

glm::dmat4 Camera::projection(double aspect, const Box& scene) const {
  const DepthRange range = depth_range(scene);
  if (!orthographic)
    return glm::perspective(radians(fov_deg), aspect, range.near_depth, range.far_depth);
  const double h = half_height();
  return glm::ortho(-h * aspect, h * aspect, -h, h, range.near_depth, range.far_depth);
}

Ray Camera::ray(glm::dvec2 ndc, double aspect, const Box& scene) const {
  const glm::dvec3 through = on_target_plane(ndc, aspect);
  if (!orthographic) return {eye(), glm::normalize(through - eye())};
  return {through + forward() * (depth_range(scene).near_depth - distance), forward()};
}

Camera::DepthRange Camera::depth_range(const Box& scene) const {
  double nearest = distance;
  double farthest = distance;
  const auto corners = scene.corners();
  for (const glm::dvec3& corner : std::span(corners).first(scene.empty() ? 0 : corners.size())) {
    const double depth = glm::dot(corner - eye(), forward());
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // Lines are drawn a little before their surface, which in a flat scene must not be before the
  // near plane.
  const double slack = 0.01 * std::max(farthest - nearest, 1.5 * distance);
  farthest += slack;
  nearest -= slack;
  if (!orthographic) nearest = std::max(nearest, smallest_near_to_far * farthest);
  return {nearest, farthest};
}

glm::dvec3 Camera::on_target_plane(glm::dvec2 ndc, double aspect) const {
  return target + half_height() * (ndc.x * aspect * right() + ndc.y * up());
}

}  // namespace aomd::scene
