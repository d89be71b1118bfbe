#pragma once
// What is drawn of a mesh with regions or quads: its skin as it is cut now, and what lies inside.

#include <memory>
#include <optional>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/drawing/cell_drawing.h"
#include "viewer/drawing/skin_surface.h"
#include "viewer/drawing/surface_drawing.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// Of one document that has a skin.
class SkinKeeper {
 public:
  /// What is not as it was before an update.
  struct Changes {
    bool mesh = false;     ///< the document's
    bool surface = false;  ///< the triangles that are drawn
    bool inside = false;   ///< sections, shrunken regions and interior edges
  };
  /// O(1) where nothing has changed, else O(entities).
  Changes update(const Document& document, const View& view);
  /// Draws what lies inside anew.
  void draw_inside(const Document& document, SurfaceDrawing& drawing);

  /// Null before the first update.
  [[nodiscard]] const SkinSurface* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Of each triangle of the drawing's cells.
  [[nodiscard]] const std::vector<Region>& cell_regions() const { return cell_regions_; }

 private:
  [[nodiscard]] const Skin& skin(const Document& document) const;
  void cut(const Document& document, const std::optional<glm::dvec4>& plane, bool anew);

  std::unique_ptr<SkinCutter> cutter_;  ///< once a plane was there
  std::optional<Skin> clipped_;  ///< of the regions before the plane, where it takes whole ones
  std::optional<glm::dvec4> plane_;
  std::optional<CellStyle> cells_;  ///< what is drawn of the inside
  std::vector<Region> cell_regions_;
  std::optional<SkinSurface> surface_;
  SkinStyle style_;
  HistoryPlace place_;
};

}  // namespace aomd::scene
