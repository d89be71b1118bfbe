#pragma once
// The words that follow a command's name.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/mesh/model_ref.h"
#include "viewer/base/entity_text.h"

namespace aomd::scene {

/// Read from left to right. Every member throws CommandError that names the command and what it
/// wants.
class Arguments {
 public:
  Arguments(std::string_view command, std::string_view usage, std::string_view text);

  [[nodiscard]] bool done();
  /// The next word; quotes hold blanks together, and \\" is a quote among them: see in_quotes().
  [[nodiscard]] std::string word(std::string_view what);
  /// All that is left, without quotes around it: a file name may hold blanks.
  [[nodiscard]] std::string rest(std::string_view what);
  [[nodiscard]] double number(std::string_view what);
  /// A number in [low, high].
  [[nodiscard]] double number(std::string_view what, double low, double high);
  [[nodiscard]] long long integer(std::string_view what);
  /// A whole number in [low, high], both at most 2^53; "1e3" is one.
  [[nodiscard]] long long integer(std::string_view what, long long low, long long high);
  /// One of two or more words.
  [[nodiscard]] std::string one_of(const std::vector<std::string_view>& words);
  /// What one of two or more words stands for.
  template <typename T, std::size_t N>
  [[nodiscard]] T choice(const std::array<std::pair<std::string_view, T>, N>& choices) {
    std::vector<std::string_view> words;
    words.reserve(N);
    for (const auto& each : choices) words.push_back(each.first);
    const std::string word = one_of(words);
    for (const auto& [name, value] : choices)
      if (word == name) return value;
    return {};
  }
  /// vertex, edge, face or region as 0 to 3; those below `lowest` are not taken.
  [[nodiscard]] int level(int lowest = 0);
  /// on, off or toggle; a missing word is toggle.
  [[nodiscard]] bool flag(bool present);
  /// "960x600"
  [[nodiscard]] glm::ivec2 size();
  /// "face:3", "edge:-1", "vertex:2"
  [[nodiscard]] ModelRef model_entity();
  /// Throws when words are left.
  void end();
  [[noreturn]] void fail(const std::string& why) const;

 private:
  void skip_blanks();

  std::string command_;
  std::string usage_;
  std::string_view text_;
};

/// A text as one word of a line, in quotes: word() and rest() read it back, whatever is in it.
[[nodiscard]] std::string in_quotes(std::string_view text);
/// A text as the last words of a line: in quotes only where rest() would read something else.
[[nodiscard]] std::string as_rest(const std::string& text);

/// What stands before a comment: `#` begins one at the start of a word, but not in quotes.
[[nodiscard]] std::string_view without_comment(std::string_view line);

}  // namespace aomd::scene
