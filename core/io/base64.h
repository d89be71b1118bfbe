#pragma once
// Bytes as letters and digits.

#include <string>
#include <string_view>

namespace aomd::io::detail {

/// What a digit stands for, or -1 for what is none.
[[nodiscard]] int base64_value(char digit);

/// The bytes that the digits stand for, up to the first character that is none.
[[nodiscard]] std::string from_base64(std::string_view text);
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace aomd::io::detail
