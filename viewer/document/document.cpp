#include "viewer/document/document.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "core/decimate/spacing/spacing.h"
#include "core/mesh/journal_scope.h"
#include "viewer/document/saved_work.h"

namespace aomd::scene {

HistoryPlace Document::place() const {
  if (!loaded_) return {creations_, 0, 0, 0};
  const std::size_t last_cut = journal().epoch() == epoch_at_mark_ ? last_cut_ : mark_begin_;
  return {creations_, journal().epoch(), journal().cursor(), last_cut};
}

bool Document::unsaved() const {
  if (!loaded_ || loaded_->source.practice || journal().cursor() == 0) return false;
  return !tree_.saved_at(journal().cursor());
}

bool Document::would_be_missed() const {
  if (!unsaved()) return false;
  const bool sample = loaded_->file.empty() && !loaded_->source.data && saved_file_.empty();
  return !sample || std::any_of(marks_.begin(), marks_.end(), [&](const HistoryMark& mark) {
    return mark.begin < journal().cursor() && changes_classes(mark.label);
  });
}

void Document::mark_saved(std::filesystem::path file) {
  saved_file_ = std::move(file);
  tree_.set_saved(journal().cursor());
}

std::string_view Document::hindrance() const { return loaded_ ? loaded_->obstacle : ""; }

Column<Vertex, double> Document::wanted_lengths() const {
  if (options().spacing) return *options().spacing;
  prepare_lengths(*loaded_);
  if (options().coarsest || options().target_faces > 0 || loaded_->edge_lengths.size() == 0)
    return Column<Vertex, double>(mesh().capacity(0), std::numeric_limits<double>::infinity());
  Column<Vertex, double> lengths = loaded_->edge_lengths;
  for (std::uint32_t id = 0; id < lengths.size(); ++id) lengths[Vertex(id)] *= options().factor;
  return lengths;
}

const HistoryMark& Document::mark_of(std::size_t step) const {
  auto after = std::upper_bound(marks_.begin(), marks_.end(), step,
                                [](std::size_t s, const HistoryMark& m) { return s < m.begin; });
  return *(after - 1);
}

std::optional<std::size_t> Document::focus() const {
  if (!loaded_ || !focused_ || journal().cursor() == 0) return {};
  return journal().cursor() - 1;
}

Document::Document(DocumentOptions& options, std::unique_ptr<LoadedMesh> loaded)
    : loaded_(std::move(loaded)), options_(options) {
  if (!loaded_) return;
  loaded_->journal.keep_cut(true);
  skin_place_ = place();
  mark_saved({});
}

void Document::restore(const SavedWork& work) {
  prepare();
  marks_ = work.marks;
  options_.set(work.options);
  options_.classify = work.classify;
  options_.snaps = work.snaps;
  epoch_at_mark_ = journal().epoch();
  for (const auto& [name, step] : work.bookmarks) tree_.set_bookmark(name, step);
  move_to(work.cursor, false);
  if (!work.spacing.empty()) set_spacing(work.spacing);
  if (!work.model.empty()) set_model(work.model);
}

/// What it shows depends on which entities there are and on what they lie.
void Document::renew_skin() {
  if (!loaded_->skin || skin_place_ == place()) return;
  loaded_->skin.emplace(whole_skin(*loaded_));
  skin_place_ = place();
}

/// Relations that were asked for are told in panels, and sets for look-up too.
std::unique_ptr<LoadedMesh> Document::take_untouched() {
  if (!loaded_ || loaded_->file.empty() || loaded_->mesh.revision() != loaded_->revision)
    return nullptr;
  if (loaded_->prepared || loaded_->decimation || loaded_->model || loaded_->original || trial_ ||
      adjacency_change_)
    return nullptr;
  for (int dim = 1; dim <= 3; ++dim)
    if (loaded_->mesh.hash(dim).built()) return nullptr;
  return std::move(loaded_);
}

void Document::prepare() {
  if (!loaded_->volume()) prepare_lengths(*loaded_);
  if (loaded_->prepared || !loaded_->volume() || !hindrance().empty()) return;
  prepare_volume(*loaded_);
  as_loaded_.reset();
  ++creations_;
  skin_place_ = place();
}

const AdjacencyChange& Document::set_adjacency(int i, int j, bool on) {
  Mesh& mesh = loaded_->mesh;
  const auto entities = [&] { return std::array{mesh.count(1), mesh.count(2), mesh.count(3)}; };
  const auto before = entities();
  adjacency_change_ = change_adjacency(mesh, i, j, on);
  if (entities() != before) ++creations_;
  return *adjacency_change_;
}

void Document::build_hash(int level, std::uint32_t buckets) {
  loaded_->mesh.drop_hash(level);
  loaded_->mesh.build_hash(level, buckets);
}

/// Looks at the mesh as it is after a step and returns.
void Document::visit(std::size_t step, const std::function<void()>& look) {
  Mesh& mesh = loaded_->mesh;
  Journal& journal = loaded_->journal;
  const std::size_t cursor = journal.cursor();
  journal.seek(mesh, step);
  try {
    look();
  } catch (...) {
    journal.seek(mesh, cursor);
    throw;
  }
  journal.seek(mesh, cursor);
  stale_ = stale_ || (cursor != step && loaded_->decimation);
}

// Going there and back leaves all as it was: the decimation need not know.
AsLoaded& Document::copy_mesh_as_loaded() {
  const bool stale = stale_;
  if (!as_loaded_) visit(0, [&] { as_loaded_ = std::make_unique<AsLoaded>(loaded_->mesh); });
  stale_ = stale;
  return *as_loaded_;
}

/// What a strategy keeps to, and measures lengths by, is the mesh as loaded, not what another one
/// has left; but with the model edges that it was given before anything else was done.
void Document::begin_strategy() {
  stale_ = false;
  strategy_from_ = classified_start();
  visit(*strategy_from_, [&] {
    loaded_->decimation.reset();
    loaded_->decimation.emplace(loaded_->mesh, options_for_mesh());
  });
}

/// Tetrahedra always keep the topology, and the regions that stay are no part of the aim.
DecimationOptions Document::options_for_mesh() const {
  DecimationOptions options = this->options();
  if (!loaded_->volume()) return options;
  options.topology = TopologyRule::Safe;
  if (options.target_faces > 0) options.target_faces += loaded_->stays;
  return options;
}

/// The decimation, made at the first need and told what it has missed.
Decimation& Document::build_decimation() {
  prepare();
  const bool other = !decimation() || !keeps_to_original();
  const std::size_t start = classified_start();
  if (other || (stale_ && (journal().cursor() == start || strategy_from_ != start)))
    begin_strategy();
  DecimationOptions options = options_for_mesh();
  options.model = model_to_snap_to();
  if (stale_) loaded_->decimation->invalidate();
  stale_ = false;
  loaded_->decimation->set_options(options);
  return *loaded_->decimation;
}

/// The present decimation has what it takes from the mesh as loaded: it need not begin there again.
bool Document::keeps_to_original() const {
  const DecimationOptions& has = decimation()->options();
  const bool measures = options().max_distance <= 0 || has.max_distance == options().max_distance;
  return has.strategy == options().strategy && measures;
}

Decimation* Document::build_decimation_to_judge() {
  if (!loaded_ || !hindrance().empty()) return nullptr;
  try {
    return &build_decimation();
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

bool Document::answers_about(EntityRef e) const {
  if (!e.valid()) return false;
  const bool unprepared = loaded_->volume() && !loaded_->prepared;
  return e.dimension == 1 || (e.dimension == 0 && !unprepared);
}

bool Document::judges_at_once() const {
  if (!loaded_ || !hindrance().empty() || (loaded_->volume() && !loaded_->prepared)) return false;
  const bool ready = decimation() && !stale_ && keeps_to_original();
  return ready || options().strategy == Strategy::Paper;
}

void Document::set_spacing(const std::string& source) {
  cancel_run();
  const SpacingSource parsed = parse_spacing(source, options().factor);
  prepare();
  visit(0, [&] {
    options_.set_spacing(
        std::make_shared<const Column<Vertex, double>>(evaluate_spacing(loaded_->mesh, parsed)),
        source);
  });
}

void Document::open_mark(std::string label) {
  const std::size_t cursor = journal().cursor();
  if (journal().epoch() != epoch_at_mark_) last_cut_ = mark_begin_;
  mark_begin_ = cursor;
  const auto undone = std::find_if(marks_.begin(), marks_.end(),
                                   [&](const HistoryMark& m) { return m.begin >= cursor; });
  undone_marks_.assign(std::make_move_iterator(undone), std::make_move_iterator(marks_.end()));
  marks_.erase(undone, marks_.end());
  epoch_at_mark_ = journal().epoch();
  marks_.push_back({cursor, std::move(label)});
}

// A command that changed nothing leaves no mark, and what had been undone can still be redone.
std::size_t Document::close_mark() {
  const std::size_t made = journal().cursor() - marks_.back().begin;
  if (made == 0) marks_.pop_back();
  keep_cut();
  if (journal().epoch() == epoch_at_mark_ && made == 0)
    marks_.insert(marks_.end(), undone_marks_.begin(), undone_marks_.end());
  undone_marks_.clear();
  return made;
}

std::size_t Document::record(std::string label, const std::function<void()>& edit) {
  cancel_run();
  end_trial();
  prepare();
  focused_ = false;
  open_mark(std::move(label));
  try {
    edit();
  } catch (...) {
    close_mark();
    throw;
  }
  return close_mark();
}

/// An edit of the decimation: it may have to put the mesh back on its model first.
std::size_t Document::operate(std::string label, const std::function<void()>& edit) {
  if (snaps() && loaded_->model) fit_to(*loaded_->model);
  const std::size_t made = record(std::move(label), [&] {
    edit();
    note_sweeps();
  });
  note_last_work();
  return made;
}

void Document::restore_file_classes() {
  Mesh& mesh = loaded_->mesh;
  const JournalScope scope(mesh, StepKind::Classify, {});
  for (int dim = 0; dim < 3; ++dim) {
    const auto& classes = loaded_->file_classes[static_cast<std::size_t>(dim)];
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      const ModelRef wanted = id < classes.size() ? classes[id] : ModelRef();
      if (mesh.alive({dim, id}) && mesh.classification({dim, id}) != wanted)
        mesh.set_classification({dim, id}, wanted);
    }
  }
}

void Document::reclassify(const ClassifyOptions& options) {
  options_.classify = options;
  if (!loaded_) return;
  record("classify", [&] {
    ClassifyOptions each = options;
    each.seams = std::move(loaded_->classify_options.seams);
    each.keep_present = loaded_->classified_by_file();
    if (each.keep_present) restore_file_classes();
    loaded_->classified = classify(loaded_->mesh, each);
    loaded_->classify_options = options;
    loaded_->classify_options.seams = std::move(each.seams);
    forget_fits();
    stale_ = loaded_->decimation.has_value();
  });
}

std::size_t Document::step(std::size_t count) {
  const std::size_t made = operate("step", [&] {
    Decimation& decimation = build_decimation();
    for (std::size_t i = 0; i < count && decimation.step(); ++i) {
    }
  });
  focused_ = made > 0;
  return made;
}

std::size_t Document::sweep(std::size_t count) {
  return operate("sweep", [&] {
    Decimation& decimation = build_decimation();
    for (std::size_t i = 0; i < count; ++i) decimation.sweep();
  });
}

std::size_t Document::swap() {
  return operate("swap", [&] { build_decimation().swap_pass(); });
}

std::size_t Document::smooth() {
  return operate("smooth", [&] { build_decimation().smooth_pass(); });
}

std::size_t Document::improve() {
  return operate("improve", [&] { build_decimation().improve(); });
}

void Document::start_run() {
  cancel_run();
  if (snaps() && loaded_->model) fit_to(*loaded_->model);
  Decimation& decimation = build_decimation();
  if (decimation.done()) return;
  end_trial();
  open_mark("run");
  first_sweep_of_run_ = decimation.sweeps().size();
  running_ = true;
  focused_ = false;
}

void Document::cancel_run() { end_run(); }

/// Returns how many operations it made.
std::size_t Document::end_run() {
  if (!running_) return 0;
  running_ = false;
  note_sweeps();
  const std::size_t made = close_mark();
  note_last_work();
  return made;
}

double Document::run_progress() const {
  if (!decimation()) return 0;
  if (decimation()->done()) return 1;
  if (decimation()->options().strategy == Strategy::Quality) return decimation()->progress();
  // The paper's loop counts the sweeps of its whole life.
  const double left = 1 - decimation()->progress();
  return 1 - left * std::pow(2.0, static_cast<double>(first_sweep_of_run_) - 1);
}

void Document::tick(std::optional<std::chrono::microseconds> budget) {
  if (!running_) return;
  const Decimation::Stop stop = build_decimation().run(budget);
  keep_cut();
  if (stop == Decimation::Stop::Done) note_stop(end_run());
}

void Document::move_to(std::size_t step, bool single) {
  cancel_run();
  const std::size_t before = journal().cursor();
  loaded_->journal.seek(loaded_->mesh, step);
  if (strategy_from_ && step < *strategy_from_) strategy_from_.reset();
  stale_ = stale_ || (journal().cursor() != before && loaded_->decimation);
  focused_ = single;
  if (journal().cursor() != before) end_trial();
}

bool Document::undo() {
  if (!can_undo()) return false;
  cancel_run();
  move_to(mark_of(journal().cursor() - 1).begin, false);
  return true;
}

bool Document::redo() {
  if (!can_redo()) return false;
  cancel_run();
  const auto next = std::find_if(marks_.begin(), marks_.end(), [&](const HistoryMark& m) {
    return m.begin > journal().cursor();
  });
  move_to(next == marks_.end() ? journal().size() : next->begin, false);
  return true;
}

void Document::seek(std::size_t step) {
  if (loaded_) move_to(std::min(step, journal().size()), true);
}

}  // namespace aomd::scene
