#pragma once
// All of the viewer's state that is not on the GPU: document, view, what is under way, and what is to be
// said.

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/scene/cell_drawing.h"
#include "viewer/scene/clipboard.h"
#include "viewer/scene/document.h"
#include "viewer/scene/field_keeper.h"
#include "viewer/scene/histogram_keeper.h"
#include "viewer/scene/loader.h"
#include "viewer/scene/mesh_facts.h"
#include "viewer/scene/picture_series.h"
#include "viewer/scene/recovery.h"
#include "viewer/scene/skin_surface.h"
#include "viewer/scene/surface_drawing.h"
#include "viewer/scene/view.h"

namespace aomd::scene {

/// Changed by commands (see commands.h) and by tick() alone.
class Session {
 public:
  Document document;
  View view;
  std::deque<ScreenshotRequest> screenshots;  ///< whoever draws fulfils them
  std::string status;                         ///< one line: what the last command did
  std::string error;                          ///< stays until it is dismissed
  std::optional<std::string> log;             ///< for standard output, once
  bool quit = false;
  Clipboard clipboard;
  std::string asked;                         ///< the line that waits for an answer about unsaved work
  std::optional<std::string> next_line;      ///< to be carried out after the present one
  std::unique_ptr<RecoveryKeeper> recovery;  ///< null: unsaved work is not kept
  std::vector<std::shared_ptr<const SavedWork>> found_work;  ///< of programs that died, newest first

  void start_loading(LoadRequest request);
  void cancel_loading();
  [[nodiscard]] bool loading() const { return loader_.busy(); }
  [[nodiscard]] const std::string& loading_name() const { return loader_.name(); }

  void play(bool on);
  [[nodiscard]] bool playing() const { return playing_; }
  /// Nothing is loaded, running, played or exported.
  [[nodiscard]] bool idle() const { return !loading() && !document.running() && !playing_ && !series_; }

  /// Keeps unsaved work in a folder from now on, and looks for what others have left there.
  void keep_work(const std::filesystem::path& folder);

  /// A mesh must be there. Ends a run.
  void start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                    std::optional<glm::ivec2> size);
  /// The series of pictures that is being made; null: none.
  [[nodiscard]] const PictureSeries* series() const { return series_ ? &*series_ : nullptr; }
  /// Asks for its next picture once the one before has been taken.
  void advance_series();
  /// Puts back what it changed; the pictures that are made stay.
  void cancel_series();

  /// What goes on by itself, for a frame of `frame_s` seconds: loading, a run (about `budget`), playing.
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
  /// The mesh as loaded, in the same colours; null where it is not shown.
  [[nodiscard]] SurfaceDrawing* original_drawing() { return shows_original_ ? &original_drawing_ : nullptr; }
  [[nodiscard]] bool shows_original() const { return shows_original_; }

 private:
  void take_loaded(Loader::Result result);
  void restore(const SavedWork& work);
  void keep();
  void advance_playing(double frame_s);
  void run_on(std::optional<std::chrono::microseconds> budget);
  void refresh_surface();
  void refresh_field(const Mesh& shown, SurfaceChanges& changes);
  void refresh_skin();
  void refresh_cells();
  void refresh_original();
  void refresh_marks(bool changed);

  Loader loader_;
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
  SurfaceDrawing original_drawing_;
  bool shows_original_ = false;
  std::uint64_t original_generation_ = 0;  ///< of the mesh that original_drawing_ has; 0: none
  std::unique_ptr<SkinCutter> cutter_;     ///< of the present skin's mesh, once a plane was there
  std::optional<Skin> clipped_skin_;       ///< of the regions before the plane, where it takes whole ones
  std::optional<glm::dvec4> skin_plane_;
  std::optional<CellStyle> cells_;           ///< what is drawn of the inside; none: nothing
  std::optional<SkinSurface> skin_surface_;  ///< of the present skin, where there is one
  SkinStyle skin_style_;
  HistoryPlace skin_place_;
  std::optional<std::size_t> drawn_focus_;
};

}  // namespace aomd::scene
