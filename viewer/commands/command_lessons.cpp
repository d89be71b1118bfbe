// Lessons: opening one, its pages, and leaving it.

#include <algorithm>
#include <string>

#include "viewer/commands/command_groups.h"
#include "viewer/commands/lesson_commands.h"

namespace aomd::scene {
namespace {

const Lesson& present_lesson(const Session& session) {
  if (session.lesson.lesson() == nullptr)
    throw CommandError("no lesson is open: lesson NAME opens one, lesson list names them");
  return *session.lesson.lesson();
}

void open_by_name(Session& session, const std::string& name, Arguments& arguments) {
  const Lesson* lesson = find_lesson(name);
  if (lesson == nullptr) {
    std::string names;
    for (const Lesson& each : lessons()) names += (names.empty() ? "" : ", ") + each.name;
    arguments.fail("there is no lesson '" + name + "', but " + names);
  }
  const auto pages = static_cast<long long>(lesson->pages.size());
  const long long page = arguments.done() ? 1 : arguments.integer("a page", 1, pages);
  arguments.end();
  open_lesson(session, *lesson, static_cast<std::size_t>(page) - 1);
}

void list(Session& session) {
  std::string text;
  for (const Lesson& each : lessons()) {
    std::string name = each.name;
    name.resize(std::max<std::size_t>(name.size(), 16), ' ');
    text += (text.empty() ? "" : "\n") + name + each.title;
  }
  session.log = text;
}

/// Keys come here too: at the ends, and without a lesson, a word is enough.
void turn(Session& session, bool forwards) {
  const LessonPlayer& player = session.lesson;
  if (player.lesson() == nullptr) {
    session.status = "No lesson is open: F2 lists them";
  } else if (forwards ? player.last_page() : player.page_number() == 0) {
    session.status =
        forwards ? "This is the lesson's last page: the button below it opens the next lesson"
                 : "This is the lesson's first page";
  } else {
    open_lesson(session, *player.lesson(),
                forwards ? player.page_number() + 1 : player.page_number() - 1);
  }
}

void lesson(Session& session, Arguments& arguments) {
  const std::string word = arguments.word("a lesson's name, or what to do");
  if (word == "mesh") {
    static_cast<void>(present_lesson(session));
    const std::string name = arguments.word("a mesh's name");
    arguments.end();
    return load_lesson_mesh(session, name);
  }
  constexpr std::string_view words[] = {"next", "back", "restart", "off", "show",
                                        "hide", "hint", "solve",   "list"};
  if (std::find(std::begin(words), std::end(words), word) == std::end(words))
    return open_by_name(session, word, arguments);
  arguments.end();
  if (word == "list") return list(session);
  if (word == "next" || word == "back") return turn(session, word == "next");
  const Lesson& present = present_lesson(session);
  if (word == "restart") open_lesson(session, present, session.lesson.page_number());
  if (word == "off") session.leave_lesson(true);
  if (word == "show" || word == "hide") session.lesson.shown = word == "show";
  if (word == "hint") session.lesson.hinted = !session.lesson.hinted;
  if (word == "solve") solve_lesson(session);
}

}  // namespace

std::vector<Command> lesson_commands() {
  return {
      {"lesson",
       "NAME [PAGE] | next | back | restart | hint | solve | show | hide | off | list | mesh NAME",
       "Opens a lesson, or turns its pages: each page begins in the same way, whatever was done "
       "before. "
       "restart begins the page again, solve does its task, hide shows the mesh's panel instead, "
       "off puts "
       "back what was there before the lesson; mesh loads one that the open lesson brings along.",
       CommandGroup::Scripts,
       lesson,
       {{"Ctrl+PageDown", "lesson next"}, {"Ctrl+PageUp", "lesson back"}}},
  };
}

}  // namespace aomd::scene
