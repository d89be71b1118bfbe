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

}  // namespace aomd
