#include "core/operators/collapse_checks.h"

#include <algorithm>

namespace aomd {
namespace {

// The cosine of the smallest angle of all faces around a vertex.
double smallest_angle_around(const Mesh& mesh, const Star& star, const glm::dvec3& centre) {
  double cosine = 0.5;
  for (const StarFace& f : star)
    cosine = std::max(
        cosine, smallest_angle_cosine(centre, mesh.position(f.next), mesh.position(f.previous)));
  return cosine;
}

}  // namespace

// The faces that stay when `moved` goes to `to`; those that also use `other` fall away.
Verdict judge_faces(const Mesh& mesh, const Star& star, const EndMove& move,
                    const CollapseRules& rules) {
  const glm::dvec3 from = mesh.position(move.vertex), to = move.to;
  for (const StarFace& f : star) {
    if (f.uses(move.other)) continue;
    const glm::dvec3 p = mesh.position(f.next), q = mesh.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    if (is_flat(to, p, q, after)) return {Reason::Flat, f.face};
    if (!rules.max_turn.allows(before, after) && !is_flat(from, p, q, before))
      return {Reason::Angle, f.face, cosine_between(before, after)};
    if (rules.original_normals) {
      const Column<Vertex, glm::vec3>& normals = *rules.original_normals;
      const glm::dvec3 original(normals[move.vertex] + normals[move.other] + normals[f.next] +
                                normals[f.previous]);
      if (original != glm::dvec3(0.0) && !rules.max_away.allows(original, after))
        return {Reason::Angle, f.face, cosine_between(original, after)};
    }
    if (!rules.least_angle.binds() && !rules.least_around.binds()) continue;
    const double cosine = smallest_angle_cosine(to, p, q);
    if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }) ||
        !rules.least_around.allows(cosine, [&] { return smallest_angle_around(mesh, star, from); }))
      return {Reason::Shape, f.face, cosine};
  }
  return {};
}

// The curve u - deleted - kept becomes u - kept: neither of its two old directions may turn too
// far.
Verdict judge_curve(const Mesh& mesh, const Star& star, ModelRef model, const Contraction& c,
                    const TurnLimit& limit) {
  Verdict verdict;
  const glm::dvec3 from = mesh.position(c.deleted);
  for_edges_at(mesh, c.deleted, star, [&](Edge e, Vertex far) {
    if (far == c.kept || mesh.classification(e) != model || !verdict.accepted()) return;
    const glm::dvec3 start = mesh.position(far), now = c.position - start;
    for (const glm::dvec3& old : {from - start, c.position - from})
      if (!limit.allows(old, now)) verdict = {Reason::Angle, e, cosine_between(old, now)};
  });
  return verdict;
}

// The rest of the curve beyond the kept vertex, where that moves.
Verdict judge_rest_of_curve(const Mesh& mesh, const Star& star, ModelRef model,
                            const Contraction& c, const TurnLimit& limit) {
  Verdict verdict;
  for_edges_at(mesh, c.kept, star, [&](Edge e, Vertex far) {
    if (far == c.deleted || mesh.classification(e) != model || !verdict.accepted()) return;
    const glm::dvec3 end = mesh.position(far), old = end - mesh.position(c.kept),
                     now = end - c.position;
    if (!limit.allows(old, now)) verdict = {Reason::Angle, e, cosine_between(old, now)};
  });
  return verdict;
}

}  // namespace aomd
