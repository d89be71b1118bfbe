#pragma once
// Keeps the values of the field that colours the surface, measuring no more than has changed.

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/scalar_field.h"

namespace aomd::scene {

/// What a field is measured of.
struct FieldSource {
  const Mesh& mesh;  ///< of triangles; what is drawn
  Document& document;
  bool skin = false;             ///< `mesh` is the skin of a volume or of quads
  bool still = true;             ///< nothing runs: what takes long may be measured
  bool as_loaded = false;        ///< `mesh` is the document's as it was loaded
  const KeptRun* run = nullptr;  ///< `mesh` is that of a kept state
  std::optional<std::chrono::microseconds> budget = {};  ///< for what takes long; none: all at once
};

/// Of one mesh. Quality is measured with every change and needs no longer than drawing; Spacing
/// when the options change. Distance (about 20 microseconds a changed face) and Curvature
/// (O(faces)) wait until nothing runs: until then changed faces have no colour, or that of before.
/// Distance is measured in slices of time.
class FieldKeeper {
 public:
  /// Brings the field that `coloring` names up to date, or lets go of it. `changes` are those of
  /// the mesh since the last call; faces that get a value late are added to them.
  void update(Coloring coloring, const FieldSource& source, SurfaceChanges& changes);
  /// Faces still wait to be measured.
  [[nodiscard]] bool pending() const { return pending_; }
  /// Colours by the scale of another mesh's field.
  void take_scale(const ScalarField& other);
  /// Null where nothing is coloured by numbers, or the mesh has no such numbers.
  [[nodiscard]] const std::shared_ptr<const ScalarField>& field() const { return shown_; }

 private:
  void spacing(const FieldSource& source, bool anew);
  void quality(const FieldSource& source, const SurfaceChanges& changes);
  void distance(const FieldSource& source, SurfaceChanges& changes);
  void curvature(const FieldSource& source, const SurfaceChanges& changes);
  [[nodiscard]] bool measure_distances(const FieldSource& source);
  void take_distances(const Mesh& mesh, SurfaceChanges& changes);
  void set_scale(const FieldScale& scale);

  std::shared_ptr<ScalarField> field_;
  std::shared_ptr<const ScalarField> shown_;  ///< the same
  std::uint64_t options_ = 0;                 ///< revision of those that Spacing was evaluated for
  bool pending_ = false;
  std::uint32_t next_ = 0;      ///< faces before it have been looked at since the last change
  std::vector<Face> measured_;  ///< and these got a value, which is not drawn yet
};

}  // namespace aomd::scene
