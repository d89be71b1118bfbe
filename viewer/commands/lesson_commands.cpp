#include "viewer/commands/lesson_commands.h"

#include <algorithm>
#include <utility>

#include "viewer/commands/commands.h"

namespace aomd::scene {
namespace {

/// What is loaded while it lives is for practice.
class Entering {
 public:
  explicit Entering(LessonPlayer& player) : player_(player), was_(player.entering()) {
    player.set_entering(true);
  }
  ~Entering() { player_.set_entering(was_); }
  Entering(const Entering&) = delete;
  Entering& operator=(const Entering&) = delete;

 private:
  LessonPlayer& player_;
  bool was_;
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

/// Waits before each line, and for loading after the last; what the last one starts may go on
/// before the user's eyes.
void carry_out(Session& session, const std::vector<LessonLine>& lines, bool to_the_end) {
  const std::string file = session.lesson.lesson()->file;
  for (const LessonLine& line : lines) {
    try {
      session.finish();
      execute(session, line.text);
      if (to_the_end || session.loading()) session.finish();
      session.refresh();
    } catch (const std::exception& error) {
      throw CommandError(file + ":" + std::to_string(line.number) + ": " + error.what());
    }
  }
}

bool holds(Session& session, const LessonCheck& check) {
  const auto met = [&](const LessonLine& line) {
    try {
      execute(session, line.text);
      return true;
    } catch (const ExpectationMissed&) {
      return false;
    }
  };
  return std::all_of(check.expectations.begin(), check.expectations.end(), met);
}

LessonPlayer::Stamp stamp(const Session& session) {
  const HistoryPlace place = session.document().place();
  return {session.executed, place.cursor, place.epoch};
}

}  // namespace

void open_lesson(Session& session, const Lesson& lesson, std::size_t page) {
  session.cancel_loading();
  session.play(false);
  if (session.lesson.lesson() == nullptr) session.remember_camera();
  Document& document = session.document();
  document.cancel_run();
  session.lesson.begin(lesson, page,
                       {source_of(document), session.view, document.options(),
                        document.classify_options(), document.snaps()});
  session.sheet().selection.clear();
  session.sheet().runs.set_reference(0);
  session.error.clear();
  session.view = view_for_lesson(session.view);
  session.options.set({});
  session.options.classify = {};
  document.set_snapping(false);
  const Entering entering(session.lesson);
  for (std::size_t i = 0; i <= page; ++i) carry_out(session, lesson.pages[i].commands, i < page);
  session.status = lesson.title + ", page " + std::to_string(page + 1) + " of " +
                   std::to_string(lesson.pages.size());
  session.lesson.begin_task();
  update_lesson(session);
}

void load_lesson_mesh(Session& session, const std::string& name) {
  const auto& meshes = session.lesson.lesson()->meshes;
  const auto found = meshes.find(name);
  if (found == meshes.end()) throw CommandError("this lesson has no mesh '" + name + "'");
  LoadRequest request;
  request.data = found->second;
  request.sample = name.substr(0, name.rfind('.'));
  request.classify = session.options.classify;
  const Entering entering(session.lesson);
  session.start_loading(std::move(request));
}

void solve_lesson(Session& session) {
  carry_out(session, session.lesson.page().solution, true);
  update_lesson(session);
}

void update_lesson(Session& session) {
  LessonPlayer& player = session.lesson;
  if (player.lesson() == nullptr || player.entering() || session.document().empty()) return;
  if (player.done()) return player.note_completion();
  if (!session.idle() || !player.differs(stamp(session))) return;
  std::vector<bool> met;
  for (const LessonCheck& check : player.page().checks) met.push_back(holds(session, check));
  player.take(std::move(met));
  if (player.done())
    session.status =
        player.last_page() ? "Done: that was the lesson" : "Done: go on with the next page";
  player.set_looked_at(stamp(session));
}

}  // namespace aomd::scene
