#include "viewer/commands/session.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "viewer/base/text.h"
#include "viewer/document/history_places.h"

namespace aomd::scene {
namespace {

constexpr std::chrono::milliseconds slice_of_kept_run{50};

SkinStyle skin_style(const View& view) {
  SkinStyle style;
  const auto is_region = [](ModelRef ref) { return ref.dimension() == 3; };
  std::copy_if(view.hidden.begin(), view.hidden.end(),
               std::inserter(style.hidden_regions, style.hidden_regions.end()), is_region);
  if (view.highlighted && is_region(*view.highlighted)) style.highlighted_region = view.highlighted;
  style.interfaces = view.interfaces;
  style.faces = view.shrink == 0;
  return style;
}

bool wants_histograms(const View& view) {
  return view.marked || (view.panels.side && view.panels.page == Page::Histograms);
}

/// True where it differs from before, that is kept from now on.
template <typename T>
bool renew(std::optional<T>& kept, const T& now) {
  if (kept && *kept == now) return false;
  kept = now;
  return true;
}

/// "7,160 faces", "165,295 regions"
std::string size_words(const MeshFacts& facts) {
  return facts.regions > 0 ? counted(facts.regions, "region") : counted(facts.faces, "face");
}

}  // namespace

void Session::keep_work(const std::filesystem::path& folder) {
  recovery = std::make_unique<RecoveryKeeper>(folder);
  found_work = find_saved_work(folder);
  for (const std::string& why : found_work.unreadable)
    warnings.push_back("Unsaved work cannot be recovered, its files stay: " + why);
}

void Session::keep() {
  if (!recovery) return;
  recovery->update(document);
  if (auto problem = recovery->take_problem()) warnings.push_back(std::move(*problem));
}

void Session::start_loading(LoadRequest request) {
  request.recoverable = recovery != nullptr;
  request.practice = lesson.entering();
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
  comparison_.reset();
  strategies_.reset();
  measurement_.reset();
  runs.clear();
  view.reference = 0;
  if (!result.mesh->source.practice) lesson.leave(*this, false);
  document.replace(std::move(result.mesh));
  view.hidden.clear();
  view.highlighted.reset();
  view.marked.reset();
  view.menu.reset();
  view.clip.reset();
  view.shrink = 0;
  drawing_.set_bounds(document.content().bounds);
  drawing_.set_face_flags({});
  drawing_.set_marked(document.mesh(), {});
  marked_cells_.clear();
  drawn_mark_.reset();
  drawing_.highlight_step(document.mesh(), document.journal(), {});
  drawing_.set_cells({});
  cell_regions_.clear();
  drawing_.set_interior_edges({});
  original_drawing_.set_bounds(document.content().bounds);
  skin_surface_.reset();
  forget_selection();
  clipped_skin_.reset();
  cutter_.reset();
  cells_.reset();
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
  std::erase(found_work.works, shared);
  if (recovery) recovery->take_over(shared);
  document.restore(work);
  status = "Restored " + work.name() + ": " + counted(work.cursor, "operation") + ", " +
           counted(document.mesh().count(2), "face");
}

void Session::start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                           std::optional<glm::ivec2> size) {
  come_to_rest();
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
  status =
      "Saved " + std::to_string(series_->count()) + " pictures in " + series_->folder().string();
  series_.reset();
}

void Session::cancel_series() {
  if (!series_) return;
  screenshots.clear();
  series_->put_back(document, view);
  status = "Export cancelled after " + std::to_string(series_->made()) + " pictures";
  series_.reset();
}

void Session::start_comparison() {
  come_to_rest();
  strategies_.reset();
  comparison_ = start_comparing(document.mesh(), document.options());
  status = "Comparing strategies ...";
}

void Session::cancel_comparison() {
  if (!comparison_) return;
  comparison_.reset();
  status = "Comparison of strategies cancelled";
}

void Session::take_comparison(bool wait) {
  auto result = take(comparison_, wait);
  if (!result) return;
  strategies_ = std::move(result);
  status = strategies_->same ? "Both strategies lead to the same mesh"
                             : "The strategies lead to different meshes";
}

void Session::come_to_rest() {
  play(false);
  document.cancel_run();
}

void Session::play(bool on) {
  if (!on && playing_) status = "Paused: " + place_words(document.journal());
  if (on && document.empty()) return;
  if (on && !document.can_redo()) document.seek(0);
  playing_ = on && document.can_redo();
  steps_due_ = 0;
}

void Session::advance_playing(double frame_s) {
  steps_due_ += frame_s * view.play_speed.in(document.journal().size());
  const double whole = std::floor(steps_due_);
  steps_due_ -= whole;
  if (whole > 0) document.seek(document.journal().cursor() + static_cast<std::size_t>(whole));
  playing_ = document.can_redo();
  status = (playing_ ? "Playing: " : "Played to the end: ") + place_words(document.journal());
}

