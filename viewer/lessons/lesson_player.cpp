#include "viewer/lessons/lesson_player.h"

#include <algorithm>
#include <utility>

#include "core/samples/samples.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/session.h"

namespace aomd::scene {
namespace {

/// As after the start of the program, but for how the window looks.
View plain_view(const View& present) {
  View view;
  view.camera.orthographic = false;
  view.aspect = present.aspect;
  view.height_px = present.height_px;
  view.theme = present.theme;
  view.play_speed = present.play_speed;
  view.panels = present.panels;
  view.panels.mesh = true;
  return view;
}

class Flag {
 public:
  explicit Flag(bool& flag) : flag_(flag) { flag_ = true; }
  ~Flag() { flag_ = false; }
  Flag(const Flag&) = delete;
  Flag& operator=(const Flag&) = delete;

 private:
  bool& flag_;
};

/// What the present mesh can be loaded from again, as it is.
LoadRequest source_of(const Document& document) {
  LoadRequest source;
  if (document.empty()) return source;
  source = document.content().source;
  source.work.reset();
  if (!document.saved_file().empty()) source = {};
  if (!document.saved_file().empty()) source.file = document.saved_file();
  source.classify = document.classify_options();
  return source;
}

}  // namespace

void LessonPlayer::open(Session& session, const Lesson& lesson, std::size_t page) {
  session.cancel_loading();
  session.play(false);
  session.document.cancel_run();
  if (!before_)
    before_ = std::make_unique<Before>(
        Before{source_of(session.document), session.view, session.document.options(),
               session.document.classify_options(), session.document.snaps()});
  before_->options.spacing.reset();  // these belong to the mesh
  before_->options.keep.reset();
  before_->options.model = nullptr;
  lesson_ = &lesson;
  page_ = page;
  shown = true;
  hinted = false;
  suggested = Hint::None;
  session.selection.clear();
  session.error.clear();
  session.view = plain_view(session.view);
  session.document.set_options({});
  session.document.set_classify_options({});
  session.document.set_snapping(false);
  const Flag entering(entering_);
  for (std::size_t i = 0; i <= page; ++i) carry_out(session, lesson.pages[i].commands, i < page);
  session.status = lesson.title + ", page " + std::to_string(page + 1) + " of " +
                   std::to_string(lesson.pages.size());
  met_.assign(lesson.pages[page].checks.size(), false);
  done_ = met_.empty();
  looked_at_.reset();
  update(session);
}

/// Waits before each line, and for loading after the last; what the last one starts may go on
/// before the user's eyes.
void LessonPlayer::carry_out(Session& session, const std::vector<LessonLine>& lines,
                             bool to_the_end) {
  for (const LessonLine& line : lines) {
    try {
      session.finish();
      execute(session, line.text);
      if (to_the_end || session.loading()) session.finish();
      session.refresh();
    } catch (const std::exception& error) {
      throw CommandError(lesson_->file + ":" + std::to_string(line.number) + ": " + error.what());
    }
  }
}

void LessonPlayer::load_mesh(Session& session, const std::string& name) {
  const auto found = lesson_->meshes.find(name);
  if (found == lesson_->meshes.end()) throw CommandError("this lesson has no mesh '" + name + "'");
  LoadRequest request;
  request.data = found->second;
  request.sample = name.substr(0, name.rfind('.'));
  request.classify = session.document.classify_options();
  const bool was = std::exchange(entering_, true);
  session.start_loading(std::move(request));
  entering_ = was;
}

void LessonPlayer::solve(Session& session) {
  carry_out(session, page().solution, true);
  update(session);
}

void LessonPlayer::leave(Session& session, bool reload) {
  if (lesson_ == nullptr) return;
  lesson_ = nullptr;
  const std::unique_ptr<Before> before = std::move(before_);
  const Camera camera = session.view.camera;
  const View present = session.view;
  session.view = before->view;
  session.view.camera = camera;
  session.view.aspect = present.aspect;
  session.view.height_px = present.height_px;
  session.view.theme = present.theme;
  session.view.panels.mesh_ems = present.panels.mesh_ems;
  session.view.panels.side_ems = present.panels.side_ems;
  session.view.dialog = present.dialog;
  session.document.set_options(before->options);
  session.document.set_classify_options(before->classify);
  session.document.set_snapping(before->snaps);
  if (!reload) return;
  LoadRequest source = std::move(before->source);
  if (source.file.empty() && source.sample.empty()) source.sample = samples().front().name;
  session.start_loading(std::move(source));
}

bool LessonPlayer::holds(Session& session, const LessonCheck& check) const {
  return std::all_of(check.expectations.begin(), check.expectations.end(),
                     [&](const LessonLine& line) {
                       try {
                         execute(session, line.text);
                         return true;
                       } catch (const ExpectationMissed&) {
                         return false;
                       }
                     });
}

void LessonPlayer::update(Session& session) {
  if (lesson_ == nullptr || entering_ || session.document.empty()) return;
  const auto stamp = [&] {
    return Stamp{session.executed, session.document.place(), session.idle()};
  };
  if (done_ || !session.idle() || looked_at_ == stamp()) {
    if (done_ && last_page()) completed.insert(lesson_->name);
    return;
  }
  const auto& checks = page().checks;
  for (std::size_t i = 0; i < checks.size(); ++i) met_[i] = holds(session, checks[i]);
  done_ = std::all_of(met_.begin(), met_.end(), [](bool met) { return met; });
  if (done_ && last_page()) completed.insert(lesson_->name);
  if (done_)
    session.status = last_page() ? "Done: that was the lesson" : "Done: go on with the next page";
  looked_at_ = stamp();
}

}  // namespace aomd::scene
