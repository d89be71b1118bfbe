#include "viewer/base/text.h"

#include <array>
#include <cstdio>

#include "core/mesh/names.h"

namespace aomd::scene {

std::string counted(std::int64_t n, std::string_view one) {
  return grouped(n) + " " + (n == 1 ? std::string(one) : plural(one));
}

std::string signed_grouped(std::int64_t n) {
  if (n == 0) return "\u00b10";
  return n > 0 ? "+" + grouped(n) : grouped(n);
}

std::string counts_text(const std::array<std::size_t, 4>& counts) {
  std::string text;
  for (const int dim : {3, 2, 1, 0}) {
    const auto count = static_cast<std::int64_t>(counts[static_cast<std::size_t>(dim)]);
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + grouped(count) + " " +
            (count == 1 ? entity_name(dim) : entity_plural(dim));
  }
  return text;
}

std::string bytes_text(std::size_t bytes) {
  constexpr std::array units = {" B", " KB", " MB", " GB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 999.95 && unit + 1 < units.size(); ++unit) value /= 1000;
  return (unit == 0 ? std::to_string(bytes) : short_number(value, 1)) + units[unit];
}

std::string short_number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string result = text;
  if (result.find('.') == std::string::npos) return result;
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result;
}

std::string significant(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace aomd::scene
