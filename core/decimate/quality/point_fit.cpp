#include "core/decimate/quality/point_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/decimate/quadric.h"
#include "core/model/nearest_lanes.h"

namespace aomd {
namespace {

// What the shape of a face costs: 0 for an equilateral one, without bound as it degenerates.
double misshape(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return std::min(50.0, 1 / (triangle_quality(a, b, c) + 1e-9) - 1);
}

}  // namespace

double triangle_quality(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - b, w = a - c;
  const double squares = glm::dot(u, u) + glm::dot(v, v) + glm::dot(w, w);
  return squares > 0 ? 2 * std::numbers::sqrt3 * glm::length(glm::cross(u, v)) / squares : 0;
}

bool Fitter::least_squares(Vertex v, const Star& star, const FitRules& rules,
                           glm::dvec3& target) const {
  const glm::dvec3 at = mesh_.position(v);
  Quadric error;
  glm::dvec3 centre(0.0), normal(0.0);
  double weights = 0, area = 0, nearest = std::numeric_limits<double>::infinity();
  const OriginalPoint* anchor = nullptr;
  const double far = rules.far / rules.mean_square, off_far = rules.stay_far / rules.mean_square;
  for (const StarFace& f : star) {
    const glm::dvec3 p = mesh_.position(f.next), q = mesh_.position(f.previous);
    const glm::dvec3 n = area_normal(at, p, q);
    const double length = glm::length(n);
    if (!(length > 0)) continue;
    const glm::dvec3 unit = n / length;
    normal += n;
    centre += length / 3 * (at + p + q);
    area += length;
    original_.for_points(f.face, [&](const OriginalPoint& point) {
      const int slot = static_cast<int>(f.slot);
      const double own = point.barycentric[slot];
      const double weight = double(point.weight) * (1 + double(point.distance2) * far);
      const glm::dvec3 rest = double(point.barycentric[(slot + 1) % 3]) * p +
                              double(point.barycentric[(slot + 2) % 3]) * q;
      error.add_plane(own * unit, -glm::dot(unit, point.position - rest), weight);
      weights += weight * own * own;
      const glm::dvec3 d = point.position - at;
      if (glm::dot(d, d) >= nearest) return;
      nearest = glm::dot(d, d);
      anchor = &point;
    });
  }
  if (!(area > 0) || !(weights > 0) || anchor == nullptr) return false;
  centre /= area;
  normal /= std::max(glm::length(normal), std::numeric_limits<double>::min());
  const glm::dvec3 plane = anchor->normal;
  const double off = glm::dot(plane, at - anchor->position);
  error.add_plane(plane, -glm::dot(plane, anchor->position),
                  rules.stay * weights * (1 + off * off * off_far));
  error.add_point(centre, rules.pull * weights);
  error.add_plane(normal, -glm::dot(normal, centre), -rules.pull * weights);
  return error.minimum(at, 1e-3 * weights, target);
}

// The points on the faces around the vertex count as planes through their faces, and those of the
// curve by their distance across it, as if each stood for a strip of surface. Along the curve the
// vertex is pulled to the middle, which costs nothing where the curve is straight.
bool Fitter::least_squares_on_curve(Vertex v, const Star& star, const FitRules& rules,
                                    glm::dvec3& target) const {
  constexpr double width = 2;  // of the strip, by the length of the curve around the vertex
  constexpr double along = 10;
  const glm::dvec3 at = mesh_.position(v);
  const CurvePlace place = curves_.around(v);
  const double length = curves_.length(place);
  const glm::dvec3 a = mesh_.position(place.far[0]) - at, b = mesh_.position(place.far[1]) - at;
  const double chord = glm::length(b - a);
  if (!(length > 0) || !(chord > 0)) return false;
  Quadric error = curves_.quadric(mesh_, place, at);  // as seen from the vertex
  error *= width * length;
  const double weights = width * length * length / 3 + add_points(v, star, error);
  const glm::dvec3 tangent = (b - a) / chord;
  error.add_plane(tangent, -glm::dot(tangent, a + b) / 2, along * rules.pull * weights);
  if (!error.minimum(glm::dvec3(0.0), 1e-3 * weights, target)) return false;
  target += at;
  return true;
}

double Fitter::add_points(Vertex v, const Star& star, Quadric& error) const {
  const glm::dvec3 at = mesh_.position(v);
  double weights = 0;
  for (const StarFace& f : star) {
    const glm::dvec3 p = mesh_.position(f.next) - at, q = mesh_.position(f.previous) - at;
    const glm::dvec3 n = glm::cross(p, q);
    const double length = glm::length(n);
    if (!(length > 0)) continue;
    const int slot = static_cast<int>(f.slot);
    original_.for_points(f.face, [&](const OriginalPoint& point) {
      const double own = point.barycentric[slot];
      const glm::dvec3 rest = double(point.barycentric[(slot + 1) % 3]) * p +
                              double(point.barycentric[(slot + 2) % 3]) * q;
      error.add_plane(own / length * n, -glm::dot(n / length, point.position - at - rest),
                      point.weight);
      weights += double(point.weight) * own * own;
    });
  }
  return weights;
}

bool Fitter::looks_away(const glm::dvec3& original, const glm::dvec3& normal,
                        const FitRules& rules) {
  return original != glm::dvec3(0.0) && !rules.max_away.allows(original, normal);
}

Verdict Fitter::judge_target(Vertex v, const Star& star, const glm::dvec3& target,
                             const FitRules& rules) const {
  constexpr double poor = 0.2;
  const glm::dvec3 from = mesh_.position(v);
  for (const StarFace& f : star) {
    const glm::dvec3 p = mesh_.position(f.next), q = mesh_.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(target, p, q);
    if (is_flat(target, p, q, after)) return {Reason::Flat, f.face};
    if (!rules.max_turn.allows(before, after))
      return {Reason::Angle, f.face, cosine_between(before, after)};
    const glm::dvec3 original = original_.normal_under(f.face);
    if (looks_away(original, after, rules) && !looks_away(original, before, rules))
      return {Reason::Angle, f.face, cosine_between(original, after)};
    const double quality = triangle_quality(target, p, q);
    if (quality < poor && quality < triangle_quality(from, p, q))
      return {Reason::Quality, f.face, smallest_angle_cosine(target, p, q)};
    const double cosine = smallest_angle_cosine(target, p, q);
    if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }))
      return {Reason::Shape, f.face, cosine};
  }
  return {};
}

