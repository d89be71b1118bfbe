#pragma once
// Numbered pictures of a turn around the mesh, or of its history.

#include <filesystem>
#include <optional>

#include <glm/vec2.hpp>

#include "viewer/document/document.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// A picture that whoever draws is to write.
struct ScreenshotRequest {
  std::filesystem::path file;
  std::optional<glm::ivec2> size;  ///< in pixels; none: as large as the window
  bool transparent = false;        ///< nothing behind the mesh
  bool interface = true;           ///< with panels, where there are any
  /// How much larger text, lines and dots are; none: as in the window, without panels larger where
  /// the picture has more than 1080 pixels each way.
  std::optional<double> scale = {};
};

/// One after the other, so that whoever draws can show how far it is and be told to stop. Holds
/// what it has to put back: the camera, the place in the history, and whether the last operation is
/// marked.
class PictureSeries {
 public:
  enum class Kind { Turntable, History };

  /// `count` >= 1 pictures named turn-0001.png or history-0001.png in `folder`, which is made. A
  /// history of S operations has at most S + 1 different pictures: no more are made. Throws
  /// io::WriteError.
  PictureSeries(Kind kind, std::filesystem::path folder, int count, std::optional<glm::ivec2> size,
                const Document& document, const View& view);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int made() const { return made_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Brings document and view to the next picture; none when all are made.
  [[nodiscard]] std::optional<ScreenshotRequest> next(Document& document, View& view);
  /// Everything as it was before.
  void put_back(Document& document, View& view) const;

 private:
  Kind kind_;
  std::filesystem::path folder_;
  int count_;
  int made_ = 0;
  std::optional<glm::ivec2> size_;
  Camera camera_;
  std::size_t step_;
  bool operation_;
};

}  // namespace aomd::scene
