#pragma once
// Keeps unsaved work on disk while it is being done, so that a program that dies loses a few
// seconds of it.

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "viewer/document/document.h"
#include "viewer/document/work_folder.h"

namespace aomd::scene {

/// Of one process. Writes in the background, a whole journal each time: after each command, and
/// during a run every few seconds; never for more than a twentieth of the time. Files appear whole
/// or not at all. Where the folder cannot be written nothing is kept, which is said once.
///
/// Kept are surfaces of triangles that came from a file or a sample: what can be decimated.
class RecoveryKeeper {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RecoveryKeeper(std::filesystem::path folder);
  /// Waits for what is being written. The files stay, for the next start to find: only finish()
  /// removes them.
  ~RecoveryKeeper();
  RecoveryKeeper(const RecoveryKeeper&) = delete;
  RecoveryKeeper& operator=(const RecoveryKeeper&) = delete;

  /// Has the present state written where it is due, or the files removed where nothing is unsaved
  /// any more. To be called after commands and, while something goes on, every now and then: cheap
  /// where nothing has changed, a copy of the journal where it has.
  void update(const Document& document);
  /// Another document begins.
  void begin() { place_.reset(); }
  /// Writes whatever the pauses since the last time say, and waits until it is done.
  void write_now(const Document& document);
  /// The work has been restored here: its files go once this process has written its own.
  void take_over(std::shared_ptr<const SavedWork> work) { taken_over_ = std::move(work); }
  /// Why work is not kept, once: a sentence.
  [[nodiscard]] std::optional<std::string> take_problem() {
    return std::exchange(problem_, std::nullopt);
  }
  /// A clean end: nothing is left.
  void finish();

 private:
  [[nodiscard]] bool due(const Document& document, const HistoryPlace& now) const;
  [[nodiscard]] bool lock();
  void start_writing(const Document& document);
  void take_written();
  void report(const std::string& problem);
  void remove_files();

  std::filesystem::path folder_;
  std::filesystem::path file_;  ///< NAME.json; empty until something is written
  std::shared_ptr<const FileLock> lock_;
  std::shared_ptr<const SavedWork> taken_over_;
  std::filesystem::path journal_;  ///< of the last complete writing; empty: nothing is on disk
  unsigned number_ = 0;
  std::optional<HistoryPlace> place_;  ///< of the last writing begun; none: of another document
  std::uint64_t bookmarks_ = 0;        ///< HistoryTree::version() then
  Clock::time_point not_before_{};
  struct Written {
    std::filesystem::path journal;  ///< empty: it failed
    Clock::duration time{};
    std::string problem;  ///< why it failed
  };
  std::future<Written> writing_;
  std::optional<std::string> problem_;
  bool reported_ = false;
};

}  // namespace aomd::scene
