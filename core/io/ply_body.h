#pragma once
// The values of a PLY file, as text or binary, behind one interface.

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/io/ply_header.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {

/// Values in text, one element a line.
class PlyText {
 public:
  PlyText(const Source& source, const PlyHeader& header)
      : cursor_(source, source.bytes, header.body) {
    cursor_.pass_comment_lines();
  }

  [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what); }
  [[nodiscard]] std::size_t left() const { return cursor_.left(); }
  [[nodiscard]] bool at_end() { return cursor_.skip_to_content(); }
  [[nodiscard]] std::string_view rest() const {
    TextCursor ahead = cursor_;
    ahead.skip_to_content();
    return ahead.rest();
  }
  void end_element() { cursor_.end_line(); }

  double real(NumberType, const char* what) { return cursor_.real(what); }
  std::int64_t integer(NumberType, const char* what) { return cursor_.integer(what); }
  void skip(NumberType type) { (void)any(type); }
  /// Whatever stands there: NaN for what is no number.
  double any(NumberType) {
    if (double value = 0; cursor_.takes_plain_real(value)) return value;
    const std::string_view word = cursor_.word();
    if (word.empty()) cursor_.fail("the line ends before all properties are there");
    return number_of(word).value_or(std::numeric_limits<double>::quiet_NaN());
  }

 private:
  TextCursor cursor_;
};

/// Values in binary of one byte order.
template <std::endian Order>
class PlyBinary {
 public:
  PlyBinary(const Source& source, const PlyHeader& header)
      : source_(source), at_(header.body), value_at_(at_) {}

  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(value_at_, what); }
  [[nodiscard]] std::size_t left() const { return source_.bytes.size() - at_; }
  [[nodiscard]] bool at_end() const { return left() == 0; }
  [[nodiscard]] std::string_view rest() const { return source_.bytes.substr(at_); }
  void end_element() {}

  double real(NumberType type, const char* what) {
    const double value = number(type);
    if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number");
    return value;
  }
  std::int64_t integer(NumberType type, const char* what) {
    switch (type) {
      case NumberType::Int32:
        return take<std::int32_t>();
      case NumberType::UInt32:
        return take<std::uint32_t>();
      case NumberType::UInt8:
        return take<std::uint8_t>();
      default:
        break;
    }
    const double value = number(type);
    if (!(std::abs(value) < 9e15) || value != std::floor(value))
      fail(std::string(what) + " is not a whole number");
    return static_cast<std::int64_t>(value);
  }
  void skip(NumberType type) { take_bytes(size_of(type)); }
  double any(NumberType type) { return number(type); }

 private:
  double number(NumberType type) {
    switch (type) {
      case NumberType::Int8:
        return take<std::int8_t>();
      case NumberType::UInt8:
        return take<std::uint8_t>();
      case NumberType::Int16:
        return take<std::int16_t>();
      case NumberType::UInt16:
        return take<std::uint16_t>();
      case NumberType::Int32:
        return take<std::int32_t>();
      case NumberType::UInt32:
        return take<std::uint32_t>();
      case NumberType::Float32:
        return take<float>();
      case NumberType::Float64:
        return take<double>();
      case NumberType::Int64:
      case NumberType::UInt64:
        break;  // PLY has none
    }
    return 0;
  }

  template <class Value>
  Value take() {
    const char* from = take_bytes(sizeof(Value));
    char bytes[sizeof(Value)];
    for (std::size_t i = 0; i < sizeof(Value); ++i) {
      bytes[i] = from[Order == std::endian::native ? i : sizeof(Value) - 1 - i];
    }
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }

  const char* take_bytes(std::size_t n) {
    value_at_ = at_;
    if (left() < n) source_.fail_at_byte(source_.bytes.size(), "the file ends within its data");
    at_ += n;
    return source_.bytes.data() + value_at_;
  }

  const Source& source_;
  std::size_t at_;
  std::size_t value_at_;  ///< where the value read last begins
};

}  // namespace aomd::io::detail
