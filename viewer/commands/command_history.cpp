#include <algorithm>
#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/document/history_places.h"

namespace aomd::scene {
namespace {

constexpr const char* seek_usage = "N|end|next|previous|next-phase|previous-phase|bookmark NAME";

void start_seek(Session& session, Arguments& arguments) {
  arguments.end();
  need_mesh(session);
  session.play(false);
}

void say_where(Session& session, const char* what) {
  session.status = std::string(what) + ": " + place_words(session.document().journal());
}

void undo(Session& session, Arguments& arguments) {
  start_seek(session, arguments);
  if (session.document().undo())
    say_where(session, "Undo");
  else
    session.status = "Nothing to undo";
}

void redo(Session& session, Arguments& arguments) {
  start_seek(session, arguments);
  if (session.document().redo())
    say_where(session, "Redo");
  else
    session.status = "Nothing to redo";
}

/// Where a word of `seek` leads.
std::size_t place_of(const Document& document, Arguments& arguments) {
  constexpr const char* wanted =
      "a number of operations, end, next, previous, next-phase, previous-phase or bookmark";
  const std::string text = arguments.word(wanted);
  if (text == "end") return document.journal().size();
  if (text == "next") return next_command(document);
  if (text == "previous") return previous_command(document);
  if (text == "next-phase") return next_phase(document);
  if (text == "previous-phase") return previous_phase(document);
  return static_cast<std::size_t>(
      std::max(0LL, Arguments("seek", seek_usage, text).integer(wanted)));
}

void seek_bookmark(Session& session, Arguments& arguments) {
  const std::string name = arguments.rest("a bookmark's name");
  session.play(false);
  if (!session.document().go_to_bookmark(name))
    arguments.fail("there is no bookmark '" + name + "'");
  say_where(session, name.c_str());
}

void seek(Session& session, Arguments& arguments) {
  need_mesh(session);
  Arguments again = arguments;
  if (!again.done() && again.word("a place") == "bookmark") return seek_bookmark(session, again);
  const std::size_t target = arguments.done() ? 0 : place_of(session.document(), arguments);
  start_seek(session, arguments);
  session.document().seek(target);
  say_where(session, "Timeline");
}

/// Through what is known; beyond its end by something new.
void forward(Session& session, Arguments& arguments) {
  const auto count =
      arguments.done()
          ? 1
          : static_cast<std::size_t>(arguments.integer("a number of operations", 1, 1'000'000'000));
  start_seek(session, arguments);
  Document& document = session.document();
  const std::size_t known = document.journal().size() - document.journal().cursor();
  if (known == 0) {
    need_decimable(session);
    if (document.step(count) == 0) {
      session.status = "Nothing left to do with these settings";
      return;
    }
  } else {
    document.seek(document.journal().cursor() + std::min(count, known));
  }
  say_where(session, "Step");
}

void reset(Session& session, Arguments& arguments) {
  start_seek(session, arguments);
  session.document().seek(0);
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
       seek_usage,
       "Moves to where N operations are applied; to where the next or the previous command begins, "
       "or phase: "
       "operations of one kind in a row; or to a bookmark, on whichever branch it is.",
       CommandGroup::History,
       seek,
       {{"Home", "seek 0"},
        {"End", "seek end"},
        {"PageDown", "seek next"},
        {"PageUp", "seek previous"},
        {"Ctrl+Right", "seek next-phase"},
        {"Ctrl+Left", "seek previous-phase"}}},
      {"forward",
       "[N]",
       "N operations forward through what is known; at its end N new ones, as step.",
       CommandGroup::History,
       forward,
       {{"Right", "forward"}, {"Shift+Right", "forward 100"}}},
      {"reset",
       "",
       "Back to the mesh as it was loaded; redo leads forward again.",
       CommandGroup::History,
       reset,
       {{"Ctrl+R", "reset"}}},
  };
}

}  // namespace aomd::scene
