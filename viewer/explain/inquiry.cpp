#include "viewer/explain/inquiry.h"

#include "viewer/explain/seam_words.h"

namespace aomd::scene {

void Inquiry::hover(Document& document, const Hovered& at, bool busy) {
  const EntityRef e = at.entity;
  hovered_ = at;
  if (hovered_words_of_ == e) return;
  hovered_words_.clear();
  hovered_words_of_ = e;
  hovered_verdict_.reset();
  if (e.dimension != 1 || busy || !document.judges_at_once()) return;
  hovered_verdict_ = judge(*document.build_decimation_to_judge(), document.mesh(), e);
  if (!hovered_verdict_) return;
  add_seam_words(document, *hovered_verdict_);
  hovered_words_ = short_words(*hovered_verdict_);
}

std::size_t Inquiry::previewed_way(const View& view) const {
  if (!verdict_ || verdict_->ways.empty()) return 0;
  switch (view.previewed) {
    case PreviewedWay::Best:
      return verdict_->best;
    case PreviewedWay::First:
      return 0;
    case PreviewedWay::Second:
      return verdict_->ways.size() - 1;
    case PreviewedWay::Swap:
      break;
  }
  return verdict_->ways.size();
}

void Inquiry::update(Document& document, const Selection& selection, const View& view,
                     bool mesh_changed, bool busy) {
  update_model_entity(document, view, busy);
  const Asked now{selection.revision(), document.options_revision(), stored_bits(document.mesh()),
                  busy};
  const bool same = !mesh_changed && asked_ == now;
  const EntityRef e = selection.single();
  if (!same || neighbours_level_ != view.neighbours) find_neighbours_anew(document.mesh(), e, view);
  if (same) return;
  asked_ = now;
  hovered_words_of_ = {};
  hovered_verdict_.reset();
  facts_.reset();
  verdict_.reset();
  if (!e.valid()) return;
  const bool judges = document.answers_about(e) && !busy;
  if (Decimation* decimation = judges ? document.build_decimation_to_judge() : nullptr)
    verdict_ = judge(*decimation, document.mesh(), e);
  if (verdict_) add_seam_words(document, *verdict_);
  facts_ = entity_facts(document, e);
}

void Inquiry::find_neighbours_anew(const Mesh& mesh, EntityRef e, const View& view) {
  neighbours_level_ = view.neighbours;
  neighbours_.reset();
  drawn_preview_.reset();
  if (view.neighbours && e.valid()) neighbours_ = find_neighbours(mesh, e, *view.neighbours);
}

void Inquiry::update_model_entity(const Document& document, const View& view, bool busy) {
  const bool wanted = view.highlighted && view.panels.side && view.panels.page == Page::Selection;
  if (!wanted) return model_entity_.reset();
  const bool same = model_entity_ && model_entity_->ref == *view.highlighted;
  if (same && (busy || model_entity_place_ == document.place())) return;
  model_entity_ = model_entity_facts(document.mesh(), *view.highlighted);
  model_entity_place_ = document.place();
}

/// What the mouse points at comes before what is selected; neighbours take the place of what an
/// operation would lead to: both at once would be too much.
const EntityVerdict* Inquiry::previewed(const Selection& selection, const View& view) const {
  if (!view.preview || neighbours_) return nullptr;
  const bool points = hovered_ && hovered_verdict_ && hovered_verdict_->entity == hovered_->entity;
  if (points && hovered_->entity != selection.single()) return &*hovered_verdict_;
  return verdict();
}

void Inquiry::draw_preview(const Mesh& mesh, const Selection& selection, const View& view,
                           Drawable& drawable) {
  const EntityVerdict* judged = previewed(selection, view);
  const bool selected = judged != nullptr && judged == verdict();
  const std::size_t way = selected ? previewed_way(view) : judged == nullptr ? 0 : judged->best;
  const std::pair wanted(judged == nullptr ? EntityRef() : judged->entity, way);
  if (drawn_preview_ == wanted) return;
  drawn_preview_ = wanted;
  drawable.preview.clear();
  if (neighbours_) draw_neighbours(mesh, *neighbours_, drawable.origin, drawable.preview);
  if (judged == nullptr) return;
  if (way < judged->ways.size())
    scene::draw_preview(mesh, judged->ways[way], drawable.origin, drawable.preview);
  else if (judged->swap)
    scene::draw_preview(mesh, *judged->swap, drawable.origin, drawable.preview);
  else if (judged->move)
    scene::draw_preview(mesh, *judged->move, drawable.origin, drawable.preview);
}

}  // namespace aomd::scene
