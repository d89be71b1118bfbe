#include "viewer/document/kept_runs.h"

#include <algorithm>

#include "core/measure/statistics.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/mesh.h"
#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

void measure_cells(const Mesh& mesh, KeptRun& run) {
  if (mesh.count(3) > 0) {
    const measure::VolumeQuality quality = measure::measure_volume(mesh);
    run.cells = mesh.count(3);
    run.worst_angle_deg = quality.min_dihedral_deg;
    run.mean_angle_deg = quality.mean_dihedral_deg;
  } else {
    const measure::Quality quality = measure::measure_quality(mesh);
    run.cells = mesh.count(2);
    run.worst_angle_deg = quality.min_angle_worst_deg;
    run.mean_angle_deg = quality.min_angle_mean_deg;
  }
}

KeptRun copy_of(const Mesh& mesh) {
  KeptRun run;
  measure_cells(mesh, run);
  run.data = std::make_shared<const MeshData>(to_data(mesh));
  run.vertices = std::make_shared<const std::vector<Vertex>>(mesh.vertices().list());
  return run;
}

/// Whether a step of the present branch leads to it.
bool is_at(const KeptRun& run, const Document& document, std::size_t step) {
  if (run.number == 0) return step == 0;
  const TreePlace* place = document.tree().find_place(run.number);
  return place != nullptr && place->branch == 0 && place->step == step;
}

std::string optional_text(const std::optional<double>& value) {
  return value ? std::to_string(*value) : std::string();
}

std::string row_text(const KeptRun& run) {
  const auto distance = [&](double RunDistance::*part) {
    return run.distance ? std::to_string(*run.distance.*part) : std::string();
  };
  const std::string from = run.number == 0    ? ""
                           : run.from.empty() ? "the mesh as loaded"
                                              : run.from;
  return run.name + '\t' + from + '\t' + run.strategy + '\t' + run.aim + '\t' +
         optional_text(run.angle_deg) + '\t' + std::to_string(run.cells) + '\t' +
         std::to_string(run.worst_angle_deg) + '\t' + std::to_string(run.mean_angle_deg) + '\t' +
         distance(&RunDistance::rms_pct) + '\t' + distance(&RunDistance::max_pct) + '\t' +
         optional_text(run.seconds) + '\n';
}

}  // namespace

std::string aim_words(const Document& document) {
  const DecimationOptions& options = document.options();
  if (options.spacing) return "spacing " + std::string(document.spacing_source());
  if (options.coarsest) return "coarsest";
  if (options.target_faces > 0)
    return counted(options.target_faces, document.content().volume() ? "tetrahedron" : "face");
  return "factor " + short_number(options.factor, 2);
}

const KeptRun& KeptRuns::keep(Document& document, const std::string& name,
                              std::optional<double> seconds) {
  const auto known = std::find_if(rows_.begin(), rows_.end(), [&](const KeptRun& row) {
    return row.number > 0 && is_at(row, document, document.journal().cursor());
  });
  if (known != rows_.end()) {
    if (!name.empty()) known->name = name;
    return *known;
  }
  KeptRun run = copy_of(document.mesh());
  run.number = ++last_;
  run.name = name.empty() ? "Run " + std::to_string(run.number) : name;
  const DecimationOptions& options = document.options();
  run.strategy = options.strategy == Strategy::Paper ? "paper" : "quality";
  run.aim = aim_words(document);
  run.angle_deg = options.angle_deg;
  run.seconds = seconds;
  if (seconds) run.from = start_of_run(document);
  document.set_place(run.number);
  rows_.push_back(std::move(run));
  if (size() > most) make_way(document);
  return rows_.back();
}

void KeptRuns::make_way(Document& document) {
  const auto oldest = std::find_if(rows_.begin(), rows_.end(), [&](const KeptRun& row) {
    return row.number > 0 && row.number != reference_;
  });
  remove(document, oldest->number);
}

void KeptRuns::keep_original(Document& document) {
  if (has_original()) return;
  KeptRun row;
  const Mesh& mesh = document.copy_mesh_as_loaded().mesh();
  row.name = "As loaded";
  measure_cells(mesh, row);
  rows_.insert(rows_.begin(), std::move(row));
}

const KeptRun* KeptRuns::find(unsigned number) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const KeptRun& r) { return r.number == number; });
  return found == rows_.end() ? nullptr : &*found;
}

const KeptRun* KeptRuns::at(const Document& document, std::size_t step) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const KeptRun& run) { return is_at(run, document, step); });
  return found == rows_.end() ? nullptr : &*found;
}

/// Of the one that has just ended.
std::string KeptRuns::start_of_run(const Document& document) const {
  const std::size_t step = document.mark_of(document.journal().cursor() - 1).begin;
  if (step == 0) return {};
  const KeptRun* run = at(document, step);
  return run == nullptr ? "operation " + grouped(step) : run->name;
}

const KeptRun* KeptRuns::shown(const Document& document) const {
  return document.empty() ? nullptr : at(document, document.journal().cursor());
}

void KeptRuns::remove(Document& document, unsigned number) {
  document.forget_place(number);
  if (reference_ == number) reference_ = 0;
  std::erase_if(rows_, [&](const KeptRun& r) { return r.number == number; });
}

void KeptRuns::set_distance(unsigned number, const RunDistance& distance) {
  for (KeptRun& run : rows_)
    if (run.number == number) run.distance = distance;
}

std::string runs_table(const KeptRuns& runs, bool volume) {
  std::string text = "Run\tFrom\tStrategy\tAim\tAngle, degrees\t";
  text += volume
              ? "Regions\tSmallest dihedral angle, degrees\tMean smallest dihedral angle, degrees\t"
              : "Faces\tSmallest angle, degrees\tMean smallest angle, degrees\t";
  text += "RMS distance, % of the diagonal\tLargest distance, % of the diagonal\tSeconds\n";
  for (const KeptRun& run : runs.rows()) text += row_text(run);
  return text;
}

}  // namespace aomd::scene
