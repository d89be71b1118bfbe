#include "core/decimate/quality/attribute_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/nearest_lanes.h"

namespace aomd {
namespace {

// What is not known on either side makes no difference.
double squares(std::span<const float> wanted, std::span<const float> a, std::span<const float> b,
               std::span<const float> c, const glm::vec3& weights) {
  double sum = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const float off = weights.x * a[k] + weights.y * b[k] + weights.z * c[k] - wanted[k];
    if (!std::isnan(off)) sum += double(off) * double(off);
  }
  return sum;
}

}  // namespace

std::vector<bool> AttributeFit::find_all() {
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::size_t n = original_.components();
  Column<Vertex, std::size_t> nearest(mesh_.capacity(0));
  Column<Vertex, double> least(mesh_.capacity(0), far);
  for (std::size_t i = 0; i < surface_.points().size(); ++i) {
    const OriginalPoint& p = surface_.points()[i];
    if (p.face == no_index) continue;
    for (const Vertex v : mesh_.triangle(Face(p.face))) {
      const glm::dvec3 d = mesh_.position(v) - p.position;
      if (!(glm::dot(d, d) < least[v])) continue;
      least[v] = glm::dot(d, d);
      nearest[v] = i;
    }
  }
  present_.assign(n * mesh_.capacity(0), unknown);
  std::vector<bool> moved(mesh_.capacity(0));
  for (const Vertex v : mesh_.vertices()) {
    moved[v.index] = least[v] > 0;
    if (least[v] < far)
      original_.at(mesh_.position(v), nearest[v], std::span(present_).subspan(n * v.index, n));
  }
  return moved;
}

std::vector<fields::FitPoint> AttributeFit::fit_points() const {
  std::vector<fields::FitPoint> points;
  points.reserve(surface_.points().size());
  for (const OriginalPoint& p : surface_.points()) {
    fields::FitPoint point{{}, glm::vec3(0.0f), 0};  // what lies nowhere weighs nothing
    if (p.face != no_index) {
      const auto t = mesh_.triangle(Face(p.face));
      point = {{t[0].index, t[1].index, t[2].index}, p.barycentric, p.weight};
    }
    points.push_back(point);
  }
  return points;
}

void AttributeFit::fit_all(const std::vector<bool>& moved) {
  const std::size_t n = original_.components();
  const auto fitted_of = [&](std::span<const float> all) {
    std::vector<double> values;
    values.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      if (fitted_[i % n]) values.push_back(double(all[i]));
    return values;
  };
  std::vector<double> values = fitted_of(present_);
  fields::fit_values(n_fitted(), fit_points(), moved, fitted_of(original_.all()), values);
  auto next = values.begin();
  for (std::size_t i = 0; i < present_.size(); ++i)
    if (fitted_[i % n]) present_[i] = static_cast<float>(*next++);
}

void AttributeFit::locate() {
  const std::vector<bool> moved = find_all();
  if (n_fitted() > 0) fit_all(moved);
}

// At the nearest of these points, on the original's faces around it.
void AttributeFit::find(const Star& star, const glm::dvec3& target, std::span<float> values) const {
  double least = std::numeric_limits<double>::infinity();
  const OriginalPoint* nearest = nullptr;
  for (const StarFace& f : star)
    surface_.for_points(f.face, [&](const OriginalPoint& point) {
      const glm::dvec3 d = target - point.position;
      if (!(glm::dot(d, d) < least)) return;
      least = glm::dot(d, d);
      nearest = &point;
    });
  if (nearest)
    original_.at(target, number_of(*nearest), values);
  else
    std::fill(values.begin(), values.end(), std::numeric_limits<float>::quiet_NaN());
}

void AttributeFit::move(Vertex v) {
  std::copy(proposed_.begin(), proposed_.end(),
            present_.begin() + std::ptrdiff_t(proposed_.size() * v.index));
}

double AttributeFit::error(const OriginalPoint& point, const std::array<Vertex, 3>& corners,
                           const glm::vec3& barycentric) const {
  return squares(at(point), at(corners[0]), at(corners[1]), at(corners[2]), barycentric);
}

// What the points on one face around a vertex say of it, before and after a move.
void AttributeFit::add_wishes(Vertex v, const StarFace& f, const glm::dvec3& target) {
  const auto mine = at(v), next = at(f.next), previous = at(f.previous);
  const TwoPoints places = two_points(mesh_.position(v), target), b(mesh_.position(f.next)),
                  c(mesh_.position(f.previous));
  surface_.for_points(f.face, [&](const OriginalPoint& point) {
    TwoPoints on;
    (void)nearest_barycentric(TwoPoints(point.position), places, b, c, on);
    const auto wanted = at(point);
    const double area = double(point.weight), weight = on.x[1], pull = area * weight;
    for (std::size_t k = 0; k < wishes_.size(); ++k) {
      const double y = double(next[k]), z = double(previous[k]), x = double(wanted[k]);
      const double before = x - on.x[0] * double(mine[k]) - on.y[0] * y - on.z[0] * z;
      if (std::isnan(before)) continue;
      const double off = x - on.y[1] * y - on.z[1] * z;
      Wish& wish = wishes_[k];
      wish.before += area * before * before;
      wish.pulls += pull;
      wish.squares += pull * weight;
      wish.sum += pull * off;
      wish.rest += area * off * off;
    }
  });
}

double AttributeFit::propose(Vertex v, const Star& star, const glm::dvec3& target) {
  wishes_.assign(original_.components(), {});
  proposed_.assign(at(v).begin(), at(v).end());
  for (const StarFace& f : star) add_wishes(v, f, target);
  if (n_fitted() < fitted_.size()) find(star, target, proposed_);
  double growth = 0;
  for (std::size_t k = 0; k < wishes_.size(); ++k) {
    const Wish& wish = wishes_[k];
    if (fitted_[k] && wish.squares > 0)
      proposed_[k] = static_cast<float>(wish.best(double(at(v)[k])));
    if (!std::isnan(proposed_[k])) growth += wish.error(double(proposed_[k])) - wish.before;
  }
  return growth;
}

}  // namespace aomd
