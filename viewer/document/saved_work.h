#pragma once
// Unsaved work of a session: NAME.json says where the mesh came from, how far the history is
// applied and what was set; NAME-N.journal beside it is that history.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/decimate/options.h"
#include "viewer/document/history_tree.h"
#include "viewer/document/load_request.h"

namespace aomd::scene {

class FileLock;

/// All that brings work back, but for the operations themselves.
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

/// NAME.json as text. File names and other texts that are no UTF-8 come back byte by byte.
[[nodiscard]] std::string saved_work_text(const SavedWork& work);
/// Throws io::ReadError for what is no such file, is of a newer version, or holds a value that no
/// command would have taken.
[[nodiscard]] SavedWork read_saved_work(const std::filesystem::path& file);

}  // namespace aomd::scene
