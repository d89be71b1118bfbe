// What the quality strategy says about an operation on a volume that it has not made.

#include <algorithm>

#include "core/decimate/volume/volume_quality_loop.h"

namespace aomd {

Verdict VolumeQualityLoop::judge(Edge edge, Vertex& deleted) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  Scratch scratch;
  Plan plan;
  Verdict verdict = judge_edge(a, b, scratch, plan);
  if (verdict.reason == Reason::Spacing) verdict.entity = edge;
  if (!scratch.places.empty()) deleted = scratch.places.front().contraction.deleted;
  if (verdict.accepted()) deleted = plan.collapse.contraction.deleted;
  return verdict;
}

Verdict VolumeQualityLoop::judge(Vertex a, Vertex b) {
  Scratch scratch;
  Plan plan;
  return judge_edge(a, b, scratch, plan);
}

Verdict VolumeQualityLoop::judge_edge(Vertex a, Vertex b, Scratch& scratch, Plan& plan) {
  for (const Vertex v : {a, b})
    if (!among_tets(v)) return {Reason::Kept, v};
  const double length = glm::length(mesh_.position(a) - mesh_.position(b));
  if (!(length < std::max(reach_of(a), reach_of(b)))) return {Reason::Spacing, a, length};
  if (options_.kept(a) && options_.kept(b)) return {Reason::Kept, a};
  if (!(cost(a, b) < unlimited))
    return {Reason::Classification, mesh_.classification(a).dimension() == 0 ? a : b};
  return judge(a, b, scratch, plan);
}

std::vector<CollapseOutlook> VolumeQualityLoop::outlook(Edge edge) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  CollapseOutlook o;
  Scratch scratch;
  Plan plan;
  o.contraction = {a, b, mesh_.position(b)};
  o.verdict = judge_edge(a, b, scratch, plan);
  if (!scratch.places.empty()) o.contraction = scratch.places.front().contraction;
  if (o.verdict.accepted()) o.contraction = plan.collapse.contraction;
  o.limits.turn_deg = rules_.faces.max_turn.angle_deg();
  o.limits.min_angle_deg = rules_.faces.least_angle.angle_deg();
  if (mesh_.classification(edge).dimension() == 1)
    o.limits.curve_deg = rules_.faces.max_curve_turn.angle_deg();
  o.length = glm::length(mesh_.position(a) - mesh_.position(b));
  o.longest = std::max(reach_of(a), reach_of(b));
  if (const float known = cost(a, b); known < unlimited) o.cost = double(known);
  return {o};
}

// Removing an edge is told by the tetrahedra around it, which a surface's outlook has no words for.
std::optional<SwapOutlook> VolumeQualityLoop::swap_outlook(Edge) { return {}; }

std::optional<MoveOutlook> VolumeQualityLoop::move_outlook(Vertex v) {
  MoveOutlook o;
  o.vertex = v;
  o.target = mesh_.position(v);
  Scratch scratch;
  glm::dvec3 x(0.0);
  if (options_.kept(v))
    o.verdict = {Reason::Kept, v};
  else if (mesh_.classification(v).dimension() == 0)
    o.verdict = {Reason::Classification, v};
  else if (find_target(v, scratch, x))
    o.target += x;
  else
    o.verdict = {Reason::Quality, v};
  o.limits.turn_deg = improving_.removal.max_turn.angle_deg();
  return o;
}

Reason VolumeQualityLoop::last_refusal(Edge e) const {
  return e.index < refusal_.size() ? refusal_[e] : Reason::None;
}

double VolumeQualityLoop::spacing(Vertex v) const {
  return v.index < state_.size() ? 2 * reach_of(v) : 0;
}

}  // namespace aomd
