#pragma once
// A mesh with all that belongs to it: made by loading it, ended by loading the next one.

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/mesh_facts.h"
#include "viewer/document/selection.h"
#include "viewer/document/storage_comparison.h"
#include "viewer/drawing/histogram_keeper.h"
#include "viewer/drawing/picking.h"
#include "viewer/drawing/reference_drawing.h"
#include "viewer/drawing/skin_keeper.h"
#include "viewer/drawing/texture_keeper.h"
#include "viewer/explain/inquiry.h"
#include "viewer/explain/verdict_keeper.h"

namespace aomd::scene {

/// Nothing of it outlives it, so that nothing of one mesh is ever shown beside another one. Options
/// and view are the session's. What it shows is brought up to date by refresh() alone.
class Sheet {
 public:
  /// Without a mesh where `loaded` is null: the start of a session.
  Sheet(DocumentOptions& options, const View& view, std::unique_ptr<LoadedMesh> loaded = {});
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  Document document;
  Selection selection;
  KeptRuns runs;

  // Going through the history by itself (sheet_work.cpp).
  void play(bool on);
  [[nodiscard]] bool playing() const { return playing_; }
  void advance_playing(double frame_s);
  void play_to_the_end();

  // What is worked out in the background, on copies of the mesh.
  /// The mesh must be there and can be decimated.
  void start_comparison();
  /// While it goes on; else null.
  [[nodiscard]] const Background<StorageComparison>* comparison() const {
    return comparison_.get();
  }
  [[nodiscard]] bool take_comparison(bool wait);
  [[nodiscard]] bool cancel_comparison();
  /// The last one; null before.
  [[nodiscard]] const StorageComparison* storage() const { return storage_ ? &*storage_ : nullptr; }
  /// How far kept states are from the mesh as loaded. False where all are measured.
  [[nodiscard]] bool start_measuring();
  [[nodiscard]] bool measuring() const { return measurement_ != nullptr; }
  [[nodiscard]] bool take_measurement(bool wait);
  [[nodiscard]] bool cancel_measuring();

  /// The mesh is on its way: looking would be in the way of that.
  [[nodiscard]] bool busy() const { return document.running() || playing_; }
  /// Nothing runs, is played, measured or judged, but for what the colours wait for.
  [[nodiscard]] bool at_rest() const {
    return !busy() && !comparison_ && !measurement_ && !verdicts_.pending();
  }
  /// The colours wait for nothing.
  [[nodiscard]] bool coloured() const {
    return !fields_.pending() && !texture_.pending() && !openness_;
  }
  /// The pictures on the surface; null where none are shown.
  [[nodiscard]] const SurfaceTexture* texture() const { return texture_.texture().get(); }

  /// Brings facts and drawings up to date. `undisturbed`: nothing else of the session goes on.
  /// Judging and measuring take about `budget`; without one all is done at once. O(what changed).
  void refresh(bool undisturbed, std::optional<std::chrono::microseconds> budget);
  [[nodiscard]] const MeshFacts& facts() const { return facts_.facts(); }
  /// The facts right after loading.
  [[nodiscard]] const MeshFacts& loaded_facts() const { return loaded_facts_; }
  /// What the surface's colours show besides classification; null where they show none.
  [[nodiscard]] const ScalarField* field() const { return fields_.field().get(); }
  /// Null unless somebody looks at them.
  [[nodiscard]] const Histograms* histograms() const { return histograms_.histograms(); }
  /// What the bar of a histogram counts: faces, edges or vertices, of a volume regions. Nothing may
  /// run, and a mesh must be there. O(entities).
  [[nodiscard]] std::vector<EntityRef> measure_counted_in(const MarkedBar& bar);
  [[nodiscard]] SurfaceDrawing& drawing() { return drawing_; }
  [[nodiscard]] const SurfaceDrawing& drawing() const { return drawing_; }
  /// What the present mesh is compared with, in the same colours; null where it is not shown.
  [[nodiscard]] SurfaceDrawing* reference_drawing() { return reference_.drawing(); }
  [[nodiscard]] bool shows_reference() const { return reference_.shown(); }
  /// The reference has the left half of the picture, the present one the right. What cannot be
  /// decimated stays as loaded.
  [[nodiscard]] bool side_by_side() const {
    return view_.side_by_side && !document.empty() && document.hindrance().empty();
  }
  /// "as loaded", "Run 1"
  [[nodiscard]] std::string reference_name() const;
  /// "7,160 faces", of a volume "165,295 regions"
  [[nodiscard]] std::string reference_size() const;

