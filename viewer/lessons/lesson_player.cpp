#include "viewer/lessons/lesson_player.h"

#include <algorithm>

namespace aomd::scene {

View view_for_lesson(const View& present) {
  View view;
  view.camera.orthographic = false;
  view.aspect = present.aspect;
  view.height_px = present.height_px;
  view.theme = present.theme;
  view.text_scale = present.text_scale;
  view.occlusion = present.occlusion;
  view.detail = present.detail;
  view.presenting = present.presenting;
  view.play_speed = present.play_speed;
  view.panels = present.panels;
  view.panels.mesh = true;
  return view;
}

View view_after_lesson(const View& before, const View& present) {
  View view = before;
  view.camera = present.camera;
  view.aspect = present.aspect;
  view.height_px = present.height_px;
  view.theme = present.theme;
  view.text_scale = present.text_scale;
  if (before.presenting.has_value() != present.presenting.has_value()) view.panels = present.panels;
  view.presenting = present.presenting;
  view.panels.mesh_ems = present.panels.mesh_ems;
  view.panels.side_ems = present.panels.side_ems;
  view.dialog = present.dialog;
  return view;
}

void LessonPlayer::begin(const Lesson& lesson, std::size_t page, BeforeLesson before) {
  if (!before_) before_ = std::move(before);
  before_->options.spacing.reset();  // these belong to the mesh
  before_->options.keep.reset();
  before_->options.model = nullptr;
  lesson_ = &lesson;
  page_ = page;
  shown = true;
  hinted = false;
  suggested = Hint::None;
}

void LessonPlayer::begin_task() {
  met_.assign(page().checks.size(), false);
  done_ = met_.empty();
  looked_at_.reset();
}

void LessonPlayer::take(std::vector<bool> met) {
  met_ = std::move(met);
  done_ = std::all_of(met_.begin(), met_.end(), [](bool each) { return each; });
  note_completion();
}

void LessonPlayer::note_completion() {
  if (done_ && last_page()) completed.insert(lesson_->name);
}

std::optional<BeforeLesson> LessonPlayer::end() {
  if (std::exchange(lesson_, nullptr) == nullptr) return {};
  return std::exchange(before_, std::nullopt);
}

}  // namespace aomd::scene
