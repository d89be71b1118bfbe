#pragma once
// What the present mesh is compared with, drawn in the same colours.

#include <memory>
#include <optional>

#include "viewer/document/beside_mesh.h"
#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/drawing/field_keeper.h"
#include "viewer/drawing/skin_keeper.h"
#include "viewer/drawing/surface_drawing.h"
#include "viewer/drawing/texture_keeper.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// Of one document: the mesh as loaded, or a state of it that is kept.
class ReferenceDrawing {
 public:
  /// `reference` is null for the mesh as loaded. `present` colours the present mesh. `still`:
  /// nothing runs, what takes long may be measured.
  void update(Document& document, const KeptRun* reference, const View& view,
              const FieldKeeper& present, bool still);
  [[nodiscard]] bool shown() const { return shown_; }
  /// Null where it is not shown.
  [[nodiscard]] SurfaceDrawing* drawing() { return shown_ ? &drawing_ : nullptr; }

 private:
  [[nodiscard]] const Mesh& mesh_of(Document& document, const KeptRun* reference);
  void draw_skin(const FieldSource& source, const View& view, SurfaceChanges& changes);

  bool shown_ = false;
  std::optional<unsigned> drawn_;  ///< number of the state that is drawn; 0: the mesh as loaded
  std::unique_ptr<BesideMesh> beside_;  ///< where that is a kept state
  std::optional<Skin> skin_;            ///< of a volume
  std::optional<SkinKeeper> skin_keeper_;
  FieldKeeper fields_;
  TextureKeeper texture_;
  SurfaceDrawing drawing_;
};

}  // namespace aomd::scene
