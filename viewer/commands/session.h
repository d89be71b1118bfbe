#pragma once
// All of the viewer's state that is not on the GPU: document, view, what is under way, and what is
// to be said.

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/commands/clipboard.h"
#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/loader.h"
#include "viewer/document/mesh_facts.h"
#include "viewer/document/recovery.h"
#include "viewer/document/run_measurement.h"
#include "viewer/document/selection.h"
#include "viewer/document/storage_comparison.h"
#include "viewer/document/work_folder.h"
#include "viewer/drawing/cell_drawing.h"
#include "viewer/drawing/field_keeper.h"
#include "viewer/drawing/histogram_keeper.h"
#include "viewer/drawing/picking.h"
#include "viewer/drawing/picture_series.h"
#include "viewer/drawing/skin_surface.h"
#include "viewer/drawing/surface_drawing.h"
#include "viewer/drawing/view.h"
#include "viewer/explain/edge_verdicts.h"
#include "viewer/explain/entity_facts.h"
#include "viewer/explain/model_entity.h"
#include "viewer/explain/neighbours.h"
#include "viewer/lessons/lesson_player.h"

namespace aomd::scene {

/// Changed by commands (see commands.h) and by tick() alone.
class Session {
 public:
  Document document;
  View view;
  Selection selection;
  KeptRuns runs;                              ///< of the present mesh; see the members below
  std::deque<ScreenshotRequest> screenshots;  ///< whoever draws fulfils them
  std::string status;                         ///< one line: what the last command did
  std::string error;                          ///< stays until it is dismissed
  std::optional<std::string> log;             ///< for standard output, once
  bool quit = false;
  Clipboard clipboard;
  std::string asked;                     ///< the line that waits for an answer about unsaved work
  std::optional<std::string> next_line;  ///< to be carried out after the present one
  LessonPlayer lesson;
  std::uint64_t executed = 0;                ///< how many commands were carried out
  std::unique_ptr<RecoveryKeeper> recovery;  ///< null: unsaved work is not kept
  FoundWork found_work;                      ///< of programs that died
  std::vector<std::string> warnings;         ///< what a user is to be told, whatever was asked for

  void start_loading(LoadRequest request);
  void cancel_loading();
  [[nodiscard]] bool loading() const { return loader_.busy(); }
  [[nodiscard]] const std::string& loading_name() const { return loader_.name(); }

  void play(bool on);
  [[nodiscard]] bool playing() const { return playing_; }
  /// Nothing is loaded, running, played, exported, measured or judged.
  [[nodiscard]] bool idle() const { return at_rest() && !fields_.pending(); }

  /// Measures the paper's two ways to store adjacencies on a copy of the present mesh, which must
  /// be there and can be decimated, in the background. Ends a run.
  void start_comparison();
  void cancel_comparison();
  /// While it goes on; else null.
  [[nodiscard]] const Background<StrategyResult>* comparison() const { return comparison_.get(); }
  /// The last one on the present mesh; null before.
  [[nodiscard]] const StrategyResult* strategies() const {
    return strategies_ ? &*strategies_ : nullptr;
  }

  // States that are kept (session_runs.cpp). A mesh that can be decimated must be there.
  /// Keeps the present one; without a name it gets one, or keeps the one that it has.
  void keep_run(const std::string& name);
  void remove_run(unsigned number);
  /// Measures in the background how far they are from the mesh as loaded, where that is not known
  /// yet. Ends a run.
  void start_measuring();
  void cancel_measuring();
  [[nodiscard]] bool measuring() const { return measurement_ != nullptr; }
  /// What the present mesh is compared with, in pictures and histograms; null: the mesh as loaded.
  [[nodiscard]] const KeptRun* reference() const;
  /// "as loaded", "Run 1"
  [[nodiscard]] std::string reference_name() const;
  [[nodiscard]] std::int64_t reference_faces() const;

  /// Keeps unsaved work in a folder from now on, and looks for what others have left there.
  void keep_work(const std::filesystem::path& folder);
  /// Has unsaved work written where that is due. Cheap where nothing has changed.
  void keep();

  /// A mesh must be there. Ends a run.
  void start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                    std::optional<glm::ivec2> size);
  /// The series of pictures that is being made; null: none.
  [[nodiscard]] const PictureSeries* series() const { return series_ ? &*series_ : nullptr; }
  /// Asks for its next picture once the one before has been taken.
  void advance_series();
  /// Puts back what it changed; the pictures that are made stay.
  void cancel_series();

