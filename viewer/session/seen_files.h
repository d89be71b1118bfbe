#pragma once
// From where files were looked at.

#include <deque>
#include <filesystem>
#include <optional>

#include "viewer/base/box.h"
#include "viewer/drawing/camera.h"

namespace aomd::scene {

/// The cameras of the files that were shown last, for when one of them is opened again.
class SeenFiles {
 public:
  static constexpr std::size_t most = 16;

  void remember(const std::filesystem::path& file, const Box& bounds, const Camera& camera);
  /// None where the file was not shown, or is now another thing: elsewhere, or of another size.
  [[nodiscard]] std::optional<Camera> camera(const std::filesystem::path& file,
                                             const Box& bounds) const;

 private:
  struct Seen {
    std::filesystem::path file;
    Box bounds;
    Camera camera;
  };
  std::deque<Seen> seen_;  ///< newest first
};

}  // namespace aomd::scene
