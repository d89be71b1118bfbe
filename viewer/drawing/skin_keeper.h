#pragma once
// What is drawn of a mesh with regions or quads: its skin as it is cut now, and what lies inside.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/document/volume_changes.h"
#include "viewer/drawing/cell_drawing.h"
#include "viewer/drawing/inside_keeper.h"
#include "viewer/drawing/skin_surface.h"
#include "viewer/drawing/surface_drawing.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// What a skin is drawn of.
struct SkinSource {
  const Mesh& mesh;
  std::function<const Skin&()> whole;  ///< the whole one, as the mesh is now
  const Box& bounds;                   ///< what planes stand in
  HistoryPlace place;
  bool prepared = false;  ///< a prepared volume (prepare_volume), which stores what patches need
  std::shared_ptr<const ScalarField> field = {};  ///< what colours the inside; null: nothing does
};

/// That of a document that has a skin, and outlives it.
[[nodiscard]] SkinSource skin_source(Document& document);

/// Of one mesh.
class SkinKeeper {
 public:
  /// What is not as it was before an update.
  struct Changes {
    bool mesh = false;       ///< the document's
    bool inside = false;     ///< sections, shrunken regions and interior edges
    SurfaceChanges surface;  ///< the triangles that are drawn
  };
  /// `changes` are those of the mesh since the last update. O(1) where nothing has changed,
  /// O(changes) where a prepared volume has, else O(entities).
  Changes update(const SkinSource& source, const View& view, const VolumeChanges& changes,
                 SurfaceDrawing& drawing);

  /// Null before the first update.
  [[nodiscard]] const SkinSurface* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Whether it is that of the mesh at this place.
  [[nodiscard]] bool current(const HistoryPlace& place) const {
    return surface_ && place == place_;
  }
  /// Of each triangle of the drawing's cells.
  [[nodiscard]] const std::vector<Region>& cell_regions() const { return inside_.cell_regions(); }

 private:
  void make_surface(const SkinSource& source, SurfaceDrawing& drawing);
  void patch_surface(const SkinSource& source, const VolumeChanges& changes,
                     SurfaceDrawing& drawing, SurfaceChanges& found);
  [[nodiscard]] const Skin& skin(const SkinSource& source);

  std::unique_ptr<SkinCutter> cutter_;  ///< once a plane was there
  std::optional<Skin> clipped_;  ///< of the regions before the plane, where it takes whole ones
  std::optional<glm::dvec4> plane_;
  std::optional<CellStyle> cells_;  ///< what is drawn of the inside
  InsideKeeper inside_;
  std::optional<SkinSurface> surface_;
  SkinStyle style_;
  HistoryPlace place_;
};

}  // namespace aomd::scene
