#pragma once
// The files opened last and the folder they came from, kept between sessions.

#include <filesystem>
#include <vector>

namespace aomd::ui {

class RecentFiles {
 public:
  static constexpr std::size_t most = 10;

  /// Remembers for this session only: nothing is read or written.
  RecentFiles() = default;
  /// Kept in `file`, one path a line; a file that cannot be read counts as empty.
  explicit RecentFiles(std::filesystem::path file);

  /// Puts a file first. Written at once; failing to write is not worth a message.
  void add(const std::filesystem::path& path);
  [[nodiscard]] const std::vector<std::filesystem::path>& paths() const { return paths_; }

 private:
  std::filesystem::path file_;
  std::vector<std::filesystem::path> paths_;
};

/// XDG_CONFIG_HOME/aomd-studio/recent-files, or below ~/.config; empty where there is neither.
[[nodiscard]] std::filesystem::path recent_files_path();

}  // namespace aomd::ui
