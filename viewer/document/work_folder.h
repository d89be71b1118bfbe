#pragma once
// The folder in which programs keep unsaved work. Each has a name there, its process number:
// NAME.json and NAME-N.journal are its work (saved_work.h), NAME.lock is locked while it lives.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viewer/document/saved_work.h"

namespace aomd::scene {

/// A file that is locked while this lives. The lock goes with the process, however it ends.
class FileLock {
 public:
  /// Makes the file where there is none. Null when another holder is alive, or the folder cannot be
  /// written.
  [[nodiscard]] static std::shared_ptr<const FileLock> take(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// What programs that died have left.
struct FoundWork {
  std::vector<std::shared_ptr<const SavedWork>> works;  ///< newest first; locked while it is held
  std::vector<std::string> unreadable;  ///< why others cannot be read, one line each
};

/// Removes what the programs had not finished writing, and nothing else: work that cannot be read,
/// being damaged or of a newer version, stays as it is, as do files that are none of theirs.
[[nodiscard]] FoundWork find_saved_work(const std::filesystem::path& folder);

/// Removes all files of a work.
void discard(const SavedWork& work);

/// XDG_STATE_HOME/aomd, or ~/.local/state/aomd; empty where there is neither.
[[nodiscard]] std::filesystem::path recovery_folder();

}  // namespace aomd::scene
