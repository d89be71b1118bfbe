#include "viewer/session/session.h"

#include <algorithm>
#include <utility>

#include "core/samples/samples.h"
#include "viewer/base/entity_text.h"
#include "viewer/base/text.h"
#include "viewer/document/history_places.h"

namespace aomd::scene {
namespace {

constexpr std::chrono::milliseconds slice_of_kept_run{50};
constexpr std::size_t most_cameras = 8;

}  // namespace

void Session::keep_work(const std::filesystem::path& folder) {
  recovery = std::make_unique<RecoveryKeeper>(folder);
  found_work = find_saved_work(folder);
  for (const std::string& why : found_work.unreadable)
    warnings.push_back("Unsaved work cannot be recovered, its files stay: " + why);
}

void Session::keep() {
  if (!recovery) return;
  recovery->update(document());
  if (auto problem = recovery->take_problem()) warnings.push_back(std::move(*problem));
}

void Session::start_loading(LoadRequest request) {
  request.recoverable = recovery != nullptr;
  request.practice = lesson.entering();
  if (auto known = spare != nullptr ? spare->take(request) : nullptr)
    loader_.give(std::move(known));
  else
    loader_.start(std::move(request));
  status = "Loading " + loader_.name() + " ...";
}

void Session::cancel_loading() {
  if (!loading()) return;
  loader_.cancel();
  status = "Loading of " + loader_.name() + " cancelled";
}

void Session::show(std::unique_ptr<LoadedMesh> loaded) {
  cancel_series();
  options.let_go_of_mesh();
  static_cast<MeshView&>(view) = {};
  sheet_ = std::make_unique<Sheet>(options, view);  // what was there need not wait for the next
  sheet_ = std::make_unique<Sheet>(options, view, std::move(loaded));
  if (recovery) recovery->begin();
  arrived_ = true;
}

void Session::take_loaded(Loader::Result result) {
  if (result.error) std::rethrow_exception(result.error);
  error.clear();
  cancel_series();
  if (!lesson.entering()) remember_camera();
  if (!result.mesh->source.practice) leave_lesson(false);
  const auto file_before = document().empty() ? std::filesystem::path() : document().content().file;
  const MeshView before(static_cast<const MeshView&>(view));
  show(std::move(result.mesh));
  const LoadedMesh& content = document().content();
  if (!content.file.empty() && content.file == file_before) {
    view.clip = before.clip;
    view.shrink = before.shrink;
    view.hidden = before.hidden;
  }
  look_from_where_it_was_seen();
  watch(watching_);
  status = content.name + ": " + size_words(content.mesh);
  for (const std::string& note : content.notes) status += ", " + note;
  if (const auto work = content.source.work) restore(*work);
}

void Session::look_from_where_it_was_seen() {
  const LoadedMesh& content = document().content();
  const auto seen =
      content.file.empty() ? std::nullopt : seen_.camera(content.file, content.bounds);
  if (seen) {
    view.camera = *seen;
    return;
  }
  cameras_before_.clear();
  view.light_from.reset();
  view.camera.up_axis = content.up;
  view.camera.turn_to(StandardView::Iso);
  view.camera.fit(content.bounds, view.aspect);
}

void Session::note_jump() {
  if (!cameras_before_.empty() && cameras_before_.front() == view.camera) return;
  cameras_before_.push_front(view.camera);
  if (cameras_before_.size() > most_cameras) cameras_before_.pop_back();
}

void Session::jump_back(std::size_t which) {
  const Camera camera = cameras_before_[which];
  cameras_before_.erase(cameras_before_.begin() + static_cast<std::ptrdiff_t>(which));
  note_jump();
  view.camera = camera;
}

void Session::remember_camera() {
  if (document().empty() || document().content().file.empty()) return;
  seen_.remember(document().content().file, document().content().bounds, view.camera);
}

void Session::watch(bool on) {
  watching_ = on;
  const bool some = on && !document().empty();
  watch_.start(some ? document().content().file : std::filesystem::path(),
               some ? document().content().stamp : std::nullopt);
}

std::string Session::look_at_file(FileWatch::Clock::time_point now) {
  if (!watching_ || !idle() || !watch_.changed(now)) return {};
  if (!document().unsaved()) return "reload";
  warnings.push_back(
      document().content().name +
      " has changed on disk. Reload (F5) reads it; what was done here is not saved.");
  return {};
}

/// What was found goes only once this program keeps it itself.
void Session::restore(const SavedWork& work) {
  const auto shared = document().content().source.work;
  std::erase(found_work.works, shared);
  if (recovery) recovery->take_over(shared);
  document().restore(work);
  status = "Restored " + work.name() + ": " + counted(work.cursor, "operation") + ", " +
           size_words(document().mesh());
}

void Session::leave_lesson(bool reload) {
  const auto before = lesson.end();
  if (!before) return;
  view = view_after_lesson(before->view, view);
  options.set(before->options);
  options.classify = before->classify;
  document().set_snapping(before->snaps);
  if (!reload) return;
  LoadRequest source = before->source;
  if (source.file.empty() && source.sample.empty()) source.sample = samples().front().name;
  start_loading(std::move(source));
}

void Session::come_to_rest() {
  play(false);
  document().cancel_run();
}

void Session::play(bool on) {
  if (!on && sheet_->playing()) status = "Paused: " + place_words(document().journal());
  sheet_->play(on);
}

EntityRef Session::pick(glm::dvec2 ndc) {
  refresh();
  return sheet_->pick(ndc);
}

std::vector<EntityRef> Session::pick(glm::dvec2 low, glm::dvec2 high) {
  refresh();
  return sheet_->pick(low, high);
}

void Session::hover(std::optional<glm::dvec2> ndc) {
  if (ndc) refresh();
  sheet_->hover(ndc);
}

/// A run that has come to its end is kept, to be compared with others.
void Session::run_on(std::optional<std::chrono::microseconds> budget) {
  if (!document().running()) {
    run_time_s_ = 0;
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  document().tick(budget);
  run_time_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (document().running()) return;
  status = "Run finished: " + size_words(document().mesh());
  if (document().journal().cursor() > 0) sheet_->runs.keep(document(), {}, run_time_s_);
}

void Session::tick(std::chrono::microseconds budget, double frame_s) {
  budget_ = budget;
  if (auto result = loader_.take(false)) take_loaded(std::move(*result));
  run_on(budget);
  take_results(false);
  if (sheet_->playing()) {
    sheet_->advance_playing(frame_s);
    status = (sheet_->playing() ? "Playing: " : "Played to the end: ") +
             place_words(document().journal());
  }
  keep();
}

void Session::finish() {
  budget_.reset();
  if (auto result = loader_.take(true)) take_loaded(std::move(*result));
  while (recovery && document().running()) {
    run_on(slice_of_kept_run);
    keep();
  }
  run_on({});
  take_results(true);
  sheet_->play_to_the_end();
  keep();
}

}  // namespace aomd::scene
