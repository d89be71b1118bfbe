#pragma once
// Keeps the values of the field that colours the surface, measuring no more than has changed.

#include <memory>

#include "core/decimate/options.h"
#include "viewer/scene/document.h"
#include "viewer/scene/scalar_field.h"
#include "viewer/scene/surface_changes.h"

namespace aomd::scene {

/// What a field is measured of.
struct FieldSource {
  const Mesh& mesh;  ///< of triangles; what is drawn
  Document& document;
  bool skin = false;       ///< `mesh` is the skin of a volume or of quads
  bool still = true;       ///< nothing runs: what takes long may be measured
  bool as_loaded = false;  ///< `mesh` is the document's as it was loaded
};

/// Quality is measured with every change and needs no longer than drawing; Spacing when the options change.
/// Distance (about 20 microseconds a changed face) and Curvature (O(faces)) wait until nothing runs: until
/// then changed faces have no colour, or that of before.
class FieldKeeper {
 public:
  /// Brings the field that `coloring` names up to date, or lets go of it. `changes` are those of the mesh
  /// since the last call; faces that get a value late are added to them.
  void update(Coloring coloring, const FieldSource& source, SurfaceChanges& changes);
  /// Colours by the scale of another mesh's field.
  void take_scale(const ScalarField& other);
  /// Null where nothing is coloured by numbers, or the mesh has no such numbers.
  [[nodiscard]] const std::shared_ptr<const ScalarField>& field() const { return shown_; }

 private:
  void spacing(const FieldSource& source, bool anew);
  void quality(const FieldSource& source, const SurfaceChanges& changes);
  void distance(const FieldSource& source, SurfaceChanges& changes);
  void curvature(const FieldSource& source, const SurfaceChanges& changes);
  void measure_distances(const FieldSource& source, SurfaceChanges& changes);
  void set_scale(const FieldScale& scale);

  std::shared_ptr<ScalarField> field_;
  std::shared_ptr<const ScalarField> shown_;  ///< the same
  DecimationOptions options_;                 ///< that Spacing was evaluated for
  std::uint64_t generation_ = 0;
  bool pending_ = false;
};

}  // namespace aomd::scene
