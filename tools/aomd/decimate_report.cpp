#include "tools/aomd/decimate_report.h"

#include <cmath>
#include <ostream>

#include "core/base/text.h"
#include "core/decimate/explain/verdict_words.h"
#include "tools/aomd/field_report.h"
#include "tools/aomd/repair_items.h"

namespace aomd::cli {
namespace {

/// "stopped" of a report.
Json stopped_json(const DecimationOptions& steps, const DecimateReport& r) {
  const char* why = r.missed                 ? "missed"
                    : r.error_pct            ? "error"
                    : steps.target_faces > 0 ? "target"
                                             : "done";
  const bool helps = r.missed && !r.missed->help.empty();
  Json let_go = Json::array();
  for (const Guard guard : r.let_go) let_go.push_back(guard_name(guard));
  return {{"why", why},
          {"refused", r.missed ? refused_json(r.missed->edges) : Json::object()},
          {"would_help", helps ? Json(r.missed->help.front().option) : Json(nullptr)},
          {"help", r.missed ? help_json(r.missed->help) : Json::object()},
          {"let_go", let_go},
          {"error_pct", r.error_pct ? Json(*r.error_pct) : Json(nullptr)},
          {"tries", r.error_pct ? Json(r.tries) : Json(nullptr)}};
}

Json options_json(const DecimateOptions& options, DecimationOptions steps,
                  const ClassifyOptions& how, const DecimateReport& r) {
  steps.target_faces = r.target;
  Json json = options.json(steps, r.volume());
  json["feature_angle_deg"] = how.feature_angle_deg ? Json(*how.feature_angle_deg) : Json(nullptr);
  return json;
}

Json all_quality_json(const DecimateReport& r) {
  Json quality = quality_json(r.quality);
  if (r.volume()) add_volume_quality(quality, r.volume_quality);
  return quality;
}

std::string change_words(const DecimateReport& r) {
  const std::size_t faces = r.in_blocks ? r.in_blocks->faces : r.input.faces;
  const std::string before =
      r.volume() ? counted(r.input.regions - r.others, "tetrahedron") : counted(faces, "face");
  return before + " -> " + std::to_string(r.cells());
}

std::string state_words(const DecimateReport& r) {
  if (!r.volume()) return counted(r.flips, "flipped face");
  return "smallest dihedral angle " + words::degrees(r.volume_quality.min_dihedral_deg) +
         " degrees, largest change of a region's volume " +
         number_text(largest_percent(r.volumes), 2) + " %";
}

// Of one that was read in blocks the rest would have to be looked for in all of the file.
Json input_json(const DecimateOptions& options, const DecimateReport& r) {
  if (!r.in_blocks) return counts_json(options.input, r.input);
  return {{"file", options.input},       {"vertices", r.in_blocks->vertices},
          {"faces", r.in_blocks->faces}, {"regions", 0},
          {"euler", r.input.euler},      {"of_blocks", counts_json(options.input, r.input)}};
}

}  // namespace

Json report_json(const DecimateOptions& options, const DecimationOptions& steps,
                 const ClassifyOptions& how, const DecimateReport& r) {
  const bool volume = r.volume();
  return {{"schema", 1},
          {"input", input_json(options, r)},
          {"output", counts_json(options.output, r.output)},
          {"options", options_json(options, steps, how, r)},
          {"repair", options.repair ? Json{{"done", items_json(r.repaired.done)},
                                           {"left", items_json(r.repaired.left)}}
                                    : Json(nullptr)},
          {"seconds", r.seconds},
          {"memory_bytes", r.memory},
          {"sweeps", sweeps_json(r.sweeps)},
          {"quality", all_quality_json(r)},
          {"model_regions", volume ? volume_changes_json(r.volumes) : Json(nullptr)},
          {"volume_change_pct", volume ? Json(largest_percent(r.volumes)) : Json(nullptr)},
          {"fields", fields_json(r.fields)},
          {"findings",
           {{"flips", r.flips}, {"self_intersections", r.self_intersections}, {"verify", 0}}},
          {"stopped", stopped_json(steps, r)}};
}

std::string words_of_let_go(const std::vector<Guard>& guards) {
  std::vector<std::string> names;
  names.reserve(guards.size());
  for (const Guard guard : guards) names.emplace_back(guard_name(guard));
  return "let go of " + joined(names, " and ") + " to come that far";
}

void print_decimation(std::ostream& out, const DecimateOptions& options, const DecimateReport& r) {
  const bool kept = r.input.euler == r.output.euler;
  out << printable(options.input) << ": " << change_words(r) << ", Euler number " << r.input.euler
      << (kept ? " kept" : " -> " + std::to_string(r.output.euler)) << ", "
      << counted(r.self_intersections, "self-intersection") << ", " << state_words(r) << ", "
      << std::llround(1000 * r.seconds["total"].get<double>()) << " ms\n";
  if (r.error_pct)
    out << "  distance from the original " << number_text(*r.error_pct, 4)
        << " % of the diagonal, within " << number_text(options.target_error_pct) << " %, after "
        << counted(r.tries, "run") << '\n';
  if (r.volume()) print_volume_changes(out, r.volumes);
  if (!r.fields.empty()) print_fields(out, r.fields);
}

}  // namespace aomd::cli
