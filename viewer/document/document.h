#pragma once
// The present mesh, its history and its decimation. Only commands change it; panels read it.

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/class_rules.h"
#include "viewer/document/adjacency.h"
#include "viewer/document/as_loaded.h"
#include "viewer/document/document_options.h"
#include "viewer/document/feature_trial.h"
#include "viewer/document/history_tree.h"
#include "viewer/document/loaded_mesh.h"
#include "viewer/document/surface_changes.h"

namespace aomd::scene {

/// Whether a command with that label changes the classification and nothing else.
[[nodiscard]] bool changes_classes(std::string_view label);

/// What an edit of the classification would change; see core/model/class_edits.h.
using ClassEdit = std::function<ClassOverlay(const Mesh&, double corner_angle_deg)>;

/// Of one mesh, or without any. A run goes on from tick to tick; every other member that moves the
/// history ends it first.
class Document {
 public:
  /// Reads and sets these options. Without a mesh where `loaded` is null.
  Document(DocumentOptions& options, std::unique_ptr<LoadedMesh> loaded);
  [[nodiscard]] bool empty() const { return !loaded_; }
  [[nodiscard]] const LoadedMesh& content() const { return *loaded_; }
  [[nodiscard]] const Mesh& mesh() const { return loaded_->mesh; }
  [[nodiscard]] const Journal& journal() const { return loaded_->journal; }
  /// Null until the first operation asked for it.
  [[nodiscard]] const Decimation* decimation() const {
    return loaded_ && loaded_->decimation ? &*loaded_->decimation : nullptr;
  }
  [[nodiscard]] const DecimationOptions& options() const { return options_.decimation(); }
  [[nodiscard]] std::uint64_t options_revision() const { return options_.revision(); }
  [[nodiscard]] std::string_view spacing_source() const { return options_.spacing_source(); }
  [[nodiscard]] const ClassifyOptions& classify_options() const { return options_.classify; }
  /// Whether smoothing keeps vertices on the model: the given one, or else the faceted original.
  [[nodiscard]] bool snaps() const { return options_.snaps; }
  /// The CAD model of the present mesh; null where none was given.
  [[nodiscard]] const GivenModel* model() const {
    return loaded_ && loaded_->model ? &*loaded_->model : nullptr;
  }
  /// Whether the present classification is known to be on it.
  [[nodiscard]] bool lies_on_model() const;
  /// Whether the mesh differs from the one that was loaded or saved last. A mesh that was changed
  /// and changed back by new operations differs. One of a lesson never does.
  [[nodiscard]] bool unsaved() const;
  /// Whether somebody would miss that: what runs have made of a sample can be made again at once,
  /// as long as nothing was classified by hand and nothing of it is in a file.
  [[nodiscard]] bool would_be_missed() const;
  /// Where the present mesh was saved last; empty where it was not.
  [[nodiscard]] const std::filesystem::path& saved_file() const { return saved_file_; }
  /// Why the present mesh cannot be decimated, as a sentence; empty where it can.
  [[nodiscard]] std::string_view hindrance() const;
  /// How long the present options want the edges at each vertex to be, also at those that are gone;
  /// infinite without a limit, where a number of faces decides, where the mesh cannot be decimated,
  /// or is a volume that is not prepared; 0 at a vertex that has no edges as loaded. A mesh must be
  /// there.
  [[nodiscard]] Column<Vertex, double> wanted_lengths() const;
  [[nodiscard]] HistoryPlace place() const;
  [[nodiscard]] const std::vector<HistoryMark>& marks() const { return marks_; }
  [[nodiscard]] bool can_undo() const { return loaded_ && journal().cursor() > 0; }
  [[nodiscard]] bool can_redo() const { return loaded_ && journal().cursor() < journal().size(); }
  /// Other ways on from places of the history, and named places.
  [[nodiscard]] const HistoryTree& tree() const { return tree_; }
  /// The command that the step belongs to. step < journal().size().
  [[nodiscard]] const HistoryMark& mark_of(std::size_t step) const;
  /// The step to point at: the last one applied, when the history was last moved step by step.
  [[nodiscard]] std::optional<std::size_t> focus() const;
  // What was counted on the way to the present place (document_sweeps.cpp).
  /// By the last sweep that counted something before it; null: there was none.
  [[nodiscard]] const SweepStatistics* last_sweep() const;
  /// Why the run that ended here stopped, as a sentence; empty where none did.
  [[nodiscard]] std::string_view stop() const;

