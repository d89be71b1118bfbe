#pragma once
// Failures of the outside world: one line each, `FILE:LINE: what is wrong` or `FILE: byte N: what
// is wrong`. Names and words of files stand in it with their control characters escaped.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/base/text.h"

#pragma GCC visibility push(default)

namespace aomd::io {

/// Where in a file something is wrong.
struct Place {
  std::optional<std::uint64_t> line{};  ///< 1-based, for text
  std::optional<std::uint64_t> byte{};  ///< 0-based offset, for binary files
};

/// Base of the failures below; what() is the whole line, without the program's name.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& file, Place place, const std::string& what)
      : std::runtime_error(printable(format(file, place, what))) {}

 private:
  static std::string format(const std::string& file, Place place, const std::string& what) {
    if (place.line) return file + ":" + std::to_string(*place.line) + ": " + what;
    if (place.byte) return file + ": byte " + std::to_string(*place.byte) + ": " + what;
    return file + ": " + what;
  }
};

/// The input is missing, unreadable or invalid: exit code 3.
class ReadError : public FileError {
 public:
  using FileError::FileError;
};

/// The output could not be written; what stood there before is untouched: exit code 4.
class WriteError : public FileError {
 public:
  using FileError::FileError;
};

/// The input is sound but larger than this program or machine can hold: exit code 5.
class LimitError : public FileError {
 public:
  using FileError::FileError;
};

}  // namespace aomd::io

#pragma GCC visibility pop
