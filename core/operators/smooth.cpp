#include "core/operators/smooth.h"

#include "core/mesh/journal_scope.h"
#include "core/operators/star.h"

namespace aomd {
namespace {

// Average of the neighbours; on a model edge, of those along it. False where there is nothing to
// average.
bool find_target(const Mesh& mesh, Vertex v, glm::dvec3& target) {
  const ModelRef model = mesh.classification(v);
  glm::dvec3 sum(0.0);
  int count = 0;
  for (const Edge e : mesh.row<1>(v)) {
    if (model.dimension() == 1 && mesh.classification(e) != model) continue;
    sum += mesh.position(mesh.other_end(e, v));
    ++count;
  }
  if (count == 0 || (model.dimension() == 1 && count != 2)) return false;
  target = sum / double(count);
  return true;
}

}  // namespace

Verdict judge_smooth(const Mesh& mesh, Vertex v, const SmoothRules& rules, glm::dvec3& target) {
  if (mesh.classification(v).dimension() == 0 || !find_target(mesh, v, target))
    return {Reason::Classification, v};
  if (const ModelRef on = mesh.classification(v); rules.model && on.valid())
    target = rules.model->snap(on, target);
  const glm::dvec3 from = mesh.position(v);
  std::vector<std::uint32_t> derived;
  for (const Face f : faces_around(mesh, v, derived)) {
    const auto t = mesh.triangle(f);
    const int slot = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const glm::dvec3 p = mesh.position(t[static_cast<std::size_t>((slot + 1) % 3)]);
    const glm::dvec3 q = mesh.position(t[static_cast<std::size_t>((slot + 2) % 3)]);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(target, p, q);
    if (is_flat(target, p, q, after)) return {Reason::Flat, f};
    if (!rules.max_turn.allows(before, after) && !is_flat(from, p, q, before))
      return {Reason::Angle, f, cosine_between(before, after)};
    if (!rules.least_angle.binds()) continue;
    const double cosine = smallest_angle_cosine(target, p, q);
    if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }))
      return {Reason::Shape, f, cosine};
  }
  return {};
}

void apply_smooth(Mesh& mesh, Vertex v, const glm::dvec3& target) {
  const JournalScope step(mesh, StepKind::Smooth, v);
  mesh.move(v, target);
}

}  // namespace aomd
