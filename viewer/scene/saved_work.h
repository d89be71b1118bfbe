#pragma once
// What a recovery folder keeps of a session: NAME.json says where the mesh came from, how far the
// history is applied and what was set; NAME-N.journal beside it is that history. NAME is the
// process, NAME.lock is locked while it lives.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/decimate/options.h"
#include "viewer/scene/document.h"
#include "viewer/scene/loaded_mesh.h"

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

/// Unsaved work: all that brings it back, but for the operations themselves.
struct SavedWork {
  LoadRequest source;  ///< what it starts from, with the classification then
  std::size_t cursor = 0;
  std::size_t steps = 0;  ///< in the journal
  std::vector<HistoryMark> marks;
  std::vector<std::pair<std::string, std::size_t>>
      bookmarks;              ///< names and places; without branches
  DecimationOptions options;  ///< without spacing, keep and model
  std::string spacing;        ///< source of the spacing; empty: none
  ClassifyOptions classify;   ///< of the next classification
  bool snaps = false;
  std::filesystem::path model;  ///< the CAD file that the mesh lies on; empty: none
  std::int64_t seconds = 0;     ///< when it was written, since 1970
  std::filesystem::path file;   ///< NAME.json
  std::filesystem::path journal;
  std::shared_ptr<const FileLock> lock;  ///< held by whoever may restore or discard it

  /// "bunny.ply", or a sample's name.
  [[nodiscard]] std::string name() const;
};

/// What of a document is to be kept now. The mesh must have come from a file or a sample.
[[nodiscard]] SavedWork work_of(const Document& document);

/// NAME.json as text.
[[nodiscard]] std::string saved_work_text(const SavedWork& work);
/// Throws io::ReadError for what is no such file.
[[nodiscard]] SavedWork read_saved_work(const std::filesystem::path& file);

/// Puts the history, nothing of it applied, into a mesh that has just been loaded from the work's
/// source. Throws io::ReadError when the mesh is not the one that the history starts from.
void restore_history(LoadedMesh& loaded, const SavedWork& work);

/// The work that dead processes have left in a folder, newest first; each locked while it is held.
/// Files that cannot be read are passed over.
[[nodiscard]] std::vector<std::shared_ptr<const SavedWork>> find_saved_work(
    const std::filesystem::path& folder);

/// Removes all its files.
void discard(const SavedWork& work);

/// XDG_STATE_HOME/aomd, or ~/.local/state/aomd; empty where there is neither.
[[nodiscard]] std::filesystem::path recovery_folder();

}  // namespace aomd::scene
