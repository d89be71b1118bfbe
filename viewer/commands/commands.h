#pragma once
// The commands: the only way in which menus, buttons, keys, scripts and tests change a session.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/commands/command_error.h"
#include "viewer/session/session.h"

namespace aomd::scene {

class Arguments;

/// A key that emits a line. Chords are written as app::chord_name() writes them.
struct Shortcut {
  std::string_view chord;
  std::string_view line;
};

enum class CommandGroup { File, Options, Operations, History, Selection, View, Scripts };
[[nodiscard]] std::string_view group_name(CommandGroup group);

/// One row of the table that parser, menus, keys, overview and docs/COMMANDS.md are made from.
struct Command {
  std::string_view name;
  std::string_view arguments;  ///< "FILE [WxH]": words as in a manual
  std::string_view help;       ///< one sentence or two
  CommandGroup group;
  void (*run)(Session&, Arguments&);
  std::vector<Shortcut> shortcuts;
};

/// Every command, in the order in which they are listed.
[[nodiscard]] std::span<const Command> commands();

/// What a line asks for: without its comment, and without blanks around it.
[[nodiscard]] std::string_view command_text(std::string_view line);

/// Carries out one line; an empty one and a comment do nothing. Loading and running only start
/// here: see Session::tick. Throws CommandError for what is wrong in the line, io::WriteError from
/// `save`.
void execute(Session& session, std::string_view line);

/// Whether the table has a command of the line's name.
[[nodiscard]] bool is_command(std::string_view line);

/// For what a person asks for in a window: true where the line would lose unsaved work. The line
/// then waits in Session::asked, and the dialog asks; the command `unsaved` answers. Scripts are
/// not asked.
[[nodiscard]] bool asks_first(Session& session, std::string_view line);

/// The line that a chord emits; empty where it has none.
[[nodiscard]] std::string_view line_of_chord(std::string_view chord);
/// The first chord that emits exactly this line; empty where there is none. For menus and tooltips.
[[nodiscard]] std::string_view chord_of_line(std::string_view line);

/// The text of docs/COMMANDS.md.
[[nodiscard]] std::string commands_markdown();
/// The list for --help.
[[nodiscard]] std::string commands_help();

}  // namespace aomd::scene
