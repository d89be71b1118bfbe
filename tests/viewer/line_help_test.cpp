// Sentences for people: every line that keys, tabs and buttons emit has one of its own.

#include <gtest/gtest.h>

#include <set>

#include "viewer/base/text.h"
#include "viewer/commands/command_search.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/line_help.h"

namespace aomd::scene::line_help_test {
namespace {

std::string_view command_help(std::string_view line) {
  for (const Command& command : commands())
    if (command.name == line.substr(0, line.find(' '))) return command.help;
  return {};
}

TEST(LineHelp, EachIsASentenceOfItsOwnForALineThatIsACommand) {
  std::set<std::string_view> seen, lines;
  for (const LineHelp& each : helped_lines()) {
    EXPECT_TRUE(is_command(each.line)) << each.line;
    EXPECT_TRUE(lines.insert(each.line).second) << each.line << " twice";
    EXPECT_TRUE(seen.insert(each.help).second) << each.line << " says what another line says";
    EXPECT_TRUE(each.help.ends_with('.')) << each.line;
    EXPECT_EQ(line_help(each.line), each.help);
  }
}

TEST(LineHelp, KeysThatEmitMoreThanANameSayWhatTheyDo) {
  for (const Command& command : commands())
    for (const Shortcut& s : command.shortcuts)
      if (s.line != command.name) {
        EXPECT_NE(line_help(s.line), command_help(s.line)) << s.line;
      }
}

TEST(LineHelp, TabsAndTransportButtonsDiffer) {
  std::set<std::string_view> helps;
  const std::initializer_list<std::string_view> lines = {"panel decimation on",
                                                         "panel adjacency on",
                                                         "panel histograms on",
                                                         "panel selection on",
                                                         "seek 0",
                                                         "step -1",
                                                         "play toggle",
                                                         "forward",
                                                         "seek end"};
  for (const std::string_view line : lines) helps.insert(line_help(line));
  EXPECT_EQ(helps.size(), lines.size());
}

// What the palette lists by the words that a command names says what that word does, not what all
// of them do.
TEST(LineHelp, ChoicesOfThePaletteSayWhatTheyDo) {
  std::size_t choices = 0;
  for (const Command& command : commands())
    for (const CommandMatch& match : find_commands(command.name, {}))
      if (match.complete && match.command == &command && match.line != command.name) {
        ++choices;
        EXPECT_NE(line_help(match.line), command.help) << match.line;
      }
  EXPECT_GT(choices, 80u);
}

TEST(LineHelp, OtherLinesHaveTheHelpOfTheirCommand) {
  EXPECT_EQ(line_help("sample sphere 8"), command_help("sample"));
  EXPECT_EQ(line_help("no such command"), "");
}

TEST(Counted, AgreesWithItsNumber) {
  EXPECT_EQ(counted(1, "swap"), "1 swap");
  EXPECT_EQ(counted(0, "swap"), "0 swaps");
  EXPECT_EQ(counted(7160, "face"), "7,160 faces");
  EXPECT_EQ(counted(1, "model vertex"), "1 model vertex");
  EXPECT_EQ(counted(2, "model vertex"), "2 model vertices");
  EXPECT_EQ(counted(2, "branch"), "2 branches");
}

}  // namespace
}  // namespace aomd::scene::line_help_test
