// aomd decimate: read, classify, decimate, check, write, report.

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/fields/seams.h"
#include "core/io/journal_file.h"
#include "core/io/left_out.h"
#include "core/io/output_files.h"
#include "core/measure/distinct.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/facets.h"
#include "core/model/gmsh_model.h"
#include "core/model/mesh_on_model.h"
#include "core/repair/triangulate.h"
#include "tools/aomd/command.h"
#include "tools/aomd/decimate_report.h"
#include "tools/aomd/given_classes.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/keep_file.h"
#include "tools/aomd/missed_target.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/repair_items.h"
#include "tools/aomd/surface_lines.h"
#include "tools/aomd/volume_faults.h"

namespace aomd::cli {
namespace {

std::string dear_features(int model_vertices, std::uint32_t faces) {
  return std::to_string(model_vertices) + " model vertices would take more than half of " +
         counted(faces, "face") +
         ": only corners of 50 degrees and more are kept (--feature-angle 20 keeps all)";
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
  explicit Run(const DecimateOptions& options, const Listener* listener = nullptr)
      : options_(options),
        listener_(listener),
        progress_(listener ? Progress(listener->progress) : Progress(options.quiet)),
        steps_(options.for_library()),
        how_(options.for_classification()) {}

  int run() {
    format_ = format_of_output(options_.output, options_.format);
    options_.check_spacing();
    check_files(options_.inputs(), options_.outputs());
    read();
    classify_mesh();
    add_what_needs_the_mesh();
    decimate();
    check();
    write();
    progress_.wipe();
    if (!options_.quiet) print_summary();
    return did_.missed && options_.strict ? says_no : done;
  }

  /// The same without files for the meshes.
  Decimated run(MeshData mesh) {
    options_.check_spacing();
    check_files(beside_mesh(options_.inputs()), beside_mesh(options_.outputs()));
    take(std::move(mesh));
    classify_mesh();
    add_what_needs_the_mesh();
    decimate();
    check();
    write();
    if (did_.missed) note_what_is_missed();
    return {std::move(result_), std::move(report_), did_.missed ? missed_words() : std::string()};
  }

 private:
  // All notes of a run pass here: to whoever listens, else to standard error.
  void print_notes(const std::string& file, const std::vector<std::string>& notes) const {
    if (listener_ == nullptr) return cli::print_notes(file, notes);
    for (const std::string& note : notes) listener_->note(note);
  }

  void read() {
    progress_.show("reading");
    io::ReadResult read = read_input(options_.input);
    progress_.wipe();
    if (!options_.quiet) print_notes(options_.input, read.notes);
    take(std::move(read.mesh));
  }

  void take(MeshData mesh) {
    original_ = std::move(mesh);
    did_.seconds["read"] = watch_.lap();
    if (options_.triangulate) cut_quads();
    if (options_.repair) repair_mesh();
    mesh_ = Mesh(original_);
    if (volume() && !has_tetrahedra(mesh_))
      throw NothingToDo(printable(options_.input) + ": " + decimation_obstacle(mesh_));
    if (const char* obstacle = decimation_obstacle(mesh_))
      throw io::LimitError(options_.input, {}, obstacle);
    if (const auto finding = first_repeated_region(mesh_))
      throw io::ReadError(options_.input, {}, "cannot be decimated: " + finding->text);
    check_kind();
    count_cells();
    if (!options_.model.empty()) model_ = load_gmsh_model(options_.model);
    diagonal_ = diagonal_of(original_);
    if (volume()) forget_regions();
    did_.seconds["read"] = did_.seconds["read"].get<double>() + watch_.lap();
  }

  [[nodiscard]] bool volume() const { return !original_.regions.empty(); }

  // Their vertices, a fifth of what a decimation takes, are asked for where data go with them, and
  // where something is to be blamed on the input, which can be read again.
  void forget_regions() {
    const bool again = listener_ == nullptr && options_.input != "-" &&
                       std::filesystem::is_regular_file(options_.input);
    if (!again || !original_.attributes.empty() || !original_.periodic.empty()) return;
    original_.regions.vertices = std::vector<std::uint32_t>();
    forgotten_ = true;
  }

  // Options that belong to the other kind of mesh, or of strategy.
  void check_kind() const {
    if (volume() && steps_.topology != TopologyRule::Safe)
      throw UsageError("--topology paper is for surfaces: tetrahedra always keep the topology");
    if (!volume() && !options_.volume_rule.empty())
      throw UsageError("--volume is for volumes, and " + options_.input + " has no regions");
    if (!volume() && options_.min_dihedral_given)
      throw UsageError("--min-dihedral is for volumes, and " + options_.input +
                       " has no regions: --min-angle limits the angles of faces");
    if (options_.volume_rule == "keep" && options_.paper())
      throw UsageError(
          "--volume keep is for --strategy quality: the printed loop places no vertex");
    if (options_.volume_rule == "keep" && options_.snaps())
      throw UsageError("--volume keep excludes --snap model, which says where vertices lie");
    if (volume() && steps_.exchange && !options_.quiet)
      print_notes(options_.input, {"--exchange changes nothing: a volume keeps T(0,3) throughout"});
  }

  // Regions of other shapes than tetrahedra stay, and count beside the target.
  void count_cells() {
    for (const Region r : mesh_.regions()) did_.others += mesh_.shape(r) != Shape::Tetrahedron;
    did_.target = options_.target_count(volume(), cells());
    steps_.target_faces = did_.target > 0 ? did_.target + did_.others : 0;
  }

  /// Faces, or tetrahedra.
  [[nodiscard]] std::uint32_t cells() const {
    return volume() ? mesh_.count(3) - did_.others : mesh_.count(2);
  }

  void cut_quads() {
    const std::size_t quads = triangulate_quads(original_);
    if (quads > 0 && !options_.quiet)
      print_notes(options_.input, {counted(quads, "quad") + " cut into triangles"});
  }

  void repair_mesh() {
    check_mendable(options_.input, original_);
    progress_.show("repairing");
    RepairOptions how;
    options_.weld.apply(how, original_);
    did_.repaired = repair(original_, how);
    progress_.wipe();
    if (!options_.quiet) {
      for (const RepairItem& item : did_.repaired.done)
        print_notes(options_.input, {line_of(item)});
      for (const RepairItem& item : did_.repaired.left)
        print_notes(options_.input, {line_of(item)});
    }
    did_.seconds["repair"] = watch_.lap();
  }

  void classify_mesh() {
    progress_.show("classifying");
    const bool looks_at_all = model_ || options_.snaps();  // at edges, and faces of a volume
    how_.complete = looks_at_all || options_.paper();
    if (!volume() && options_.seams == "keep") how_.seams = fields::seams_of(original_);
    if (volume()) balls_ = mesh_.request_listed(0, 3, "the command");
    classify_by_angle();
    if (!looks_at_all) {
      if (volume()) mesh_.keep_model_faces_only();
      if (!options_.paper()) keep_edges_for_quality(mesh_);
    }
    if (!options_.journal.empty()) {
      record_.classify = how_;
      record_.seams = !how_.seams.empty();
      record_.start = io::fingerprint(mesh_);
      mesh_.attach(&record_.journal);
    }
    if (model_) fit_to_model();
    if (options_.snaps() && !model_) model_ = std::make_unique<DiscreteModel>(mesh_);
    if (options_.snaps()) snap_to_model();
    did_.seconds["classify"] = watch_.lap();
    did_.input = measure::count_entities(mesh_);
    volumes_before_ = measure::region_volumes(mesh_);
    if (volume()) faults_.emplace(mesh_, did_.input);
    if (!options_.quiet) print_notes(options_.input, what_is_wrong());
    watch_.lap();
  }

  /// What keeps a surface from its target, or what does not fit together in a volume.
  [[nodiscard]] std::vector<std::string> what_is_wrong() const {
    if (!volume()) return dirt_notes(original_, did_.input, false);
    std::vector<std::string> notes =
        notes_of(*faults_, did_.others == 0 ? "tetrahedra" : "regions");
    for (const SurfaceFinding& finding :
         hanging_findings(mesh_, steps_.threads, measure::Skin::Listed))
      notes.push_back(finding.dirt.name + ": " + finding.dirt.text + ": aomd check names them");
    return notes;
  }

  // The mesh may lie on what its own facets do not give, such as a model face without faces.
  void snap_to_model() {
    try {
      check_entities(mesh_, *model_);
    } catch (const ModelError& e) {
      throw io::ReadError(options_.input, {}, std::string("--snap model: ") + e.what());
    }
    steps_.model = model_.get();
  }

  // What the angle finds is classified without edges that would cost too much of the target.
  void classify_by_angle() {
    const ClassifyResult found = classify(mesh_, how_);
    if (found.given && options_.feature_angle_given && !options_.quiet)
      print_notes(options_.input,
                  {"the file classifies faces or edges: --feature-angle has no say"});
    const bool free =
        !volume() && !options_.feature_angle_given && !model_ && steps_.target_faces > 0;
    if (!free || features_pay(found.features, found.model_vertices, steps_.target_faces)) return;
    how_.feature_angle_deg = FacetJudge::corner_deg;
    mesh_ = Mesh(original_);
    classify(mesh_, how_);
    if (!options_.quiet)
      print_notes(options_.input, {dear_features(found.model_vertices, steps_.target_faces)});
  }

  // Classification by the model is a step of the journal, so that a replay needs no model.
  void fit_to_model() {
    try {
      if (original_.classified())
        check_against(mesh_, *model_);
      else
        classify_on(mesh_, *model_);
    } catch (const ModelError& e) {
      throw io::ReadError(options_.input, {}, e.what() + (" (" + options_.model + ")"));
    }
  }

  /// What the decimation is told that needs the mesh.
  void add_what_needs_the_mesh() {
    if (options_.max_distance_pct > 0)
      steps_.max_distance = options_.max_distance_pct / 100 * diagonal_;
    if (!options_.keep.empty()) steps_.keep = read_keep_file(options_.keep, mesh_);
    if (!options_.only.empty()) steps_.keep = read_only_file(options_.only, mesh_, steps_.keep);
    std::size_t required = 0;
    steps_.keep = keep_required(mesh_, steps_.keep, required);
    if (required > 0 && !options_.quiet)
      print_notes(options_.input, {counted(required, "required vertex") + " kept in place"});
    const auto source = options_.spacing_source();
    if (!source) return;
    progress_.show("spacing");
    try {
      steps_.spacing = std::make_shared<Column<Vertex, double>>(evaluate_spacing(mesh_, *source));
    } catch (const std::invalid_argument& e) {
      throw UsageError(std::string("--spacing: ") + e.what());
    }
    did_.seconds["spacing"] = watch_.lap();
  }

  void decimate() {
    Decimation decimation(mesh_, steps_);
    did_.seconds["adjacency"] = watch_.lap();
    const std::size_t entities = mesh_.entity_bytes(), adjacency = mesh_.adjacency_bytes();
    using namespace std::chrono_literals;
    const auto slice =
        progress_.shown() ? std::optional<std::chrono::microseconds>(100ms) : std::nullopt;
    while (decimation.run(slice) == Decimation::Stop::Budget)
      progress_.show(phase_name(decimation.phase()), decimation.progress());
    balls_ = {};
    did_.seconds["decimate"] = watch_.lap();
    did_.memory = {{"mesh", std::max(entities, mesh_.entity_bytes())},
                   {"adjacency", std::max(adjacency, mesh_.adjacency_bytes())},
                   {"journal", record_.journal.bytes()},
                   {"decimate_peak", peak_bytes()}};
    did_.sweeps = decimation.sweeps();
    if (!misses(cells(), did_.target)) return;
    progress_.show("asking why");
    did_.missed = {decimation.edges_left(), ""};
    did_.missed->would_help = what_would_help(did_.missed->edges, options_, steps_, original_,
                                              did_.input, mesh_.count(2));
  }

  void check() {
    progress_.show("checking");
    mesh_.attach(nullptr);
    if (const auto findings = verify(mesh_); !findings.empty()) blame(findings.front());
    did_.self_intersections = measure::count_self_intersections(mesh_, steps_.threads).pairs;
    did_.output = measure::count_entities(mesh_);
    if (volume()) check_volume();
    if (!volume()) count_flips();
    did_.seconds["check"] = watch_.lap();
    did_.quality = measure::measure_quality(mesh_);
    watch_.lap();
  }

  void count_flips() {
    const TriangleTree original(measure::distinct(triangles_of(original_).corners).triangles,
                                steps_.threads);
    did_.flips = measure::measure_normals(original, mesh_, steps_.threads).flips;
  }

  // An input may have faults of its own.
  void check_volume() {
    did_.volume_quality = measure::measure_volume(mesh_);
    did_.volumes = volume_changes(volumes_before_, measure::region_volumes(mesh_));
    if (const auto worse = made_worse(*faults_, VolumeFaults(mesh_, did_.output)))
      throw InternalFault(options_.input + ": internal fault: " + *worse +
                          " in the result, which was not written");
  }

  /// The result contradicts itself: because the input did, or because of a fault in this program.
  /// Nothing is written then but the journal, which shows the operation at fault.
  [[noreturn]] void blame(const Finding& finding) const {
    Mesh start(forgotten_ ? read_input(options_.input).mesh : original_);
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
    GivenClasses(original_).apply(result_);
    carry_arrays(result_);
    io::OutputFiles files;
    io::EncodedMesh encoded;
    if (listener_ == nullptr) {
      const auto path = output_path(options_.output);
      encoded = io::to_bytes(path, format_, result_);
      files.add(path, std::move(encoded.bytes));
    }
    if (!options_.journal.empty()) files.add(output_path(options_.journal), io::to_bytes(record_));
    did_.seconds["write"] = watch_.lap();
    did_.seconds["total"] = watch_.total();
    did_.memory["peak"] = peak_bytes();
    report_ = report_json(options_, steps_, how_, did_);
    if (!options_.report.empty()) files.add(output_path(options_.report), text_of(report_));
    files.commit();
    progress_.wipe();
    if (!options_.quiet) print_notes(options_.output, encoded.notes);
  }

  void carry_arrays(MeshData& result) {
    io::CarriedAlong along = io::carry_along(original_, result, steps_.threads);
    did_.fields = std::move(along.fields);
    if (!did_.fields.empty()) did_.seconds["fields"] = watch_.lap();
    if (!options_.quiet) print_notes(options_.output, along.notes);
  }

  void print_summary() const {
    print_decimation(stream_beside(options_.outputs()), options_, did_);
    if (did_.missed) note_what_is_missed();
  }

  [[nodiscard]] std::string missed_words() const {
    return sentence(*did_.missed, steps_, did_.target, cells(), volume());
  }

  void note_what_is_missed() const {
    print_notes(options_.output, {missed_words()});
    print_notes(options_.input, dirt_notes(original_, did_.input, true));
  }

  const DecimateOptions& options_;
  const Listener* listener_;  ///< null: the mesh comes from a file and goes into one
  Progress progress_;
  io::Format format_ = io::Format::Ply;
  DecimationOptions steps_;
  ClassifyOptions how_;
  Stopwatch watch_;
  MeshData original_;  ///< as read, or as repaired
  double diagonal_ = 0;
  bool forgotten_ = false;  ///< the vertices of the regions of `original_`
  Mesh mesh_;
  Request balls_;  ///< T(0,3) of a volume, which all stages but the last ones read
  std::unique_ptr<Model> model_;
  io::JournalFile record_;
  std::vector<measure::RegionVolume> volumes_before_;
  std::optional<VolumeFaults> faults_;  ///< of a volume as classified
  DecimateReport did_;
  MeshData result_;
  Json report_;
};

}  // namespace

Decimated decimate(const DecimateOptions& options, MeshData mesh, const Listener& listener) {
  return Run(options, &listener).run(std::move(mesh));
}

void add_decimate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("decimate", "Makes a mesh coarser and writes it");
  const auto o = std::make_shared<DecimateOptions>();
  add_decimate_options(*command, *o);
  command->callback([&action, o] { action = [o] { return Run(*o).run(); }; });
}

}  // namespace aomd::cli
