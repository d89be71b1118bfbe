#pragma once
// All of the viewer's state that is not on the GPU: the sheet, how it is looked at, what is under
// way, and what is to be said.

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/document/loader.h"
#include "viewer/document/recovery.h"
#include "viewer/document/spare_mesh.h"
#include "viewer/drawing/picture_series.h"
#include "viewer/drawing/view.h"
#include "viewer/lessons/lesson_player.h"
#include "viewer/session/clipboard.h"
#include "viewer/session/seen_files.h"
#include "viewer/session/sheet.h"

namespace aomd::scene {

/// What belongs to a window, whatever mesh is there. Changed by commands (see commands.h) and by
/// tick() alone.
class Session {
 public:
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  DocumentOptions options;
  View view;
  std::deque<ScreenshotRequest> screenshots;  ///< whoever draws fulfils them
  /// Brings the shape of the picture in `view` up to what is shown, before each line: of whoever
  /// draws.
  std::function<void()> keep_shape;
  std::string status;                 ///< one line: what the last command did
  std::string error;                  ///< stays until it is dismissed
  std::vector<std::string> warnings;  ///< what a user is to be told, whatever was asked for
  std::optional<std::string> log;     ///< for standard output, once
  bool quit = false;
  Clipboard clipboard;
  std::string asked;                     ///< the line that waits for an answer about unsaved work
  std::optional<std::string> next_line;  ///< to be carried out after the present one
  LessonPlayer lesson;
  std::uint64_t executed = 0;                ///< how many commands were carried out
  std::unique_ptr<RecoveryKeeper> recovery;  ///< null: unsaved work is not kept
  FoundWork found_work;                      ///< of programs that died
  SpareMesh* spare = nullptr;                ///< instead of reading a file once more; null: none

  /// The present mesh with all that belongs to it. Another one after each load.
  [[nodiscard]] Sheet& sheet() { return *sheet_; }
  [[nodiscard]] const Sheet& sheet() const { return *sheet_; }
  [[nodiscard]] Document& document() { return sheet_->document; }
  [[nodiscard]] const Document& document() const { return sheet_->document; }
  /// True once after each load.
  [[nodiscard]] bool take_arrival() { return std::exchange(arrived_, false); }

  void start_loading(LoadRequest request);
  void cancel_loading();
  [[nodiscard]] bool loading() const { return loader_.busy(); }
  [[nodiscard]] const std::string& loading_name() const { return loader_.name(); }
  /// Ends the present sheet and starts one with this mesh.
  void show(std::unique_ptr<LoadedMesh> loaded);
  /// What the picture was seen from before the camera jumped, newest first; another mesh begins
  /// without. `jump` leads to one of them, whose place the present camera takes.
  [[nodiscard]] const std::deque<Camera>& cameras_before() const { return cameras_before_; }
  void note_jump();
  void jump_back(std::size_t which);
  /// Where the present file is seen from, for when it is opened again.
  void remember_camera();
  /// Whether the present file is looked at, and is to be read again once it changes.
  void watch(bool on);
  [[nodiscard]] bool watching() const { return watching_; }
  /// The program itself has written that file.
  void note_written(const std::filesystem::path& file) { watch_.note_written(file); }
  /// The line that reads the watched file again, once it has changed; else empty. Where that would
  /// lose unsaved work it warns instead.
  [[nodiscard]] std::string look_at_file(FileWatch::Clock::time_point now);
  /// Puts back options and view as they were before the lesson, and loads what was there; another
  /// file's mesh may be there already.
  void leave_lesson(bool reload);

  /// Nothing is loaded, running, played, exported, measured or judged.
  [[nodiscard]] bool idle() const {
    return undisturbed() && sheet_->at_rest() && sheet_->coloured();
  }
  void play(bool on);
  /// What lies under a place of the picture (-1..1), or in a rectangle, once the drawing is up to
  /// date. A mesh must be there.
  [[nodiscard]] EntityRef pick(glm::dvec2 ndc);
  [[nodiscard]] std::vector<EntityRef> pick(glm::dvec2 low, glm::dvec2 high);
  /// The mouse points there; none: at nothing.
  void hover(std::optional<glm::dvec2> ndc);

  // What takes its time on the present sheet, and says so (session_work.cpp). Starting one ends a
  // run and playing.
  /// Measures the paper's two ways to store adjacencies; the mesh can be decimated.
  void start_comparison();
  void cancel_comparison();
  /// Keeps the present state; without a name it gets one, or keeps the one that it has. The mesh
  /// can be decimated.
  void keep_run(const std::string& name);
  /// Measures how far kept states are from the mesh as loaded, where that is not known yet.
  void start_measuring();
  void cancel_measuring();
  /// A mesh must be there.
  void start_series(PictureSeries::Kind kind, const std::filesystem::path& folder, int count,
                    std::optional<glm::ivec2> size);
  /// The series of pictures that is being made; null: none.
  [[nodiscard]] const PictureSeries* series() const { return series_ ? &*series_ : nullptr; }
  /// Asks for its next picture once the one before has been taken.
  void advance_series();
  /// Puts back what it changed; the pictures that are made stay.
  void cancel_series();

  /// Keeps unsaved work in a folder from now on, and looks for what others have left there.
  void keep_work(const std::filesystem::path& folder);
  /// Has unsaved work written where that is due. Cheap where nothing has changed.
  void keep();

  /// What goes on by itself, for a frame of `frame_s` seconds: loading, a run (about `budget`),
  /// playing.
  void tick(std::chrono::microseconds budget, double frame_s);
  /// Ticks until nothing is loaded, running or played. Throws what loading threw.
  void finish();
  /// Brings the sheet's facts and drawings up to date. O(what changed).
  void refresh() { sheet_->refresh(undisturbed(), budget_); }

 private:
  [[nodiscard]] bool undisturbed() const { return !loading() && !series_; }
  void take_loaded(Loader::Result result);
  void look_from_where_it_was_seen();
  void restore(const SavedWork& work);
  void come_to_rest();
  void run_on(std::optional<std::chrono::microseconds> budget);
  void take_results(bool wait);

  Loader loader_;
  std::unique_ptr<Sheet> sheet_ = std::make_unique<Sheet>(options, view);
  bool arrived_ = false;
  SeenFiles seen_;
  std::deque<Camera> cameras_before_;
  bool watching_ = false;
  FileWatch watch_;
  std::optional<PictureSeries> series_;
  double run_time_s_ = 0;                            ///< of the run that goes on
  std::optional<std::chrono::microseconds> budget_;  ///< of a frame; none: all at once
};

}  // namespace aomd::scene
