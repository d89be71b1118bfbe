#pragma once
// Keeps the values of the field that colours the surface, measuring no more than has changed.

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/scalar_field.h"
#include "viewer/drawing/skin_surface.h"

namespace aomd::scene {

/// What a field is measured of.
struct FieldSource {
  const Mesh& mesh;
  Document& document;
  const SkinSurface* skin = nullptr;     ///< what is drawn of the mesh; null: itself, of triangles
  std::span<const Region> regions = {};  ///< of the mesh, that are not as they were
  const ScaleChoice* choice = nullptr;   ///< of the scale; null: as usual
  const ScalarField* like = nullptr;     ///< another mesh's field, which gives the scale
  bool changed = false;                  ///< the mesh is not as it was
  bool still = true;                     ///< nothing runs: what takes long may be measured
  bool as_loaded = false;                ///< `mesh` is the document's as it was loaded
  const KeptRun* run = nullptr;          ///< `mesh` is that of a kept state
  std::optional<std::chrono::microseconds> budget = {};  ///< for what takes long; none: all at once

  [[nodiscard]] const Mesh& drawn() const { return skin != nullptr ? skin->mesh : mesh; }
  [[nodiscard]] bool volume() const { return document.content().volume(); }
};

/// Of one mesh. Quality is measured with every change and needs no longer than drawing; Spacing
/// when the options change. Distance (about 20 microseconds a changed face) and Curvature
/// (O(faces)) wait until nothing runs: until then changed faces have no colour, or that of before.
/// Distance is measured in slices of time. Inside of a volume there are Quality, of its regions,
/// and Spacing.
class FieldKeeper {
 public:
  /// What colours the inside of a volume, before its skin is drawn; `source` has none yet.
  const std::shared_ptr<const ScalarField>& update_inside(Coloring coloring,
                                                          const FieldSource& source);
  /// Brings the field that `coloring` names up to date, or lets go of it. `changes` are those of
  /// what is drawn since the last call; faces that get a value late, or another one though they
  /// stay, are added to them.
  void update(Coloring coloring, const FieldSource& source, SurfaceChanges& changes);
  /// Faces still wait to be measured.
  [[nodiscard]] bool pending() const { return pending_; }
  /// Null where nothing is coloured by numbers, or the mesh has no such numbers.
  [[nodiscard]] const std::shared_ptr<const ScalarField>& field() const { return shown_; }

 private:
  void spacing(const FieldSource& source, bool anew);
  void spacing_of_skin(const SkinSurface& skin, const SurfaceChanges& changes);
  void quality(const FieldSource& source, SurfaceChanges& changes);
  void measure_quality(const FieldSource& source, Face face);
  void distance(const FieldSource& source, SurfaceChanges& changes);
  void curvature(const FieldSource& source, const SurfaceChanges& changes);
  [[nodiscard]] bool measure_distances(const FieldSource& source);
  [[nodiscard]] static float measure_distance(const FieldSource& source, Face face);
  void take_distances(const Mesh& mesh, SurfaceChanges& changes);
  void settle_scale(const FieldSource& source, ScalarField& field);
  [[nodiscard]] static std::vector<float> values_of(const FieldSource& source,
                                                    const ScalarField& field);

  std::shared_ptr<ScalarField> field_;
  std::shared_ptr<const ScalarField> shown_;  ///< the same
  std::shared_ptr<ScalarField> inside_;       ///< by the vertices and regions of a volume
  std::shared_ptr<const ScalarField> shown_inside_;
  std::uint64_t inside_version_ = 0;  ///< of what the skin's numbers are from
  FieldScale usual_;                  ///< the scale, where nobody chose another one
  ScaleChoice settled_;               ///< the choice that the scale is of
  FieldScale settled_usual_;
  bool unsettled_ = false;     ///< there are other numbers than then
  std::uint64_t options_ = 0;  ///< revision of those that Spacing was evaluated for
  bool pending_ = false;
  std::uint32_t next_ = 0;      ///< faces before it have been looked at since the last change
  std::vector<Face> measured_;  ///< and these got a value, which is not drawn yet
};

}  // namespace aomd::scene
