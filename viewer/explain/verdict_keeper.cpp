#include "viewer/explain/verdict_keeper.h"

namespace aomd::scene {

void VerdictKeeper::update(const Document& document, const View& view,
                           const SurfaceChanges& changes, bool busy, SurfaceDrawing& drawing) {
  if (view.coloring != Coloring::Verdict || !document.hindrance().empty()) {
    verdicts_.reset();
    drawing.set_edge_codes(nullptr);
    return;
  }
  const std::uint64_t options = document.options_revision();
  const bool anew = !verdicts_ || changes.everything || options_ != options || was_busy_;
  if (!busy && anew) {
    verdicts_.emplace().start(document.mesh());
    options_ = options;
  } else if (verdicts_) {
    verdicts_->note(document.mesh(), changes);
  }
  was_busy_ = busy;
  drawing.set_edge_codes(verdicts_ ? verdicts_->codes() : nullptr);
}

void VerdictKeeper::judge(Document& document, std::optional<std::chrono::microseconds> budget,
                          bool busy, SurfaceDrawing& drawing) {
  if (!pending() || busy) return;
  drawing.recode(document.mesh(),
                 verdicts_->judge(*document.build_decimation_to_judge(), document.mesh(), budget));
}

std::vector<EntityRef> find_edges_refused_for(Document& document, Reason reason) {
  EdgeVerdicts verdicts;
  verdicts.start(document.mesh());
  static_cast<void>(
      verdicts.judge(*document.build_decimation_to_judge(), document.mesh(), std::nullopt));
  std::vector<EntityRef> edges;
  for (const Edge e : document.mesh().edges())
    if ((*verdicts.codes())[e] == static_cast<std::uint8_t>(reason)) edges.emplace_back(e);
  return edges;
}

}  // namespace aomd::scene
