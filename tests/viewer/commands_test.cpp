// The table of commands and what is made from it.

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/message.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::commands_test {
namespace {

TEST(Commands, TheCommittedListIsTheGeneratedOne) {
  std::ifstream in(AOMD_SOURCE "/docs/COMMANDS.md");
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), commands_markdown())
      << "bin/aomd-view --commands-markdown > docs/COMMANDS.md makes it current";
}

TEST(Commands, NamesAndChordsAreUnique) {
  std::set<std::string_view> names;
  std::set<std::string_view> chords;
  for (const Command& command : commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_FALSE(command.help.empty()) << command.name;
    for (const Shortcut& s : command.shortcuts)
      EXPECT_TRUE(chords.insert(s.chord).second) << s.chord;
  }
}

TEST(Commands, EveryShortcutIsALineThatItsCommandTakes) {
  Session session;
  test::drive(session, {"sample sphere 8"});
  for (const Command& command : commands()) {
    for (const Shortcut& s : command.shortcuts) {
      EXPECT_EQ(s.line.substr(0, s.line.find(' ')),
                s.line.rfind("dialog", 0) == 0 ? "dialog" : command.name);
      EXPECT_NO_THROW(test::drive(session, {s.line})) << s.line;
      EXPECT_EQ(line_of_chord(s.chord), s.line);
    }
  }
}

TEST(Commands, EveryOneIsListedInTheHelp) {
  const std::string help = commands_help();
  for (const Command& command : commands()) {
    EXPECT_NE(help.find("\n  " + std::string(command.name)), std::string::npos) << command.name;
    EXPECT_NE(help.find(command.help), std::string::npos) << command.name;
  }
}

TEST(Commands, WhatTakesNoArgumentsRefusesThem) {
  Session session;
  test::drive(session, {"sample sphere 8"});
  for (const Command& command : commands()) {
    if (!command.arguments.empty()) continue;
    EXPECT_THROW(execute(session, std::string(command.name) + " surplus"), CommandError)
        << command.name;
  }
}

TEST(Commands, AWrongWordIsAnsweredByThoseThatAreTaken) {
  Session session;
  test::drive(session, {"sample sphere 8"});
  const auto refusal = [&](const char* line) {
    return aomd::test::message([&] { execute(session, line); });
  };
  EXPECT_EQ(refusal("topology loose"),
            "topology: 'loose' is neither safe nor paper (usage: topology safe|paper)");
  EXPECT_EQ(refusal("strategy"), "strategy: give paper or quality (usage: strategy paper|quality)");
  EXPECT_EQ(refusal("neighbours node"),
            "neighbours: 'node' is none of vertex, edge, face, region, off (usage: neighbours "
            "vertex|edge|face|region|off)");
  EXPECT_NE(refusal("select node 3").find("'node' is none of vertex, edge, face, region ("),
            std::string::npos);
  EXPECT_NE(refusal("hash-sets build vertex").find("'vertex' is none of edge, face, region ("),
            std::string::npos);
  EXPECT_NE(refusal("expect faces == 3").find("'==' is none of =, <, >, <=, >= ("),
            std::string::npos);
  EXPECT_NE(refusal("highlight face3").find("'face3' is not a model entity like face:3"),
            std::string::npos);
}

TEST(Commands, EmptyLinesAndCommentsDoNothing) {
  Session session;
  for (const char* line : {"", "   ", "# open nothing", "\t# \r"})
    EXPECT_NO_THROW(execute(session, line));
}

}  // namespace
}  // namespace aomd::scene::commands_test
