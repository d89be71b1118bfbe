#pragma once
// Bytes as letters and digits.

#include <cstddef>
#include <string>
#include <string_view>

namespace aomd::io::detail {

/// What a digit stands for, or -1 for what is none.
[[nodiscard]] int base64_value(char digit);

/// The bytes that the digits stand for, up to the first character that is none.
[[nodiscard]] std::string from_base64(std::string_view text);
/// Writes the three bytes of each group of four digits that `text` begins with, up to the first
/// that has something else in it, and of no more groups than `most`. Returns of how many.
std::size_t decode_groups(std::string_view text, std::size_t most, char* to);
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace aomd::io::detail
