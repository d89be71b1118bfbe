#include "viewer/drawing/reference_drawing.h"

namespace aomd::scene {

const Mesh& ReferenceDrawing::mesh_of(Document& document, const KeptRun* reference) {
  if (reference == nullptr) {
    beside_.reset();
    return document.copy_mesh_as_loaded().mesh();
  }
  if (!beside_ || drawn_ != reference->number)
    beside_ = std::make_unique<BesideMesh>(*reference->data);
  return beside_->mesh();
}

void ReferenceDrawing::update(Document& document, const KeptRun* reference, const View& view,
                              const FieldKeeper& present, bool still) {
  shown_ = (view.original || view.side_by_side) && document.hindrance().empty() &&
           document.can_look_back();
  if (!shown_) return;
  const Mesh& mesh = mesh_of(document, reference);
  const unsigned number = reference == nullptr ? 0 : reference->number;
  SurfaceChanges changes;
  changes.everything = drawn_ != number;
  if (changes.everything) {
    fields_ = {};
    skin_.reset();
    drawing_.set_bounds(document.content().bounds);
  }
  drawn_ = number;
  FieldSource source{mesh, document};
  source.as_loaded = reference == nullptr;
  source.still = source.as_loaded || still;
  source.run = reference;
  source.like = present.field().get();
  if (document.content().volume()) {
    draw_skin(source, view, changes);
    source.skin = skin_keeper_->surface();
  }
  fields_.update(view.coloring, source, changes);
  drawing_.set_field(fields_.field());
  texture_.update_reference(document, reference, view, changes.everything);
  drawing_.set_texture(texture_.texture());
  drawing_.update(source.drawn(), view, changes);
}

/// What is drawn of a volume; what of it is another one than before joins the changes.
void ReferenceDrawing::draw_skin(const FieldSource& source, const View& view,
                                 SurfaceChanges& changes) {
  if (!skin_) skin_.emplace(source.mesh), skin_keeper_.emplace();
  SkinSource of{source.mesh,
                [this]() -> const Skin& { return *skin_; },
                source.document.content().bounds,
                {}};
  of.field = fields_.update_inside(view.coloring, source);
  changes = skin_keeper_->update(of, view, {}, drawing_).surface;
  drawing_.set_whole_faces(false);
}

}  // namespace aomd::scene
