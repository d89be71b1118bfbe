#include "core/decimate/guard/patches.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/geometry.h"

namespace aomd {
namespace {

using glm::dvec3;

constexpr std::size_t most_triangles = 96, normal_triangles = 12;
constexpr double least_facing = 0.2;  // cosine between a triangle's normal and the patch's

// Squared distance from the origin to the segment, as seen along the normal.
double flat_distance2(dvec3 a, dvec3 b, const dvec3& normal) {
  a -= glm::dot(a, normal) * normal;
  b -= glm::dot(b, normal) * normal;
  const dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double s = length2 > 0 ? std::clamp(-glm::dot(a, along) / length2, 0.0, 1.0) : 0.0;
  const dvec3 nearest = a + s * along;
  return glm::dot(nearest, nearest);
}

dvec3 middle(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }
dvec3 normal_of(const Triangle& t) { return area_normal(t[0], t[1], t[2]); }

// Pairs of sides that run between the same vertices in opposite directions, with no third one.
std::vector<std::uint32_t> find_across(std::span<const std::array<std::uint32_t, 3>> vertices) {
  struct Side {
    std::uint32_t low, high, place;
    bool forward;
  };
  std::vector<Side> sides;
  sides.reserve(3 * vertices.size());
  for (std::uint32_t n = 0; n < vertices.size(); ++n)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = vertices[n][k], b = vertices[n][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), 3 * n + k, a < b});
    }
  const auto less = [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  };
  std::sort(sides.begin(), sides.end(), less);
  std::vector<std::uint32_t> across(sides.size(), no_index);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && !less(sides[i], sides[end]);) ++end;
    if (end != i + 2 || sides[i].forward == sides[i + 1].forward) continue;
    across[sides[i].place] = sides[i + 1].place / 3;
    across[sides[i + 1].place] = sides[i].place / 3;
  }
  return across;
}

}  // namespace

Patches::Patches(const TriangleTree& tree, std::span<const std::array<std::uint32_t, 3>> vertices,
                 double reach)
    : reach_(reach), patch_of_(tree.size(), no_index), seen_(tree.size(), 0) {
  if (vertices.empty()) return;
  std::vector<std::array<std::uint32_t, 3>> in_order(tree.size());
  for (std::uint32_t n = 0; n < tree.size(); ++n) in_order[n] = vertices[tree.source(n)];
  across_ = find_across(in_order);
}

const Patch& Patches::around(const TriangleTree& tree, std::uint32_t n) {
  if (patch_of_[n] == no_index) {
    Patch patch;
    if (!across_.empty()) grow(tree, n, patch);
    patch_of_[n] = static_cast<std::uint32_t>(patches_.size());
    share(tree, patch);
    patches_.push_back(patch);
  }
  return patches_[patch_of_[n]];
}

std::uint32_t Patches::walk(const TriangleTree& tree, const dvec3& p, std::uint32_t n,
                            double& distance2) const {
  const auto distance2_to = [&](std::uint32_t m) {
    const dvec3 d = nearest_point(tree.triangle(m), p) - p;
    return glm::dot(d, d);
  };
  distance2 = distance2_to(n);
  if (across_.empty()) return n;
  for (std::uint32_t last = no_index, from = n; from != last;) {
    last = from;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = across_[3 * std::size_t{last} + k];
      if (next == no_index) continue;
      if (const double d2 = distance2_to(next); d2 < distance2) distance2 = d2, n = from = next;
    }
  }
  return n;
}

dvec3 Patches::mean_normal(const TriangleTree& tree, std::uint32_t seed) {
  ++stamp_;
  region_.assign(1, seed);
  seen_[seed] = stamp_;
  dvec3 sum(0.0);
  for (std::size_t i = 0; i < region_.size(); ++i) {
    sum += normal_of(tree.triangle(region_[i]));
    for (std::size_t k = 0; k < 3 && region_.size() < normal_triangles; ++k) {
      const std::uint32_t next = across_[3 * std::size_t{region_[i]} + k];
      if (next == no_index || seen_[next] == stamp_) continue;
      seen_[next] = stamp_;
      region_.push_back(next);
    }
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : sum;
}

// Takes a triangle into the region unless it faces away or stands out.
bool Patches::add(const TriangleTree& tree, const Patch& patch, std::uint32_t n) {
  const Triangle& t = tree.triangle(n);
  const dvec3 normal = normal_of(t);
  const double facing = glm::dot(normal, patch.normal);
  if (!(facing > 0) || facing * facing < least_facing * least_facing * glm::dot(normal, normal))
    return false;
  double low = low_, high = high_;
  for (const dvec3& p : t) {
    const double height = glm::dot(patch.normal, p - patch.centre);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high - low > reach_) return false;
  low_ = low, high_ = high;
  seen_[n] = stamp_;
  region_.push_back(n);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const dvec3 a = t[k] - patch.centre, b = t[(k + 1) % 3] - patch.centre;
    border_.push_back({flat_distance2(a, b, patch.normal), n, k});
    std::push_heap(border_.begin(), border_.end(),
                   [](const Border& x, const Border& y) { return x.distance2 > y.distance2; });
  }
  return true;
}

// Triangles are taken in over the nearest border first; the first that cannot be is where the disc
// ends. Seen along the normal the region then covers the disc: all its triangles face up, so that
// each point outside the border is covered as often as its neighbours, and the first triangle
// covers the centre.
void Patches::grow(const TriangleTree& tree, std::uint32_t seed, Patch& patch) {
  patch.normal = mean_normal(tree, seed);
  patch.centre = middle(tree.triangle(seed));
  ++stamp_;
  region_.clear();
  border_.clear();
  low_ = high_ = 0;
  if (!add(tree, patch, seed)) return;
  while (true) {
    const Border nearest = border_.front();
    std::pop_heap(border_.begin(), border_.end(),
                  [](const Border& x, const Border& y) { return x.distance2 > y.distance2; });
    border_.pop_back();
    const std::uint32_t next = across_[3 * nearest.triangle + nearest.side];
    if (next != no_index && seen_[next] == stamp_) {
      if (border_.empty()) break;
      continue;
    }
    if (next == no_index || region_.size() == most_triangles || !add(tree, patch, next)) {
      patch.radius2 = nearest.distance2 * (1 - 1e-9);
      break;
    }
  }
  patch.bottom = high_ - reach_;
  patch.top = low_ + reach_;
}

void Patches::share(const TriangleTree& tree, const Patch& patch) {
  if (!(patch.radius2 > 0)) return;
  const auto id = static_cast<std::uint32_t>(patches_.size());
  for (const std::uint32_t n : region_) {
    const dvec3 d = middle(tree.triangle(n)) - patch.centre;
    if (patch_of_[n] == no_index && 4 * glm::dot(d, d) < patch.radius2) patch_of_[n] = id;
  }
}

}  // namespace aomd
