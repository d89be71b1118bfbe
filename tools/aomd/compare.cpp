// aomd compare: distances, normals and topology between two surfaces or volumes; a check for
// scripts when limits are given.

#include <iomanip>
#include <iostream>
#include <memory>
#include <utility>

#include "core/base/parallel.h"
#include "core/measure/distance.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/mesh/extent.h"
#include "tools/aomd/command.h"
#include "tools/aomd/compare_arguments.h"
#include "tools/aomd/compare_volumes.h"
#include "tools/aomd/field_report.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/report.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

/// One of the two surfaces, by itself.
struct Side {
  std::string file;
  Mesh mesh;
  measure::Counts counts;
  measure::Quality quality;
  std::size_t self_intersections = 0;
};

struct Comparison {
  Side original, result;
  double diagonal = 0;
  measure::MutualDistance distance;
  measure::NormalDeviation normals;
  std::vector<measure::FieldDifference> fields;

  /// A length in percent of the original's diagonal; infinite where that is a point.
  [[nodiscard]] double percent(double length) const {
    return length > 0 ? 100 * length / diagonal : 0;
  }
};

// Squares of what is larger or smaller are no numbers, and a distance of none would look like 0.
void check_extent(const std::string& file, const Mesh& mesh) {
  if (!has_usual_extent(mesh))
    throw io::LimitError(file, {},
                         "Only meshes from 1e-20 to 1e+18 across can be compared: write it in "
                         "another unit.");
}

MeshData read(const std::string& file, bool quiet, Progress& progress) {
  progress.show("reading " + file);
  return read_mesh(file, quiet).mesh;
}

Side measured(const std::string& file, Mesh mesh, Progress& progress, int threads) {
  Side side{file, std::move(mesh), {}, {}, 0};
  if (side.mesh.count(2) == 0) throw io::ReadError(file, {}, "has no faces to compare");
  progress.show("measuring " + file);
  side.counts = measure::count_entities(side.mesh);
  side.quality = measure::measure_quality(side.mesh);
  side.self_intersections = measure::count_self_intersections(side.mesh, threads).pairs;
  return side;
}

Comparison compare(const CompareArguments& options, Mesh original, Mesh result) {
  Progress progress(options.quiet);
  const int threads = thread_count(options.threads);
  Comparison c{measured(options.original, std::move(original), progress, threads),
               measured(options.result, std::move(result), progress, threads),
               0,
               {},
               {},
               {}};
  progress.show("measuring distances");
  const measure::Surface from(c.original.mesh, threads), to(c.result.mesh, threads);
  c.diagonal = from.tree().box().diagonal();
  c.distance = measure::mutual_distance(from, to, options.samples, threads);
  c.normals = measure::measure_normals(from.tree(), c.result.mesh, threads);
  return c;
}

bool same_topology(const measure::Counts& a, const measure::Counts& b) {
  return a.euler == b.euler && a.components == b.components &&
         a.nonmanifold_edges == b.nonmanifold_edges &&
         (a.boundary_edges > 0) == (b.boundary_edges > 0);
}

std::vector<std::string> objections(const Comparison& c, const CompareArguments& options) {
  Objections list;
  list.limit(options.max_distance, c.percent(c.distance.max()), "largest distance", " %");
  list.limit(options.max_rms, c.percent(c.distance.rms()), "rms distance", " %");
  list.limit(options.max_flips, c.normals.flips, "number of flips", "");
  list.limit(options.max_intersections, c.result.self_intersections, "number of self-intersections",
             "");
  if (options.same_topology && !same_topology(c.original.counts, c.result.counts))
    list.add("the topology differs");
  return list.list();
}

// -----------------------------------------------------------------------------------------------
// JSON --

