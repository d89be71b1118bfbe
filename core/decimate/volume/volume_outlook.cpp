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
  return judge(a, b, scratch, plan, alone_.collapser);
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
  o.limits = limits();
  o.limits.turn_deg = rules_.faces.max_turn.angle_deg();
  if (mesh_.classification(edge).dimension() == 1)
    o.limits.curve_deg = rules_.faces.max_curve_turn.angle_deg();
  o.length = glm::length(mesh_.position(a) - mesh_.position(b));
  o.longest = std::max(reach_of(a), reach_of(b));
  if (const float known = cost(a, b); known < unlimited) o.cost = double(known);
  return {o};
}

// Of improvement.
Limits VolumeQualityLoop::limits() const {
  Limits limits;
  limits.turn_deg = improving_.removal.max_turn.angle_deg();
  limits.min_angle_deg = rules_.faces.least_angle.angle_deg();
  limits.min_dihedral_deg = rules_.least_dihedral.angle_deg();
  limits.distance = options_.max_distance;
  limits.volume_pct = options_.keep_volumes ? 100 * most_owed : 0;
  limits.regions = true;
  return limits;
}

// By the tetrahedra around the edge; of a pair of faces only the ends of the edge are known inside
// a region.
std::optional<SwapOutlook> VolumeQualityLoop::swap_outlook(Edge edge) {
  SwapOutlook o;
  const auto [a, b] = mesh_.edge_vertices(edge);
  Plan plan;
  o.verdict = aomd::judge(mesh_, a, b, improving_.removal, plan.removal);
  if (o.verdict.accepted()) o.verdict = judge_removal(plan.removal, plan.change);
  o.limits = limits();
  const EdgeRing& ring = plan.removal.ring;
  o.pair.a = a;
  o.pair.b = b;
  const bool no_ring =
      o.verdict.reason == Reason::Classification || o.verdict.reason == Reason::Topology;
  if (!no_ring && ring.on_model_face())
    o.pair = {ring.faces[0], ring.faces[1], ring.a, ring.b, ring.apexes[0], ring.apexes[1]};
  return o;
}

std::optional<MoveOutlook> VolumeQualityLoop::move_outlook(Vertex v) {
  MoveOutlook o;
  o.vertex = v;
  o.target = mesh_.position(v);
  Scratch scratch;
  Plan plan;
  glm::dvec3 x(0.0);
  if (options_.kept(v))
    o.verdict = {Reason::Kept, v};
  else if (const Region other = first_other_shape(mesh_, v); other.valid())
    o.verdict = {Reason::Kept, other};
  else if (mesh_.classification(v).dimension() == 0)
    o.verdict = {Reason::Classification, v};
  else if (!find_target(v, scratch, x))
    o.verdict = {Reason::Quality, v};
  else if (o.verdict = judge_move(v, x, scratch, plan.change); o.verdict.accepted())
    o.target += x;
  o.limits = limits();
  return o;
}

Reason VolumeQualityLoop::last_refusal(Edge e) const {
  return e.index < refusal_.size() ? refusal_[e] : Reason::None;
}

double VolumeQualityLoop::spacing(Vertex v) const {
  return v.index < state_.size() ? 2 * reach_of(v) : 0;
}

}  // namespace aomd
