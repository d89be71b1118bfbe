#include "core/operators/smooth.h"

#include "core/mesh/journal_scope.h"
#include "core/operators/star.h"

namespace aomd {
namespace {

// Average of the neighbours; on a model edge, of those along it. False where there is nothing to
// average. `far` gives the i-th neighbour; `along` tells whether the edge to it lies on what the
// vertex lies on.
template <typename Far, typename Along>
bool find_target(const Mesh& mesh, Vertex v, std::size_t neighbours, Far&& far, Along&& along,
                 glm::dvec3& target) {
  const bool on_curve = mesh.classification(v).dimension() == 1;
  glm::dvec3 sum(0.0);
  int count = 0;
  for (std::size_t i = 0; i < neighbours; ++i) {
    if (on_curve && !along(i)) continue;
    sum += mesh.position(far(i));
    ++count;
  }
  if (count == 0 || (on_curve && count != 2)) return false;
  target = sum / double(count);
  return true;
}

Verdict judge_move(const Mesh& mesh, Vertex v, const SmoothRules& rules, glm::dvec3& target) {
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

}  // namespace

Verdict judge_smooth(const Mesh& mesh, Vertex v, const SmoothRules& rules, glm::dvec3& target) {
  const ModelRef on = mesh.classification(v);
  const Row<1> edges = mesh.row<1>(v);
  const auto far = [&](std::size_t i) { return mesh.other_end(edges[i], v); };
  const auto along = [&](std::size_t i) { return mesh.classification(edges[i]) == on; };
  if (on.dimension() == 0 || !find_target(mesh, v, edges.size(), far, along, target))
    return {Reason::Classification, v};
  return judge_move(mesh, v, rules, target);
}

Verdict judge_smooth(const Mesh& mesh, Vertex v, std::span<const Vertex> neighbours,
                     const SmoothRules& rules, glm::dvec3& target) {
  const ModelRef on = mesh.classification(v);
  const auto far = [&](std::size_t i) { return neighbours[i]; };
  const auto along = [&](std::size_t i) {
    if (!may_end_model_edge(mesh, neighbours[i])) return false;
    const Edge e = mesh.find_edge(v, neighbours[i]);
    return e.valid() && mesh.classification(e) == on;
  };
  if (on.dimension() == 0 || !find_target(mesh, v, neighbours.size(), far, along, target))
    return {Reason::Classification, v};
  return judge_move(mesh, v, rules, target);
}

void apply_smooth(Mesh& mesh, Vertex v, const glm::dvec3& target) {
  const JournalScope step(mesh, StepKind::Smooth, v);
  mesh.move(v, target);
}

}  // namespace aomd
