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

/// What a skin is drawn of, which must stay where it is from one update to the next.
struct SkinSource {
  const Mesh& mesh;
  const Skin& skin;   ///< the whole one
  const Box& bounds;  ///< what planes stand in
  HistoryPlace place;
};

/// That of a document that has a skin.
[[nodiscard]] inline SkinSource skin_source(const Document& document) {
  const LoadedMesh& content = document.content();
  return {content.mesh, *content.skin, content.bounds, document.place()};
}

/// Of one mesh.
class SkinKeeper {
 public:
  /// What is not as it was before an update.
  struct Changes {
    bool mesh = false;     ///< the document's
    bool surface = false;  ///< the triangles that are drawn
    bool inside = false;   ///< sections, shrunken regions and interior edges
  };
  /// O(1) where nothing has changed, else O(entities).
  Changes update(const SkinSource& source, const View& view);
  /// Draws what lies inside anew.
  void draw_inside(const SkinSource& source, SurfaceDrawing& drawing);

  /// Null before the first update.
  [[nodiscard]] const SkinSurface* surface() const { return surface_ ? &*surface_ : nullptr; }
  /// Whether it is that of the mesh at this place.
  [[nodiscard]] bool current(const HistoryPlace& place) const {
    return surface_ && place == place_;
  }
  /// Of each triangle of the drawing's cells.
  [[nodiscard]] const std::vector<Region>& cell_regions() const { return cell_regions_; }

 private:
  [[nodiscard]] const Skin& skin(const SkinSource& source) const;
  void cut(const SkinSource& source, const std::optional<glm::dvec4>& plane, bool anew);

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
