#pragma once
// Words and numbers as messages show them.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace aomd {

/// The word for any number of things but one: "faces", "vertices", "patches".
[[nodiscard]] std::string plural(std::string_view one);

/// "1 face", "12 faces", "2 vertices".
[[nodiscard]] std::string counted(std::uint64_t n, std::string_view one);

/// "69,451".
[[nodiscard]] std::string grouped(std::int64_t n);
template <std::unsigned_integral N>
[[nodiscard]] std::string grouped(N n) {
  return grouped(static_cast<std::int64_t>(n));
}

/// "a, b or c", where the last two are joined by " or ".
template <typename Words>
[[nodiscard]] std::string joined(const Words& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += std::string(i == 0 ? "" : i + 1 == words.size() ? last : ", ").append(words[i]);
  return text;
}

/// The text in small letters; bytes outside of ASCII stay.
[[nodiscard]] std::string lower(std::string_view text);

/// A word of an input as a message shows it: in quotes, cut after 24 characters, with a question
/// mark for each byte that is no printable ASCII.
[[nodiscard]] std::string shown(std::string_view word);

/// A text on one line: control bytes as \x1b, a line feed as \n.
[[nodiscard]] std::string on_one_line(std::string_view text);

}  // namespace aomd
