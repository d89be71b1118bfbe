// aomd decimate: read, classify, decimate, check, write, report.

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/io/journal_file.h"
#include "core/measure/distinct.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/gmsh_model.h"
#include "core/model/mesh_on_model.h"
#include "tools/aomd/command.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/given_classes.h"
#include "tools/aomd/interrupt.h"
#include "tools/aomd/keep_file.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/repair_items.h"
#include "tools/aomd/surface_lines.h"

namespace aomd::cli {
namespace {

/// One run, stage by stage; each fills its part of the report.
class Run {
 public:
  explicit Run(const DecimateOptions& options)
      : options_(options),
        progress_(options.quiet),
        steps_(options.for_library()),
        how_(options.for_classification()) {}

  int run() {
    static_cast<void>(
        io::format_for_writing(options_.output));  // complain before the work, not after it
    static_cast<void>(options_.spacing_source());
    read();
    classify_mesh();
    add_what_needs_the_mesh();
    decimate();
    check();
    write();
    report();
    return done;
  }

 private:
  void read() {
    progress_.show("reading");
    io::ReadResult read = io::read(options_.input);
    progress_.wipe();
    if (!options_.quiet) print_notes(options_.input, read.notes);
    stop_if_interrupted();
    original_ = std::move(read.mesh);
    seconds_["read"] = watch_.lap();
    if (options_.repair && original_.regions.empty()) repair_mesh();
    mesh_ = Mesh(original_);
    if (const char* obstacle = decimation_obstacle(mesh_))
      throw io::LimitError(options_.input, {}, obstacle);
    if (!options_.model.empty()) model_ = load_gmsh_model(options_.model);
    seconds_["read"] = seconds_["read"].get<double>() + watch_.lap();
  }

  void repair_mesh() {
    progress_.show("repairing");
    RepairOptions how;
    options_.weld.apply(how, original_);
    repaired_ = repair(original_, how);
    progress_.wipe();
    if (!options_.quiet) {
      for (const RepairItem& item : repaired_.done) print_notes(options_.input, {line_of(item)});
      for (const RepairItem& item : repaired_.left) print_notes(options_.input, {line_of(item)});
    }
    seconds_["repair"] = watch_.lap();
    stop_if_interrupted();
  }

  void classify_mesh() {
    progress_.show("classifying");
    classify(mesh_, how_);
    if (!options_.paper() && !model_ && !options_.snaps())
      mesh_.keep_model_edges_only();  // models look at all edges
    if (!options_.journal.empty()) {
      record_.classify = how_;
      record_.start = io::fingerprint(mesh_);
      mesh_.attach(&record_.journal);
    }
    if (model_) fit_to_model();
    if (options_.snaps() && !model_) model_ = std::make_unique<DiscreteModel>(mesh_);
    if (options_.snaps()) steps_.model = model_.get();
    seconds_["classify"] = watch_.lap();
    stop_if_interrupted();
    input_ = measure::count_entities(mesh_);
    if (!options_.quiet) print_notes(options_.input, dirt_notes(original_, input_, false));
    watch_.lap();
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
      steps_.max_distance = options_.max_distance_pct / 100 *
                            TriangleTree(triangles_of(original_).corners).box().diagonal();
    if (!options_.keep.empty()) steps_.keep = read_keep_file(options_.keep, mesh_);
    const auto source = options_.spacing_source();
    if (!source) return;
    progress_.show("spacing");
    try {
      steps_.spacing = std::make_shared<Column<Vertex, double>>(evaluate_spacing(mesh_, *source));
    } catch (const std::invalid_argument& e) {
      throw UsageError(std::string("--spacing: ") + e.what());
    }
    seconds_["spacing"] = watch_.lap();
    stop_if_interrupted();
  }

  void decimate() {
    Decimation decimation(mesh_, steps_);
    seconds_["adjacency"] = watch_.lap();
    const std::size_t entities = mesh_.entity_bytes(), adjacency = mesh_.adjacency_bytes();
    using namespace std::chrono_literals;
    const auto slice =
        progress_.shown() ? std::optional<std::chrono::microseconds>(100ms) : std::nullopt;
    while (decimation.run(slice, interrupted) == Decimation::Stop::Budget)
      progress_.show(phase_name(decimation.phase()), decimation.progress());
    stop_if_interrupted();
    seconds_["decimate"] = watch_.lap();
    memory_ = {{"mesh", std::max(entities, mesh_.entity_bytes())},
               {"adjacency", std::max(adjacency, mesh_.adjacency_bytes())},
               {"journal", record_.journal.bytes()},
               {"decimate_peak", peak_bytes()}};
    sweeps_ = decimation.sweeps();
  }

