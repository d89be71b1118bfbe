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
  shown_ =
      (view.original || view.side_by_side) && !document.content().skin && document.can_look_back();
  if (!shown_) return;
  const Mesh& mesh = mesh_of(document, reference);
  const unsigned number = reference == nullptr ? 0 : reference->number;
  SurfaceChanges changes;
  changes.everything = drawn_ != number;
  if (changes.everything) {
    fields_ = {};
    drawing_.set_bounds(document.content().bounds);
  }
  drawn_ = number;
  const bool as_loaded = reference == nullptr;
  FieldSource source{mesh, document, false, as_loaded || still, as_loaded};
  source.run = reference;
  fields_.update(view.coloring, source, changes);
  if (present.field()) fields_.take_scale(*present.field());
  drawing_.set_field(fields_.field());
  drawing_.update(mesh, view, changes);
}

}  // namespace aomd::scene
