#include "core/decimate/volume/volume_placement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aomd {
namespace {

constexpr double steady =
    1e-3;  // of the quadric's trace: flat places leave the minimum open otherwise

// The condition with the longest normal among those that have not had their turn.
std::size_t strongest(std::span<const VolumeCondition> conditions, std::uint32_t done) {
  std::size_t best = conditions.size();
  double longest = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(conditions.size(), 32); ++i) {
    const double square = glm::dot(conditions[i].normal, conditions[i].normal);
    if ((done >> i & 1u) == 0 && square > longest) best = i, longest = square;
  }
  return best;
}

// The minimum over the directions that are left, each pulled to where x is now.
glm::dvec3 least_over(const Quadric& q, const FixedDirections& fixed, const glm::dvec3& x) {
  const double stay = steady * q.trace();
  const glm::dvec3 slope = q.slope(x);
  if (fixed.taken() == 3) return x;
  const glm::dvec3& g = fixed.axis(2);
  const double gg = glm::dot(g, q.times(g)) + stay, sg = glm::dot(g, slope);
  if (fixed.taken() == 2) return gg > 0 ? x - sg / gg * g : x;
  const glm::dvec3& f = fixed.axis(1);
  const double ff = glm::dot(f, q.times(f)) + stay, fg = glm::dot(f, q.times(g)),
               sf = glm::dot(f, slope), determinant = ff * gg - fg * fg;
  if (!(determinant > 0)) return x;
  return x + ((fg * sg - gg * sf) * f + (fg * sf - ff * sg) * g) / determinant;
}

}  // namespace

bool FixedDirections::take(const glm::dvec3& n) {
  constexpr double least_new = 0.1;
  const glm::dvec3 part = free_part(n);
  const double free = glm::length(part);
  if (taken_ == 3 || !(free > least_new * glm::length(n))) return false;
  axes_[static_cast<std::size_t>(taken_++)] = part / free;
  return true;
}

void FixedDirections::complete() {
  if (taken_ == 1) {
    const glm::dvec3& n = axes_[0];
    const glm::dvec3 other = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    axes_[1] = glm::normalize(glm::cross(n, other));
  }
  if (taken_ == 1 || taken_ == 2) axes_[2] = glm::cross(axes_[0], axes_[1]);
}

void take_planes(const ModelPlanes& planes, FixedDirections& fixed) {
  for (const ModelFacePart& p : planes.parts())
    if (p.flat()) fixed.take(p.normal);
}

void take_conditions(std::span<const VolumeCondition> conditions, double payment, int most,
                     FixedDirections& fixed, glm::dvec3& x) {
  constexpr double least_say = 0.05;
  std::uint32_t done = 0;
  while (fixed.taken() < most) {
    const std::size_t i = strongest(conditions, done);
    if (i == conditions.size()) return;
    done |= 1u << i;
    const VolumeCondition& c = conditions[i];
    const glm::dvec3 part = fixed.free_part(c.normal);
    if (glm::length(c.normal) < least_say * c.outside || !fixed.take(c.normal)) continue;
    const double payable = payment * glm::length(part);
    const double wanted = -c.change(x) - std::clamp(c.debt, -payable, payable);
    x += wanted / glm::dot(part, part) * part;
  }
}

glm::dvec3 least_under(const Quadric& q, const ModelPlanes& planes,
                       std::span<const VolumeCondition> conditions, const PlacementLimits& limits) {
  FixedDirections fixed;
  take_planes(planes, fixed);
  glm::dvec3 x = limits.middle;
  take_conditions(conditions, limits.payment, 2, fixed, x);
  if (fixed.taken() > 0) {
    fixed.complete();
    return least_over(q, fixed, x);
  }
  return q.minimum(limits.middle, steady * q.trace(), x) ? x : limits.middle;
}

glm::dvec3 nearest_under(const ModelPlanes& planes, std::span<const VolumeCondition> conditions,
                         const PlacementLimits& limits, const glm::dvec3& x) {
  FixedDirections fixed;
  take_planes(planes, fixed);
  glm::dvec3 near = x;
  take_conditions(conditions, limits.payment, 2, fixed, near);
  return near;
}

glm::dvec3 least_on_line(const Quadric& q, const glm::dvec3& direction,
                         const PlacementLimits& limits) {
  const double bend = glm::dot(direction, q.times(direction)) + steady * q.trace();
  const double step = bend > 0 ? -glm::dot(direction, q.slope(limits.middle)) / bend : 0;
  return limits.middle + std::clamp(step, -limits.reach, limits.reach) * direction;
}

}  // namespace aomd