  void check() {
    progress_.show("checking");
    mesh_.attach(nullptr);
    self_intersections_ = measure::count_self_intersections(mesh_, steps_.threads).pairs;
    const TriangleTree original(measure::distinct(triangles_of(original_).corners).triangles,
                                steps_.threads);
    flips_ = measure::measure_normals(original, mesh_, steps_.threads).flips;
    verify_ = verify(mesh_).size();
    seconds_["check"] = watch_.lap();
    stop_if_interrupted();
    output_ = measure::count_entities(mesh_);
    quality_ = measure::measure_quality(mesh_);
    watch_.lap();
  }

  void write() {
    progress_.show("writing");
    MeshData result = to_data(mesh_);
    GivenClasses(original_).apply(result);
    stop_if_interrupted();
    io::write(options_.output, result);
    if (!options_.journal.empty()) io::write_journal(options_.journal, record_);
    seconds_["write"] = watch_.lap();
  }

  void report() {
    seconds_["total"] = watch_.total();
    memory_["peak"] = peak_bytes();
    if (!options_.report.empty()) io::write_file(options_.report, text_of(report_json()));
    progress_.wipe();
    if (!options_.quiet) print_summary();
  }

  [[nodiscard]] bool at_target() const {
    return steps_.target_faces > 0 && output_.faces <= steps_.target_faces;
  }

  [[nodiscard]] Json report_json() const {
    return {{"schema", 1},
            {"input", counts_json(options_.input, input_)},
            {"output", counts_json(options_.output, output_)},
            {"options", options_.json()},
            {"repair", options_.repair ? Json{{"done", items_json(repaired_.done)},
                                              {"left", items_json(repaired_.left)}}
                                       : Json(nullptr)},
            {"seconds", seconds_},
            {"memory_bytes", memory_},
            {"sweeps", sweeps_json(sweeps_)},
            {"quality", quality_json(quality_)},
            {"findings",
             {{"flips", flips_}, {"self_intersections", self_intersections_}, {"verify", verify_}}},
            {"stopped", at_target() ? "target" : "done"}};
  }

  void print_summary() const {
    const bool kept = input_.euler == output_.euler;
    std::cout << options_.input << ": " << counted(input_.faces, "face") << " -> " << output_.faces
              << ", Euler number " << input_.euler
              << (kept ? " kept" : " -> " + std::to_string(output_.euler)) << ", "
              << counted(self_intersections_, "self-intersection") << ", "
              << counted(flips_, "flipped face") << ", " << std::llround(1000 * watch_.total())
              << " ms\n";
    if (steps_.target_faces > 0 && !at_target())
      std::cerr << "aomd: note: " << options_.output << ": nothing more may go above the target of "
                << counted(steps_.target_faces, "face") << '\n';
    if (steps_.target_faces > 0 && !at_target())
      print_notes(options_.input, dirt_notes(original_, input_, true));
    if (verify_ > 0)
      std::cerr << "aomd: note: " << options_.output << ": " << counted(verify_, "finding")
                << " (aomd check)\n";
  }

  const DecimateOptions& options_;
  Progress progress_;
  DecimationOptions steps_;
  ClassifyOptions how_;
  Stopwatch watch_;
  Json seconds_, memory_;
  MeshData original_;  ///< as read, or as repaired
  RepairReport repaired_;
  Mesh mesh_;
  std::unique_ptr<Model> model_;
  io::JournalFile record_;
  measure::Counts input_, output_;
  measure::Quality quality_;
  std::vector<SweepStatistics> sweeps_;
  std::size_t flips_ = 0, self_intersections_ = 0, verify_ = 0;
};

}  // namespace

void add_decimate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("decimate", "Makes a mesh coarser and writes it");
  const auto o = std::make_shared<DecimateOptions>();
  add_decimate_options(*command, *o);
  command->callback([&action, o] { action = [o] { return Run(*o).run(); }; });
}

}  // namespace aomd::cli
