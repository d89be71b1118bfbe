// Every command, and every word that its usage names, is run by a script in tests/scripts; every
// page and dialog has its pictures.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/suite/suite.h"

namespace aomd::scene::script_coverage_test {
namespace {

namespace fs = std::filesystem;
const fs::path scripts = AOMD_SOURCE "/tests/scripts";

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The lines of all scripts below a folder, as words.
std::vector<std::vector<std::string>> lines_below(const fs::path& folder) {
  std::vector<std::vector<std::string>> lines;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".aomd") continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);)
      if (const auto words = words_of(line.substr(0, line.find('#'))); !words.empty())
        lines.push_back(words);
  }
  return lines;
}

/// The words in lower case that a usage names: "off" of "FILE|off", not what stands for something
/// else.
std::set<std::string> literals_of(std::string_view usage) {
  static const std::regex word("[A-Za-z0-9.,:=-]+"), literal("[a-z][a-z-]+");
  const std::string text(usage);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it)
    if (std::regex_match(it->str(), literal)) found.insert(it->str());
  return found;
}

/// What is asked for here and cannot be done by a script: nothing would be left to compare, or it
/// needs a program that died, a display, or a file that is not ours.
const std::set<std::string> elsewhere = {"recover", "recover discard", "recover all",
                                         "unsaved save"};

std::set<std::string> runs_of(const std::vector<std::vector<std::string>>& lines) {
  std::set<std::string> runs;
  for (const auto& words : lines) {
    runs.insert(words[0]);
    for (const std::string& word : words)
      runs.insert(words[0] + " " + word.substr(0, word.find(':')));
  }
  return runs;
}

TEST(ScriptCoverage, EveryCommandAndEveryWordOfItsUsageIsRun) {
  const std::set<std::string> runs = runs_of(lines_below(scripts));
  for (const Command& command : commands()) {
    const std::string name(command.name);
    EXPECT_TRUE(runs.contains(name) || elsewhere.contains(name)) << "no script runs " << name;
    for (const std::string& word : literals_of(command.arguments)) {
      const std::string run = name + " " + word;
      EXPECT_TRUE(runs.contains(run) || elsewhere.contains(run)) << "no script runs " << run;
    }
  }
}

std::set<std::string> words_of_command(std::string_view name) {
  for (const Command& command : commands())
    if (command.name == name) return literals_of(command.arguments);
  return {};
}

TEST(ScriptCoverage, EveryPanelAndDialogHasItsPictures) {
  const std::set<std::string> runs = runs_of(lines_below(scripts / "panels"));
  for (const std::string_view name : {"panel", "dialog"})
    for (const std::string& word : words_of_command(name)) {
      if (word == "on" || word == "off" || word == "toggle" || word == "none") continue;
      const std::string run = std::string(name) + " " + word;
      EXPECT_TRUE(runs.contains(run)) << "no script in tests/scripts/panels runs " << run;
    }
}

/// The scripts of a folder's cases, with how many cases each has.
std::map<std::string, int> cases_of(const char* file) {
  std::map<std::string, int> found;
  for (const suite::Case& each : suite::read_suite(scripts / ".." / file).cases) {
    EXPECT_EQ(each.problem, "") << each.name;
    EXPECT_TRUE(each.name.starts_with(fs::path(each.script).stem().string())) << each.name;
    ++found[fs::path(each.script).filename().string()];
  }
  return found;
}

std::map<std::string, int> scripts_in(const fs::path& folder, int cases) {
  std::map<std::string, int> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".aomd") found[entry.path().filename().string()] = cases;
  return found;
}

TEST(ScriptCoverage, EveryScriptIsACaseOfItsSuite) {
  EXPECT_EQ(cases_of("pictures.toml"), scripts_in(scripts, 1));
  std::map<std::string, int> panels = scripts_in(scripts / "panels", 4);
  panels.erase("dialog_recovery.aomd");  // its work is locked by whoever finds it
  EXPECT_EQ(cases_of("panels.toml"), panels);
}

}  // namespace
}  // namespace aomd::scene::script_coverage_test
