#pragma once
// The files that the options of a command name.

#include <filesystem>
#include <string>
#include <vector>

namespace aomd::app {

/// A file that an option names; none where the path is empty.
struct NamedFile {
  std::string option;
  std::filesystem::path path;
};

/// What is wrong where a file would be written over another one that an option names; else empty.
[[nodiscard]] std::string clash_of_files(const std::vector<NamedFile>& read,
                                         const std::vector<NamedFile>& written);

}  // namespace aomd::app
