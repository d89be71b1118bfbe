#include "core/operators/collapse_checks.h"

#include <algorithm>
#include <array>

#include "core/base/lanes.h"

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

// What the original looks like around the corners of a face that stretches, or 0.
glm::dvec3 original_normal(const EndMove& move, const StarFace& f, const CollapseRules& rules) {
  const Column<Vertex, glm::vec3>& normals = *rules.original_normals;
  return glm::dvec3(normals[move.vertex] + normals[move.other] + normals[f.next] +
                    normals[f.previous]);
}

// Whether a face neither gets flat nor turns too far, unless it was flat before.
inline Verdict judge_turn(const TurnLimit& limit, const StarFace& f, const glm::dvec3& from,
                          const glm::dvec3& to, const glm::dvec3& p, const glm::dvec3& q) {
  const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
  if (limit.allows(before, after) & has_area(to, p, q, after)) return {};
  if (is_flat(to, p, q, after)) return {Reason::Flat, f.face};
  if (is_flat(from, p, q, before)) return {};
  return {Reason::Angle, f.face, cosine_between(before, after)};
}

Verdict judge_face(const Mesh& mesh, const Star& star, const StarFace& f, const EndMove& move,
                   const CollapseRules& rules) {
  const glm::dvec3 from = mesh.position(move.vertex), to = move.to;
  const glm::dvec3 p = mesh.position(f.next), q = mesh.position(f.previous);
  if (const Verdict v = judge_turn(rules.max_turn, f, from, to, p, q); !v.accepted()) return v;
  if (rules.original_normals) {
    const glm::dvec3 original = original_normal(move, f, rules), after = area_normal(to, p, q);
    if (original != glm::dvec3(0.0) && !rules.max_away.allows(original, after))
      return {Reason::Angle, f.face, cosine_between(original, after)};
  }
  if (!rules.least_angle.binds() && !rules.least_around.binds()) return {};
  const double cosine = smallest_angle_cosine(to, p, q);
  if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }) ||
      !rules.least_around.allows(cosine, [&] { return smallest_angle_around(mesh, star, from); }))
    return {Reason::Shape, f.face, cosine};
  return {};
}

// Where nothing but turning is limited.
Verdict judge_turns(const Mesh& mesh, const Star& star, const EndMove& move,
                    const TurnLimit& limit) {
  const glm::dvec3 from = mesh.position(move.vertex), to = move.to;
  for (const StarFace& f : star) {
    if (f.uses(move.other)) continue;
    const glm::dvec3 &p = mesh.position(f.next), &q = mesh.position(f.previous);
    if (const Verdict v = judge_turn(limit, f, from, to, p, q); !v.accepted()) return v;
  }
  return {};
}

// Two faces that stretch, held against the original too: in which lanes no limit is touched, so
// that judge_face() would accept.
DoubleLanes::Mask are_fine(const Mesh& mesh, const std::array<const StarFace*, 2>& faces,
                           const EndMove& move, const CollapseRules& rules) {
  const StarFace &f = *faces[0], &g = *faces[1];
  const TwoPoints from(mesh.position(move.vertex)), to(move.to);
  const TwoPoints p = two_points(mesh.position(f.next), mesh.position(g.next));
  const TwoPoints q = two_points(mesh.position(f.previous), mesh.position(g.previous));
  const TwoPoints original =
      two_points(original_normal(move, f, rules), original_normal(move, g, rules));
  const TwoPoints after = area_normal(to, p, q);
  const auto turned = rules.max_turn.allows(area_normal(from, p, q), after);
  const auto fine = has_area(to, p, q, after) & turned & rules.max_away.allows(original, after);
  if (!rules.least_angle.binds() && !rules.least_around.binds()) return fine;
  const DoubleLanes cosine = smallest_angle_cosine(to, p, q);
  return fine & rules.least_angle.holds_for(cosine) & rules.least_around.holds_for(cosine);
}

// Most faces pass all limits: those that do not are judged again, for the reason.
Verdict judge_in_pairs(const Mesh& mesh, const Star& star, const EndMove& move,
                       const CollapseRules& rules) {
  std::array<const StarFace*, 2> two;
  std::size_t count = 0;
  const auto judge_both = [&] {
    const auto fine = are_fine(mesh, {two[0], two[count - 1]}, move, rules);
    for (std::size_t i = 0; i < count; ++i)
      if (fine[i] == 0)
        if (const Verdict v = judge_face(mesh, star, *two[i], move, rules); !v.accepted()) return v;
    count = 0;
    return Verdict();
  };
  for (const StarFace& f : star) {
    if (f.uses(move.other)) continue;
    two[count++] = &f;
    if (count < two.size()) continue;
    if (const Verdict v = judge_both(); !v.accepted()) return v;
  }
  return count > 0 ? judge_both() : Verdict();
}

}  // namespace

// The faces that stay when `moved` goes to `to`; those that also use `other` fall away. Where only
// turning is limited there is too little to compute for pairs to pay.
Verdict judge_faces(const Mesh& mesh, const Star& star, const EndMove& move,
                    const CollapseRules& rules) {
  if (rules.original_normals) return judge_in_pairs(mesh, star, move, rules);
  if (!rules.least_angle.binds() && !rules.least_around.binds())
    return judge_turns(mesh, star, move, rules.max_turn);
  for (const StarFace& f : star) {
    if (f.uses(move.other)) continue;
    if (const Verdict v = judge_face(mesh, star, f, move, rules); !v.accepted()) return v;
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
