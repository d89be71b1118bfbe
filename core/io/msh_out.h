#pragma once
// Writes the numbers of an MSH file, as text or binary.

#include <string>
#include <string_view>

#include "core/io/byte_writer.h"

namespace aomd::io::detail {

/// Numbers of one section after the other; in text, blanks and line ends between them.
class MshOut {
 public:
  explicit MshOut(bool binary) : binary_(binary) {}

  void begin(std::string_view section) { out_ << '$' << section << '\n'; }
  void end(std::string_view section) {
    if (binary_) out_ << '\n';
    out_ << "$End" << section << '\n';
  }

  void integer(std::int64_t value) { number(static_cast<std::int32_t>(value)); }
  void count(std::uint64_t value) { number(value); }
  void real(double value) { number(value); }
  void end_line() {
    if (!binary_) out_ << '\n';
    line_start_ = true;
  }

  /// For what is text in binary files too.
  [[nodiscard]] ByteWriter& text() { return out_; }
  [[nodiscard]] bool binary() const { return binary_; }

 private:
  template <class Number>
  void number(Number value) {
    if (binary_) {
      out_.raw<std::endian::native>(value);
      return;
    }
    if (!line_start_) out_ << ' ';
    out_ << value;
    line_start_ = false;
  }

  bool binary_, line_start_ = true;
  ByteWriter out_;
};

}  // namespace aomd::io::detail
