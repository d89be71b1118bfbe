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

void AttributeFit::locate() {
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
  for (const Vertex v : mesh_.vertices())
    if (least[v] < far)
      original_.at(mesh_.position(v), nearest[v], std::span(present_).subspan(n * v.index, n));
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

void AttributeFit::move(Vertex v, const Star& star, const glm::dvec3& target) {
  const std::size_t n = original_.components();
  find(star, target, std::span(present_).subspan(n * v.index, n));
}

double AttributeFit::error(const OriginalPoint& point, const std::array<Vertex, 3>& corners,
                           const glm::vec3& barycentric) const {
  return squares(at(point), at(corners[0]), at(corners[1]), at(corners[2]), barycentric);
}

double AttributeFit::growth(Vertex v, const Star& star, const glm::dvec3& target) const {
  std::vector<float> there(original_.components());
  find(star, target, there);
  const TwoPoints places = two_points(mesh_.position(v), target);
  double growth = 0;
  for (const StarFace& f : star) {
    const TwoPoints next(mesh_.position(f.next)), previous(mesh_.position(f.previous));
    surface_.for_points(f.face, [&](const OriginalPoint& point) {
      TwoPoints on;
      (void)nearest_barycentric(TwoPoints(point.position), places, next, previous, on);
      const auto off = [&](std::span<const float> at_v, std::size_t lane) {
        return squares(at(point), at_v, at(f.next), at(f.previous),
                       {on.x[lane], on.y[lane], on.z[lane]});
      };
      growth += double(point.weight) * (off(there, 1) - off(at(v), 0));
    });
  }
  return growth;
}

}  // namespace aomd
