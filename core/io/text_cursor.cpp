#include "core/io/text_cursor.h"
#include "core/base/text.h"

#include <cstdlib>

namespace aomd::io::detail {

bool TextCursor::skip_to_content() {
  while (p_ != end_) {
    if (is_blank(*p_) || is_line_end(*p_)) {
      ++p_;
    } else if (*p_ == comment_) {
      skip_line();
    } else {
      return false;
    }
  }
  return true;
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
  const std::string text(word());
  if (text.empty()) fail(std::string("the line ends before ") + what);
  if (!is_number(text))
    fail(std::string("expected a number for ") + what + ", found " + shown(text));
  // What is left: a leading plus sign, "inf" and "nan", and numbers beyond the range of a double.
  // Those too small for it become zero or subnormal.
  const double value = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number: " + shown(text));
  return value;
}

std::int64_t TextCursor::unusual_integer(const char* what) {
  if (find_in_next_line()) return integer(what);
  const std::string_view text = word();
  if (text.empty()) fail(std::string("the line ends before ") + what);
  fail(std::string("expected a whole number for ") + what + ", found " + shown(text));
}

bool is_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [next, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && next == word.data() + word.size();
}

}  // namespace aomd::io::detail