  /// What the last set_adjacency() on the present mesh came to; null before.
  [[nodiscard]] const AdjacencyChange* last_adjacency_change() const {
    return adjacency_change_ ? &*adjacency_change_ : nullptr;
  }
  /// The present mesh at the start of its history, made at the first need: O(steps + entities), and
  /// where steps are applied nothing may be running. A mesh must be there.
  [[nodiscard]] AsLoaded& copy_mesh_as_loaded();
  /// Whether that copy can be had now.
  [[nodiscard]] bool can_look_back() const { return as_loaded_ || !running_; }
  /// Takes over what had been done to the present mesh, which has just been loaded with that
  /// history, and what had been set. Throws as set_spacing and set_model, in the end: all else is
  /// then restored.
  void restore(const SavedWork& work);
  /// The mesh as it is now is in that file.
  void mark_saved(std::filesystem::path file);
  /// Keeps what has been done; cheap while nothing runs.
  void set_options(const DecimationOptions& options) { options_.set(options); }
  /// Lengths for the mesh as loaded, which must be there; another mesh drops them. Throws as
  /// parse_spacing and evaluate_spacing; the options are then as before.
  void set_spacing(const std::string& source);
  /// For the next mesh that is loaded; reclassify() for the present one.
  void set_classify_options(const ClassifyOptions& options) { options_.classify = options; }
  /// Derives the classification anew; what the file says still wins. One command in the history. A
  /// volume gets all its faces and edges.
  void reclassify(const ClassifyOptions& options);
  /// Edits it by hand where no rule is broken: one command in the history. A surface of triangles
  /// must be there. Ends a run. (document_classes.cpp)
  ClassVerdict edit_classes(std::string label, const ClassEdit& edit);
  /// What a feature angle would lead to; a surface of triangles must be there. Ends a run.
  /// O(entities).
  const FeatureTrial& try_feature_angle(double angle_deg);
  void end_trial() { trial_.reset(); }
  /// The angle that is being tried out, until the mesh changes; null: none.
  [[nodiscard]] const FeatureTrial* trial() const { return trial_ ? &*trial_ : nullptr; }

  /// For the next smoothing, and for meshes to come. Ends a run.
  void set_snapping(bool on);
  /// Reads a CAD file for the present mesh, which must be there, and classifies the mesh on it
  /// where no file says what it lies on: one command in the history. Blocks while it reads. Throws
  /// ModelError, which names the file, where it cannot be read or does not fit; everything is then
  /// as before.
  void set_model(const std::filesystem::path& file);
  void drop_model();

  /// Stores a relation until it is unset, or lets go of it. No part of the history. A mesh must be
  /// there.
  const AdjacencyChange& set_adjacency(int i, int j, bool on);

  /// Builds the hash set of level 1, 2 or 3 anew, starting with about so many buckets (0: one for
  /// each entity), or lets go of it. No part of the history. A mesh must be there. O(entities).
  void build_hash(int level, std::uint32_t buckets);
  void drop_hash(int level) { loaded_->mesh.drop_hash(level); }

  // Each is one command in the history and returns how many operations it made.
  std::size_t step(std::size_t count);
  std::size_t sweep(std::size_t count);
  std::size_t swap();
  std::size_t smooth();
  std::size_t improve();

  /// The decimation as it would go on now, for asking what it says about an edge; made where it is
  /// not there yet, which takes the quality strategy a second for a million faces. Null where the
  /// mesh cannot be decimated, or not with these options. Changes neither mesh nor history, but
  /// prepares a volume.
  [[nodiscard]] Decimation* build_decimation_to_judge();
  /// Whether questions about an entity are answered: about edges and vertices. Of a volume that is
  /// not prepared, about edges alone, for which it is prepared: a vertex changes no T(I,J).
  [[nodiscard]] bool answers_about(EntityRef e) const;
  /// Whether build_decimation_to_judge() costs next to nothing.
  [[nodiscard]] bool judges_at_once() const;
  /// Before the first operation, or the first question about one: prepare_lengths() and, for
  /// tetrahedra, prepare_volume(), once.
  void prepare();
  /// The mesh, where nothing has been done to it since its file was read: the document is then
  /// without one, and must go before it. Else null, and it stays.
  [[nodiscard]] std::unique_ptr<LoadedMesh> take_untouched();
  /// Brings the skin, where there is one, up to the mesh. O(size) where that has changed.
  void renew_skin();

