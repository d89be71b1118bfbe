#pragma once
// Whether a file on disk is still the one that was read.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace aomd::scene {

/// What tells one state of a file from another without reading it.
struct FileStamp {
  std::filesystem::file_time_type time;
  std::uintmax_t bytes = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// None where there is no such file.
[[nodiscard]] std::optional<FileStamp> stamp_of(const std::filesystem::path& file);

/// Looks at one file a few times a second and tells once of each change, as soon as two looks in a
/// row have found the same: until then somebody may still be writing.
class FileWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds between_looks{250};

  /// `known` is what the file was when it was read. An empty name ends watching.
  void start(std::filesystem::path file, std::optional<FileStamp> known);
  /// What the file is now is known, where it is this one: the program itself has written it.
  void note_written(const std::filesystem::path& file);
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] bool changed(Clock::time_point now);

 private:
  std::filesystem::path file_;
  std::optional<FileStamp> known_, seen_;
  Clock::time_point next_look_{};
};

}  // namespace aomd::scene
