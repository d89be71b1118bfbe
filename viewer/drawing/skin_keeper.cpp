#include "viewer/drawing/skin_keeper.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "viewer/drawing/skin_patch.h"

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

SkinSource skin_source(Document& document) {
  const LoadedMesh& content = document.content();
  return {content.mesh,
          [&document, &content]() -> const Skin& {
            document.renew_skin();
            return *content.skin;
          },
          content.bounds,
          document.place(),
          content.prepared,
          {}};
}

SkinKeeper::Changes SkinKeeper::update(const SkinSource& source, const View& view,
                                       const VolumeChanges& changes, SurfaceDrawing& drawing) {
  const CellStyle cells = cell_style(view, source.bounds, source.field);
  const SkinStyle style = skin_style(view);
  Changes found;
  found.mesh = !current(source.place);
  const bool other_skin = cells.whole_plane() != plane_ || style != style_ || !surface_;
  const bool patches = found.mesh && source.prepared && !changes.everything;
  const bool anew = found.mesh && !patches;
  found.surface.everything = other_skin || anew;
  found.inside = found.mesh || cells_ != cells;
  if (found.mesh) cutter_.reset();
  if (found.mesh || cells.whole_plane() != plane_) clipped_.reset();
  const bool inside_anew = anew || cells_ != cells;
  plane_ = cells.whole_plane();
  cells_ = cells;
  style_ = style;
  place_ = source.place;
  if (found.surface.everything) make_surface(source, drawing);
  if (patches && !other_skin) patch_surface(source, changes, drawing, found.surface);
  if (inside_anew) inside_.draw(source.mesh, skin(source), *cells_, drawing.drawable());
  if (patches && !inside_anew) inside_.patch(source.mesh, changes, *cells_, drawing.drawable());
  return found;
}

void SkinKeeper::make_surface(const SkinSource& source, SurfaceDrawing& drawing) {
  surface_.emplace(make_skin_surface(source.mesh, skin(source), style_));
  drawing.set_face_flags(surface_->flags);
}

void SkinKeeper::patch_surface(const SkinSource& source, const VolumeChanges& changes,
                               SurfaceDrawing& drawing, SurfaceChanges& found) {
  found = SkinPatch(source.mesh, style_, plane_, *surface_).apply(changes);
  for (const Face f : found.faces)
    if (surface_->mesh.alive(f)) drawing.set_face_flags(f, surface_->flags[f.index]);
}

/// As the plane leaves it. A cutter serves many planes, but one mesh.
const Skin& SkinKeeper::skin(const SkinSource& source) {
  if (!plane_) return source.whole();
  if (clipped_) return *clipped_;
  if (source.prepared && is_of_tetrahedra(source.mesh))
    return clipped_.emplace(Skin::of_tetrahedra(source.mesh, plane_));
  if (!cutter_) cutter_ = std::make_unique<SkinCutter>(source.mesh);
  return clipped_.emplace(cutter_->before(*plane_));
}

}  // namespace aomd::scene