Verdict Fitter::judge_move(Vertex v, const FitRules& rules, Star& star, glm::dvec3& target) const {
  const bool on_curve = mesh_.classification(v).dimension() < 2;
  if (on_curve && !curves_.inside(v)) return {Reason::Classification, v};
  gather(mesh_, v, star);
  const glm::dvec3 from = mesh_.position(v);
  glm::dvec3 wanted;
  if (!(on_curve ? least_squares_on_curve(v, star, rules, wanted)
                 : least_squares(v, star, rules, wanted)))
    return {Reason::Flat, v};
  Verdict verdict;
  for (double part = 1; part > 0.2; part /= 2) {
    target = from + part * (wanted - from);
    if (rules.model) target = rules.model->snap(mesh_.classification(v), target);
    verdict = on_curve && leaves_curve(v, target) ? Verdict(Reason::Quality, v)
                                                  : judge_target(v, star, target, rules);
    if (values_ && verdict.accepted() && loses_values(v, star, target, rules))
      verdict = {Reason::Quality, v};
    if (verdict.accepted()) break;
  }
  return verdict;
}

// What the shape would gain must not cost the numbers beside it much.
bool Fitter::loses_values(Vertex v, const Star& star, const glm::dvec3& target,
                          const FitRules& rules) const {
  constexpr double most = 0.1;  // of the error of an average face
  return values_->propose(v, star, target) > most * rules.face_energy;
}

// What the surface beside a curve would gain must not cost the curve much.
bool Fitter::leaves_curve(Vertex v, const glm::dvec3& target) const {
  constexpr double most = 1.2;  // of its error before
  const CurvePlace place = curves_.around(v);
  return curves_.error(mesh_, place, target).squares >
         most * curves_.error(mesh_, place, mesh_.position(v)).squares;
}

double Fitter::error_of_values(const EdgePair& pair) const {
  double error = 0;
  for (const Face f : {pair.f, pair.g})
    original_.for_points(f, [&, t = mesh_.triangle(f)](const OriginalPoint& p) {
      error += double(p.weight) * values_->error(p, t, p.barycentric);
    });
  return error;
}

// At a point that would lie on one of the two new faces, the first or the second.
double Fitter::error_of_values(const EdgePair& pair, const OriginalPoint& p, const TwoPoints& at,
                               std::size_t face) const {
  using Corners = std::array<Vertex, 3>;
  const Corners corners =
      face == 0 ? Corners{pair.d, pair.b, pair.c} : Corners{pair.c, pair.a, pair.d};
  return values_->error(p, corners, {at.x[face], at.y[face], at.z[face]});
}

