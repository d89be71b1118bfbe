#include "core/base/text.h"

namespace aomd {

std::string plural(std::string_view one) {
  constexpr std::string_view latin = "vertex";
  if (one.ends_with(latin)) return std::string(one.substr(0, one.size() - 2)) + "ices";
  return std::string(one) + (one.ends_with("ch") ? "es" : "s");
}

std::string counted(std::uint64_t n, std::string_view one) {
  return std::to_string(n) + ' ' + (n == 1 ? std::string(one) : plural(one));
}

std::string grouped(std::int64_t n) {
  std::string text = std::to_string(n < 0 ? -n : n);
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, ",");
  return n < 0 ? "\u2212" + text : text;
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text = "\"";
  for (const char c : word.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return text + (word.size() > longest ? "...\"" : "\"");
}

std::string on_one_line(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n')
      result += "\\n";
    else if (byte < 0x20 || byte == 0x7f)
      result.append("\\x").append({digits[byte >> 4], digits[byte & 15u]});
    else
      result += c;
  }
  return result;
}

}  // namespace aomd
