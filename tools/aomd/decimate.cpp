// aomd decimate: read, classify, decimate, check, write, report.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/decimate/error_search.h"
#include "core/fields/seams.h"
#include "core/io/journal_file.h"
#include "core/io/left_out.h"
#include "core/io/output_files.h"
#include "core/measure/distance.h"
#include "core/mesh/extent.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/facets.h"
#include "core/model/gmsh_model.h"
#include "core/model/mesh_on_model.h"
#include "tools/aomd/attribute_weights.h"
#include "tools/aomd/block_input.h"
#include "tools/aomd/command.h"
#include "tools/aomd/compare_arguments.h"
#include "tools/aomd/decimate_batch.h"
#include "tools/aomd/decimate_input.h"
#include "tools/aomd/decimate_report.h"
#include "tools/aomd/given_classes.h"
#include "tools/aomd/given_mesh.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/keep_file.h"
#include "tools/aomd/letting_go.h"
#include "tools/aomd/missed_target.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/result_check.h"
#include "tools/aomd/surface_lines.h"

namespace aomd::cli {
namespace {

constexpr const char* about = "Makes a mesh coarser and writes it";

void leave_as_it_is(DecimationOptions& steps) {
  steps.target_faces = no_index;
  steps.swap = steps.smooth = false;
}

/// The files of a run whose mesh, the first of them, is in memory.
std::vector<NamedFile> beside_mesh(std::vector<NamedFile> files) {
  files.erase(files.begin());
  return files;
}

/// One run, stage by stage; each fills its part of the report.
class Run {
 public:
  /// With a listener the mesh is in memory.
  Run(const DecimateOptions& options, Exchange& exchange, const Listener* listener = nullptr)
      : options_(options),
        exchange_(exchange),
        listener_(listener),
        progress_(listener ? Progress(listener->progress)
                           : Progress(options.quiet || options.one_of_several)),
        steps_(options.for_library()),
        asked_(options.for_classification()),
        given_(options),
        check_(options, given_, steps_.threads) {}

  int run() {
    format_ = format_of_output(options_.output, options_.format);
    options_.check_spacing();
    std::vector<NamedFile> inputs = options_.inputs(),
                           outputs = piece_files(options_.output, format_, options_.pieces);
    for (NamedFile& piece : named_pieces(options_.input)) inputs.push_back(std::move(piece));
    for (NamedFile& file : options_.outputs()) outputs.push_back(std::move(file));
    check_files(inputs, outputs);
    if (exchange_.rank() > 0) return help();
    read();
    meet_target();
    check();
    write();
    progress_.wipe();
    print_summary();
    return did_.missed && options_.strict ? says_no : done;
  }

  /// The same without files for the meshes.
  Decimated run(const MeshData& mesh) {
    options_.check_spacing();
    check_files(beside_mesh(options_.inputs()), beside_mesh(options_.outputs()));
    given_.take(mesh);
    prepare();
    meet_target();
    check();
    write();
    note_target();
    return {std::move(result_), std::move(report_), did_.missed ? missed_words() : std::string()};
  }

 private:
  // Of one that is not the first of those who share the blocks.
  int help() {
    if (options_.blocks > 1) static_cast<void>(read_in_blocks(options_, exchange_, progress_));
    return done;
  }

  // All notes of a run pass here: to whoever listens, else to standard error.
  void print_notes(const std::string& file, const std::vector<std::string>& notes) const {
    if (listener_ == nullptr) return cli::print_notes(file, notes);
    for (const std::string& note : notes) listener_->note(note);
  }

  void read() {
    note(options_.input, given_.read(exchange_, progress_));
    if (given_.in_blocks()) lap("blocks");
    did_.in_blocks = given_.in_blocks();
    prepare();
  }

  void prepare() {
    lap("read");
    if (options_.triangulate) note(options_.input, cut_quads(given_.own()));
    if (options_.split_to_tets) note(options_.input, cut_regions(given_.own()));
    if (options_.repair) repair_mesh();
    mesh_ = Mesh(given());
    check_decimable(mesh_, options_.input);
    options_.check_kind(volume());
    if (volume() && steps_.exchange)
      note(options_.input, {"--exchange changes nothing: a volume keeps T(0,3) throughout"});
    count_cells();
    if (!options_.model.empty()) model_ = load_gmsh_model(options_.model);
    diagonal_ = diagonal_of(given());
    if (volume()) given_.forget_regions();
    lap("read");
  }

  [[nodiscard]] const MeshData& given() const { return given_.mesh(); }
  [[nodiscard]] bool volume() const { return given_.is_volume(); }

