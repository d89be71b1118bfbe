#include "tools/aomd/report.h"

#include <sys/resource.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace aomd::cli {

Json counts_json(const std::string& file, const measure::Counts& counts) {
  Json shapes = Json::object(), classes = Json::object();
  for (std::size_t i = 0; i < counts.by_shape.size(); ++i)
    if (counts.by_shape[i] > 0)
      shapes[std::string(shape_template(static_cast<Shape>(i)).name)] = counts.by_shape[i];
  for (std::size_t dim = 0; dim < counts.by_class.size(); ++dim)
    classes[std::to_string(dim)] = counts.by_class[dim];
  return {{"file", file},
          {"vertices", counts.vertices},
          {"unused_vertices", counts.unused_vertices},
          {"edges", counts.edges},
          {"faces", counts.faces},
          {"regions", counts.regions},
          {"boundary_edges", counts.boundary_edges},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"boundary_faces", counts.boundary_faces},
          {"nonmanifold_faces", counts.nonmanifold_faces},
          {"components", counts.components},
          {"euler", counts.euler},
          {"by_shape", shapes},
          {"by_class", classes}};
}

Json quality_json(const measure::Quality& quality) {
  return {{"min_angle_mean_deg", quality.min_angle_mean_deg},
          {"min_angle_worst_deg", quality.min_angle_worst_deg},
          {"faces_below_10deg_pct", quality.faces_below_10deg_pct},
          {"min_dihedral_deg", nullptr},
          {"worst_region", nullptr}};
}

void add_volume_quality(Json& quality, const measure::VolumeQuality& volume) {
  if (!volume.worst.valid()) return;
  quality["min_dihedral_deg"] = volume.min_dihedral_deg;
  quality["worst_region"] = volume.worst.index;
}

Json sweeps_json(const std::vector<SweepStatistics>& sweeps) {
  Json list = Json::array();
  for (const SweepStatistics& sweep : sweeps) {
    Json refused = Json::object();
    for (int i = 1; i < reason_count; ++i)
      refused[reason_name(static_cast<Reason>(i))] = sweep.refused[static_cast<std::size_t>(i)];
    list.push_back({{"collapses", sweep.collapses},
                    {"swaps", sweep.swaps},
                    {"smooths", sweep.smooths},
                    {"faces", sweep.faces},
                    {"regions", sweep.regions},
                    {"refused", refused}});
  }
  return list;
}

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void give_back_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

std::string text_of(const Json& json, bool in_one_line) {
  return json.dump(in_one_line ? -1 : 2, ' ', false, Json::error_handler_t::replace) + '\n';
}

double Stopwatch::lap() {
  const double passed = seconds(lap_);
  lap_ = Clock::now();
  return passed;
}

}  // namespace aomd::cli
