#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace aomd {
namespace {

unsigned char byte_of(char c) { return static_cast<unsigned char>(c); }

bool continues(char c) { return (byte_of(c) & 0xc0u) == 0x80u; }

/// The bytes of the character at the start of the text that a terminal can show, or 0: controls
/// (below 0x20, 0x7f, and U+0080 to U+009F, which some terminals obey) and what is no UTF-8.
std::size_t shown_bytes(std::string_view text) {
  const unsigned char first = byte_of(text[0]);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), continues))
    return 0;
  return first == 0xc2 && byte_of(text[1]) < 0xa0 ? 0 : size;
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  constexpr std::string_view digits = "0123456789abcdef";
  return {'\\', 'x', digits[byte_of(c) >> 4], digits[byte_of(c) & 15]};
}

/// The first bytes of a text, without half a character at their end.
std::string_view start_of(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && longest - end < 3 && continues(text[end])) --end;
  return text.substr(0, end);
}

std::string limited_line(std::string_view line) {
  constexpr std::size_t longest = 400;
  constexpr std::string_view more = "...";
  std::string text = printable(line.substr(0, longest + 1));
  if (text.size() <= longest && line.size() <= longest) return text;
  text.resize(start_of(text, longest - more.size()).size());
  return text.append(more);
}

}  // namespace

std::string plural(std::string_view one) {
  constexpr std::string_view latin = "vertex";
  if (one.ends_with(latin)) return std::string(one.substr(0, one.size() - 2)) + "ices";
  if (one.ends_with("hedron")) return std::string(one.substr(0, one.size() - 2)) + 'a';
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

std::string number_text(double value, int digits) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.begin(), text.end(), value, std::chars_format::general, digits).ptr;
  return {text.begin(), end};
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t size = shown_bytes(text);
    if (size == 0) {
      result += escaped(text[0]);
    } else {
      result += text.substr(0, size);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 24;
  return '"' + printable(start_of(word, longest)) + (word.size() > longest ? "...\"" : "\"");
}

std::vector<std::string> limited_lines(std::vector<std::string> lines) {
  constexpr std::size_t most = 20;
  const std::size_t all = lines.size();
  if (all > most) lines.resize(most - 1);
  for (std::string& line : lines) line = limited_line(line);
  if (all > most) lines.push_back("and " + std::to_string(all - lines.size()) + " more");
  return lines;
}

}  // namespace aomd
