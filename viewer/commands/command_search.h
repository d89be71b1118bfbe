#pragma once
// Finds commands by what a person types: for the palette.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/commands/commands.h"

namespace aomd::scene {

/// A line that the typed text may mean.
struct CommandMatch {
  const Command* command = nullptr;
  std::string line;       ///< "factor 3"; a blank at its end where arguments are missing
  std::string_view key;   ///< the chord that emits exactly this line; empty: none
  bool complete = false;  ///< it can be carried out as it stands
  bool recent = false;
  int score = 0;  ///< higher is better
};

/// How well the characters of `pattern` are found in `text`, in their order and whatever their
/// case: 0 where they are not; more where they stand together, at the beginning of words, and where
/// little else does.
[[nodiscard]] int fuzzy_score(std::string_view pattern, std::string_view text);

/// What `text` may mean, best first: recent lines, commands by name (further words are arguments),
/// lines that have a key, the choices that a command names, and commands whose help has the words.
/// Without text the recent lines, then every command in the order of the table. `recent`: newest
/// first. O(commands).
[[nodiscard]] std::vector<CommandMatch> find_commands(std::string_view text,
                                                      std::span<const std::string> recent);

}  // namespace aomd::scene
