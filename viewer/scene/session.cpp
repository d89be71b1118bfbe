#include "viewer/scene/session.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "viewer/scene/text.h"

namespace aomd::scene {
namespace {

constexpr double longest_play_s = 12;      // however long the history
constexpr double slowest_steps_per_s = 4;  // slow enough to follow each
constexpr std::chrono::milliseconds slice_of_kept_run{50};

SkinStyle skin_style(const View& view) {
  SkinStyle style;
  const auto is_region = [](ModelRef ref) { return ref.dimension() == 3; };
  std::copy_if(view.hidden.begin(), view.hidden.end(),
               std::inserter(style.hidden_regions, style.hidden_regions.end()), is_region);
  if (view.highlighted && is_region(*view.highlighted)) style.highlighted_region = view.highlighted;
  style.interfaces = view.interfaces;
  return style;
}

/// "7,160 faces", "165,295 regions"
std::string size_words(const MeshFacts& facts) {
  return facts.regions > 0 ? grouped(facts.regions) + " regions" : grouped(facts.faces) + " faces";
}

}  // namespace

void Session::keep_work(const std::filesystem::path& folder) {
  recovery = std::make_unique<RecoveryKeeper>(folder);
  found_work = find_saved_work(folder);
}

void Session::keep() {
  if (recovery) recovery->update(document);
}

void Session::start_loading(LoadRequest request) {
  request.recoverable = recovery != nullptr;
  loader_.start(std::move(request));
  status = "Loading " + loader_.name() + " ...";
}

void Session::cancel_loading() {
  if (!loading()) return;
  loader_.cancel();
  status = "Loading of " + loader_.name() + " cancelled";
}

void Session::take_loaded(Loader::Result result) {
  if (result.error) std::rethrow_exception(result.error);
  playing_ = false;
  error.clear();
  document.replace(std::move(result.mesh));
  view.hidden.clear();
  view.highlighted.reset();
  drawing_.set_bounds(document.content().bounds);
  drawing_.set_face_flags({});
  drawing_.highlight_step(document.mesh(), document.journal(), {});
  skin_surface_.reset();
  refresh();
  loaded_facts_ = facts();
  view.camera.up_axis = document.content().up;
  view.camera.turn_to(StandardView::Iso);
  view.camera.fit(document.content().bounds, view.aspect);
  status = document.content().name + ": " + size_words(facts());
  for (const std::string& note : document.content().notes) status += ", " + note;
  if (const auto work = document.content().source.work) restore(*work);
}

/// What was found goes only once this program keeps it itself.
void Session::restore(const SavedWork& work) {
  const auto shared = document.content().source.work;
  std::erase(found_work, shared);
  if (recovery) recovery->take_over(shared);
  document.restore(work);
  status = "Restored " + work.name() + ": " + grouped(static_cast<std::int64_t>(work.cursor)) +
           " operations, " + grouped(document.mesh().count(2)) + " faces";
}

void Session::start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                           std::optional<glm::ivec2> size) {
  play(false);
  document.cancel_run();
  series_.emplace(kind, folder, count, size, document, view);
  status = "Exporting " + std::to_string(series_->count()) + " pictures ...";
}

void Session::advance_series() {
  if (!series_ || !screenshots.empty()) return;
  if (auto picture = series_->next(document, view)) {
    screenshots.push_back(std::move(*picture));
    return;
  }
  series_->put_back(document, view);
  status = "Saved " + std::to_string(series_->count()) + " pictures in " + series_->folder().string();
  series_.reset();
}

void Session::cancel_series() {
  if (!series_) return;
  screenshots.clear();
  series_->put_back(document, view);
  status = "Export cancelled after " + std::to_string(series_->made()) + " pictures";
  series_.reset();
}

void Session::play(bool on) {
  if (on && document.empty()) return;
  if (on && !document.can_redo()) document.seek(0);
  playing_ = on && document.can_redo();
  steps_due_ = 0;
}

void Session::advance_playing(double frame_s) {
  const auto size = static_cast<double>(document.journal().size());
  steps_due_ += frame_s * std::max(slowest_steps_per_s, size / longest_play_s);
  const double whole = std::floor(steps_due_);
  steps_due_ -= whole;
  if (whole > 0) document.seek(document.journal().cursor() + static_cast<std::size_t>(whole));
  playing_ = document.can_redo();
}

void Session::run_on(std::optional<std::chrono::microseconds> budget) {
  const bool was_running = document.running();
  document.tick(budget);
  if (was_running && !document.running())
    status = "Run finished: " + grouped(document.mesh().count(2)) + " faces";
}

void Session::tick(std::chrono::microseconds budget, double frame_s) {
  if (auto result = loader_.take(false)) take_loaded(std::move(*result));
  run_on(budget);
  if (playing_) advance_playing(frame_s);
  keep();
}

void Session::finish() {
  if (auto result = loader_.take(true)) take_loaded(std::move(*result));
  while (recovery && document.running()) {
    run_on(slice_of_kept_run);
    keep();
  }
  run_on({});
  if (playing_) document.seek(document.journal().size());
  playing_ = false;
  keep();
}

void Session::refresh() {
  if (document.empty()) return;
  if (document.content().skin)
    refresh_skin();
  else
    refresh_surface();
}

void Session::refresh_skin() {
  const LoadedMesh& content = document.content();
  const HistoryPlace place = document.place();
  SurfaceChanges all;
  all.everything = true;
  if (const SkinStyle style = skin_style(view);
      !skin_surface_ || place != skin_place_ || style != skin_style_) {
    if (place != skin_place_ && content.volume()) facts_.set(volume_facts(content.mesh, *content.skin));
    if (place != skin_place_ && !content.volume()) facts_.update(content.mesh, all);
    skin_surface_.emplace(make_skin_surface(content.mesh, *content.skin, style));
    skin_style_ = style;
    skin_place_ = place;
    drawing_.set_face_flags(skin_surface_->flags);
  } else {
    all.everything = false;
  }
  refresh_field(all.everything);
  drawing_.update(skin_surface_->mesh, view, all);
}

void Session::refresh_field(bool anew) {
  const bool wanted = view.coloring == Coloring::Spacing && !document.content().skin;
  if (!anew && wanted == field_.has_value() && (!wanted || field_options_ == document.options())) return;
  field_.reset();
  if (wanted) field_ = make_vertex_field(document.mesh(), document.wanted_lengths());
  field_options_ = document.options();
  drawing_.set_vertex_colors(field_ ? field_->colors : nullptr);
}

void Session::refresh_surface() {
  const HistoryPlace place = document.place();
  const SurfaceChanges found = changes_.read(document.mesh(), document.journal(), place);
  facts_.update(document.mesh(), found);
  refresh_field(found.everything);
  drawing_.update(document.mesh(), view, found);
  const auto focus = view.operation ? document.focus() : std::nullopt;
  if (focus != drawn_focus_ || !found.nothing()) {
    drawing_.highlight_step(document.mesh(), document.journal(), focus);
    drawn_focus_ = focus;
  }
}

}  // namespace aomd::scene