/// A run that has come to its end is kept, to be compared with others.
void Session::run_on(std::optional<std::chrono::microseconds> budget) {
  if (!document.running()) {
    run_time_s_ = 0;
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  document.tick(budget);
  run_time_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (document.running()) return;
  status = "Run finished: " + counted(document.mesh().count(2), "face");
  if (document.journal().cursor() > 0) runs.keep(document, {}, run_time_s_);
}

void Session::tick(std::chrono::microseconds budget, double frame_s) {
  judging_budget_ = budget;
  if (auto result = loader_.take(false)) take_loaded(std::move(*result));
  run_on(budget);
  take_comparison(false);
  take_measurement(false);
  if (playing_) advance_playing(frame_s);
  keep();
  lesson.update(*this);
}

void Session::finish() {
  judging_budget_.reset();
  if (auto result = loader_.take(true)) take_loaded(std::move(*result));
  while (recovery && document.running()) {
    run_on(slice_of_kept_run);
    keep();
  }
  run_on({});
  take_comparison(true);
  take_measurement(true);
  if (playing_) document.seek(document.journal().size());
  playing_ = false;
  keep();
  lesson.update(*this);
}

void Session::refresh() {
  if (document.empty()) return;
  if (document.content().skin)
    refresh_skin();
  else
    refresh_surface();
  refresh_original();
}

void Session::refresh_skin() {
  const LoadedMesh& content = document.content();
  const HistoryPlace place = document.place();
  const bool moved = !skin_surface_ || place != skin_place_;
  const bool recut = renew(cells_, cell_style(view, content.bounds));
  const auto plane = cells_->whole_plane();
  SurfaceChanges changes;
  if (const SkinStyle style = skin_style(view);
      moved || plane != skin_plane_ || style != skin_style_) {
    if (place != skin_place_ && content.volume())
      facts_.set(volume_facts(content.mesh, *content.skin));
    changes.everything = true;
    if (place != skin_place_ && !content.volume()) facts_.update(content.mesh, changes);
    if (moved || plane != skin_plane_) clipped_skin_.reset();
    if (moved) cutter_.reset();
    if (plane && !cutter_) cutter_ = std::make_unique<SkinCutter>(content.mesh);
    if (plane && !clipped_skin_) clipped_skin_.emplace(cutter_->before(*plane));
    skin_plane_ = plane;
    skin_surface_.emplace(
        make_skin_surface(content.mesh, clipped_skin_ ? *clipped_skin_ : *content.skin, style));
    skin_style_ = style;
    skin_place_ = place;
    picker_.forget();
    drawing_.set_face_flags(skin_surface_->flags);
  }
  if (moved || recut) refresh_cells();
  drawing_.set_whole_faces(false);
  refresh_field(skin_surface_->mesh, changes);
  refresh_verdicts(changes);
  drawing_.update(skin_surface_->mesh, view, changes);
  const bool marks = refresh_marked_cells();
  refresh_selection(changes.everything, moved || recut || marks);
}

/// What the marked bar counts, of a mesh that has `changed` or not; none where that is as it was.
std::optional<std::vector<EntityRef>> Session::newly_marked(bool changed) {
  const bool anew = histograms_.update(document, reference(), wants_histograms(view), idle());
  if (!anew && !changed && view.marked == drawn_mark_) return {};
  const bool known = view.marked && histograms_.current(document.place());
  return known ? histograms_.histograms()->counted_in(*view.marked) : std::vector<EntityRef>();
}

/// True where others are marked than before.
bool Session::refresh_marked_cells() {
  auto marked = newly_marked(false);
  if (!marked) return false;
  drawn_mark_ = view.marked;
  marked_cells_ = std::move(*marked);
  return true;
}

void Session::refresh_cells() {
  const Mesh& mesh = document.mesh();
  const Skin& skin = clipped_skin_ ? *clipped_skin_ : *document.content().skin;
  const glm::dvec3 origin = document.content().bounds.center();
  CellFaces faces;
  if (cells_->shrink > 0) faces = draw_shrunken(mesh, skin, *cells_, origin);
  if (cells_->sections()) faces.append(draw_sections(mesh, *cells_, origin));
  drawing_.set_cells(std::move(faces.corners));
  cell_regions_ = std::move(faces.regions);
  picker_.forget_cells();
  drawing_.set_interior_edges(cells_->interior_edges
                                  ? draw_interior_edges(mesh, skin, *cells_, origin)
                                  : std::vector<Segment>());
}

void Session::refresh_field(const Mesh& shown, SurfaceChanges& changes) {
  FieldSource source{shown, document, document.content().skin.has_value()};
  source.still = at_rest() && document.can_look_back();
  source.budget = judging_budget_;
  fields_.update(view.coloring, source, changes);
  drawing_.set_field(fields_.field());
}

void Session::refresh_surface() {
  const HistoryPlace place = document.place();
  SurfaceChanges found = changes_.read(document.mesh(), document.journal(), place);
  const bool changed = !found.nothing();
  facts_.update(document.mesh(), found);
  picker_.note(found);
  drawing_.set_whole_faces(true);
  refresh_field(document.mesh(), found);
  refresh_verdicts(found);
  drawing_.update(document.mesh(), view, found);
  judge_edges();
  refresh_marks(changed);
  const auto focus = view.operation ? document.focus() : std::nullopt;
  if (focus != drawn_focus_ || view.step_sides != drawn_sides_ || changed ||
      view.marked != drawn_mark_) {
    drawing_.highlight_step(document.mesh(), document.journal(), focus, view.step_sides);
    drawn_focus_ = focus;
    drawn_sides_ = view.step_sides;
    drawn_mark_ = view.marked;
  }
  refresh_selection(changed);
}

std::vector<EntityRef> Session::counted_in(const MarkedBar& bar) {
  histograms_.update(document, reference(), true, true);
  return histograms_.histograms()->counted_in(bar);
}

void Session::refresh_marks(bool changed) {
  auto marked = newly_marked(changed);
  if (marked && (view.marked || drawn_mark_))
    drawing_.set_marked(document.mesh(), std::move(*marked));
}

}  // namespace aomd::scene
