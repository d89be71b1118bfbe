#include "core/decimate/quality/quality_loop.h"

#include <algorithm>

namespace aomd {

// A mesh of slivers cannot reach its target without making some. Then only what the user asked for
// binds.
bool QualityLoop::relax() {
  const bool stuck = goals_[stage_] > 0 && mesh_.count(2) > goals_[stage_];
  if (!stuck || !rules_.least_around.binds()) return false;
  rules_.least_around = LeastAngle(0);
  fit_.least_angle = rules_.least_angle;
  queue_.refill();
  rounds_.begin(goals_[stage_], part_count_);
  return true;
}

bool QualityLoop::advance_collapse() {
  const Vertex v = rounds_.next();
  if (!v.valid()) {
    if (!relax()) begin_improvement();
    return false;
  }
  alone_.within_part = rounds_.in_part();
  alone_.part = partition_.part_of(v);
  return try_vertex(v, alone_);
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is
// cheaper.
bool QualityLoop::try_vertex(Vertex v, Hand& hand) {
  Trial cheapest;
  if (hand.within_part && !is_inside(v)) {
    rounds_.leave(hand.part, v);
    return false;
  }
  if (queue_.cheapest(v, cheapest.candidate)) {
    if (must_wait(cheapest.candidate.contraction, hand)) {
      rounds_.leave(hand.part, v);
      return false;
    }
    cheapest.reason = try_collapse(cheapest.candidate, hand);
    if (cheapest.reason == Reason::None) return true;
  }
  return try_others(v, cheapest, hand);
}

// The cheapest candidate is not known any more, or not allowed: then it is not judged again. One
// that may be allowed later waits until others cost so much more.
bool QualityLoop::try_others(Vertex v, const Trial& cheapest, Hand& hand) {
  queue_.take_all(v, hand.turn);
  const std::vector<CollapseQueue::Candidate>& found = hand.turn.found;
  float later = CollapseQueue::unlimited;
  for (std::size_t i = 0; i < found.size() && found[i].cost <= later; ++i) {
    if (queue_.put_off(v, i, later, hand.turn)) return false;
    if (must_wait(found[i].contraction, hand)) {
      queue_.remember(v, i, later, hand.turn);
      rounds_.leave(hand.part, v);
      return false;
    }
    const Reason reason = cheapest.is_of(found[i]) ? cheapest.reason : try_collapse(found[i], hand);
    if (reason == Reason::None) return true;
    const float allowed_at = price_after(reason) * found[i].cost;
    if (allowed_at > queue_.level(hand.part)) later = std::min(later, allowed_at);
  }
  if (later < CollapseQueue::unlimited) queue_.wait(v, later);
  return false;
}

Verdict QualityLoop::judge(const Contraction& c, const CollapseRules& rules, Collapser& collapser,
                           Plan& plan) {
  const CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser.judge(mesh_, c, rules, plan.collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, c, collapse.around_deleted(), collapse.around_kept());
}

Reason QualityLoop::try_collapse(const CollapseQueue::Candidate& candidate, Hand& hand) {
  const Contraction& c = candidate.contraction;
  const Reason reason = judge(c, rules_for(candidate, hand), hand.collapser, hand.plan).reason;
  if (reason == Reason::None)
    collapse(c, hand);
  else
    refused(c, reason, hand);
  return reason;
}

void QualityLoop::refused(const Contraction& c, Reason reason, Hand& hand) {
  SweepStatistics& sweep = hand.edits ? hand.made : sweeps_.back();
  ++sweep.refused[static_cast<std::size_t>(reason)];
  if (!mesh_.stored(0, 1)) return;
  if (const Edge e = mesh_.find_edge(c.deleted, c.kept); e.valid() && e.index < refusal_.size())
    refusal_[e] = reason;
}

void QualityLoop::collapse(const Contraction& c, Hand& hand) {
  const CollapsePlan& plan = hand.plan.collapse;
  queue_.merge(c);
  original_.merged(c.deleted, c.kept);
  if (hand.edits)
    hand.collapser.apply(mesh_, *hand.edits, plan);
  else
    hand.collapser.apply(mesh_, plan);
  curves_.merged(mesh_, c.deleted, c.kept);
  queue_.refresh_around(c, hand.turn);
  if (rules_.topology == TopologyRule::Paper) queue_.forget_lost_edges(plan, hand.turn);
  count(c, hand);
}

void QualityLoop::count(const Contraction& c, Hand& hand) {
  if (hand.within_part) {
    rounds_.took(hand.part, hand.plan.collapse.faces_gone());
  } else {
    partition_.joined(mesh_, c.kept);
  }
  if (hand.edits)
    ++hand.made.collapses;
  else
    made(StepKind::Collapse, c.kept, hand.plan.change);
}

}  // namespace aomd
