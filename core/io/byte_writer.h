#pragma once
// Builds the bytes of an output file.

#include <bit>
#include <charconv>
#include <concepts>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace aomd::io::detail {

/// Appends text and raw values to a string. Doubles are written with the fewest digits that read
/// back as the same value.
class ByteWriter {
 public:
  ByteWriter& operator<<(std::string_view text) {
    bytes_ += text;
    return *this;
  }
  ByteWriter& operator<<(char c) {
    bytes_ += c;
    return *this;
  }
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) ByteWriter& operator<<(
      Number value) {
    char digits[32];
    bytes_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return *this;
  }

  /// Appends the value's own bytes, in the byte order asked for.
  template <std::endian Order, class Value>
  void raw(Value value) {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    if constexpr (Order == std::endian::native) {
      bytes_.append(bytes, sizeof(Value));
    } else {
      bytes_.append(std::make_reverse_iterator(bytes + sizeof(Value)),
                    std::make_reverse_iterator(bytes));
    }
  }

  void reserve(std::size_t n) { bytes_.reserve(n); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

 private:
  std::string bytes_;
};

}  // namespace aomd::io::detail
