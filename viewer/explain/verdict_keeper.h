#pragma once
// Keeps what decimation says about every edge, judging no more than has changed.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/document/volume_changes.h"
#include "viewer/drawing/skin_surface.h"
#include "viewer/drawing/surface_drawing.h"
#include "viewer/drawing/view.h"
#include "viewer/explain/edge_verdicts.h"

namespace aomd::scene {

/// Of one document, while the colours show it.
class VerdictKeeper {
 public:
  /// Notes which edges are to be judged. `busy`: the mesh is on its way, which judging would be in
  /// the way of.
  void note(const Document& document, const View& view, const SurfaceChanges& changes, bool busy);
  /// The same for a volume.
  void note_volume(const Document& document, const View& view, const VolumeChanges& changes,
                   bool busy);
  /// The same for a surface, whose drawing shows them.
  void update(const Document& document, const View& view, const SurfaceChanges& changes, bool busy,
              SurfaceDrawing& drawing);
  /// Goes on judging for about `budget`, without one to the end.
  void judge(Document& document, std::optional<std::chrono::microseconds> budget, bool busy,
             SurfaceDrawing& drawing);
  /// The same where the skin of the mesh is drawn, which may be another one than before (`anew`).
  void judge_skin(Document& document, const SkinSurface& skin,
                  std::optional<std::chrono::microseconds> budget, bool busy,
                  SurfaceDrawing& drawing, bool anew);
  /// Null while the colours show something else.
  [[nodiscard]] const EdgeVerdicts* verdicts() const { return verdicts_ ? &*verdicts_ : nullptr; }
  [[nodiscard]] bool pending() const { return verdicts_ && verdicts_->pending(); }

 private:
  [[nodiscard]] std::vector<Edge> judge_on(Document& document,
                                           std::optional<std::chrono::microseconds> budget,
                                           bool busy);

  std::optional<EdgeVerdicts> verdicts_;
  std::shared_ptr<const EdgeCodes> skin_codes_;  ///< by edges of the skin
  std::uint64_t options_ = 0;  ///< revision of the options that they were judged with
  bool was_busy_ = false;
};

/// The edges that would be refused now, and why. The document must have a mesh that can be
/// decimated. O(edges).
[[nodiscard]] std::vector<EntityRef> find_edges_refused_for(Document& document, Reason reason);

}  // namespace aomd::scene
