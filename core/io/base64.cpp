#include "core/io/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace aomd::io::detail {
namespace {

constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<std::int8_t, 256> base64_values = [] {
  std::array<std::int8_t, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < base64_digits.size(); ++i)
    table[static_cast<unsigned char>(base64_digits[i])] = static_cast<std::int8_t>(i);
  return table;
}();

}  // namespace

int base64_value(char digit) { return base64_values[static_cast<unsigned char>(digit)]; }

std::string from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int known = 0;
  for (const char c : text) {
    const int digit = base64_value(c);
    if (digit < 0) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    if ((known += 6) < 8) continue;
    known -= 8;
    bytes += static_cast<char>(bits >> known & 255u);
  }
  return bytes;
}

std::size_t decode_groups(std::string_view text, std::size_t most, char* to) {
  const std::size_t groups = std::min(most, text.size() / 4);
  for (std::size_t i = 0; i < groups; ++i, to += 3) {
    const int a = base64_value(text[4 * i]), b = base64_value(text[4 * i + 1]),
              c = base64_value(text[4 * i + 2]), d = base64_value(text[4 * i + 3]);
    if ((a | b | c | d) < 0) return i;
    to[0] = static_cast<char>(a << 2 | b >> 4);
    to[1] = static_cast<char>(b << 4 | c >> 2);
    to[2] = static_cast<char>(c << 6 | d);
  }
  return groups;
}

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= group.size() ? base64_digits[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

}  // namespace aomd::io::detail
