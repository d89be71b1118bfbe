#include "viewer/drawing/skin_keeper.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace aomd::scene {
namespace {

SkinStyle skin_style(const View& view) {
  SkinStyle style;
  const auto is_region = [](ModelRef ref) { return ref.dimension() == 3; };
  std::copy_if(view.hidden.begin(), view.hidden.end(),
               std::inserter(style.hidden_regions, style.hidden_regions.end()), is_region);
  if (view.highlighted && is_region(*view.highlighted)) style.highlighted_region = view.highlighted;
  style.interfaces = view.interfaces;
  style.faces = view.shrink == 0;
  return style;
}

}  // namespace

SkinKeeper::Changes SkinKeeper::update(const Document& document, const View& view) {
  const LoadedMesh& content = document.content();
  const CellStyle cells = cell_style(view, content.bounds);
  Changes changes;
  changes.mesh = !surface_ || document.place() != place_;
  changes.inside = changes.mesh || cells_ != cells;
  cells_ = cells;
  const auto plane = cells.whole_plane();
  const SkinStyle style = skin_style(view);
  changes.surface = changes.mesh || plane != plane_ || style != style_;
  if (!changes.surface) return changes;
  cut(document, plane, changes.mesh);
  style_ = style;
  place_ = document.place();
  surface_.emplace(make_skin_surface(content.mesh, skin(document), style));
  return changes;
}

void SkinKeeper::cut(const Document& document, const std::optional<glm::dvec4>& plane, bool anew) {
  if (anew) cutter_.reset();
  if (anew || plane != plane_) clipped_.reset();
  plane_ = plane;
  if (!plane) return;
  if (!cutter_) cutter_ = std::make_unique<SkinCutter>(document.mesh());
  if (!clipped_) clipped_.emplace(cutter_->before(*plane));
}

const Skin& SkinKeeper::skin(const Document& document) const {
  return clipped_ ? *clipped_ : *document.content().skin;
}

void SkinKeeper::draw_inside(const Document& document, SurfaceDrawing& drawing) {
  const Mesh& mesh = document.mesh();
  const glm::dvec3 origin = document.content().bounds.center();
  CellFaces faces;
  if (cells_->shrink > 0) faces = draw_shrunken(mesh, skin(document), *cells_, origin);
  if (cells_->sections()) faces.append(draw_sections(mesh, *cells_, origin));
  drawing.set_cells(std::move(faces.corners));
  cell_regions_ = std::move(faces.regions);
  drawing.set_interior_edges(cells_->interior_edges
                                 ? draw_interior_edges(mesh, skin(document), *cells_, origin)
                                 : std::vector<Segment>());
}

}  // namespace aomd::scene
