#include "core/model/tilted_box.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace aomd {
namespace {

using glm::dvec3;

// Any direction at right angles to a unit vector.
dvec3 across(const dvec3& u) {
  const dvec3 size = glm::abs(u);
  const dvec3 other = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                      : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                           : dvec3(0, 0, 1);
  return glm::normalize(glm::cross(u, other));
}

dvec3 longest_side(const std::array<dvec3, 3>& t) {
  dvec3 longest = t[1] - t[0];
  for (const dvec3& side : {t[2] - t[1], t[0] - t[2]})
    if (glm::dot(side, side) > glm::dot(longest, longest)) longest = side;
  return longest;
}

bool is_unit(const dvec3& v) { return std::abs(glm::dot(v, v) - 1) < 1e-12; }

}  // namespace

TiltedBox::TiltedBox(const std::array<dvec3, 3>& triangle, const Box& all)
    : middle_(0.5 * all.low + 0.5 * all.high),
      doubt_(16 * std::numeric_limits<double>::epsilon() * all.diagonal()) {
  axes_[0] = glm::normalize(longest_side(triangle));
  if (!is_unit(axes_[0])) axes_[0] = dvec3(1, 0, 0);
  axes_[2] = glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  axes_[1] = glm::normalize(glm::cross(axes_[2], axes_[0]));
  if (!is_unit(axes_[1])) axes_[1] = across(axes_[0]);
  axes_[2] = glm::cross(axes_[0], axes_[1]);
}

void TiltedBox::add(const dvec3& p) {
  const dvec3 q = along(p);
  box_.add(q - dvec3(doubt_));
  box_.add(q + dvec3(doubt_));
}

void TiltedBox::add(const TiltedBox& other) {
  for (int corner = 0; corner < 8; ++corner) {
    dvec3 p = middle_;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      p += ((corner >> k & 1) != 0 ? other.box_.high : other.box_.low)[k] * other.axes_[axis];
    }
    add(p);
  }
}

// Looks along its own axes alone.
bool TiltedBox::may_touch(const Box& other, double reach) const {
  const dvec3 centre = along(0.5 * other.low + 0.5 * other.high),
              half = 0.5 * other.high - 0.5 * other.low;
  for (int k = 0; k < 3; ++k) {
    const double size = glm::dot(glm::abs(axes_[static_cast<std::size_t>(k)]), half) + reach;
    if (centre[k] - size > box_.high[k] || centre[k] + size < box_.low[k]) return false;
  }
  return true;
}

}  // namespace aomd
