#include "viewer/document/file_watch.h"

#include <system_error>
#include <utility>

namespace aomd::scene {

std::optional<FileStamp> stamp_of(const std::filesystem::path& file) {
  std::error_code no_time, no_size;
  const FileStamp stamp{std::filesystem::last_write_time(file, no_time),
                        std::filesystem::file_size(file, no_size)};
  if (no_time || no_size) return {};
  return stamp;
}

void FileWatch::start(std::filesystem::path file, std::optional<FileStamp> known) {
  file_ = std::move(file);
  known_ = seen_ = known;
  next_look_ = {};
}

void FileWatch::note_written(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!file_.empty() && std::filesystem::equivalent(file, file_, ignored))
    known_ = seen_ = stamp_of(file_);
}

/// A file that is gone is about to be written anew, or will be missed when it is opened.
bool FileWatch::changed(Clock::time_point now) {
  if (file_.empty() || now < next_look_) return false;
  next_look_ = now + between_looks;
  const std::optional<FileStamp> present = stamp_of(file_);
  const bool still = present == std::exchange(seen_, present);
  if (!still || !present || present == known_) return false;
  known_ = present;
  return true;
}

}  // namespace aomd::scene
