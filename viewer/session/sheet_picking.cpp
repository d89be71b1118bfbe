// What a sheet selects and points at.

#include <glm/geometric.hpp>

#include "viewer/drawing/selection_drawing.h"
#include "viewer/drawing/use_arrows.h"
#include "viewer/explain/measures.h"
#include "viewer/session/sheet.h"

namespace aomd::scene {

Shown Sheet::shown() const {
  const Drawable& drawable = drawing_.drawable();
  if (const SkinSurface* skin = skin_.surface())
    return {skin->mesh,
            document.mesh(),
            skin,
            document.content().bounds,
            drawable.cells.values(),
            skin_.cell_regions(),
            drawable.origin};
  return {document.mesh(), document.mesh(), nullptr, document.content().bounds};
}

/// Not while the mesh is on its way and its skin is not the one that is drawn.
bool Sheet::can_pick() {
  if (skin_.surface() == nullptr) return true;
  const bool inner_edges = view_.clip && view_.clip->cells && !busy();
  if (inner_edges && !document.content().prepared) {
    document.prepare();
    refresh_skin();
  }
  return skin_.current(document.place());
}

EntityRef Sheet::pick(glm::dvec2 ndc) {
  if (!can_pick()) return {};
  return picker_.at(shown(), view_, ndc);
}

std::vector<EntityRef> Sheet::pick(glm::dvec2 low, glm::dvec2 high) {
  if (!can_pick()) return {};
  return picker_.within(shown(), view_, low, high);
}

void Sheet::hover(std::optional<glm::dvec2> ndc) {
  inquiry_.point_at_nothing();
  if (!ndc) return;
  const EntityRef e = pick(*ndc);
  if (e.valid()) inquiry_.hover(document, {e, *ndc}, busy());
}

std::optional<glm::dvec4> Sheet::preview_cut() const {
  const EntityVerdict* verdict = inquiry_.verdict();
  const SkinSurface* skin = skin_.surface();
  const bool previews = verdict != nullptr && !verdict->ways.empty() && view_.preview &&
                        !view_.neighbours && !view_.clip && !view_.interior_edges;
  if (!previews || skin == nullptr || !skin_.current(document.place())) return {};
  const auto [a, b] = document.mesh().edge_vertices(Edge(verdict->entity.index));
  if (skin->has_edge(a, b)) return {};
  const glm::dvec3 from = document.mesh().position(a), to = document.mesh().position(b);
  const glm::dvec3 sight =
      view_.camera.ray({0, 0}, view_.aspect, document.content().bounds).direction;
  const glm::dvec3 along = glm::normalize(to - from);
  glm::dvec3 normal = sight - glm::dot(sight, along) * along;
  if (glm::length(normal) < 1e-3 * glm::length(sight)) normal = sight;  // it is seen end on
  normal = glm::normalize(normal);
  return glm::dvec4(normal, -glm::dot(normal, from));
}

void Sheet::refresh_selection(bool mesh_changed, bool cells_changed) {
  if (mesh_changed) {
    selection.drop_dead(document.mesh());
    inquiry_.point_at_nothing();
  }
  const bool selects_anew = selection.revision() != drawn_selection_;
  if (!points_anew_ && (mesh_changed || selects_anew)) pointed_out_.clear();
  if (mesh_changed || cells_changed || points_anew_ || selects_anew) draw_selection();
  inquiry_.update(document, selection, view_, mesh_changed, busy());
  inquiry_.draw_preview(document.mesh(), selection, view_, drawing_.drawable());
  draw_hovered();
}

void Sheet::draw_selection() {
  const Mesh& mesh = document.mesh();
  Drawable& drawable = drawing_.drawable();
  const std::vector<Region>& regions = skin_.cell_regions();
  points_anew_ = false;
  drawable.selected.clear();
  draw_entities(mesh, marked_cells_, marked_style(), drawable.origin, drawable.selected);
  draw_cells(drawable, regions, marked_cells_, marked_style(), drawable.selected);
  draw_entities(mesh, selection.entities(), selected_style(), drawable.origin, drawable.selected);
  draw_cells(drawable, regions, selection.entities(), selected_style(), drawable.selected);
  constexpr std::size_t most_arrows = 60;
  if (mesh.stored(2, 1) && selection.size() <= most_arrows)
    for (const EntityRef e : selection.entities())
      if (e.dimension == 2)
        draw_use_arrows(mesh, Face(e.index), drawable.origin, drawable.selected);
  drawable.rulers.clear();
  for (const Ruler& ruler : rulers_of(selection))
    draw_ruler(mesh, ruler, drawable.origin, drawable.rulers);
  draw_entities(mesh, pointed_out_, deciding_style(), drawable.origin, drawable.selected);
  drawn_selection_ = selection.revision();
}

void Sheet::draw_hovered() {
  const Hovered* hovered = inquiry_.hovered();
  const EntityRef over = hovered ? hovered->entity : EntityRef();
  if (over == drawn_hover_) return;
  drawn_hover_ = over;
  Drawable& drawable = drawing_.drawable();
  drawable.hovered.clear();
  if (!over.valid()) return;
  const std::span only(&over, 1);
  draw_entities(document.mesh(), only, hovered_style(), drawable.origin, drawable.hovered);
  draw_cells(drawable, skin_.cell_regions(), only, hovered_style(), drawable.hovered);
}

void Sheet::point_out(std::vector<EntityRef> entities) {
  pointed_out_ = std::move(entities);
  points_anew_ = true;
}

}  // namespace aomd::scene