  void start_run();
  void cancel_run();
  [[nodiscard]] bool running() const { return running_; }
  /// Of the present or the last run, 0..1.
  [[nodiscard]] double run_progress() const;
  /// Goes on with a run for about `budget`; without one until it is done.
  void tick(std::optional<std::chrono::microseconds> budget);

  // By whole commands; false at the end of the history.
  bool undo();
  bool redo();
  /// Until `step` steps are applied (clamped).
  void seek(std::size_t step);

  // Branches and bookmarks (document_branches.cpp). A mesh must be there.
  /// Back to where the branch leaves the present one, and forward to its end: what was ahead
  /// becomes a branch in its stead. False where there is no such branch. O(steps in between).
  bool switch_branch(unsigned id);
  /// Forgets a branch and those that leave it. Returns how many there were.
  std::size_t remove_branch(unsigned id) { return tree_.remove(id); }
  /// The present place gets a name; another place with this name loses it.
  void set_bookmark(const std::string& name) { tree_.set_bookmark(name, journal().cursor()); }
  bool remove_bookmark(const std::string& name) { return tree_.remove_bookmark(name); }
  /// Goes to the place of this name, on whichever branch it is. False where there is none.
  bool go_to_bookmark(const std::string& name);
  /// Places with a number instead of a name: see HistoryTree.
  void set_place(unsigned number) { tree_.set_place(number, journal().cursor()); }
  void forget_place(unsigned number) { tree_.forget_place(number); }
  bool go_to_place(unsigned number);

 private:
  Decimation& build_decimation();
  [[nodiscard]] bool keeps_to_original() const;
  [[nodiscard]] DecimationOptions options_for_mesh() const;
  void begin_strategy();
  void visit(std::size_t step, const std::function<void()>& look);
  std::size_t operate(std::string label, const std::function<void()>& edit);
  [[nodiscard]] std::size_t classified_at() const;
  [[nodiscard]] std::size_t classified_start() const;
  void fit_to(GivenModel& given);
  const Model* model_to_snap_to();
  void make_original();
  void forget_fits();
  void let_go_of_models();
  std::size_t record(std::string label, const std::function<void()>& edit);
  void open_mark(std::string label);
  std::size_t close_mark();
  void restore_file_classes();
  void move_to(std::size_t step, bool single);
  std::size_t end_run();
  void note_sweeps();
  void note_last_work();
  void note_stop(std::size_t made);
  void keep_cut();
  void exchange(unsigned id);
  void go_to(TreePlace place, bool single);

  std::unique_ptr<LoadedMesh> loaded_;
  std::unique_ptr<AsLoaded> as_loaded_;
  std::optional<FeatureTrial> trial_;  ///< holds on to the mesh
  /// The step whose mesh the decimation keeps to; none once the history has been before it.
  std::optional<std::size_t> strategy_from_;
  DocumentOptions& options_;
  std::vector<HistoryMark> marks_;
  std::vector<HistoryMark>
      undone_marks_;  ///< cut off by the open mark; back where it comes to nothing
  /// Where the last command began, which cut there if the epoch has changed since.
  std::size_t mark_begin_ = 0;
  std::uint64_t epoch_at_mark_ = 0;
  std::uint64_t creations_ = 0;
  HistoryPlace skin_place_;   ///< of the mesh that the skin is of
  std::size_t last_cut_ = 0;  ///< by the commands before the last
  bool running_ = false;
  bool stale_ = false;  ///< the decimation does not know yet that the history was moved
  bool focused_ = false;
  std::size_t first_sweep_of_run_ = 0;
  std::optional<AdjacencyChange> adjacency_change_;
  /// What the decimation counted last, and where: also where it changed nothing.
  struct LastWork {
    HistoryPlace place;
    std::optional<SweepStatistics> sweep;
    std::string stop;
  };
  LastWork last_work_;
  std::filesystem::path saved_file_;
  HistoryTree tree_;
};

}  // namespace aomd::scene
