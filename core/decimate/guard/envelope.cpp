#include "core/decimate/guard/envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aomd {
namespace {

using glm::dvec3;

constexpr double least_part = 1.0 / 16;  // of the distance: shorter ones count as outside
constexpr int most_parts = 4096;

double square(const dvec3& v) { return glm::dot(v, v); }

// Points that are computed to lie on a triangle lie beside it by some units in the last place of
// its coordinates, and so do the points where a triangle is cut.
double rounding(const TriangleTree& tree) {
  const Box box = tree.box();
  if (box.empty()) return 0;
  const dvec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
  return 64 * std::numeric_limits<double>::epsilon() * std::max({size.x, size.y, size.z});
}

// The side that starts at the returned corner is the longest.
std::size_t longest_side(const Triangle& t) {
  const double a = square(t[1] - t[0]), b = square(t[2] - t[1]), c = square(t[0] - t[2]);
  return a >= b && a >= c ? 0 : b >= c ? 1 : 2;
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

Envelope::Answer Envelope::contains(const Triangle& t, std::uint32_t& hint) {
  if (hint != no_index && near(t, hint)) return {true, 0};
  parts_.clear();
  parts_.push_back({t, hint});
  for (int seen = 1; !parts_.empty(); ++seen) {
    Part part = parts_.back();
    parts_.pop_back();
    const Triangle& p = part.corners;
    if (seen > 1 && near(p, part.hint)) continue;
    const std::uint32_t before = part.hint;
    const std::size_t k = longest_side(p);
    const double longest2 = square(p[(k + 1) % 3] - p[k]);
    const bool last = seen > most_parts || longest2 <= least_part * least_part * reach2_;
    const double distance2 = locate((p[0] + p[1] + p[2]) / 3.0, last, part.hint);
    hint = part.hint;
    if (!(distance2 <= reach2_)) return {false, std::sqrt(distance2)};
    if (hint != before && near(p, hint)) continue;
    if (last) return {false, std::sqrt(distance2)};
    const bool flat =
        16 * patches_.around(tree_, hint).radius2 > longest2;  // halves will soon fit in patches
    if (flat || !cut_along_sides(part, distance2)) bisect(part);
  }
  return {true, 0};
}

void Envelope::bisect(const Part& part) {
  const Triangle& t = part.corners;
  const std::size_t k = longest_side(t), l = (k + 1) % 3;
  const dvec3 middle = 0.5 * (t[k] + t[l]);
  parts_.push_back({{middle, t[l], t[(k + 2) % 3]}, part.hint});
  parts_.push_back({{t[k], middle, t[(k + 2) % 3]}, part.hint});
}

// Cuts off what reaches over a side of the nearest triangle, by the upright plane along that side
// or a little further out: the one that the part reaches over most.
bool Envelope::cut_along_sides(const Part& part, double distance2) {
  const Triangle& t = part.corners;
  const Triangle& one = tree_.triangle(part.hint);
  const dvec3 normal = glm::cross(one[1] - one[0], one[2] - one[0]);
  const double out = 0.5 * std::sqrt(reach2_ - distance2), least = 0.01 * reach_;
  double most = least;
  dvec3 beyond(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    dvec3 outward = glm::cross(one[(k + 1) % 3] - one[k], normal);
    const double length2 = square(outward);
    if (!(length2 > 0)) return false;
    outward /= std::sqrt(length2);
    dvec3 over(0.0);
    for (int i = 0; i < 3; ++i)
      over[i] = glm::dot(outward, t[static_cast<std::size_t>(i)] - one[k]) - out;
    const double high = std::max({over.x, over.y, over.z}),
                 low = std::min({over.x, over.y, over.z});
    if (high <= most || low >= -least) continue;
    most = high;
    beyond = over;
  }
  if (most <= least) return false;
  cut(part, beyond);
  return true;
}

// Cuts by a plane, given how far the corners lie beyond it: one corner lies alone on its side.
void Envelope::cut(const Part& part, const dvec3& beyond) {
  const Triangle& t = part.corners;
  const auto over = [&](std::size_t i) { return beyond[static_cast<int>(i)] > 0; };
  const std::size_t a = over(1) == over(2)   ? 0
                        : over(0) == over(2) ? 1
                                             : 2,
                    b = (a + 1) % 3, c = (a + 2) % 3;
  const auto crossing = [&](std::size_t i, std::size_t j) {
    const double from = beyond[static_cast<int>(i)], to = beyond[static_cast<int>(j)];
    return t[i] + (from / (from - to)) * (t[j] - t[i]);
  };
  const dvec3 ab = crossing(a, b), ac = crossing(a, c);
  const Part alone{{t[a], ab, ac}, part.hint}, first{{ab, t[b], t[c]}, part.hint},
      second{{ab, t[c], ac}, part.hint};
  if (!over(a))
    parts_.insert(parts_.end(), {first, second, alone});
  else
    parts_.insert(parts_.end(), {alone, first, second});
}

}  // namespace aomd
