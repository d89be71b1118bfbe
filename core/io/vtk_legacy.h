#pragma once
// Words and numbers of legacy VTK files, where text and binary alternate.

#include <string>
#include <string_view>
#include <vector>

#include "core/io/vtk_numbers.h"

namespace aomd::io::detail {

/// The name that a file encodes: "%20" stands for a space.
[[nodiscard]] std::string decoded(std::string_view name);

/// A position in a legacy file. What is wrong is a ReadError with the line, or the byte in binary
/// files.
class LegacyInput {
 public:
  explicit LegacyInput(const Source& source) : source_(source), cursor_(source, source.bytes) {}

 protected:
  [[noreturn]] void fail(const std::string& what) const { fail_at(cursor_.offset(), what); }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const;
  /// At the k-th of the values, of `size` bytes in binary, that begin at `start`.
  [[noreturn]] void fail_at_value(std::size_t start, std::size_t k, std::size_t size,
                                  const std::string& what) const;

  /// What follows is text to the end of the file.
  void read_as_text();
  /// The next word, on this line or a later one.
  std::string_view word(const char* what);
  /// The next word as a number of things.
  std::uint64_t count(const char* what);
  /// Expects a word, in any case.
  void keyword(const char* expected);
  NumberType number_type(const char* what);

  /// Where the values begin that follow.
  [[nodiscard]] std::size_t data_start() const;
  /// Refuses a number of values that the rest of the file is too short for.
  void check_room(std::uint64_t n) const;
  /// The bytes of n values of `size` bytes that follow this line.
  std::string_view take(std::uint64_t n, std::size_t size);
  /// The next n values, as text or binary.
  void values(NumberType type, std::uint64_t n, std::vector<double>& out);
  void values(NumberType type, std::uint64_t n, std::vector<std::int64_t>& out);

  const Source& source_;
  TextCursor cursor_;
  bool binary_ = false;
};

}  // namespace aomd::io::detail
