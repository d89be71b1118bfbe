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
  const bool volume = document.content().volume();
  const Mesh& drawn = volume ? draw_skin(mesh, document.content().bounds, view, changes) : mesh;
  const bool as_loaded = reference == nullptr;
  FieldSource source{drawn, document, volume, as_loaded || still, as_loaded && !volume};
  source.run = reference;
  fields_.update(view.coloring, source, changes);
  if (present.field()) fields_.take_scale(*present.field());
  drawing_.set_field(fields_.field());
  drawing_.update(drawn, view, changes);
}

/// What is drawn of a volume; what of it is another one than before joins the changes.
const Mesh& ReferenceDrawing::draw_skin(const Mesh& mesh, const Box& bounds, const View& view,
                                        SurfaceChanges& changes) {
  if (!skin_) skin_.emplace(mesh), skin_keeper_.emplace();
  const SkinSource source{mesh, [this]() -> const Skin& { return *skin_; }, bounds, {}};
  changes = skin_keeper_->update(source, view, {}, drawing_).surface;
  drawing_.set_whole_faces(false);
  return skin_keeper_->surface()->mesh;
}

}  // namespace aomd::scene
