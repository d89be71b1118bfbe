// The palette, and what keeps work from being lost.

#include <algorithm>
#include <utility>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void palette(Session& session, Arguments& arguments) {
  session.view.palette_text = arguments.done() ? "" : arguments.rest("a text");
  session.view.dialog = Dialog::Palette;
}

void unsaved(Session& session, Arguments& arguments) {
  const std::string answer = arguments.one_of({"save", "discard", "cancel"});
  arguments.end();
  if (answer == "save") {
    const std::filesystem::path file = session.document().saved_file();
    if (file.empty())
      session.view.dialog = Dialog::Save;  // whose `save` goes on with the line
    else
      execute(session, "save " + in_quotes(file.string()));
    return;
  }
  session.view.dialog = Dialog::None;
  const std::string line = std::exchange(session.asked, {});
  if (answer == "discard" && !line.empty()) session.next_line = line;
}

void need_recovery(const Session& session) {
  if (!session.recovery) throw CommandError("recovery is off: start with --recovery");
}

std::string nothing_to_recover(const FoundWork& found) {
  std::string text = "there is nothing to recover";
  for (const std::string& why : found.unreadable) text += ", but what cannot be read: " + why;
  return text;
}

std::size_t which(const Session& session, Arguments& arguments) {
  const long long number = arguments.done() ? 1 : arguments.integer("a number in the list");
  arguments.end();
  need_recovery(session);
  const auto count = static_cast<long long>(session.found_work.works.size());
  if (count == 0) throw CommandError(nothing_to_recover(session.found_work));
  if (number < 1 || number > count)
    arguments.fail("there is no number " + std::to_string(number) + ", but 1 to " +
                   std::to_string(count));
  return static_cast<std::size_t>(number - 1);
}

void discard_found(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  if (!again.done() && again.word("a number") == "all") {
    again.end();
    need_recovery(session);
    for (const auto& work : session.found_work.works) discard(*work);
    session.found_work.works.clear();
  } else {
    const std::size_t i = which(session, arguments);
    discard(*session.found_work.works[i]);
    session.found_work.works.erase(session.found_work.works.begin() +
                                   static_cast<std::ptrdiff_t>(i));
  }
  session.status = "Discarded";
  if (session.found_work.works.empty() && session.view.dialog == Dialog::Recovery)
    session.view.dialog = Dialog::None;
}

void recover(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  if (!again.done() && again.word("a number, or discard") == "discard")
    return discard_found(session, again);
  const auto work = session.found_work.works[which(session, arguments)];
  LoadRequest request = work->source;
  request.work = work;
  session.view.dialog = Dialog::None;
  session.start_loading(std::move(request));
}

void panel_width(Session& session, Arguments& arguments) {
  const std::string panel = arguments.one_of({"mesh", "side"});
  const std::string text = arguments.word("a width, or usual");
  arguments.end();
  const double ems =
      text == "usual"
          ? 0
          : Arguments("panel-width", "mesh|side EMS|usual", text).number("a width", 8, 60);
  Panels& panels = session.view.panels;
  (panel == "mesh" ? panels.mesh_ems : panels.side_ems) = static_cast<float>(ems);
}

}  // namespace

std::vector<Command> work_commands() {
  return {
      {"palette",
       "[TEXT]",
       "Finds a command by what one types; TEXT stands there already.",
       CommandGroup::View,
       palette,
       {{"Ctrl+Shift+P", "palette"}}},
      {"panel-width",
       "mesh|side EMS|usual",
       "How wide a panel is, in units of the font's size: 8 to 60, as far as the window has room. "
       "Dragging "
       "its border does the same.",
       CommandGroup::View,
       panel_width,
       {}},
      {"unsaved",
       "save|discard|cancel",
       "Answers the question about unsaved work that a window asks before it quits or opens "
       "another mesh. "
       "Scripts are never asked.",
       CommandGroup::File,
       unsaved,
       {}},
      {"recover",
       "[N|discard [N|all]]",
       "Brings back unsaved work of a program that died: the newest, or number N of the list "
       "(dialog "
       "recovery); discard forgets it.",
       CommandGroup::File,
       recover,
       {}},
  };
}

}  // namespace aomd::scene
