#pragma once
// The bytes of one input and the means to say where in them something is wrong.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/io/error.h"

namespace aomd::io::detail {

/// A named input held in memory. Offsets below are 0-based positions in `bytes`, at most its size.
struct Source {
  std::string name;
  std::string_view bytes;
  std::size_t skipped = 0;  ///< bytes of the file before these: a byte order mark

  /// Throws ReadError naming the line that holds `offset`. O(offset): lines are counted only now.
  [[noreturn]] void fail_at_line(std::size_t offset, const std::string& what) const;
  /// Throws ReadError naming the byte `offset`.
  [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& what) const;
  /// Throws ReadError about the whole input.
  [[noreturn]] void fail(const std::string& what) const;
};

/// Text without what stands behind its end: zero bytes, as programs write that fill up to a block,
/// and Ctrl-Z, the end of a file in DOS.
[[nodiscard]] Source without_padding(const Source& text);

/// The bytes of a file, none too. Throws ReadError for what is missing, a folder or unreadable.
[[nodiscard]] std::string read_whole(const std::filesystem::path& path);

/// A whole file in memory. It is read, not mapped: a file that shrinks meanwhile must not kill the
/// program.
class FileBytes {
 public:
  /// Throws ReadError for what is missing, no regular file, unreadable or empty; LimitError when it
  /// does not fit into memory.
  explicit FileBytes(const std::filesystem::path& path);

  [[nodiscard]] std::string_view view() const { return {data_.get(), size_}; }

 private:
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
};

}  // namespace aomd::io::detail
