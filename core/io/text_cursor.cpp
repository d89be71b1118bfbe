#include "core/io/text_cursor.h"
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>

namespace aomd::io::detail {
namespace {

/// "1.#INF", "-1.#IND", "1.#QNAN0": how Windows has written what is not finite.
std::optional<double> number_of_windows(std::string_view word) {
  const double sign = word.starts_with('-') ? -1 : 1;
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  if (word.starts_with("1.#INF")) return sign * std::numeric_limits<double>::infinity();
  const bool none =
      word.starts_with("1.#IND") || word.starts_with("1.#QNAN") || word.starts_with("1.#SNAN");
  return none ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

/// With "e" for Fortran's "d", where that follows a digit or the point.
std::string with_usual_exponent(std::string_view word) {
  std::string text(word);
  const std::size_t d = text.find_first_of("dD");
  if (d == std::string::npos || d == 0) return text;
  if (std::isdigit(static_cast<unsigned char>(text[d - 1])) || text[d - 1] == '.') text[d] = 'e';
  return text;
}

std::optional<double> unusual_number_of(std::string_view word) {
  if (const auto other = number_of_windows(word)) return other;
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const std::string text = with_usual_exponent(word);
  double value = 0;
  const auto [next, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || next != text.data() + text.size()) return {};
  // Beyond the range of a double: what is too small becomes zero or subnormal, the rest infinite.
  return error == std::errc{} ? value : std::strtod(text.c_str(), nullptr);
}

}  // namespace

bool TextCursor::skip_to_content() {
  while (p_ != end_) {
    if (is_blank(*p_) || is_line_end(*p_)) {
      ++p_;
    } else if (*p_ == comment_ || (*p_ == '#' && at_comment_line())) {
      skip_line();
    } else {
      return false;
    }
  }
  return true;
}

/// Looks back: nothing but blanks may stand on the line before.
bool TextCursor::at_comment_line() const {
  if (!passes_comment_lines_) return false;
  const char* p = p_;
  while (p != start_ && is_blank(p[-1])) --p;
  return p == start_ || is_line_end(p[-1]);
}

void TextCursor::skip_line() {
  while (p_ != end_ && !is_line_end(*p_)) ++p_;
  if (p_ == end_) return;
  const bool two = *p_ == '\r' && p_ + 1 != end_ && p_[1] == '\n';
  p_ += two ? 2 : 1;
}

std::string_view TextCursor::rest_of_line() {
  skip_blanks();
  const char* first = p_;
  skip_line();
  const char* last = p_;
  while (last != first && (is_blank(last[-1]) || is_line_end(last[-1]))) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

void TextCursor::end_line() {
  if (!line_done()) fail("unexpected " + shown(word()));
  skip_line();
}

std::string_view TextCursor::word() {
  skip_blanks();
  const char* first = p_;
  while (!at_word_end(p_)) ++p_;
  return {first, static_cast<std::size_t>(p_ - first)};
}

double TextCursor::unusual_real(const char* what) {
  if (find_in_next_line()) return real(what);
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends before ") + what);
  const auto value = number_of(text);
  if (!value)
    fail(std::string("expected a number for ") + what + ", found " + shown_no_number(text));
  if (!std::isfinite(*value)) fail(std::string(what) + " is not a finite number: " + shown(text));
  return *value;
}

std::int64_t TextCursor::unusual_integer(const char* what) {
  if (find_in_next_line()) return integer(what);
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends before ") + what);
  std::int64_t value = 0;
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  if (!plus || error != std::errc{} || next != end)
    fail(std::string("expected a whole number for ") + what + ", found " + shown_no_number(text));
  return value;
}

std::optional<double> number_of(std::string_view word) {
  double value = 0;
  const char* const last = word.data() + word.size();
  if (plain_real(word.data(), last, value) == last && !word.empty()) return value;
  const auto [end, failure] = std::from_chars(word.data(), last, value);
  if (failure == std::errc{} && end == last) return value;
  return unusual_number_of(word);
}

std::string shown_no_number(std::string_view word) {
  std::string with_points(word);
  std::replace(with_points.begin(), with_points.end(), ',', '.');
  if (with_points != word && is_number(with_points))
    return shown(word) + ": write decimal points, not commas";
  const std::string_view first = word.substr(0, word.find_first_of(",;"));
  if (first.size() < word.size() && is_number(first))
    return shown(word) + ": write blanks between numbers";
  return shown(word);
}

}  // namespace aomd::io::detail