  /// A stage may come several times.
  void lap(const char* stage) {
    did_.seconds[stage] = did_.seconds.value(stage, 0.0) + watch_.lap();
    if (listener_ != nullptr) give_back_memory();
  }

  /// Said once, also where it is found again.
  void note(const std::string& file, const std::vector<std::string>& notes) const {
    if (!options_.quiet && !repeated_) print_notes(file, notes);
  }

  void meet_target() {
    if (options_.target_error_pct > 0)
      meet_error();
    else
      reach_target();
  }

  void attempt() {
    how_ = asked_;
    classify_mesh();
    add_what_needs_the_mesh();
    decimate();
  }

  // From what was read, without what an attempt before has done.
  void start_over() {
    repeated_ = true;
    balls_ = {};
    steps_.keep = {};
    steps_.model = nullptr;
    if (options_.model.empty()) model_.reset();
    mesh_ = Mesh(given());
    record_ = {};
    did_.missed.reset();
    watch_.lap();
  }

  // Where the number is missed, once more with one guard after the other let go.
  void reach_target() {
    attempt();
    if (!options_.reach) return;
    for (const Guard guard : guards_in_order) {
      const bool of_model = guard == Guard::Features || guard == Guard::Corners;
      if (!did_.missed || (of_model && given_classes_)) return;
      if (!let_go(guard, steps_, asked_)) continue;
      did_.let_go.push_back(guard);
      start_over();
      attempt();
    }
  }

  // The coarsest result that is no further off; where there is none, what was read.
  void meet_error() {
    const Mesh start(given());
    const measure::Surface original(start, steps_.threads);
    ErrorSearch search(options_.target_error_pct);
    double last = 0;
    const auto run = [&](double guard_pct) {
      if (last > 0) start_over();
      steps_.max_distance = guard_pct / 100 * diagonal_;
      last = guard_pct;
      attempt();
      progress_.show("measuring");
      did_.error_pct = largest_distance_pct(original, mesh_, steps_.threads);
      lap("measure");
    };
    steps_.coarsest = true;
    while (const auto guard_pct = search.next()) {
      run(*guard_pct);
      search.tried(*guard_pct, mesh_.count(2), *did_.error_pct);
    }
    did_.tries = search.tries();
    if (!search.best()) leave_as_it_is(steps_);
    if (const double best = search.best().value_or(options_.target_error_pct); last != best)
      run(best);
  }

  // Regions of other shapes than tetrahedra stay, and count beside the target.
  void count_cells() {
    for (const Region r : mesh_.regions()) did_.others += mesh_.shape(r) != Shape::Tetrahedron;
    did_.target = options_.target_count(volume(), did_.in_blocks ? did_.in_blocks->faces : cells());
    steps_.target_faces = did_.target > 0 ? did_.target + did_.others : 0;
  }

  /// Faces, or tetrahedra.
  [[nodiscard]] std::uint32_t cells() const {
    return volume() ? mesh_.count(3) - did_.others : mesh_.count(2);
  }

  void repair_mesh() {
    progress_.show("repairing");
    std::vector<std::string> notes;
    did_.repaired = mend(given_.own(), options_, notes);
    progress_.wipe();
    note(options_.input, notes);
    lap("repair");
  }

  /// Whether nothing asks for edges as entities, but for those on model edges. The paper's strategy
  /// records its steps by them, goes over listed ones first, and means come of them in their order.
  [[nodiscard]] bool knows_edges_by_ends() const {
    if (!options_.paper()) return true;
    const bool named = !options_.journal.empty() || steps_.exchange || options_.spacing_source();
    return !volume() && !named && given().edges.shapes.empty();
  }

  void classify_mesh() {
    progress_.show("classifying");
    const bool looks_at_all = model_ || options_.snaps();  // at edges, and faces of a volume
    const bool by_ends = !looks_at_all && knows_edges_by_ends();
    how_.complete = !by_ends;
    if (!volume() && options_.seams == "keep") how_.seams = fields::seams_of(given());
    if (volume()) balls_ = mesh_.request_listed(0, 3, "the command");
    classify_by_angle();
    if (!looks_at_all) {
      if (volume()) mesh_.keep_model_faces_only();
      if (by_ends) keep_edges_for_quality(mesh_);
    }
    if (!options_.journal.empty()) {
      record_.classify = how_;
      record_.seams = !how_.seams.empty();
      record_.start = io::fingerprint(mesh_);
      mesh_.attach(&record_.journal);
    }
    if (model_) fit_to_model(mesh_, given().classified(), *model_, options_);
    if (options_.snaps() && !model_) model_ = std::make_unique<DiscreteModel>(mesh_);
    if (options_.snaps()) check_snapping(mesh_, *model_, options_);
    if (options_.snaps()) steps_.model = model_.get();
    lap("classify");
    note(options_.input, check_.before(mesh_, did_));
    watch_.lap();
  }

