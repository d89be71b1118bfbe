#pragma once
// Walks through text word by word and line by line, and knows where it is when something is wrong.

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/plain_number.h"
#include "core/io/source.h"

namespace aomd::io::detail {

/// A position in text. Blanks are spaces and tabs; lines end with "\n", "\r\n" or "\r"; a comment
/// runs from its sign to the end of the line. Errors are ReadErrors with the line of the position.
class TextCursor {
 public:
  /// `text` is what is read: the bytes of `source`, or an edited copy with every byte at its old
  /// offset.
  TextCursor(const Source& source, std::string_view text, std::size_t offset = 0,
             char comment_sign = '\n')
      : source_(&source),
        start_(text.data()),
        p_(start_ + offset),
        end_(start_ + text.size()),
        comment_(comment_sign) {}

  void move_to(std::size_t offset) { p_ = start_ + offset; }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(p_ - start_); }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - p_); }
  [[nodiscard]] std::string_view rest() const { return {p_, left()}; }
  [[noreturn]] void fail(const std::string& what) const { source_->fail_at_line(offset(), what); }

  /// From now on skip_to_content() also moves over lines that begin with "#", where the format has
  /// no comments of its own.
  void pass_comment_lines() { passes_comment_lines_ = true; }
  /// Moves over blanks, line ends and comments; true when nothing else is left.
  bool skip_to_content();
  /// Moves over blanks; true when the line holds nothing more.
  bool line_done() {
    skip_blanks();
    return p_ == end_ || is_line_end(*p_) || *p_ == comment_;
  }
  /// Moves to the start of the next line, whatever stands before it.
  void skip_line();
  /// The rest of the line without blanks at its ends; moves to the start of the next line.
  std::string_view rest_of_line();
  /// Moves to the next line; an error names the word that still stands on this one.
  void end_line();

  /// The next word on this line; empty when there is none.
  std::string_view word();
  /// From now on real() and integer() go on in the next line where this one holds nothing more.
  void join_lines() { joins_lines_ = true; }
  /// The next word on this line as a finite number; `what` names it in errors.
  double real(const char* what);
  /// Whether the next word on this line is a number as plain_real() reads; takes it then.
  bool takes_plain_real(double& value) {
    skip_blanks();
    const char* const end = plain_real(p_, end_, value);
    if (!end || !at_word_end(end)) return false;
    p_ = end;
    return true;
  }
  /// The next word on this line as a whole number, without a decimal point.
  std::int64_t integer(const char* what);

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  [[nodiscard]] bool at_word_end(const char* p) const {
    return p == end_ || is_blank(*p) || is_line_end(*p) || *p == comment_;
  }
  void skip_blanks() {
    while (p_ != end_ && is_blank(*p_)) ++p_;
  }
  double unusual_real(const char* what);
  std::int64_t unusual_integer(const char* what);
  bool find_in_next_line() { return joins_lines_ && line_done() && !skip_to_content(); }
  [[nodiscard]] bool at_comment_line() const;

  const Source* source_;
  const char* start_;
  const char* p_;
  const char* end_;
  char comment_;  ///< '\n' where the format has no comments
  bool joins_lines_ = false, passes_comment_lines_ = false;
};

inline double TextCursor::real(const char* what) {
  double value = 0;
  if (takes_plain_real(value)) return value;
  const auto [next, error] = std::from_chars(p_, end_, value);
  if (error != std::errc{} || !at_word_end(next) || !std::isfinite(value))
    return unusual_real(what);
  p_ = next;
  return value;
}

inline std::int64_t TextCursor::integer(const char* what) {
  skip_blanks();
  std::int64_t value = 0;
  if (const char* end = plain_integer(p_, end_, value); end && at_word_end(end)) {
    p_ = end;
    return value;
  }
  const auto [next, error] = std::from_chars(p_, end_, value);
  if (error != std::errc{} || !at_word_end(next)) return unusual_integer(what);
  p_ = next;
  return value;
}

/// What all of `word` is as a number, finite or not. Beside the usual there is the exponent of
/// Fortran ("1.5d0"), and what Windows calls "1.#INF" and "-1.#IND".
[[nodiscard]] std::optional<double> number_of(std::string_view word);
[[nodiscard]] inline bool is_number(std::string_view word) { return number_of(word).has_value(); }

/// What an error says of a word that is no number: shown, and what would help where it is known.
[[nodiscard]] std::string shown_no_number(std::string_view word);

}  // namespace aomd::io::detail
