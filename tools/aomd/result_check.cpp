#include "tools/aomd/result_check.h"

#include "core/measure/distinct.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "tools/aomd/command.h"
#include "tools/aomd/surface_lines.h"

namespace aomd::cli {

std::vector<std::string> ResultCheck::before(const Mesh& mesh, DecimateReport& report) {
  report.input = measure::count_entities(mesh);
  volumes_ = measure::region_volumes(mesh);
  if (given_.is_volume()) faults_.emplace(mesh, report.input);
  return wrong_with(mesh, report);
}

std::vector<std::string> ResultCheck::wrong_with(const Mesh& mesh,
                                                 const DecimateReport& report) const {
  if (!faults_) return dirt_notes(given_.mesh(), report.input, false, options_.mending());
  std::vector<std::string> notes =
      notes_of(*faults_, report.others == 0 ? "tetrahedra" : "regions");
  for (const SurfaceFinding& finding : hanging_findings(mesh, threads_, measure::Skin::Listed))
    notes.push_back(finding.dirt.name + ": " + finding.dirt.text + ": aomd check names them");
  return notes;
}

void ResultCheck::after(const Mesh& mesh, DecimateReport& report) const {
  report.self_intersections = measure::count_self_intersections(mesh, threads_).pairs;
  report.output = measure::count_entities(mesh);
  if (faults_) return look_at_volume(mesh, report);
  const TriangleTree original(measure::distinct(triangles_of(given_.mesh()).corners).triangles,
                              threads_);
  report.flips = measure::measure_normals(original, mesh, threads_).flips;
}

// An input may have faults of its own.
void ResultCheck::look_at_volume(const Mesh& mesh, DecimateReport& report) const {
  report.volume_quality = measure::measure_volume(mesh);
  report.volumes = volume_changes(volumes_, measure::region_volumes(mesh));
  if (const auto worse = made_worse(*faults_, VolumeFaults(mesh, report.output)))
    throw InternalFault(options_.input + ": internal fault: " + *worse +
                        " in the result, which was not written");
}

}  // namespace aomd::cli
