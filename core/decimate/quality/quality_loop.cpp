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
  if (Contraction c; queue_.cheapest(v, c) && collapse(c)) return true;
  return try_others(v);
}

// The cheapest candidate is not known any more, or not allowed.
bool QualityLoop::try_others(Vertex v) {
  const std::vector<CollapseQueue::Candidate>& found = queue_.take_all(v);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (queue_.put_off(v, i)) return false;
    if (collapse(found[i].contraction)) return true;
  }
  return false;
}

Verdict QualityLoop::judge(const Contraction& c, Plan& plan) {
  const CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser_.judge(mesh_, c, rules_, plan.collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, c, collapse.around_deleted(), collapse.around_kept());
}

bool QualityLoop::collapse(const Contraction& c) {
  const Verdict verdict = judge(c, plan_);
  if (!verdict.accepted()) {
    ++sweeps_.back().refused[static_cast<std::size_t>(verdict.reason)];
    if (mesh_.stored(0, 1))
      if (const Edge e = mesh_.find_edge(c.deleted, c.kept); e.valid() && e.index < refusal_.size())
        refusal_[e] = verdict.reason;
    return false;
  }
  queue_.merge(c);
  original_.merged(c.deleted, c.kept);
  collapser_.apply(mesh_, plan_.collapse);
  queue_.refresh_around(c.kept);
  if (rules_.topology == TopologyRule::Paper) queue_.forget_lost_edges(plan_.collapse);
  made(StepKind::Collapse, c.kept, plan_.change);
  return true;
}

}  // namespace aomd
