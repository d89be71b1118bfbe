#pragma once
// All of the viewer's state that is not on the GPU: document, view, what is under way, and what is to be
// said.

#include <deque>
#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "viewer/scene/document.h"
#include "viewer/scene/inspection.h"
#include "viewer/scene/loader.h"
#include "viewer/scene/mesh_facts.h"
#include "viewer/scene/picking.h"
#include "viewer/scene/selection.h"
#include "viewer/scene/skin_surface.h"
#include "viewer/scene/surface_drawing.h"
#include "viewer/scene/verdict_field.h"
#include "viewer/scene/vertex_field.h"
#include "viewer/scene/view.h"

namespace aomd::scene {

struct ScreenshotRequest {
  std::filesystem::path file;
  std::optional<glm::ivec2> size;  ///< in pixels; none: as large as the window
};

/// Changed by commands (see commands.h) and by tick() alone.
class Session {
 public:
  Document document;
  View view;
  Selection selection;
  std::deque<ScreenshotRequest> screenshots;  ///< whoever draws fulfils them
  std::string status;                         ///< one line: what the last command did
  std::string error;                          ///< stays until it is dismissed
  std::optional<std::string> log;             ///< for standard output, once
  bool quit = false;

  void start_loading(LoadRequest request);
  void cancel_loading();
  [[nodiscard]] bool loading() const { return loader_.busy(); }
  [[nodiscard]] const std::string& loading_name() const { return loader_.name(); }

  void play(bool on);
  [[nodiscard]] bool playing() const { return playing_; }
  /// Nothing is loaded, running or played.
  [[nodiscard]] bool idle() const {
    return !loading() && !document.running() && !playing_ && !(verdicts_ && verdicts_->pending());
  }

  /// What goes on by itself, for a frame of `frame_s` seconds: loading, a run (about `budget`), playing.
  void tick(std::chrono::microseconds budget, double frame_s);
  /// The same until idle() is true. Throws what loading threw.
  void finish();

  /// Brings facts and drawing up to date. O(what changed).
  void refresh();
  [[nodiscard]] const MeshFacts& facts() const { return facts_.facts(); }
  /// The facts right after loading.
  [[nodiscard]] const MeshFacts& loaded_facts() const { return loaded_facts_; }
  /// What the surface's colours show besides classification; null where they show none.
  [[nodiscard]] const VertexField* field() const { return field_ ? &*field_ : nullptr; }
  [[nodiscard]] SurfaceDrawing& drawing() { return drawing_; }

  // What lies under a place of the picture (-1..1), or in a rectangle (session_picking.cpp). A mesh must be
  // there.
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
  [[nodiscard]] const Inspection* inspection() const { return inspection_ ? &*inspection_ : nullptr; }
  /// What decimation says about it; null where nothing, and while it runs.
  [[nodiscard]] const Judgement* judgement() const { return judgement_ ? &*judgement_ : nullptr; }
  /// What is said about every edge, while the colours show it; else null (session_verdicts.cpp).
  [[nodiscard]] const VerdictField* verdicts() const { return verdicts_ ? &*verdicts_ : nullptr; }
  /// The edges that would be refused now, and why. A mesh that can be decimated must be there. O(edges).
  [[nodiscard]] std::vector<EntityRef> edges_refused_for(Reason reason);
  /// The way of the judgement that is drawn.
  [[nodiscard]] std::size_t previewed_way() const;

 private:
  void take_loaded(Loader::Result result);
  void advance_playing(double frame_s);
  void run_on(std::optional<std::chrono::microseconds> budget);
  void refresh_surface();
  void refresh_field(bool anew);
  void refresh_skin();
  [[nodiscard]] Shown shown() const;
  void refresh_selection(bool mesh_changed);
  void refresh_inspection(bool mesh_changed);
  void refresh_preview();
  /// The mesh is on its way: looking would be in the way of that.
  [[nodiscard]] bool busy() const { return document.running() || playing_; }
  void refresh_verdicts(const SurfaceChanges& changes);
  void judge_edges();
  void forget_selection();

  Loader loader_;
  bool playing_ = false;
  double steps_due_ = 0;
  ChangeReader changes_;
  FactsKeeper facts_;
  MeshFacts loaded_facts_;
  SurfaceDrawing drawing_;
  std::optional<VertexField> field_;
  DecimationOptions field_options_;
  std::optional<SkinSurface> skin_surface_;  ///< of the present skin, where there is one
  SkinStyle skin_style_;
  HistoryPlace skin_place_;
  std::optional<std::size_t> drawn_focus_;
  Picker picker_;
  std::optional<Hovered> hovered_;
  std::optional<VerdictField> verdicts_;
  DecimationOptions verdict_options_;
  bool was_busy_ = false;
  std::optional<std::chrono::microseconds>
      judging_budget_;  ///< of a frame; none: all at once, without a window
  std::string hovered_words_;
  EntityRef hovered_words_of_;
  std::optional<Inspection> inspection_;
  std::optional<Judgement> judgement_;
  DecimationOptions judged_options_;
  bool judged_busy_ = false;
  std::optional<std::size_t> drawn_way_;
  std::uint64_t inspected_selection_ = 0;
  std::uint64_t drawn_selection_ = 0;
  EntityRef drawn_hover_;
};

}  // namespace aomd::scene
