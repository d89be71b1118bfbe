// What takes its time on the present sheet: comparing, measuring, series of pictures.

#include "viewer/base/entity_text.h"
#include "viewer/session/session.h"

namespace aomd::scene {

void Session::keep_run(const std::string& name) {
  const KeptRun& run = sheet_->runs.keep(document(), name, {});
  status = "Kept as " + run.name + ": " + size_words(document().mesh());
}

void Session::start_comparison() {
  come_to_rest();
  sheet_->start_comparison();
  status = "Comparing strategies ...";
}

void Session::cancel_comparison() {
  if (sheet_->cancel_comparison()) status = "Comparison of strategies cancelled";
}

void Session::start_measuring() {
  come_to_rest();
  status = sheet_->start_measuring() ? "Measuring distances ..." : "All distances are measured";
}

void Session::cancel_measuring() {
  if (sheet_->cancel_measuring()) status = "Measuring cancelled";
}

void Session::take_results(bool wait) {
  if (sheet_->take_comparison(wait))
    status = sheet_->storage()->same ? "Both strategies lead to the same mesh"
                                     : "The strategies lead to different meshes";
  if (sheet_->take_measurement(wait)) status = "Distances are measured";
}

void Session::start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                           std::optional<glm::ivec2> size) {
  come_to_rest();
  series_.emplace(kind, folder, count, size, document(), view);
  status = "Exporting " + std::to_string(series_->count()) + " pictures ...";
}

void Session::advance_series() {
  if (!series_ || !screenshots.empty()) return;
  if (auto picture = series_->next(document(), view)) {
    screenshots.push_back(std::move(*picture));
    return;
  }
  series_->put_back(document(), view);
  status =
      "Saved " + std::to_string(series_->count()) + " pictures in " + series_->folder().string();
  series_.reset();
}

void Session::cancel_series() {
  if (!series_) return;
  screenshots.clear();
  series_->put_back(document(), view);
  status = "Export cancelled after " + std::to_string(series_->made()) + " pictures";
  series_.reset();
}

}  // namespace aomd::scene