Json point_json(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

Json distance_json(const Comparison& c, const measure::Distance& d) {
  return {{"hausdorff_pct", c.percent(d.max)},  {"rms_pct", c.percent(d.rms)},
          {"mean_pct", c.percent(d.mean)},      {"samples", d.samples},
          {"worst_point", point_json(d.worst)}, {"nearest_point", point_json(d.nearest)}};
}

Json side_json(const Side& side) {
  Json json = counts_json(side.file, side.counts);
  json["self_intersections"] = side.self_intersections;
  json["quality"] = quality_json(side.quality);
  return json;
}

Json comparison_json(const Comparison& c, const std::vector<std::string>& objections) {
  const measure::NormalDeviation& n = c.normals;
  return {{"schema", 1},
          {"hausdorff_pct", c.percent(c.distance.max())},
          {"rms_pct", c.percent(c.distance.rms())},
          {"mean_pct", c.percent(c.distance.mean())},
          {"normal_dev_gt10_pct", n.percent(n.above_10deg)},
          {"normal_dev_gt60_pct", n.percent(n.above_60deg)},
          {"flips", n.flips},
          {"self_intersections", c.result.self_intersections},
          {"euler", c.result.counts.euler},
          {"min_angle_mean_deg", c.result.quality.min_angle_mean_deg},
          {"faces_below_10deg_pct", c.result.quality.faces_below_10deg_pct},
          {"diagonal", c.diagonal},
          {"original_to_result", distance_json(c, c.distance.to_result)},
          {"result_to_original", distance_json(c, c.distance.to_original)},
          {"original", side_json(c.original)},
          {"fields", differences_json(c.fields)},
          {"result", side_json(c.result)},
          {"objections", objections}};
}

// -----------------------------------------------------------------------------------------------
// text --

template <typename... Values>
void row(const char* label, const Values&... values) {
  std::cout << "  " << std::left << std::setw(24) << label << std::right;
  ((std::cout << std::setw(14) << values), ...) << '\n';
}

/// One line of the part that shows both surfaces.
template <typename Value>
void sides(const char* label, const Comparison& c, Value&& value) {
  row(label, value(c.original), value(c.result));
}

void print_distances(const Comparison& c) {
  const auto line = [&c](const char* label, const auto& distance) {
    row(label, c.percent(distance.max), c.percent(distance.rms), c.percent(distance.mean));
  };
  const measure::MutualDistance& d = c.distance;
  std::cout << std::setprecision(4);
  row("distance, % of diagonal", "max", "rms", "mean");
  line("  original to result", d.to_result);
  line("  result to original", d.to_original);
  row("  the larger", c.percent(d.max()), c.percent(d.rms()), c.percent(d.mean()));
  const auto& worst =
      d.to_result.max >= d.to_original.max ? d.to_result.worst : d.to_original.worst;
  std::cout << std::defaultfloat << std::setprecision(6) << "    max is at (" << worst.x << ", "
            << worst.y << ", " << worst.z << "); the diagonal is " << c.diagonal << " long\n"
            << std::fixed;
}

void print(const Comparison& c) {
  std::cout << c.original.file << " and " << c.result.file << '\n' << std::fixed;
  print_distances(c);
  print_differences(std::cout, c.fields, "area");
  std::cout << std::setprecision(2);
  row("normals turned by more", "than 10 deg", "than 60 deg", "than 90 deg");
  row("  faces", c.normals.above_10deg, c.normals.above_60deg, c.normals.flips);
  row("  % of the result", c.normals.percent(c.normals.above_10deg),
      c.normals.percent(c.normals.above_60deg), c.normals.percent(c.normals.flips));
  row("", "original", "result");
  sides("vertices in use", c,
        [](const Side& s) { return s.counts.vertices - s.counts.unused_vertices; });
  sides("faces", c, [](const Side& s) { return s.counts.faces; });
  sides("Euler number", c, [](const Side& s) { return s.counts.euler; });
  sides("components", c, [](const Side& s) { return s.counts.components; });
  sides("boundary edges", c, [](const Side& s) { return s.counts.boundary_edges; });
  sides("non-manifold edges", c, [](const Side& s) { return s.counts.nonmanifold_edges; });
  sides("self-intersections", c, [](const Side& s) { return s.self_intersections; });
  sides("smallest angle, mean", c, [](const Side& s) { return s.quality.min_angle_mean_deg; });
  sides("smallest angle, worst", c, [](const Side& s) { return s.quality.min_angle_worst_deg; });
  sides("% faces below 10 deg", c, [](const Side& s) { return s.quality.faces_below_10deg_pct; });
}

int compare_surfaces(const CompareArguments& options, Mesh original, Mesh result,
                     std::vector<measure::FieldDifference> fields) {
  Comparison c = compare(options, std::move(original), std::move(result));
  c.fields = std::move(fields);
  const std::vector<std::string> list = objections(c, options);
  if (options.json) {
    std::cout << text_of(comparison_json(c, list));
  } else {
    print(c);
    for (const std::string& objection : list) std::cout << "no: " << objection << '\n';
  }
  return list.empty() ? done : says_no;
}

int run(const CompareArguments& options) {
  Progress progress(false);
  MeshData original = read(options.original, options.json, progress),
           result = read(options.result, options.json, progress);
  const bool volumes = !original.regions.empty() && !result.regions.empty();
  progress.show("comparing fields");
  const auto fields = measure::compare_fields(original, result, thread_count(options.threads));
  Mesh first(std::exchange(original, {})), second(std::exchange(result, {}));
  progress.wipe();
  check_extent(options.original, first);
  check_extent(options.result, second);
  return volumes ? compare_volumes(options, first, second, fields)
                 : compare_surfaces(options, std::move(first), std::move(second), fields);
}

void add_limits(CLI::App* command, CompareArguments& options) {
  const auto limit = [command](const char* name, auto& value, const char* text) {
    return command->add_option(name, value, text)
        ->type_name("N")
        ->check(at_least(0))
        ->group("Exit code 1 when exceeded");
  };
  const auto count = [&limit](const char* name, auto& value, const char* text) {
    limit(name, value, text)->transform(whole_number(0, std::uint64_t{1} << 53));
  };
  limit("--max-distance", options.max_distance, "Largest distance either way, % of the diagonal");
  limit("--max-rms", options.max_rms, "Root mean square distance either way, % of the diagonal");
  count("--max-flips", options.max_flips, "Faces whose normal turned by more than 90 degrees");
  count("--max-intersections", options.max_intersections, "Self-intersections of RESULT");
  command
      ->add_flag("--same-topology", options.same_topology,
                 "Euler number, components and non-manifold edges must be the same, and both "
                 "closed or both "
                 "open")
      ->group("Exit code 1 when exceeded");
}

}  // namespace

