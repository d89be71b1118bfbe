// The classification of a document: edited by hand, and a feature angle tried out.

#include <algorithm>
#include <array>

#include "viewer/document/document.h"

namespace aomd::scene {

bool changes_classes(std::string_view label) {
  constexpr std::array<std::string_view, 5> labels = {"assign", "classify", "demote", "promote",
                                                      "split-face"};
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

/// The step up to which nothing but the classification has changed: the shape is still as loaded.
std::size_t Document::classified_start() const {
  const std::size_t cursor = journal().cursor();
  std::size_t step = 0;
  while (step < cursor && journal().step(step).kind == StepKind::Classify) ++step;
  return step;
}

ClassVerdict Document::edit_classes(std::string label, const ClassEdit& edit) {
  cancel_run();
  const ClassOverlay classes = edit(mesh(), loaded_->classify_options.corner_angle_deg);
  const ClassVerdict verdict = judge_classes(classes);
  if (!verdict.accepted()) return verdict;
  record(std::move(label), [&] {
    apply_classes(loaded_->mesh, classes);
    forget_fits();
    stale_ = loaded_->decimation.has_value();
  });
  return verdict;
}

const FeatureTrial& Document::try_feature_angle(double angle_deg) {
  cancel_run();
  Mesh& mesh = loaded_->mesh;
  if (!trial_) {
    trial_.emplace();
    trial_->needs = {mesh.request(2, 0), mesh.request(0, 1), mesh.request(2, 1)};
  }
  ClassifyOptions options = options_.classify;
  options.feature_angle_deg = trial_->angle_deg = angle_deg;
  trial_->preview = preview_features(mesh, options);
  return *trial_;
}

}  // namespace aomd::scene
