// What decimation says about every edge, as colours and for selecting.

#include "viewer/commands/session.h"

namespace aomd::scene {

void Session::refresh_verdicts(const SurfaceChanges& changes) {
  if (view.coloring != Coloring::Verdict || !document.hindrance().empty()) {
    verdicts_.reset();
    drawing_.set_edge_codes(nullptr);
    return;
  }
  const bool anew =
      !verdicts_ || changes.everything || verdict_options_ != document.options() || was_busy_;
  if (!busy() && anew) {
    verdicts_.emplace().start(document.mesh());
    verdict_options_ = document.options();
  } else if (verdicts_) {
    verdicts_->note(document.mesh(), changes);
  }
  was_busy_ = busy();
  drawing_.set_edge_codes(verdicts_ ? verdicts_->codes() : nullptr);
}

void Session::judge_edges() {
  if (!verdicts_ || busy() || !verdicts_->pending()) return;
  drawing_.recode(document.mesh(),
                  verdicts_->judge(*document.for_judging(), document.mesh(), judging_budget_));
}

std::vector<EntityRef> Session::edges_refused_for(Reason reason) {
  refresh();
  VerdictField field;
  field.start(document.mesh());
  static_cast<void>(field.judge(*document.for_judging(), document.mesh(), {}));
  std::vector<EntityRef> edges;
  for (const Edge e : document.mesh().edges())
    if ((*field.codes())[e] == static_cast<std::uint8_t>(reason)) edges.emplace_back(e);
  return edges;
}

}  // namespace aomd::scene
