#pragma once
// Words and numbers as messages show them.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)

namespace aomd {

/// The word for any number of things but one: "faces", "vertices", "patches", "hexahedra".
[[nodiscard]] std::string plural(std::string_view one);

/// "1 face", "12 faces", "2 vertices".
[[nodiscard]] std::string counted(std::uint64_t n, std::string_view one);

/// "69,451".
[[nodiscard]] std::string grouped(std::int64_t n);
template <std::unsigned_integral N>
[[nodiscard]] std::string grouped(N n) {
  return grouped(static_cast<std::int64_t>(n));
}

/// A number as messages show it: so many digits, no trailing zeros.
[[nodiscard]] std::string number_text(double value, int digits = 6);

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

/// The text as a terminal and a single line can take it: control characters, and bytes that are no
/// UTF-8, as "\\n", "\\t" or "\\x1b".
[[nodiscard]] std::string printable(std::string_view text);

/// A word of an input as a message shows it: printable, in quotes, cut after 24 bytes.
[[nodiscard]] std::string shown(std::string_view word);

/// Lines for people: printable, none longer than 400 bytes and no more than 20 of them, of which
/// the last then says how many there were besides. Limiting them again changes nothing.
[[nodiscard]] std::vector<std::string> limited_lines(std::vector<std::string> lines);

}  // namespace aomd

#pragma GCC visibility pop
