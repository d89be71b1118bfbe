#include <algorithm>
#include <limits>
#include <string>

#include "viewer/scene/command_groups.h"
#include "viewer/scene/text.h"

namespace aomd::scene {
namespace {

void start(Session& session, Arguments& arguments) {
  arguments.end();
  need_mesh(session);
  session.play(false);
}

void say_where(Session& session, const char* what) {
  const Journal& journal = session.document.journal();
  session.status = std::string(what) + ": operation " + grouped(static_cast<std::int64_t>(journal.cursor())) +
                   " of " + grouped(static_cast<std::int64_t>(journal.size()));
}

void undo(Session& session, Arguments& arguments) {
  start(session, arguments);
  if (session.document.undo())
    say_where(session, "Undo");
  else
    session.status = "Nothing to undo";
}

void redo(Session& session, Arguments& arguments) {
  start(session, arguments);
  if (session.document.redo())
    say_where(session, "Redo");
  else
    session.status = "Nothing to redo";
}

void seek(Session& session, Arguments& arguments) {
  long long target = 0;
  if (!arguments.done()) {
    const std::string text = arguments.word("a number of operations, or end");
    target = text == "end" ? std::numeric_limits<long long>::max()
                           : Arguments("seek", "N|end", text).integer("a number of operations");
  }
  start(session, arguments);
  session.document.seek(static_cast<std::size_t>(std::max(0LL, target)));
  say_where(session, "Timeline");
}

void play(Session& session, Arguments& arguments) {
  const bool on = arguments.done() || arguments.flag(session.playing());
  arguments.end();
  need_mesh(session);
  session.play(on);
  if (on && !session.playing()) session.status = "Nothing to play: step, sweep or run first";
}

void pause(Session& session, Arguments& arguments) {
  arguments.end();
  session.play(false);
}

void reset(Session& session, Arguments& arguments) {
  start(session, arguments);
  session.document.seek(0);
  session.status = "As loaded: redo brings the operations back";
}

}  // namespace

std::vector<Command> history_commands() {
  return {
      {"undo",
       "",
       "Takes back the last command as a whole.",
       CommandGroup::History,
       undo,
       {{"Ctrl+Z", "undo"}}},
      {"redo",
       "",
       "Does it again.",
       CommandGroup::History,
       redo,
       {{"Ctrl+Shift+Z", "redo"}, {"Ctrl+Y", "redo"}}},
      {"seek",
       "N|end",
       "Moves to where N operations are applied.",
       CommandGroup::History,
       seek,
       {{"Home", "seek 0"}, {"End", "seek end"}}},
      {"play",
       "[on|off|toggle]",
       "Plays the history from where it stands; from the start when it is at the end.",
       CommandGroup::History,
       play,
       {{"Space", "play toggle"}}},
      {"pause", "", "Stops playing.", CommandGroup::History, pause, {}},
      {"reset",
       "",
       "Back to the mesh as it was loaded; redo leads forward again.",
       CommandGroup::History,
       reset,
       {{"Ctrl+R", "reset"}}},
  };
}

}  // namespace aomd::scene