  // What the angle finds is classified without edges that would cost too much of the target.
  void classify_by_angle() {
    const ClassifyResult found = classify(mesh_, how_);
    given_classes_ = found.given || !options_.model.empty();
    has_features_ = found.features.sharp > 0;
    if (found.given && options_.feature_angle_given)
      note(options_.input, {"the file classifies faces or edges: --feature-angle has no say"});
    const bool free = !volume() && !options_.feature_angle_given && !model_ &&
                      steps_.target_faces > 0 && how_.feature_angle_deg;
    if (!free) return;
    const std::string dear = dear_features(found, mesh_.count(2), steps_.target_faces);
    if (dear.empty()) return;
    how_.feature_angle_deg = FacetJudge::corner_deg;
    mesh_ = Mesh(given());
    has_features_ = classify(mesh_, how_).features.sharp > 0;
    note(options_.input, {dear});
  }

  /// What the decimation is told that needs the mesh.
  void add_what_needs_the_mesh() {
    if (options_.max_distance_pct > 0)
      steps_.max_distance = options_.max_distance_pct / 100 * diagonal_;
    if (!options_.keep.empty()) steps_.keep = read_keep_file(options_.keep, mesh_);
    if (!options_.only.empty()) steps_.keep = read_only_file(options_.only, mesh_, steps_.keep);
    std::size_t required = 0;
    steps_.keep = keep_required(mesh_, steps_.keep, required);
    if (required > 0)
      note(options_.input, {counted(required, "required vertex") + " kept in place"});
    if (!volume() && !options_.paper() && !did_.in_blocks)
      steps_.values =
          counted_values(given(), mesh_, attribute_weights(given(), options_.attributes));
    const auto source = options_.spacing_source();
    if (!source) return;
    progress_.show("spacing");
    try {
      steps_.spacing = std::make_shared<Column<Vertex, double>>(evaluate_spacing(mesh_, *source));
    } catch (const std::invalid_argument& e) {
      throw UsageError(std::string("--spacing: ") + e.what());
    }
    lap("spacing");
  }

  void decimate() {
    DecimationOptions steps = steps_;
    steps.original = given_.take_samples();
    Decimation decimation(mesh_, std::move(steps));
    lap("adjacency");
    const std::size_t entities = mesh_.entity_bytes(), adjacency = mesh_.adjacency_bytes();
    using namespace std::chrono_literals;
    const auto slice =
        progress_.shown() ? std::optional<std::chrono::microseconds>(100ms) : std::nullopt;
    while (decimation.run(slice) == Decimation::Stop::Budget)
      progress_.show(phase_name(decimation.phase()), decimation.progress());
    balls_ = {};
    lap("decimate");
    did_.memory = {{"mesh", std::max(entities, mesh_.entity_bytes())},
                   {"adjacency", std::max(adjacency, mesh_.adjacency_bytes())},
                   {"journal", record_.journal.bytes()},
                   {"decimate_peak", peak_bytes()}};
    did_.sweeps = decimation.sweeps();
    if (!misses(cells(), did_.target)) return;
    progress_.show("asking why");
    did_.missed = {decimation.edges_left(), {}};
    did_.missed->help = what_would_help(did_.missed->edges, options_, steps_,
                                        {given(), did_.input, has_features_}, mesh_.count(2));
  }

  void check() {
    progress_.show("checking");
    mesh_.attach(nullptr);
    if (const auto findings = verify(mesh_); !findings.empty()) blame(findings.front());
    check_.after(mesh_, did_);
    lap("check");
    did_.quality = measure::measure_quality(mesh_);
    watch_.lap();
  }

  /// The result contradicts itself: because the input did, or because of a fault in this program.
  /// Nothing is written then but the journal, which shows the operation at fault.
  [[noreturn]] void blame(const Finding& finding) const {
    Mesh start(given_.whole());
    classify(start, how_);
    if (const auto findings = verify(start); !findings.empty())
      throw io::ReadError(options_.input, {}, "cannot be decimated: " + findings.front().text);
    const bool journal = !options_.journal.empty();
    if (journal) io::write_journal(output_path(options_.journal), record_);
    throw InternalFault(options_.input + ": internal fault: in the result " + finding.text +
                        "; it was not written; please report it with the input, the command line " +
                        "and " + (journal ? options_.journal : "what --journal writes"));
  }

