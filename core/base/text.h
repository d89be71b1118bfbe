#pragma once
// Words and numbers as messages show them.

#include <cstdint>
#include <string>
#include <string_view>

namespace aomd {

/// The word for any number of things but one: "faces", "vertices", "patches".
[[nodiscard]] std::string plural(std::string_view one);

/// "1 face", "12 faces", "2 vertices".
[[nodiscard]] std::string counted(std::uint64_t n, std::string_view one);

/// The text in small letters; bytes outside of ASCII stay.
[[nodiscard]] std::string lower(std::string_view text);

/// A word of an input as a message shows it: in quotes, cut after 24 characters, with a question
/// mark for each byte that is no printable ASCII.
[[nodiscard]] std::string shown(std::string_view word);

}  // namespace aomd
