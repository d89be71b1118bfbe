#pragma once
// The numbers of an MSH file, as text or binary, behind one interface. The names of the sections,
// and some of what they hold, are text in both.

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/io/text_cursor.h"

namespace aomd::io::detail {

/// Numbers in text. Lines mean nothing, as in Gmsh.
class MshText {
 public:
  /// What a number takes at least.
  static constexpr std::size_t int_size = 2, long_size = 2, real_size = 2;

  MshText(const Source& source, const TextCursor& at) : source_(source), cursor_(at) {
    cursor_.pass_comment_lines();
  }

  [[nodiscard]] TextCursor text() const { return cursor_; }
  void move_to(const TextCursor& at) { cursor_ = at; }
  [[nodiscard]] std::size_t left() const {
    return cursor_.left() + 1;
  }  // the last may end without a blank
  [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const {
    source_.fail_at_line(offset, what);
  }

  std::int32_t integer(const char* what) {
    const std::int64_t value = wide(what);
    if (value < std::numeric_limits<std::int32_t>::min() ||
        value > std::numeric_limits<std::int32_t>::max())
      fail(std::string(what) + " is out of range: " + std::to_string(value));
    return static_cast<std::int32_t>(value);
  }
  /// A number that is not negative.
  std::uint64_t count(const char* what) {
    const std::int64_t value = wide(what);
    if (value < 0) fail(std::string(what) + " is negative");
    return static_cast<std::uint64_t>(value);
  }
  double real(const char* what) {
    find_word();
    return cursor_.real(what);
  }
  /// A value of a view: it need not be finite.
  double value(const char* what) {
    find_word();
    TextCursor ahead = cursor_;
    const std::string_view word = ahead.word();
    double value = 0;
    const auto [next, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || next != word.data() + word.size() || word.empty())
      return cursor_.real(what);
    cursor_ = ahead;
    return value;
  }

 private:
  std::int64_t wide(const char* what) {
    find_word();
    return cursor_.integer(what);
  }
  void find_word() {
    if (cursor_.skip_to_content()) cursor_.fail("the file ends within a section");
  }

  const Source& source_;
  TextCursor cursor_;
};

/// Numbers in binary of one byte order.
template <std::endian Order>
class MshBinary {
 public:
  static constexpr std::size_t int_size = 4, long_size = 8, real_size = 8;

  MshBinary(const Source& source, const TextCursor& at) : source_(source) { move_to(at); }

  [[nodiscard]] TextCursor text() const { return {source_, source_.bytes, at_}; }
  void move_to(const TextCursor& at) { value_at_ = at_ = at.offset(); }
  [[nodiscard]] std::size_t left() const { return source_.bytes.size() - at_; }
  /// Names the byte where the number read last begins.
  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(value_at_, what); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const {
    source_.fail_at_byte(offset, what);
  }

  std::int32_t integer(const char*) { return take<std::int32_t>(); }
  std::uint64_t count(const char* what) {
    const auto value = take<std::uint64_t>();
    if (value >> 63 != 0) fail(std::string(what) + " is out of range");
    return value;
  }
  double real(const char* what) {
    const auto number = take<double>();
    if (!std::isfinite(number)) fail(std::string(what) + " is not a finite number");
    return number;
  }
  double value(const char*) { return take<double>(); }

 private:
  template <class Value>
  Value take() {
    value_at_ = at_;
    if (left() < sizeof(Value))
      source_.fail_at_byte(source_.bytes.size(), "the file ends within a section");
    const char* from = source_.bytes.data() + at_;
    at_ += sizeof(Value);
    char bytes[sizeof(Value)];
    for (std::size_t i = 0; i < sizeof(Value); ++i)
      bytes[i] = from[Order == std::endian::native ? i : sizeof(Value) - 1 - i];
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }

  const Source& source_;
  std::size_t at_ = 0, value_at_ = 0;
};

}  // namespace aomd::io::detail
