// aomd decimate: read, classify, decimate, check, write, report.

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <utility>

#include "core/io/journal_file.h"
#include "core/measure/intersections.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/fit.h"
#include "core/model/gmsh_model.h"
#include "tools/aomd/command.h"
#include "tools/aomd/given_classes.h"
#include "tools/aomd/interrupt.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/report.h"

namespace aomd::cli {
namespace {

struct Options {
  std::string input, output, report, journal;
  std::string strategy = "quality", topology = "safe", feature_angle = "20";
  std::string snap = "none", model;
  std::optional<double> angle_deg;  ///< none: what suits the strategy
  DecimationOptions decimation;
  bool no_swap = false, no_smooth = false, quiet = false;

  [[nodiscard]] bool paper_topology() const { return topology == "paper"; }
  [[nodiscard]] bool paper() const { return strategy == "paper"; }
};

/// One run, stage by stage; each fills its part of the report.
class Run {
 public:
  explicit Run(const Options& options)
      : options_(options), progress_(options.quiet), steps_(options.decimation) {
    steps_.swap = !options.no_swap;
    steps_.smooth = !options.no_smooth;
    steps_.strategy = options.paper() ? Strategy::Paper : Strategy::Quality;
    steps_.angle_deg = options.angle_deg.value_or(options.paper() || steps_.coarsest ? 10 : 60);
    steps_.topology = options.paper_topology() ? TopologyRule::Paper : TopologyRule::Safe;
    how_.feature_angle_deg = parse_number(options.feature_angle);  // nothing for "off"
    how_.nonmanifold_edges = !options.paper_topology();
  }

  int run() {
    static_cast<void>(io::format_for_writing(options_.output));  // complain before the work, not after it
    read();
    classify_mesh();
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
    mesh_ = Mesh(original_);
    if (const char* obstacle = decimation_obstacle(mesh_)) throw io::LimitError(options_.input, {}, obstacle);
    if (!options_.model.empty()) model_ = load_gmsh_model(options_.model);
    seconds_["read"] = watch_.lap();
  }

  void classify_mesh() {
    progress_.show("classifying");
    classify(mesh_, how_);
    if (!options_.paper() && !model_ && !snaps()) mesh_.keep_model_edges_only();  // models look at all edges
    if (!options_.journal.empty()) {
      record_.classify = how_;
      record_.start = io::fingerprint(mesh_);
      mesh_.attach(&record_.journal);
    }
    if (model_) fit_to_model();
    if (snaps() && !model_) model_ = std::make_unique<DiscreteModel>(mesh_);
    if (snaps()) steps_.model = model_.get();
    seconds_["classify"] = watch_.lap();
    stop_if_interrupted();
    input_ = measure::count_entities(mesh_);
    watch_.lap();
  }

  [[nodiscard]] bool snaps() const { return options_.snap == "model"; }

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

  void decimate() {
    Decimation decimation(mesh_, steps_);
    seconds_["adjacency"] = watch_.lap();
    const std::size_t entities = mesh_.entity_bytes(), adjacency = mesh_.adjacency_bytes();
    using namespace std::chrono_literals;
    const auto slice = progress_.shown() ? std::optional<std::chrono::microseconds>(100ms) : std::nullopt;
    while (decimation.run(slice, interrupted) == Decimation::Stop::Budget)
      progress_.show(phase_name(decimation.phase()), decimation.progress());
    stop_if_interrupted();
    seconds_["decimate"] = watch_.lap();
    memory_ = {{"mesh", std::max(entities, mesh_.entity_bytes())},
               {"adjacency", std::max(adjacency, mesh_.adjacency_bytes())},
               {"journal", record_.journal.bytes()}};
    sweeps_ = decimation.sweeps();
  }

