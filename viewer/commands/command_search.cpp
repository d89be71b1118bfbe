#include "viewer/commands/command_search.h"

#include <algorithm>
#include <cctype>

#include "viewer/commands/line_help.h"

namespace aomd::scene {
namespace {

// The kinds of matches, far enough apart that no score within one reaches the next.
constexpr int completed = 5000, named_exactly = 4000, named_so_far = 3000, named_loosely = 2000,
              chosen = 1500, described = 500;
constexpr int recent_bonus = 400;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool begins_word(std::string_view text, std::size_t i) {
  return i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t from = text.find_first_not_of(' ');
    if (from == std::string_view::npos) return words;
    const std::size_t to = std::min(text.find(' ', from), text.size());
    words.push_back(text.substr(from, to - from));
    text.remove_prefix(to);
  }
}

bool has_word_from(std::string_view text, std::string_view beginning) {
  for (std::size_t i = 0; i + beginning.size() <= text.size(); ++i)
    if (begins_word(text, i) && same_letters(text.substr(i, beginning.size()), beginning))
      return true;
  return false;
}

bool needs_arguments(const Command& command) {
  return !command.arguments.empty() && command.arguments.front() != '[';
}

/// "light", "dark", "toggle" of "light|dark|toggle [...]": what stands for itself, not for
/// something else.
std::vector<std::string> choices_of(const Command& command) {
  const std::string_view first = command.arguments.substr(0, command.arguments.find(' '));
  std::vector<std::string> choices(1);
  for (const char c : first) {
    if (c == '|')
      choices.emplace_back();
    else if (std::islower(static_cast<unsigned char>(c)) != 0 || c == '-')
      choices.back() += c;
    else
      return {};
  }
  return choices.size() > 1 ? choices : std::vector<std::string>();
}

const Command* command_of(std::string_view line) {
  const std::string_view name = line.substr(0, line.find(' '));
  for (const Command& command : commands())
    if (command.name == name) return &command;
  return nullptr;
}

/// Collects matches; of those with the same line the best stays.
class Matches {
 public:
  Matches(std::string_view text, std::span<const std::string> recent)
      : text_(text), words_(words_of(text)), recent_(recent) {}

  void look_at(const Command& command) {
    by_name(command);
    for (const Shortcut& s : command.shortcuts)
      by_line(*command_of(s.line), std::string(s.line), true);
    const std::size_t blank = command.arguments.find(' ');
    const bool all = blank == std::string_view::npos || command.arguments[blank + 1] == '[';
    for (const std::string& choice : choices_of(command))
      by_line(command, std::string(command.name) + " " + choice + (all ? "" : " "), all);
    by_help(command);
    for (const LineHelp& each : helped_lines())
      if (command_of(each.line) == &command && says_all(each.help))
        add({&command, std::string(each.line), {}, true, false, described});
  }

  void look_at_recent() {
    for (const std::string& line : recent_)
      if (const Command* command = command_of(line)) by_line(*command, line, true);
  }

  std::vector<CommandMatch> take() {
    std::stable_sort(
        found_.begin(), found_.end(),
        [](const CommandMatch& a, const CommandMatch& b) { return a.score > b.score; });
    return std::move(found_);
  }

 private:
  void by_name(const Command& command) {
    const std::string_view name = words_.front();
    const int fit = fuzzy_score(name, command.name);
    if (fit == 0) return;
    const int kind = command.name == name                                      ? named_exactly
                     : same_letters(command.name.substr(0, name.size()), name) ? named_so_far
                                                                               : named_loosely;
    const auto after = static_cast<std::size_t>(name.data() + name.size() - text_.data());
    std::string rest(text_.substr(after));
    const bool bare = words_.size() == 1;
    if (bare) rest = needs_arguments(command) ? " " : "";
    add({&command,
         std::string(command.name) + rest,
         {},
         !bare || !needs_arguments(command),
         false,
         kind + fit});
  }

  /// A word that has been begun is meant to be that of a choice; a number is not meant to be a
  /// longer one.
  [[nodiscard]] bool completes(const std::string& line) const {
    return words_.size() > 1 && std::isalpha(static_cast<unsigned char>(text_.back())) != 0 &&
           same_letters(line.substr(0, text_.size()), text_);
  }

  void by_line(const Command& command, std::string line, bool complete) {
    const int fit = fuzzy_score(text_, line);
    if (fit == 0) return;
    const int kind = completes(line) ? completed : chosen;
    add({&command, std::move(line), {}, complete, false, kind + fit});
  }

  [[nodiscard]] bool says_all(std::string_view help) const {
    return std::all_of(words_.begin(), words_.end(),
                       [&](std::string_view word) { return has_word_from(help, word); });
  }

  void by_help(const Command& command) {
    for (const std::string_view word : words_)
      if (!has_word_from(command.help, word) && !has_word_from(command.arguments, word)) return;
    const bool needs = needs_arguments(command);
    add({&command, std::string(command.name) + (needs ? " " : ""), {}, !needs, false, described});
  }

  void add(CommandMatch match) {
    match.recent = std::find(recent_.begin(), recent_.end(), match.line) != recent_.end();
    if (match.recent) match.score += recent_bonus;
    match.key = chord_of_line(match.line);
    const auto known = std::find_if(found_.begin(), found_.end(),
                                    [&](const CommandMatch& m) { return m.line == match.line; });
    if (known == found_.end())
      found_.push_back(std::move(match));
    else if (known->score < match.score)
      *known = std::move(match);
  }

  std::string_view text_;
  std::vector<std::string_view> words_;
  std::span<const std::string> recent_;
  std::vector<CommandMatch> found_;
};

std::vector<CommandMatch> everything(std::span<const std::string> recent) {
  std::vector<CommandMatch> found;
  for (const std::string& line : recent)
    if (const Command* command = command_of(line))
      found.push_back({command, line, chord_of_line(line), true, true, 0});
  for (const Command& command : commands()) {
    const bool needs = needs_arguments(command);
    const std::string_view key =
        command.shortcuts.empty() ? std::string_view() : command.shortcuts[0].chord;
    found.push_back(
        {&command, std::string(command.name) + (needs ? " " : ""), key, !needs, false, 0});
  }
  return found;
}

}  // namespace

int fuzzy_score(std::string_view pattern, std::string_view text) {
  int score = 0;
  std::size_t at = 0;
  bool together = false;
  for (const char wanted : pattern) {
    const std::size_t from = at;
    while (at < text.size() && lower(text[at]) != lower(wanted)) ++at;
    if (at == text.size()) return 0;
    together = together && at == from;
    score += 4 + (together ? 9 : 0) + (begins_word(text, at) ? 8 : 0);
    together = true;
    ++at;
  }
  return pattern.empty() ? 0
                         : std::max(1, score - static_cast<int>(text.size() - pattern.size()) / 4);
}

std::vector<CommandMatch> find_commands(std::string_view text,
                                        std::span<const std::string> recent) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  if (text.empty()) return everything(recent);
  Matches matches(text, recent);
  matches.look_at_recent();
  for (const Command& command : commands()) matches.look_at(command);
  return matches.take();
}

}  // namespace aomd::scene