  void write() {
    progress_.show("writing");
    result_ = to_data(mesh_);
    GivenClasses(given()).apply(result_);
    carry_arrays(result_);
    io::OutputFiles files;
    io::EncodedMesh encoded;
    if (listener_ == nullptr) {
      const auto path = output_path(options_.output);
      io::WriteOptions how;
      how.pieces = options_.pieces;
      encoded = io::to_bytes(path, format_, result_, how);
      io::add_mesh(files, path, encoded);
      encoded.bytes = {}, encoded.beside = {};
    }
    if (!options_.journal.empty())
      files.add(output_path(options_.journal),
                [&](const io::OutputFiles::Take& take) { put_bytes(record_, take); });
    lap("write");
    did_.seconds["total"] = watch_.total();
    did_.memory["peak"] = peak_bytes();
    report_ = report_json(options_, steps_, how_, did_);
    if (!options_.report.empty()) files.add(output_path(options_.report), text_of(report_));
    files.commit();
    progress_.wipe();
    if (!options_.quiet) print_notes(options_.output, encoded.notes);
  }

  // Where nothing was done all data stay, which regions have to be compared for.
  void carry_arrays(MeshData& result) {
    const bool same_count = result.regions.size() == given().regions.size();
    if (same_count && !given().attributes.empty()) given_.recall_regions();
    io::CarriedAlong along = io::carry_along(given(), result, steps_.threads);
    did_.fields = std::move(along.fields);
    if (!did_.fields.empty()) lap("fields");
    if (!options_.quiet) print_notes(options_.output, along.notes);
  }

  void print_summary() const {
    std::ostream& out = stream_beside(options_.outputs());
    if (options_.prints_json)
      out << text_of(report_, options_.one_of_several);
    else if (!options_.quiet)
      print_decimation(out, options_, did_);
    if (!options_.quiet) note_target();
  }

  [[nodiscard]] std::string missed_words() const {
    return sentence(*did_.missed, steps_, did_.target, cells(), volume());
  }

  /// What was let go of to meet the target, and what it was missed for.
  void note_target() const {
    if (!did_.let_go.empty()) print_notes(options_.output, {words_of_let_go(did_.let_go)});
    if (!did_.missed) return;
    print_notes(options_.output, {missed_words()});
    print_notes(options_.input, dirt_notes(given(), did_.input, true, options_.mending()));
  }

  const DecimateOptions& options_;
  Exchange& exchange_;        ///< those who share the blocks
  const Listener* listener_;  ///< null: the mesh comes from a file and goes into one
  Progress progress_;
  io::Format format_ = io::Format::Ply;
  DecimationOptions steps_;
  ClassifyOptions asked_, how_;  ///< how the mesh is to be classified, and how it was
  Stopwatch watch_;
  GivenMesh given_;
  double diagonal_ = 0;
  bool repeated_ = false;       ///< the attempt is not the first
  bool given_classes_ = false;  ///< by the file or a model: the angle had no say
  bool has_features_ = false;   ///< the angle has found some
  Mesh mesh_;
  Request balls_;  ///< T(0,3) of a volume, which all stages but the last ones read
  std::unique_ptr<Model> model_;
  io::JournalFile record_;
  ResultCheck check_;
  DecimateReport did_;
  MeshData result_;
  Json report_;
};

}  // namespace

Decimated decimate(const DecimateOptions& options, const MeshData& mesh, const Listener& listener) {
  NoExchange alone;
  return Run(options, alone, &listener).run(mesh);
}

void add_shared_decimate(CLI::App& app, Action& action, Exchange& exchange) {
  CLI::App* command = app.add_subcommand("decimate", about);
  const auto o = std::make_shared<DecimateOptions>();
  add_decimate_options(*command, *o);
  command->callback(
      [&action, &exchange, o] { action = [&exchange, o] { return Run(*o, exchange).run(); }; });
}

void add_decimate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("decimate", about);
  const auto o = std::make_shared<DecimateOptions>();
  const auto batch = std::make_shared<Batch>();
  add_decimate_options(*command, *o);
  add_batch_options(*command, *batch, *o);
  command->callback([&action, o, batch] {
    take_files(*batch, *o);
    const auto work = [o](const BatchFile& file) {
      NoExchange alone;
      return Run(one_of_batch(*o, file), alone).run();
    };
    action = writing(batch, work, beside_mesh(o->inputs()));
  });
}

}  // namespace aomd::cli
