#include "core/operators/region_checks.h"

#include <algorithm>
#include <optional>

#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

using Base = std::array<glm::dvec3, 3>;

Base corners_of(const Mesh& mesh, const BallRegion& r) {
  return {mesh.position(r.others[0]), mesh.position(r.others[1]), mesh.position(r.others[2])};
}

double worst_shape(const Mesh& mesh, const Ball& ball, const glm::dvec3& centre) {
  double worst = 1;
  for (const BallRegion& r : ball) {
    const Base c = corners_of(mesh, r);
    worst = std::min(worst, tet_shape(centre, c[0], c[1], c[2]));
  }
  return worst;
}

double worst_dihedral_cosine(const Mesh& mesh, const Ball& ball, const glm::dvec3& centre) {
  double worst = -1;
  for (const BallRegion& r : ball) {
    const Base c = corners_of(mesh, r);
    worst = std::max(worst, smallest_dihedral_cosine(centre, c[0], c[1], c[2]));
  }
  return worst;
}

// `around` is the worst cosine around the end, once it has been asked for.
Verdict judge_dihedral(const Mesh& mesh, const Ball& ball, const BallRegion& r, const EndMove& move,
                       const LeastAngle& least, std::optional<double>& around) {
  if (!least.binds()) return {};
  const Base c = corners_of(mesh, r);
  const double now = smallest_dihedral_cosine(move.to, c[0], c[1], c[2]);
  const auto before = [&] {
    if (!around) around = worst_dihedral_cosine(mesh, ball, mesh.position(move.vertex));
    return *around;
  };
  if (!least.allows(now, before)) return {Reason::Shape, r.region, now};
  return {};
}

Verdict judge_lengths(const Mesh& mesh, const BallRegion& r, const EndMove& move,
                      const VolumeRules& rules) {
  const glm::dvec3 from = mesh.position(move.vertex);
  const Column<Vertex, double>& size = *rules.size;
  const double own = std::max(size[move.vertex], size[move.other]);
  for (const Vertex far : r.others) {
    const glm::dvec3 p = mesh.position(far);
    const double length = glm::length(move.to - p);
    if (length > rules.overshoot * std::max(own, size[far]) && length > glm::length(from - p))
      return {Reason::Overshoot, far, length};
  }
  return {};
}

}  // namespace

Verdict judge_regions(const Mesh& mesh, const Ball& ball, const EndMove& move,
                      const VolumeRules& rules) {
  double worst = -1;  // around the end, once it is asked for
  std::optional<double> sharpest;
  for (const BallRegion& r : ball) {
    if (r.uses(move.other)) continue;
    const Base c = corners_of(mesh, r);
    if (!is_upright(move.to, c[0], c[1], c[2])) return {Reason::Inverted, r.region};
    if (rules.overshoot > 0)
      if (const Verdict v = judge_lengths(mesh, r, move, rules); !v.accepted()) return v;
    if (const Verdict v = judge_dihedral(mesh, ball, r, move, rules.least_dihedral, sharpest);
        !v.accepted())
      return v;
    if (!(rules.least_shape > 0)) continue;
    const double shape = tet_shape(move.to, c[0], c[1], c[2]);
    if (shape >= rules.least_shape) continue;
    if (worst < 0) worst = std::max(0.0, worst_shape(mesh, ball, mesh.position(move.vertex)));
    if (shape < worst)
      return {Reason::Shape, r.region, smallest_dihedral_cosine(move.to, c[0], c[1], c[2])};
  }
  return {};
}

ModelRef class_between(const Mesh& mesh, Vertex a, Vertex b, const Star& star, const Ball& ball) {
  if (may_end_model_edge(mesh, a) && may_end_model_edge(mesh, b))
    if (const Edge e = mesh.find_edge(a, b); on_model_edge(mesh, e)) return mesh.classification(e);
  for (const StarFace& f : star)
    if (f.uses(b)) return mesh.classification(f.face);
  for (const BallRegion& r : ball)
    if (r.uses(b)) return mesh.classification(r.region);
  return {};
}

}  // namespace aomd