  // What lies under a place of the picture (-1..1), or in a rectangle, as it was refreshed last
  // (sheet_picking.cpp). A mesh must be there.
  // Where a plane takes whole regions away, the edges on what is left become entities first.
  [[nodiscard]] EntityRef pick(glm::dvec2 ndc);
  [[nodiscard]] std::vector<EntityRef> pick(glm::dvec2 low, glm::dvec2 high);
  /// None: at nothing.
  void hover(std::optional<glm::dvec2> ndc);
  [[nodiscard]] const Inquiry& inquiry() const { return inquiry_; }
  /// What is said about every edge, while the colours show it; else null.
  [[nodiscard]] const EdgeVerdicts* verdicts() const { return verdicts_.verdicts(); }
  /// Where what collapsing the selected edge would lead to lies inside of a volume that nothing
  /// else cuts: the plane through the edge that faces the camera. The volume is then of glass, and
  /// ends there. None elsewhere.
  [[nodiscard]] std::optional<glm::dvec4> preview_cut() const;
  /// Draws entities as what stands against something, or would come of it, until the mesh or the
  /// selection changes.
  void point_out(std::vector<EntityRef> entities);

 private:
  [[nodiscard]] bool still() const { return undisturbed_ && at_rest(); }
  void refresh_surface();
  void refresh_skin();
  void draw_skin();
  [[nodiscard]] VolumeChanges read_volume_changes();
  void count_volume(const VolumeChanges& changes);
  [[nodiscard]] bool asks() const;
  [[nodiscard]] FieldSource field_source();
  void refresh_field(const FieldSource& source, SurfaceChanges& changes);
  void refresh_marks(bool changed);
  [[nodiscard]] bool refresh_marked_cells();
  [[nodiscard]] std::optional<std::vector<EntityRef>> newly_marked(bool changed);
  void refresh_selection(bool mesh_changed, bool cells_changed = false);
  [[nodiscard]] bool can_pick();
  void draw_selection();
  void draw_hovered();
  [[nodiscard]] Shown shown() const;
  [[nodiscard]] const Mesh& drawn_mesh() const;
  void refresh_openness();
  void refresh_ground();

  const View& view_;
  bool undisturbed_ = true;
  std::optional<std::chrono::microseconds> budget_;
  bool playing_ = false;
  double steps_due_ = 0;
  std::unique_ptr<Background<StorageComparison>> comparison_;
  std::optional<StorageComparison> storage_;
  std::unique_ptr<Background<std::vector<MeasuredRun>>> measurement_;

  ChangeReader changes_;
  VolumeChangeReader volume_changes_;
  FactsKeeper facts_;
  VolumeFactsKeeper volume_facts_;
  MeshFacts loaded_facts_;
  SurfaceDrawing drawing_;
  SkinKeeper skin_;
  std::chrono::steady_clock::time_point skin_due_{};  ///< while the mesh is on its way
  ReferenceDrawing reference_;
  FieldKeeper fields_;
  TextureKeeper texture_;
  HistogramKeeper histograms_;
  VerdictKeeper verdicts_;
  Picker picker_;
  Inquiry inquiry_;
  std::optional<MarkedBar> drawn_mark_;
  std::vector<EntityRef> marked_cells_;  ///< of a mesh that is drawn by its skin
  std::optional<std::size_t> drawn_focus_;
  StepSides drawn_sides_;
  std::uint64_t drawn_selection_ = 0;
  EntityRef drawn_hover_;
  std::unique_ptr<Background<std::vector<std::uint8_t>>> openness_;
  std::optional<HistoryPlace> openness_of_;  ///< what it is known of, or being worked out for
  std::optional<std::pair<std::uint64_t, UpAxis>> ground_of_;  ///< revision of the surface
  std::vector<EntityRef> pointed_out_;
  bool points_anew_ = false;
};

}  // namespace aomd::scene
