// What the quality strategy says about an operation that it has not made.

#include <algorithm>

#include "core/decimate/quality/quality_loop.h"

namespace aomd {

Verdict QualityLoop::judge(Edge edge, Vertex& deleted) {
  CollapseQueue::Candidate candidate;
  const Verdict verdict = judge(edge, candidate);
  deleted = candidate.contraction.deleted;
  return verdict;
}

Verdict QualityLoop::judge(Vertex a, Vertex b) {
  CollapseQueue::Candidate candidate;
  return judge(a, b, candidate);
}

Verdict QualityLoop::judge(Edge edge, CollapseQueue::Candidate& candidate) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  Verdict verdict = judge(a, b, candidate);
  if (verdict.reason == Reason::Spacing) verdict.entity = edge;
  return verdict;
}

Verdict QualityLoop::judge(Vertex a, Vertex b, CollapseQueue::Candidate& candidate) {
  candidate = {{a, b, mesh_.position(b)}, CollapseQueue::unlimited};
  const double length = glm::length(mesh_.position(a) - mesh_.position(b));
  if (!(length < double(std::max(queue_.reach(a), queue_.reach(b)))))
    return {Reason::Spacing, a, length};
  const bool a_kept = options_.kept(a), b_kept = options_.kept(b);
  if (options_.seal_kept ? a_kept || b_kept : a_kept && b_kept)
    return {Reason::Kept, a_kept ? a : b};
  candidate.cost = queue_.cost(a, b, candidate.contraction);
  if (!(candidate.cost < CollapseQueue::unlimited))
    return {Reason::Classification, mesh_.classification(a).dimension() == 0 ? a : b};
  Plan plan;
  return judge(candidate.contraction, rules_, alone_.collapser, plan);
}

Limits QualityLoop::limits(const TurnLimit& turn, double least_angle_deg) const {
  Limits limits;
  limits.turn_deg = turn.angle_deg();
  limits.away_deg = options_.has(Idea::Facing) ? rules_.max_away.angle_deg() : 0;
  limits.min_angle_deg = least_angle_deg;
  limits.distance = options_.max_distance;
  return limits;
}

std::vector<CollapseOutlook> QualityLoop::outlook(Edge edge) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  CollapseOutlook o;
  CollapseQueue::Candidate candidate;
  o.verdict = judge(edge, candidate);
  o.contraction = candidate.contraction;
  o.limits = limits(rules_.max_turn,
                    std::max(rules_.least_angle.angle_deg(), rules_.least_around.angle_deg()));
  if (!rules_.original_normals) o.limits.away_deg = 0;
  if (mesh_.classification(edge).dimension() == 1 && rules_.topology == TopologyRule::Safe)
    o.limits.curve_deg = rules_.max_curve_turn.angle_deg();
  o.length = glm::length(mesh_.position(a) - mesh_.position(b));
  o.longest = double(std::max(queue_.reach(a), queue_.reach(b)));
  if (candidate.cost < CollapseQueue::unlimited) o.cost = double(candidate.cost);
  return {o};
}

// They are judged by the points of the original on the faces, which collapses leave behind.
std::optional<SwapOutlook> QualityLoop::swap_outlook(Edge edge) {
  if (phase_ == Phase::Collapse) return {};
  const auto [a, b] = mesh_.edge_vertices(edge);
  SwapOutlook o;
  Change change;
  o.verdict = fitter_.judge_swap(a, b, fit_, o.pair);
  if (o.verdict.accepted() && keeps_face_of(o.pair)) o.verdict = {Reason::Kept, a};
  if (o.verdict.accepted()) o.verdict = guards_.judge(mesh_, change, o.pair);
  o.limits = limits(fit_.max_turn, fit_.least_angle.angle_deg());
  return o;
}

std::optional<MoveOutlook> QualityLoop::move_outlook(Vertex v) {
  if (phase_ == Phase::Collapse) return {};
  MoveOutlook o;
  o.vertex = v;
  o.target = mesh_.position(v);
  Star star;
  Change change;
  o.verdict =
      options_.kept(v) ? Verdict(Reason::Kept, v) : fitter_.judge_move(v, fit_, star, o.target);
  if (o.verdict.accepted()) o.verdict = guards_.judge(mesh_, change, v, star, o.target);
  o.limits = limits(fit_.max_turn, fit_.least_angle.angle_deg());
  return o;
}

Reason QualityLoop::last_refusal(Edge e) const {
  return e.index < refusal_.size() ? refusal_[e] : Reason::None;
}

double QualityLoop::spacing(Vertex v) const { return 2.0 * double(queue_.reach(v)); }

}  // namespace aomd
