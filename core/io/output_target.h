#pragma once
// Where an output goes: what its path names in the end, and whether it can be written at all.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace aomd::io::detail {

/// An output as its path names it.
struct OutputTarget {
  enum class Kind {
    File,        ///< a regular file, or nothing yet: it is replaced
    Stream,      ///< a pipe or a device: it takes the bytes as they come
    Descriptor,  ///< one of this process, as /dev/stdout is: the same
  };
  Kind kind = Kind::File;
  std::filesystem::path path;  ///< all symbolic links followed
  std::optional<mode_t> mode;  ///< File: the permissions of the one that is there
  int descriptor = -1;         ///< Descriptor only
};

/// Finds the target of a path. Throws WriteError for a folder, a chain of links without an end, a
/// file that may not be written, and a target whose folder is missing, none, or may not be written.
[[nodiscard]] OutputTarget find_output_target(const std::filesystem::path& path);

/// What tells an output from other files, however its path is spelled: where it lies on the disk if
/// it is there, else its folder and its name, all symbolic links followed. None for a device such
/// as a terminal, and where links lead nowhere: nothing is lost there.
[[nodiscard]] std::optional<std::string> output_identity(const std::filesystem::path& path);
/// What tells an input from outputs, however its path is spelled; none for what no output replaces,
/// such as a pipe, and for what is not there.
[[nodiscard]] std::optional<std::string> input_identity(const std::filesystem::path& path);

/// Writes all bytes to a descriptor; false with errno where that fails.
[[nodiscard]] bool write_all(int descriptor, std::string_view bytes);

/// Throws WriteError with the words of errno.
[[noreturn]] void fail_to_write(const std::filesystem::path& path);

}  // namespace aomd::io::detail
