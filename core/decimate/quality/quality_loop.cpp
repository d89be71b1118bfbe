#include "core/decimate/quality/quality_loop.h"

namespace aomd {

// A mesh of slivers cannot reach its target without making some. Then only what the user asked for
// binds.
bool QualityLoop::relax() {
  const bool stuck = goals_[stage_] > 0 && mesh_.count(2) > goals_[stage_];
  if (!stuck || !rules_.least_around.binds()) return false;
  rules_.least_around = LeastAngle(0);
  fit_.least_angle = rules_.least_angle;
  queue_.refill();
  return true;
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is
// cheaper.
bool QualityLoop::advance_collapse() {
  const std::uint32_t goal = goals_[stage_];
  const Vertex v = goal > 0 && mesh_.count(2) <= goal ? Vertex() : queue_.pop();
  if (!v.valid()) {
    if (!relax()) begin_improvement();
    return false;
  }
  Trial cheapest;
  if (queue_.cheapest(v, cheapest.candidate)) {
    cheapest.reason = try_collapse(cheapest.candidate);
    if (cheapest.reason == Reason::None) return true;
  }
  return try_others(v, cheapest);
}

// The cheapest candidate is not known any more, or not allowed: then it is not judged again. One
// that would leave a sliver waits until others cost so much more.
bool QualityLoop::try_others(Vertex v, const Trial& cheapest) {
  const std::vector<CollapseQueue::Candidate>& found = queue_.take_all(v);
  float later = CollapseQueue::unlimited;
  for (std::size_t i = 0; i < found.size() && found[i].cost <= later; ++i) {
    if (queue_.put_off(v, i, later)) return false;
    const Reason reason = cheapest.is_of(found[i]) ? cheapest.reason : try_collapse(found[i]);
    if (reason == Reason::None) return true;
    if (reason == Reason::Shape && !pays_for_sliver(found[i]))
      later = std::min(later, sliver_price_ * found[i].cost);
  }
  if (later < CollapseQueue::unlimited) queue_.wait(v, later);
  return false;
}

Verdict QualityLoop::judge(const Contraction& c, Plan& plan) {
  const CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser_.judge(mesh_, c, rules_, plan.collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, c, collapse.around_deleted(), collapse.around_kept());
}

Reason QualityLoop::try_collapse(const CollapseQueue::Candidate& candidate) {
  const Contraction& c = candidate.contraction;
  const LeastAngle usual = rules_.least_around;
  if (pays_for_sliver(candidate)) rules_.least_around = LeastAngle(0);
  const Reason reason = judge(c, plan_).reason;
  rules_.least_around = usual;
  if (reason == Reason::None)
    collapse(c);
  else
    refused(c, reason);
  return reason;
}

void QualityLoop::refused(const Contraction& c, Reason reason) {
  ++sweeps_.back().refused[static_cast<std::size_t>(reason)];
  if (!mesh_.stored(0, 1)) return;
  if (const Edge e = mesh_.find_edge(c.deleted, c.kept); e.valid() && e.index < refusal_.size())
    refusal_[e] = reason;
}

void QualityLoop::collapse(const Contraction& c) {
  queue_.merge(c);
  original_.merged(c.deleted, c.kept);
  collapser_.apply(mesh_, plan_.collapse);
  curves_.merged(mesh_, c.deleted, c.kept);
  queue_.refresh_around(c.kept);
  if (rules_.topology == TopologyRule::Paper) queue_.forget_lost_edges(plan_.collapse);
  made(StepKind::Collapse, c.kept, plan_.change);
}

}  // namespace aomd
