#pragma once
// What single lines do, for people: tooltips, the palette and the list of keys say it first, then
// the line.

#include <span>
#include <string_view>

namespace aomd::scene {

struct LineHelp {
  std::string_view line;
  std::string_view
      help;  ///< a sentence or two that say what happens, with the unit of what is counted
};

/// All lines that have a sentence of their own, by command.
[[nodiscard]] std::span<const LineHelp> helped_lines();

/// What exactly this line does: its own sentence, or the help of a command that is the whole line;
/// empty where there is neither.
[[nodiscard]] std::string_view own_help(std::string_view line);

/// What exactly this line does, or else the help of its command; empty where there is no such
/// command.
[[nodiscard]] std::string_view line_help(std::string_view line);

}  // namespace aomd::scene
