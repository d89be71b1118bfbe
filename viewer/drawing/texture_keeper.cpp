#include "viewer/drawing/texture_keeper.h"

#include "viewer/document/whole_data.h"

namespace aomd::scene {

/// Whether there is something to show; the pictures are then there.
bool TextureKeeper::start(const Document& document, const View& view) {
  const LoadedMesh& content = document.content();
  if (view.coloring != Coloring::Texture || content.skin || !has_looks(content.appearance)) {
    *this = {};
    return false;
  }
  if (texture_) return true;
  texture_ = std::make_shared<SurfaceTexture>();
  texture_->pictures = std::make_shared<const Pictures>(read_pictures(content.appearance));
  shown_ = texture_;
  pending_ = true;
  return true;
}

/// The data list the faces of the mesh in the order of their ids.
void TextureKeeper::paint(const MeshData& data, const Mesh& mesh) {
  const std::vector<PaintedFace> painted = painted_faces(data);
  texture_->faces.assign(mesh.capacity(2), PaintedFace());
  std::size_t next = 0;
  for (const Face f : mesh.faces()) texture_->faces[f.index] = painted[next++];
  ++texture_->version;
  pending_ = false;
}

void TextureKeeper::update(Document& document, const View& view, const SurfaceChanges& changes,
                           bool still, bool in_window) {
  using Clock = std::chrono::steady_clock;
  constexpr int rest = 4;
  if (!start(document, view)) return;
  pending_ = pending_ || !changes.nothing();
  for (const Face f : changes.faces)
    if (f.index < texture_->faces.size()) texture_->faces[f.index] = {};
  const auto start = Clock::now();
  if (!pending_ || !still || (in_window && start < due_)) return;
  paint(whole_data(document).data, document.mesh());
  const auto end = Clock::now();
  due_ = end + rest * (end - start);
}

void TextureKeeper::update_reference(Document& document, const KeptRun* run, const View& view,
                                     bool changed) {
  if (!start(document, view) || !(pending_ || changed)) return;
  if (run == nullptr)
    paint(whole_as_loaded(document), document.copy_mesh_as_loaded().mesh());
  else
    paint(whole_data_of(document, *run->data).data, Mesh(*run->data));
}

}  // namespace aomd::scene
