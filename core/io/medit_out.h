#pragma once
// Writes the sections of a Medit file, as text or binary.

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "core/io/byte_writer.h"
#include "core/io/medit.h"

namespace aomd::io::detail {

/// Section after section, each announced by the number of its items and what one of them holds.
/// Binary is little-endian, of version 2, or 3 where positions may need 64 bits.
class MeditOut {
 public:
  /// `most` is a bound on the bytes to come, in binary.
  MeditOut(bool binary, std::uint64_t most) : binary_(binary), wide_(most >> 31 != 0) {
    if (binary_) {
      word(1);
      word(wide_ ? 3 : 2);
      start("Dimension", 4);
      word(3);
    } else {
      out_ << "MeshVersionFormatted 2\nDimension 3\n";
    }
  }

  void begin(std::string_view keyword, std::size_t items, std::size_t integers,
             std::size_t reals = 0) {
    if (!binary_) {
      out_ << keyword << '\n' << items << '\n';
      return;
    }
    start(keyword, 4 + items * (4 * integers + 8 * reals));
    word(static_cast<std::int32_t>(items));
  }

  /// A section of values: of so many types, whose numbers follow, and with so many numbers for each
  /// item.
  void begin_values(std::string_view keyword, std::size_t items, std::size_t types,
                    std::size_t numbers) {
    if (!binary_) {
      out_ << keyword << '\n' << items << '\n' << types;
      line_start_ = false;
      return;
    }
    start(keyword, 8 + 4 * types + items * 8 * numbers);
    word(static_cast<std::int32_t>(items));
    word(static_cast<std::int32_t>(types));
  }

  void integer(std::int64_t value) {
    if (binary_) return word(static_cast<std::int32_t>(value));
    blank();
    out_ << value;
  }
  void real(double value) {
    if (binary_) return out_.raw<std::endian::little>(value);
    blank();
    out_ << value;
  }
  /// After each item.
  void end_line() {
    if (!binary_) out_ << '\n';
    line_start_ = true;
  }

  [[nodiscard]] std::string finish() {
    if (binary_) {
      start("End", 0);
    } else {
      out_ << "End\n";
    }
    return out_.take();
  }
  void reserve(std::size_t bytes) { out_.reserve(bytes); }

 private:
  void word(std::int32_t value) { out_.raw<std::endian::little>(value); }

  /// The number of the keyword, and where the section ends: after so many more bytes. No section
  /// follows the last.
  void start(std::string_view keyword, std::uint64_t bytes) {
    const auto* known = std::find_if(std::begin(medit_codes), std::end(medit_codes),
                                     [&](const MeditCode& c) { return c.keyword == keyword; });
    word(known->code);
    const std::uint64_t end = bytes == 0 ? 0 : out_.size() + (wide_ ? 8 : 4) + bytes;
    wide_ ? out_.raw<std::endian::little>(end) : word(static_cast<std::int32_t>(end));
  }

  void blank() {
    if (!line_start_) out_ << ' ';
    line_start_ = false;
  }

  bool binary_, wide_, line_start_ = true;
  ByteWriter out_;
};

}  // namespace aomd::io::detail
