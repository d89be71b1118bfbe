// What a session selects and points at.

#include <algorithm>

#include "viewer/commands/session.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene {

Shown Session::shown() const {
  const Drawable& drawable = drawing_.drawable();
  if (skin_surface_)
    return {skin_surface_->mesh,     document.mesh(), &*skin_surface_, document.content().bounds,
            drawable.cells.values(), cell_regions_,   drawable.origin};
  return {document.mesh(), document.mesh(), nullptr, document.content().bounds};
}

EntityRef Session::pick(glm::dvec2 ndc) {
  refresh();
  return picker_.at(shown(), view, ndc);
}

std::vector<EntityRef> Session::pick(glm::dvec2 low, glm::dvec2 high) {
  refresh();
  return picker_.within(shown(), view, low, high);
}

void Session::hover(std::optional<glm::dvec2> ndc) {
  hovered_.reset();
  if (!ndc) return;
  const EntityRef e = pick(*ndc);
  if (!e.valid()) return;
  const bool known = hovered_words_of_ == e;
  hovered_ = Hovered{e, *ndc};
  if (known) return;
  hovered_words_.clear();
  hovered_words_of_ = e;
  hovered_judgement_.reset();
  if (e.dimension != 1 || busy() || !document.judges_at_once()) return;
  hovered_judgement_ = judge(*document.for_judging(), document.mesh(), e);
  if (hovered_judgement_) hovered_words_ = short_words(*hovered_judgement_);
}

std::size_t Session::previewed_way() const {
  if (!judgement_ || judgement_->ways.empty()) return 0;
  switch (view.previewed) {
    case PreviewedWay::Best:
      return judgement_->best;
    case PreviewedWay::First:
      return 0;
    case PreviewedWay::Second:
      return judgement_->ways.size() - 1;
    case PreviewedWay::Swap:
      break;
  }
  return judgement_->ways.size();
}

void Session::refresh_inspection(bool mesh_changed) {
  const bool at_work = busy();
  const std::uint32_t relations = stored_bits(document.mesh());
  const bool same = selection.revision() == inspected_selection_ && !mesh_changed &&
                    judged_options_ == document.options() && judged_busy_ == at_work &&
                    seen_relations_ == relations;
  refresh_neighbours(!same);
  if (same) return;
  seen_relations_ = relations;
  inspected_selection_ = selection.revision();
  judged_options_ = document.options();
  judged_busy_ = at_work;
  hovered_words_of_ = {};
  hovered_judgement_.reset();
  inspection_.reset();
  judgement_.reset();
  drawn_preview_.reset();
  const EntityRef e = selection.single();
  if (!e.valid()) return;
  const bool judges = e.dimension < 2 && !at_work;
  if (Decimation* decimation = judges ? document.for_judging() : nullptr)
    judgement_ = judge(*decimation, document.mesh(), e);
  inspection_ = inspect(document, e);
}

void Session::refresh_neighbours(bool anew) {
  if (!anew && neighbours_level_ == view.neighbours) return;
  neighbours_level_ = view.neighbours;
  neighbours_.reset();
  drawn_preview_.reset();
  if (const EntityRef e = selection.single(); view.neighbours && e.valid())
    neighbours_ = find_neighbours(document.mesh(), e, *view.neighbours);
}

/// What the mouse points at comes before what is selected; neighbours take the place of what an
/// operation would lead to: both at once would be too much.
const Judgement* Session::previewed() const {
  if (!view.preview || neighbours_) return nullptr;
  const bool points =
      hovered_ && hovered_judgement_ && hovered_judgement_->entity == hovered_->entity;
  if (points && hovered_->entity != selection.single()) return &*hovered_judgement_;
  return judgement_ ? &*judgement_ : nullptr;
}

void Session::refresh_preview() {
  const Judgement* judged = previewed();
  const bool selected = judgement_ && judged == &*judgement_;
  const std::size_t way = selected ? previewed_way() : judged == nullptr ? 0 : judged->best;
  const std::pair wanted(judged == nullptr ? EntityRef() : judged->entity, way);
  if (drawn_preview_ == wanted) return;
  drawn_preview_ = wanted;
  Drawable& drawable = drawing_.drawable();
  drawable.preview.clear();
  if (neighbours_)
    draw_neighbours(document.mesh(), *neighbours_, drawable.origin, drawable.preview);
  if (judged == nullptr) return;
  if (way < judged->ways.size())
    draw_preview(document.mesh(), judged->ways[way], drawable.origin, drawable.preview);
  else if (judged->swap)
    draw_preview(document.mesh(), *judged->swap, drawable.origin, drawable.preview);
  else if (judged->move)
    draw_preview(document.mesh(), *judged->move, drawable.origin, drawable.preview);
}

void Session::refresh_selection(bool mesh_changed, bool cells_changed) {
  const Mesh& mesh = document.mesh();
  if (mesh_changed) {
    selection.drop_dead(mesh);
    hovered_.reset();
  }
  Drawable& drawable = drawing_.drawable();
  if (!points_anew_ && (mesh_changed || selection.revision() != drawn_selection_))
    pointed_out_.clear();
  if (mesh_changed || cells_changed || points_anew_ || selection.revision() != drawn_selection_) {
    points_anew_ = false;
    drawable.selected.clear();
    draw_entities(mesh, marked_cells_, marked_style(), drawable.origin, drawable.selected);
    draw_cells(drawable, cell_regions_, marked_cells_, marked_style(), drawable.selected);
    draw_entities(mesh, selection.entities(), selected_style(), drawable.origin, drawable.selected);
    draw_cells(drawable, cell_regions_, selection.entities(), selected_style(), drawable.selected);
    draw_entities(mesh, pointed_out_, deciding_style(), drawable.origin, drawable.selected);
    drawn_selection_ = selection.revision();
  }
  refresh_inspection(mesh_changed);
  refresh_model_entity();
  refresh_preview();
  const EntityRef over = hovered_ ? hovered_->entity : EntityRef();
  if (over != drawn_hover_) {
    drawable.hovered.clear();
    if (over.valid()) {
      draw_entities(mesh, std::span(&over, 1), hovered_style(), drawable.origin, drawable.hovered);
      draw_cells(drawable, cell_regions_, std::span(&over, 1), hovered_style(), drawable.hovered);
    }
    drawn_hover_ = over;
  }
}

void Session::refresh_model_entity() {
  const bool wanted = view.highlighted && view.panels.side && view.panels.page == Page::Selection;
  if (!wanted) return model_entity_.reset();
  const bool same = model_entity_ && model_entity_->ref == *view.highlighted;
  if (same && (busy() || model_entity_place_ == document.place())) return;
  model_entity_ = model_entity_facts(document.mesh(), *view.highlighted);
  model_entity_place_ = document.place();
}

void Session::point_out(std::vector<EntityRef> entities) {
  pointed_out_ = std::move(entities);
  points_anew_ = true;
}

void Session::forget_selection() {
  point_out({});
  selection.clear();
  hovered_.reset();
  picker_.forget();
}

}  // namespace aomd::scene