Json compare(const CompareArguments& options, const MeshData& original, const MeshData& result) {
  auto fields = measure::compare_fields(original, result, thread_count(options.threads));
  Mesh first(original), second(result);
  check_extent(options.original, first);
  check_extent(options.result, second);
  if (!original.regions.empty() && !result.regions.empty())
    return volume_comparison_json(options, first, second, std::move(fields));
  Comparison c = compare(options, std::move(first), std::move(second));
  c.fields = std::move(fields);
  return comparison_json(c, objections(c, options));
}

double largest_distance_pct(const measure::Surface& original, const Mesh& result, int threads) {
  const std::size_t samples = CompareArguments().samples;
  const measure::Surface to(result, threads);
  const double distance = measure::mutual_distance(original, to, samples, threads).max();
  return distance > 0 ? 100 * distance / original.tree().box().diagonal() : 0;
}

void add_compare(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "compare",
      "Distances, normals and topology between two surfaces, of volumes also what their regions, "
      "model edges and model vertices kept; exit code 1 beyond given limits");
  const auto options = std::make_shared<CompareArguments>();
  command->add_option("ORIGINAL", options->original, "The mesh that is the measure")->required();
  command->add_option("RESULT", options->result, "The mesh that should be like it")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->add_option("--samples", options->samples, "Points on each surface, besides all vertices")
      ->type_name("N")
      ->transform(whole_number(1, 1'000'000'000))
      ->capture_default_str();
  add_threads(*command, options->threads);
  add_limits(command, *options);
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