  /// What goes on by itself, for a frame of `frame_s` seconds: loading, a run (about `budget`),
  /// playing.
  void tick(std::chrono::microseconds budget, double frame_s);
  /// The same until nothing is loaded, running or played. Throws what loading threw.
  void finish();

  /// Brings facts and drawing up to date. O(what changed).
  void refresh();
  [[nodiscard]] const MeshFacts& facts() const { return facts_.facts(); }
  /// The facts right after loading.
  [[nodiscard]] const MeshFacts& loaded_facts() const { return loaded_facts_; }
  /// What the surface's colours show besides classification; null where they show none.
  [[nodiscard]] const ScalarField* field() const { return fields_.field().get(); }
  /// Null unless somebody looks at them.
  [[nodiscard]] const Histograms* histograms() const { return histograms_.histograms(); }
  [[nodiscard]] SurfaceDrawing& drawing() { return drawing_; }
  [[nodiscard]] const SurfaceDrawing& drawing() const { return drawing_; }
  /// The reference (above), in the same colours; null where it is not shown.
  [[nodiscard]] SurfaceDrawing* original_drawing() {
    return shows_original_ ? &original_drawing_ : nullptr;
  }
  [[nodiscard]] bool shows_original() const { return shows_original_; }
  /// The reference has the left half of the picture, the present one the right. Volumes stay as
  /// loaded.
  [[nodiscard]] bool side_by_side() const {
    return view.side_by_side && !document.empty() && !document.content().skin;
  }

  // What lies under a place of the picture (-1..1), or in a rectangle (session_picking.cpp). A mesh
  // must be there.
  [[nodiscard]] EntityRef pick(glm::dvec2 ndc);
  [[nodiscard]] std::vector<EntityRef> pick(glm::dvec2 low, glm::dvec2 high);
  /// What the mouse points at.
  struct Hovered {
    EntityRef entity;
    glm::dvec2 place;
  };
  /// None: at nothing.
  void hover(std::optional<glm::dvec2> ndc);
  [[nodiscard]] const Hovered* hovered() const { return hovered_ ? &*hovered_ : nullptr; }
  /// One line on it: why an edge stays. Empty where that is not known at once.
  [[nodiscard]] const std::string& hovered_words() const { return hovered_words_; }
  /// Of the only entity that is selected; null where there are none or several.
  [[nodiscard]] const Inspection* inspection() const {
    return inspection_ ? &*inspection_ : nullptr;
  }
  /// What decimation says about it; null where nothing, and while it runs.
  [[nodiscard]] const Judgement* judgement() const { return judgement_ ? &*judgement_ : nullptr; }
  /// Around the only entity that is selected, of the level View::neighbours; null where nothing is
  /// to light up.
  [[nodiscard]] const Neighbours* neighbours() const {
    return neighbours_ ? &*neighbours_ : nullptr;
  }
  /// What is said about every edge, while the colours show it; else null (session_verdicts.cpp).
  [[nodiscard]] const VerdictField* verdicts() const { return verdicts_ ? &*verdicts_ : nullptr; }
  /// The edges that would be refused now, and why. A mesh that can be decimated must be there.
  /// O(edges).
  [[nodiscard]] std::vector<EntityRef> edges_refused_for(Reason reason);
  /// What the bar of a histogram counts: faces, edges or vertices, of a volume regions. Nothing may
  /// run, and a mesh must be there. O(entities).
  [[nodiscard]] std::vector<EntityRef> counted_in(const MarkedBar& bar);
  /// Of the highlighted model entity, while the page about it is up; null: none. As it was before a
  /// run.
  [[nodiscard]] const ModelEntityFacts* model_entity() const {
    return model_entity_ ? &*model_entity_ : nullptr;
  }
  /// Draws entities as what stands against something, or would come of it, until the mesh or the
  /// selection changes.
  void point_out(std::vector<EntityRef> entities);
  /// Which of the judgement's ways is drawn; their number: the swap.
  [[nodiscard]] std::size_t previewed_way() const;