  void check() {
    progress_.show("checking");
    mesh_.attach(nullptr);
    self_intersections_ = measure::self_intersections(mesh_).size();
    flips_ = measure::count_flips(TriangleTree(triangles_of(original_).corners), mesh_);
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

  [[nodiscard]] Json options_json() const {
    return {{"strategy", options_.strategy},
            {"regularity", steps_.regularity},
            {"target_faces", steps_.target_faces},
            {"factor", steps_.coarsest ? Json(nullptr) : Json(steps_.factor)},
            {"coarsest", steps_.coarsest},
            {"angle_deg", steps_.angle_deg},
            {"feature_angle_deg", how_.feature_angle_deg ? Json(*how_.feature_angle_deg) : Json(nullptr)},
            {"improve", steps_.improve_passes},
            {"swap", steps_.swap},
            {"smooth", steps_.smooth},
            {"topology", options_.topology},
            {"snap", options_.snap},
            {"model", options_.model.empty() ? Json(nullptr) : Json(options_.model)}};
  }

  [[nodiscard]] Json report_json() const {
    return {
        {"schema", 1},
        {"input", counts_json(options_.input, input_)},
        {"output", counts_json(options_.output, output_)},
        {"options", options_json()},
        {"seconds", seconds_},
        {"memory_bytes", memory_},
        {"sweeps", sweeps_json(sweeps_)},
        {"quality", quality_json(quality_)},
        {"findings", {{"flips", flips_}, {"self_intersections", self_intersections_}, {"verify", verify_}}},
        {"stopped", "done"}};
  }

  void print_summary() const {
    const bool kept = input_.euler == output_.euler;
    std::cout << options_.input << ": " << counted(input_.faces, "face") << " -> " << output_.faces
              << ", Euler number " << input_.euler
              << (kept ? " kept" : " -> " + std::to_string(output_.euler)) << ", "
              << counted(self_intersections_, "self-intersection") << ", " << counted(flips_, "flipped face")
              << ", " << std::llround(1000 * watch_.total()) << " ms\n";
    if (verify_ > 0)
      std::cerr << "aomd: note: " << options_.output << ": " << counted(verify_, "finding")
                << " (aomd check)\n";
  }

  const Options& options_;
  Progress progress_;
  DecimationOptions steps_;
  ClassifyOptions how_;
  Stopwatch watch_;
  Json seconds_, memory_;
  MeshData original_;
  Mesh mesh_;
  std::unique_ptr<Model> model_;
  io::JournalFile record_;
  measure::Counts input_, output_;
  measure::Quality quality_;
  std::vector<SweepStatistics> sweeps_;
  std::size_t flips_ = 0, self_intersections_ = 0, verify_ = 0;
};

CLI::Validator feature_angle_range() {
  const CLI::Validator angle = angle_range();
  const auto check = [angle](std::string& text) { return text == "off" ? std::string() : angle(text); };
  return CLI::Validator(check, "DEG|off");
}

CLI::Validator positive_finite() {
  const auto check = [](const std::string& text) -> std::string {
    const auto value = parse_number(text);
    return value && *value > 0 && std::isfinite(*value) ? "" : "must be a number above 0, not " + text;
  };
  return CLI::Validator(check, "F");
}

}  // namespace

void add_decimate(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("decimate", "Makes a mesh coarser and writes it");
  const auto o = std::make_shared<Options>();
  command->add_option("IN", o->input, "The mesh")->required();
  command->add_option("OUT", o->output, "Where to write the result: .obj, .ply, .off or .stl")->required();
  command->add_option("--strategy", o->strategy, "How to choose what goes")
      ->check(CLI::IsMember({"paper", "quality"}))
      ->capture_default_str();
  command
      ->add_option("--regularity", o->decimation.regularity,
                   "For quality: 0 accuracy first .. 1 regular faces first")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--target-faces", o->decimation.target_faces, "Stops at this many faces")
      ->check(CLI::PositiveNumber);
  CLI::Option* factor =
      command->add_option("--factor", o->decimation.factor, "Edges become this many times longer")
          ->check(positive_finite())
          ->capture_default_str();
  command->add_flag("--coarsest", o->decimation.coarsest, "No limit on the length of edges")
      ->excludes(factor);
  command
      ->add_option("--angle", o->angle_deg,
                   "How far the normal of a face may turn in one operation; default 10 for paper and with "
                   "--coarsest, else 60")
      ->check(angle_range());
  command
      ->add_option("--feature-angle", o->feature_angle,
                   "Edges whose faces meet at more than this stay; or off")
      ->check(feature_angle_range())
      ->capture_default_str();
  command->add_option("--improve", o->decimation.improve_passes, "Sweeps followed by swaps and smoothing")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_flag("--no-swap", o->no_swap, "No edge swaps");
  command->add_flag("--no-smooth", o->no_smooth, "No smoothing");
  command
      ->add_option("--topology", o->topology,
                   "safe: keep the topology; paper: as printed, without that check")
      ->check(CLI::IsMember({"safe", "paper"}))
      ->capture_default_str();
  command
      ->add_option(
          "--snap", o->snap,
          "model: smoothing puts vertices onto the model, that of --model or else the input's facets")
      ->check(CLI::IsMember({"none", "model"}))
      ->capture_default_str();
  command->add_option("--model", o->model,
                      "The CAD model that the mesh lies on: .step, .stp, .brep, .iges, .igs or .geo (with "
                      "Gmsh); a mesh without classification is classified on it");
  command->add_option("--report", o->report, "Writes what was done and measured, as JSON");
  command->add_option("--journal", o->journal, "Writes every operation, for aomd replay");
  command->add_flag("--quiet", o->quiet, "Prints nothing but errors");
  command->callback([&action, o] { action = [o] { return Run(*o).run(); }; });
}

}  // namespace aomd::cli
