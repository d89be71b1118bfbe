// What typed text finds, and in which order.

#include <gtest/gtest.h>

#include <algorithm>

#include "viewer/commands/command_search.h"

namespace aomd::scene::palette_test {
namespace {

std::vector<CommandMatch> find(std::string_view text, std::vector<std::string> recent = {}) {
  return find_commands(text, recent);
}

bool has_line(const std::vector<CommandMatch>& matches, std::string_view line) {
  return std::any_of(matches.begin(), matches.end(),
                     [&](const CommandMatch& m) { return m.line == line; });
}

TEST(FuzzyScore, WantsAllCharactersInTheirOrderWhateverTheirCase) {
  EXPECT_GT(fuzzy_score("fct", "factor"), 0);
  EXPECT_GT(fuzzy_score("FACT", "factor"), 0);
  EXPECT_EQ(fuzzy_score("tcf", "factor"), 0);
  EXPECT_EQ(fuzzy_score("factors", "factor"), 0);
  EXPECT_EQ(fuzzy_score("", "factor"), 0);
}

TEST(FuzzyScore, PrefersWhatStandsTogetherAndAtTheBeginningOfWords) {
  EXPECT_GT(fuzzy_score("step", "step"), fuzzy_score("step", "s-t-e-p"));
  EXPECT_GT(fuzzy_score("tf", "target-faces"), fuzzy_score("tf", "transfer"));
  EXPECT_GT(fuzzy_score("run", "run"), fuzzy_score("run", "run a longer name"));
}

TEST(FindCommands, WithoutTextListsEveryCommandInTheOrderOfTheTable) {
  const auto all = find("  ");
  ASSERT_EQ(all.size(), commands().size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].command, &commands()[i]);
}

TEST(FindCommands, WithoutTextRecentLinesComeFirst) {
  const auto all = find("", {"factor 3", "sweep"});
  ASSERT_EQ(all.size(), commands().size() + 2);
  EXPECT_EQ(all[0].line, "factor 3");
  EXPECT_TRUE(all[0].recent);
  EXPECT_TRUE(all[0].complete);
  EXPECT_EQ(all[1].line, "sweep");
}

TEST(FindCommands, TheExactNameComesFirstAndFurtherWordsAreItsArguments) {
  const auto matches = find("step 12");
  EXPECT_EQ(matches.at(0).line, "step 12");
  EXPECT_TRUE(matches.at(0).complete);
  EXPECT_EQ(find("show edges").at(0).line, "show edges");
  EXPECT_EQ(find("s").at(0).command->name[0], 's');
}

TEST(FindCommands, AShortenedNameTakesArgumentsToo) {
  EXPECT_EQ(find("fact 3").at(0).line, "factor 3");
  EXPECT_EQ(find("tgf 100").at(0).line, "target-faces 100");
}

TEST(FindCommands, WhatLacksArgumentsIsNotCompleteUnlessTheyMayBeLeftOut) {
  EXPECT_EQ(find("factor").at(0).line, "factor ");
  EXPECT_FALSE(find("factor").at(0).complete);
  EXPECT_EQ(find("sweep").at(0).line, "sweep");
  EXPECT_TRUE(find("sweep").at(0).complete);
}

TEST(FindCommands, ChoicesAreFoundByTheirOwnName) {
  EXPECT_EQ(find("dark").at(0).line, "theme dark");
  EXPECT_TRUE(find("dark").at(0).complete);
  EXPECT_TRUE(
      has_line(find("orthographic"), "camera "));  // a word of its help: no choice of its own
}

TEST(FindCommands, AChoiceThatHasBeenBegunIsCompletedANumberIsNot) {
  EXPECT_EQ(find("show su").at(0).line, "show surface");
  EXPECT_EQ(find("camera t").at(0).line, "camera top");
  EXPECT_EQ(find("step 1").at(0).line, "step 1");  // not step 100, which has a key
}

TEST(FindCommands, LinesWithAKeySayIt) {
  const auto matches = find("camera front");
  EXPECT_EQ(matches.at(0).line, "camera front");
  EXPECT_EQ(matches.at(0).key, "1");
}

TEST(FindCommands, HelpIsSearchedByTheBeginningsOfWords) {
  EXPECT_TRUE(has_line(find("takes back"), "undo"));
  EXPECT_TRUE(has_line(find("takes one back"), "step -1"));  // what this line does, not its command
  EXPECT_TRUE(find("qqqq").empty());
}

TEST(FindCommands, RecentLinesComeBeforeOthersOfTheirKind) {
  EXPECT_EQ(find("pa", {"panel mesh off"}).front().line.substr(0, 2), "pa");
  const auto plain = find("theme t"), remembered = find("theme t", {"theme toggle"});
  EXPECT_TRUE(has_line(remembered, "theme toggle"));
  EXPECT_GT(std::find_if(remembered.begin(), remembered.end(),
                         [](const CommandMatch& m) { return m.line == "theme toggle"; })
                ->score,
            std::find_if(plain.begin(), plain.end(), [](const CommandMatch& m) {
              return m.line == "theme toggle";
            })->score);
}

TEST(FindCommands, NoLineIsListedTwice) {
  for (const char* text : {"c", "se", "show", "dialog open", "t"}) {
    const auto matches = find(text, {"sweep", "show edges toggle"});
    for (std::size_t i = 0; i < matches.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_NE(matches[i].line, matches[k].line) << text;
  }
}

}  // namespace
}  // namespace aomd::scene::palette_test
