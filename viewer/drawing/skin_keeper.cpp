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

SkinKeeper::Changes SkinKeeper::update(const SkinSource& source, const View& view) {
  const CellStyle cells = cell_style(view, source.bounds);
  Changes changes;
  changes.mesh = !current(source.place);
  changes.inside = changes.mesh || cells_ != cells;
  cells_ = cells;
  const auto plane = cells.whole_plane();
  const SkinStyle style = skin_style(view);
  changes.surface = changes.mesh || plane != plane_ || style != style_;
  if (!changes.surface) return changes;
  cut(source, plane, changes.mesh);
  style_ = style;
  place_ = source.place;
  surface_.emplace(make_skin_surface(source.mesh, skin(source), style));
  return changes;
}

void SkinKeeper::cut(const SkinSource& source, const std::optional<glm::dvec4>& plane, bool anew) {
  if (anew) cutter_.reset();
  if (anew || plane != plane_) clipped_.reset();
  plane_ = plane;
  if (!plane) return;
  if (!cutter_) cutter_ = std::make_unique<SkinCutter>(source.mesh);
  if (!clipped_) clipped_.emplace(cutter_->before(*plane));
}

const Skin& SkinKeeper::skin(const SkinSource& source) const {
  return clipped_ ? *clipped_ : source.skin;
}

void SkinKeeper::draw_inside(const SkinSource& source, SurfaceDrawing& drawing) {
  const Mesh& mesh = source.mesh;
  const glm::dvec3 origin = source.bounds.center();
  CellFaces faces;
  if (cells_->shrink > 0) faces = draw_shrunken(mesh, skin(source), *cells_, origin);
  if (cells_->sections()) faces.append(draw_sections(mesh, *cells_, origin));
  drawing.set_cells(std::move(faces.corners));
  cell_regions_ = std::move(faces.regions);
  drawing.set_interior_edges(cells_->interior_edges
                                 ? draw_interior_edges(mesh, skin(source), *cells_, origin)
                                 : std::vector<Segment>());
}

}  // namespace aomd::scene
