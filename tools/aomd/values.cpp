#include "tools/aomd/values.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/text.h"

namespace aomd::cli {
namespace {

std::string refusal(const std::string& wanted, const std::string& text) {
  return "must be " + wanted + ", not " + (text.empty() ? "empty" : printable(text));
}

}  // namespace

std::optional<double> parse_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

std::optional<std::uint64_t> parse_whole_number(const std::string& text) {
  constexpr double most = 9007199254740992.0;  // 2^53: above it doubles leave whole numbers out
  const auto value = parse_number(text);
  if (!value || !(*value >= 0 && *value <= most) || *value != std::floor(*value)) return {};
  return static_cast<std::uint64_t>(*value);
}

CLI::Validator number(const std::string& wanted, std::function<bool(double)> fits) {
  const auto check = [wanted, fits = std::move(fits)](const std::string& text) {
    const auto value = parse_number(text);
    return value && fits(*value) ? std::string() : refusal(wanted, text);
  };
  return CLI::Validator(check, "");
}

CLI::Validator positive_number() {
  return number("a number above 0", [](double x) { return x > 0 && std::isfinite(x); });
}

CLI::Validator at_least(double low) {
  return number("a number of at least " + number_text(low),
                [=](double x) { return x >= low && std::isfinite(x); });
}

CLI::Validator between(double low, double high) {
  return number("between " + number_text(low) + " and " + number_text(high),
                [=](double x) { return x >= low && x <= high; });
}

CLI::Validator percent() {
  const auto take = [](std::string& text) {
    if (text.size() > 1 && text.back() == '%') text.pop_back();
    return std::string();
  };
  return CLI::Validator(take, "");
}

CLI::Validator angle() {
  return number("more than 0 and less than 180 degrees", [](double x) { return x > 0 && x < 180; });
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const auto check = [=](std::string& text) {
    const auto value = parse_whole_number(text);
    if (!value || *value < low || *value > high)
      return refusal(
          "a whole number between " + std::to_string(low) + " and " + std::to_string(high), text);
    text = std::to_string(*value);
    return std::string();
  };
  return CLI::Validator(check, "");
}

CLI::Validator not_empty() {
  const auto check = [](const std::string& text) {
    return text.empty() ? std::string("must not be empty") : std::string();
  };
  return CLI::Validator(check, "");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::IsMember(words, CLI::ignore_case).description("");
}

}  // namespace aomd::cli
