#include "core/model/projection.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace aomd {
namespace {

// The squared distance to a point as a function of the parameters: half of it, its gradient, and
// the second derivatives.
struct Distance {
  double value;
  double rounding;  ///< how wrong the value may be
  glm::dvec2 gradient;
  double uu, uv, vv;
  glm::dvec2 speed2;  ///< squared lengths of the first derivatives

  Distance(const Jet& j, const glm::dvec3& point) {
    const glm::dvec3 d = j.p - point;
    value = 0.5 * glm::dot(d, d);
    rounding = 1e-15 * glm::length(d) * (glm::length(j.p) + glm::length(point));
    gradient = {glm::dot(j.u, d), glm::dot(j.v, d)};
    speed2 = {glm::dot(j.u, j.u), glm::dot(j.v, j.v)};
    uu = speed2.x + glm::dot(j.uu, d);
    vv = speed2.y + glm::dot(j.vv, d);
    uv = glm::dot(j.u, j.v) + glm::dot(j.uv, d);
    if (uu > 0 && (speed2.y == 0 || (vv > 0 && uu * vv > uv * uv))) return;
    uu = speed2.x, vv = speed2.y,
    uv = glm::dot(j.u, j.v);  // not convex here: the descent of Gauss and Newton
  }

  // Parameters that can move: not those held by the range, nor those that move nothing.
  [[nodiscard]] glm::bvec2 free(const glm::dvec2& t, const ParameterRange& range) const {
    const double least = 1e-20 * std::max(speed2.x, speed2.y);
    glm::bvec2 can;
    for (int k = 0; k < 2; ++k) {
      const bool held =
          !range.periodic[static_cast<std::size_t>(k)] &&
          ((t[k] <= range.low[k] && gradient[k] > 0) || (t[k] >= range.high[k] && gradient[k] < 0));
      can[k] = !held && speed2[k] > least;
    }
    return can;
  }

  // How far, about, the point still is from where it should be.
  [[nodiscard]] double error(const glm::bvec2& can) const {
    return (can.x ? std::abs(gradient.x) / std::sqrt(speed2.x) : 0) +
           (can.y ? std::abs(gradient.y) / std::sqrt(speed2.y) : 0);
  }

  [[nodiscard]] glm::dvec2 step(const glm::bvec2& can) const {
    if (can.x && can.y) {
      const double det = uu * vv - uv * uv;
      if (det > 1e-14 * uu * vv)
        return glm::dvec2(uv * gradient.y - vv * gradient.x, uv * gradient.x - uu * gradient.y) /
               det;
    }
    return {can.x ? -gradient.x / uu : 0, can.y ? -gradient.y / vv : 0};
  }
};

}  // namespace

std::vector<glm::dvec2> Projection::sample_places(const ParameterRange& range, int dimension,
                                                  int across) {
  const int rows = dimension == 2 ? across : 1;
  std::vector<glm::dvec2> places;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < across; ++i)
      places.push_back(range.low +
                       (range.high - range.low) * glm::dvec2((i + 0.5) / across, (j + 0.5) / rows));
  return places;
}

Projection::Projection(const ParameterRange& range, int dimension, int across,
                       std::vector<glm::dvec3> samples)
    : range_(range),
      columns_(static_cast<std::size_t>(across)),
      rows_(dimension == 2 ? columns_ : 1),
      samples_(std::move(samples)) {
  for (std::size_t i = 0; i < samples_.size(); ++i)
    for (const std::size_t n : {neighbour(i, 1, 0), neighbour(i, 0, 1)})
      spacing_ = std::max(spacing_, glm::length(samples_[n] - samples_[i]));
}

// Round the ends in periodic directions; at the others a sample is its own neighbour.
std::size_t Projection::neighbour(std::size_t i, int du, int dv) const {
  const auto next = [](std::size_t at, int by, std::size_t count, bool round) {
    if (by > 0) return at + 1 < count ? at + 1 : round ? 0 : at;
    if (by < 0) return at > 0 ? at - 1 : round ? count - 1 : at;
    return at;
  };
  return next(i / columns_, dv, rows_, range_.periodic[1]) * columns_ +
         next(i % columns_, du, columns_, range_.periodic[0]);
}

// The samples that are nearer than all around them, nearest first.
std::vector<Projection::Start> Projection::starts(const glm::dvec3& point) const {
  std::vector<double> distance2(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const glm::dvec3 d = samples_[i] - point;
    distance2[i] = glm::dot(d, d);
  }
  std::vector<Start> found;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    bool lowest = true;
    for (int dv = rows_ > 1 ? -1 : 0; lowest && dv <= (rows_ > 1 ? 1 : 0); ++dv)
      for (int du = -1; lowest && du <= 1; ++du)
        lowest = distance2[i] <= distance2[neighbour(i, du, dv)];
    if (lowest) found.push_back({std::sqrt(distance2[i]), i});
  }
  constexpr std::size_t most = 6;
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(most, found.size()));
  std::partial_sort(found.begin(), end, found.end(),
                    [](const Start& a, const Start& b) { return a.distance < b.distance; });
  found.erase(end, found.end());
  return found;
}

glm::dvec2 Projection::inside(glm::dvec2 t) const {
  for (int k = 0; k < 2; ++k) {
    const double low = range_.low[k], high = range_.high[k], length = high - low;
    if (!range_.periodic[static_cast<std::size_t>(k)])
      t[k] = std::clamp(t[k], low, high);
    else if (!(t[k] >= low && t[k] < high))
      t[k] = std::clamp(t[k] - length * std::floor((t[k] - low) / length), low, high);
  }
  return t;
}

// Near the end the distance no longer tells better from worse, but its gradient does.
glm::dvec2 Projection::refine(const Evaluate& evaluate, const glm::dvec3& point,
                              glm::dvec2 t) const {
  constexpr int most_steps = 50, most_halvings = 12;
  Distance now(evaluate(t), point);
  for (int step = 0; step < most_steps; ++step) {
    const glm::bvec2 can = now.free(t, range_);
    const double error = now.error(can);
    if (!(error > 0)) return t;
    glm::dvec2 by = now.step(can);
    bool better = false;
    for (int halving = 0; halving < most_halvings && !better; ++halving, by *= 0.5) {
      const glm::dvec2 to = inside(t + by);
      if (to == t) return t;
      const Distance then(evaluate(to), point);
      better = then.value < now.value * (1 - 1e-9) - now.rounding ||
               (then.value <= now.value + now.rounding &&
                then.error(then.free(to, range_)) < 0.9 * error);
      if (better) t = to, now = then;
    }
    if (!better) return t;
  }
  return t;
}

ClosestPoint Projection::closest(const Evaluate& evaluate, const glm::dvec3& point) const {
  if (spacing_ <= 1e-14 * glm::length(samples_[0]))
    return {samples_[0], range_.low};  // collapsed to a point
  ClosestPoint best;
  double least = std::numeric_limits<double>::infinity();
  const std::vector<glm::dvec2> places =
      sample_places(range_, rows_ > 1 ? 2 : 1, static_cast<int>(columns_));
  for (const Start& start : starts(point)) {
    if (start.distance - spacing_ > least) break;
    const glm::dvec2 t = refine(evaluate, point, places[start.sample]);
    const glm::dvec3 p = evaluate(t).p;
    if (const double distance = glm::length(p - point); distance < least)
      least = distance, best = {p, t};
  }
  return best;
}

}  // namespace aomd
