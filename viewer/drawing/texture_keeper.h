#pragma once
// Keeps the pictures on a surface where they belong while it changes.

#include <chrono>
#include <memory>

#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/surface_texture.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// Of one surface. Where the places of a changed mesh in its pictures are is worked out when
/// nothing runs (O(size log size)), in a window for a fifth of the time at most; until then changed
/// faces have one colour.
class TextureKeeper {
 public:
  /// Brings the present mesh up to date, or lets go of it all where colours are others. `changes`
  /// are those of the mesh since the last call; `in_window`: somebody waits for the next picture.
  void update(Document& document, const View& view, const SurfaceChanges& changes, bool still,
              bool in_window);
  /// The same of the mesh as loaded, or of a kept state. `changed`: it is another one than before.
  void update_reference(Document& document, const KeptRun* run, const View& view, bool changed);
  /// Null where none is shown.
  [[nodiscard]] const std::shared_ptr<const SurfaceTexture>& texture() const { return shown_; }
  /// Faces wait for their places.
  [[nodiscard]] bool pending() const { return pending_; }

 private:
  [[nodiscard]] bool start(const Document& document, const View& view);
  void paint(const MeshData& data, const Mesh& mesh);

  std::shared_ptr<SurfaceTexture> texture_;
  std::shared_ptr<const SurfaceTexture> shown_;  ///< the same
  bool pending_ = false;
  std::chrono::steady_clock::time_point due_{};  ///< not before then in a window
};

}  // namespace aomd::scene
