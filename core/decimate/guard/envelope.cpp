#include "core/decimate/guard/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/decimate/guard/overlay.h"
#include "core/model/tilted_box.h"

namespace aomd {
namespace {

using glm::dvec3;

constexpr double patch_cost = 0.5;  // square of a radius in areas of parallelograms, as measured

double square(const dvec3& v) { return glm::dot(v, v); }

// Points that are computed to lie on a triangle lie beside it by some units in the last place of
// its coordinates, and so do the points where a triangle is cut.
double rounding(const TriangleTree& tree) {
  const Box box = tree.box();
  if (box.empty()) return 0;
  const dvec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
  return 64 * std::numeric_limits<double>::epsilon() * std::max({size.x, size.y, size.z});
}

}  // namespace

Envelope::Envelope(std::span<const Triangle> triangles, double distance,
                   std::span<const std::array<std::uint32_t, 3>> vertices)
    : tree_({triangles.begin(), triangles.end()}),
      distance_(distance),
      reach_(std::max(0.0, distance - rounding(tree_))),
      reach2_(reach_ * reach_),
      patches_(tree_, vertices, reach_) {}

// In one convex set whose points are all near: over a patch, or around one triangle. The patch, if
// there is one already, is asked first: that is less to compute.
bool Envelope::near(const Triangle& t, std::uint32_t n) {
  const auto over = [&](const Patch& patch) {
    return patch.contains(t[0]) && patch.contains(t[1]) && patch.contains(t[2]);
  };
  const bool known = patches_.known(n);
  if (known && over(patches_.around(tree_, n))) return true;
  const Triangle& one = tree_.triangle(n);
  const auto close = [&](const dvec3& p) { return square(nearest_point(one, p) - p) <= reach2_; };
  return (close(t[0]) && close(t[1]) && close(t[2])) || (!known && over(patches_.around(tree_, n)));
}

// To go over triangles then costs less than to cut until each part fits in a patch.
bool Envelope::small_patch(std::uint32_t n) {
  const auto& [a, b, c] = tree_.triangle(n);
  return patches_.around(tree_, n).radius2 < patch_cost * glm::length(glm::cross(b - a, c - a));
}

// By triangles that are over it along its normal, within reach.
bool Envelope::laid_over(const Triangle& t) const {
  Overlay overlay(t, reach2_);
  const Surroundings around(t, tree_.box(), reach_);
  tree_.reached([&](const Box& box) { return around.may_touch(box); },
                [&](std::uint32_t n) { overlay.lay(tree_.triangle(n)); });
  return overlay.complete();
}

// A triangle that may be near: by a walk from the last one, or by a search where that leads to none
// that is near enough, or where it must be the nearest.
double Envelope::locate(const dvec3& p, bool surely, std::uint32_t& near) const {
  double distance2 = 0;
  if (near != no_index) near = patches_.walk(tree_, p, near, distance2);
  if (near != no_index && !surely && 4 * distance2 <= reach2_) return distance2;
  const TriangleTree::Nearest nearest = tree_.nearest(p, near);
  near = nearest.triangle;
  return nearest.distance2;
}

Envelope::Answer Envelope::contains(const dvec3& p, std::uint32_t& hint) const {
  const double distance2 = locate(p, false, hint);
  if (distance2 <= reach2_) return {true, 0};
  return {false, std::sqrt(distance2)};
}

Envelope::Answer Envelope::contains(const Triangle& t, std::uint32_t& hint) {
  if (hint != no_index && (near(t, hint) || (small_patch(hint) && laid_over(t)))) return {true, 0};
  parts_.clear();
  parts_.push_back({t, hint});
  for (int seen = 1; !parts_.empty(); ++seen) {
    Part part = parts_.back();
    parts_.pop_back();
    const Triangle& p = part.corners;
    if (seen > 1 && near(p, part.hint)) continue;
    const std::uint32_t before = part.hint;
    const double longest2 = longest_side2(p);
    const bool last = seen > most_parts || longest2 <= least_part * least_part * reach2_;
    const double distance2 = locate((p[0] + p[1] + p[2]) / 3.0, last, part.hint);
    hint = part.hint;
    if (!(distance2 <= reach2_)) return {false, std::sqrt(distance2)};
    if (hint != before && near(p, hint)) continue;
    if (last) return {false, std::sqrt(distance2)};
    const TriangleParts smaller = cut(p, hint, distance2, longest2);
    for (const Triangle& corners : smaller.span()) parts_.push_back({corners, hint});
  }
  return {true, 0};
}

// Along the sides of the nearest triangle, or a little further out; in halves where these will soon
// fit in patches.
TriangleParts Envelope::cut(const Triangle& t, std::uint32_t nearest, double distance2,
                            double longest2) {
  if (16 * patches_.around(tree_, nearest).radius2 <= longest2) {
    const double out = 0.5 * std::sqrt(reach2_ - distance2);
    const TriangleParts parts = cut_along_sides(t, tree_.triangle(nearest), out, 0.01 * reach_);
    if (parts.count > 0) return parts;
  }
  return bisected(t);
}

}  // namespace aomd