 private:
  void take_loaded(Loader::Result result);
  void take_comparison(bool wait);
  void restore(const SavedWork& work);
  void come_to_rest();
  void advance_playing(double frame_s);
  void run_on(std::optional<std::chrono::microseconds> budget);
  void refresh_surface();
  void refresh_field(const Mesh& shown, SurfaceChanges& changes);
  void refresh_skin();
  [[nodiscard]] Shown shown() const;
  void refresh_selection(bool mesh_changed, bool cells_changed = false);
  void refresh_inspection(bool mesh_changed);
  void refresh_neighbours(bool anew);
  [[nodiscard]] const Judgement* previewed() const;
  void refresh_preview();
  void refresh_model_entity();
  /// The mesh is on its way: looking would be in the way of that.
  [[nodiscard]] bool busy() const { return document.running() || playing_; }
  /// The same as idle(), but for what the colours wait for.
  [[nodiscard]] bool at_rest() const {
    return !loading() && !busy() && !series_ && !comparison_ && !measurement_ &&
           !(verdicts_ && verdicts_->pending());
  }
  void refresh_verdicts(const SurfaceChanges& changes);
  void judge_edges();
  void forget_selection();
  void refresh_cells();
  void refresh_original();
  void take_measurement(bool wait);
  [[nodiscard]] const Mesh& reference_mesh();
  void refresh_marks(bool changed);
  [[nodiscard]] bool refresh_marked_cells();
  [[nodiscard]] std::optional<std::vector<EntityRef>> newly_marked(bool changed);

  Loader loader_;
  std::unique_ptr<Background<StrategyResult>> comparison_;
  std::optional<StrategyResult> strategies_;
  std::optional<PictureSeries> series_;
  bool playing_ = false;
  double steps_due_ = 0;
  ChangeReader changes_;
  FactsKeeper facts_;
  MeshFacts loaded_facts_;
  SurfaceDrawing drawing_;
  FieldKeeper fields_, original_fields_;
  HistogramKeeper histograms_;
  std::optional<MarkedBar> drawn_mark_;
  std::vector<EntityRef> marked_cells_;  ///< of a mesh that is drawn by its skin
  SurfaceDrawing original_drawing_;
  bool shows_original_ = false;
  std::pair<std::uint64_t, unsigned>
      drawn_original_;                  ///< mesh and reference that original_drawing_ has
  std::unique_ptr<BesideMesh> beside_;  ///< the reference, where it is a kept state
  unsigned beside_number_ = 0;
  std::unique_ptr<Background<std::vector<MeasuredRun>>> measurement_;
  double run_time_s_ = 0;               ///< of the run that goes on
  std::unique_ptr<SkinCutter> cutter_;  ///< of the present skin's mesh, once a plane was there
  std::optional<Skin>
      clipped_skin_;  ///< of the regions before the plane, where it takes whole ones
  std::optional<glm::dvec4> skin_plane_;
  std::optional<CellStyle> cells_;           ///< what is drawn of the inside; none: nothing
  std::vector<Region> cell_regions_;         ///< of each triangle of the drawing's cells
  std::optional<SkinSurface> skin_surface_;  ///< of the present skin, where there is one
  SkinStyle skin_style_;
  HistoryPlace skin_place_;
  std::optional<std::size_t> drawn_focus_;
  StepSides drawn_sides_;
  Picker picker_;
  std::optional<Hovered> hovered_;
  std::optional<VerdictField> verdicts_;
  DecimationOptions verdict_options_;
  bool was_busy_ = false;
  std::optional<std::chrono::microseconds>
      judging_budget_;  ///< of a frame; none: all at once, without a window
  std::string hovered_words_;
  EntityRef hovered_words_of_;
  std::optional<Judgement> hovered_judgement_;
  std::optional<Inspection> inspection_;
  std::optional<Judgement> judgement_;
  std::optional<Neighbours> neighbours_;
  std::optional<int> neighbours_level_;
  std::uint32_t seen_relations_ = 0;  ///< stored_bits() when inspection and neighbours were found
  DecimationOptions judged_options_;
  bool judged_busy_ = false;
  std::optional<std::pair<EntityRef, std::size_t>> drawn_preview_;  ///< of which entity, which way
  std::uint64_t inspected_selection_ = 0;
  std::uint64_t drawn_selection_ = 0;
  std::vector<EntityRef> pointed_out_;
  std::optional<ModelEntityFacts> model_entity_;
  HistoryPlace model_entity_place_;
  bool points_anew_ = false;
  EntityRef drawn_hover_;
};

}  // namespace aomd::scene