// What the energy falls by. Where that is not enough, something that is not enough either.
double Fitter::swap_gain(const EdgePair& pair, const FitRules& rules, double enough) const {
  const glm::dvec3 a = mesh_.position(pair.a), b = mesh_.position(pair.b),
                   c = mesh_.position(pair.c), d = mesh_.position(pair.d);
  const double shapes =
      misshape(a, b, c) + misshape(b, a, d) - misshape(d, b, c) - misshape(c, a, d);
  double before = 0;
  for (const Face f : {pair.f, pair.g})
    original_.for_points(
        f, [&](const OriginalPoint& p) { before += double(p.weight) * double(p.distance2); });
  if (values_) before += error_of_values(pair);
  double unit = rules.face_energy;
  if (rules.local > 0)
    unit *= std::pow(std::min(1.0, before / (2 * rules.face_energy)), rules.local);
  const double gain = rules.shape * unit * shapes;
  if (gain + before <= 0) return gain;  // even without any error left it would not pay
  const TwoPoints corners[] = {two_points(d, c), two_points(b, a), two_points(c, d)};
  double after = 0;
  const auto add = [&](const OriginalPoint& p) {
    TwoPoints at;
    const DoubleLanes distance2 =
        nearest_barycentric(TwoPoints(p.position), corners[0], corners[1], corners[2], at);
    after += double(p.weight) * std::min(distance2[0], distance2[1]);
    const std::size_t nearer = distance2[1] < distance2[0] ? 1 : 0;
    if (values_) after += double(p.weight) * error_of_values(pair, p, at, nearer);
    return gain + before - after > enough;
  };
  if (original_.for_points_while(pair.f, add)) original_.for_points_while(pair.g, add);
  return gain + before - after;
}

Verdict Fitter::judge_swap(Vertex a, Vertex b, const FitRules& rules, EdgePair& pair) const {
  constexpr double least_gain =
      1e-9;  // of the energy of a face; less is noise and could swap back and forth
  if (const Verdict v = find_pair(mesh_, a, b, pair); !v.accepted()) return v;
  const glm::dvec3 pa = mesh_.position(pair.a), pb = mesh_.position(pair.b),
                   pc = mesh_.position(pair.c), pd = mesh_.position(pair.d);
  const glm::dvec3 both = area_normal(pa, pb, pc) + area_normal(pb, pa, pd);
  const glm::dvec3 new_f = area_normal(pd, pb, pc), new_g = area_normal(pc, pa, pd);
  if (is_flat(pd, pb, pc, new_f)) return {Reason::Flat, pair.f};
  if (is_flat(pc, pa, pd, new_g)) return {Reason::Flat, pair.g};
  const glm::dvec3 original = original_.normal_under(pair.f) + original_.normal_under(pair.g);
  for (const glm::dvec3& now : {new_f, new_g}) {
    if (!rules.max_turn.allows(both, now))
      return {Reason::Angle, pair.f, cosine_between(both, now)};
    if (looks_away(original, now, rules))
      return {Reason::Angle, pair.f, cosine_between(original, now)};
  }
  const double worst =
      std::max(smallest_angle_cosine(pd, pb, pc), smallest_angle_cosine(pc, pa, pd));
  if (!rules.least_angle.allows(worst, [&] {
        return std::max(smallest_angle_cosine(pa, pb, pc), smallest_angle_cosine(pb, pa, pd));
      }))
    return {Reason::Shape, pair.f, worst};
  const double enough = least_gain * rules.face_energy;
  if (!(swap_gain(pair, rules, enough) > enough)) return {Reason::Quality, pair.f, worst};
  if (joined(mesh_, pair.c, pair.d)) return {Reason::Topology, pair.c};
  return {};
}

void Fitter::swapped(const EdgePair& pair) {
  const auto corners = [&](Face face, Vertex from, Vertex to) {
    auto t = mesh_.triangle(face);
    std::replace(t.begin(), t.end(), from, to);
    return std::array{mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])};
  };
  const auto f = corners(pair.f, pair.a, pair.d), g = corners(pair.g, pair.b, pair.c);
  original_.redistribute(pair.f, pair.g, [&](OriginalPoint& p) {
    glm::dvec3 on_f, on_g;
    const double to_f = nearest_barycentric(p.position, f[0], f[1], f[2], on_f);
    const double to_g = nearest_barycentric(p.position, g[0], g[1], g[2], on_g);
    p.distance2 = static_cast<float>(std::min(to_f, to_g));
    p.barycentric = to_f <= to_g ? on_f : on_g;
    return to_f <= to_g;
  });
}

}  // namespace aomd
