#include "tools/aomd/compare_volumes.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/measure/volume_comparison.h"
#include "core/mesh/names.h"
#include "tools/aomd/command.h"
#include "tools/aomd/field_report.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/volume_report.h"

namespace aomd::cli {
namespace {

using measure::InterfaceChange;
using measure::RegionChange;

constexpr std::size_t most_lines = 20, bins = 18;

/// One of the two meshes, by itself.
struct VolumeSide {
  VolumeSide(std::string name, const Mesh& mesh, int threads)
      : file(std::move(name)),
        volume(mesh, threads),
        counts(measure::count_entities(mesh)),
        quality(measure::measure_volume(mesh, threads)),
        dihedrals(measure::make_histogram(quality.dihedrals, 0, 90, bins)),
        skin(volume.skin()),
        self_intersections(measure::count_self_intersections(skin, threads).pairs) {}

  std::string file;
  measure::Volume volume;
  measure::Counts counts;
  measure::VolumeQuality quality;
  measure::Histogram dihedrals;
  Mesh skin;
  std::size_t self_intersections;
};

bool all_measured(const std::vector<InterfaceChange>& list) {
  return std::all_of(list.begin(), list.end(), [](const auto& c) { return c.measured(); });
}

struct Compared {
  VolumeSide original, result;
  measure::VolumeComparison changes;
  std::vector<measure::FieldDifference> fields;
  std::size_t flips = 0;

  /// A length in percent of the original's diagonal.
  [[nodiscard]] double percent(double length) const {
    return length > 0 ? 100 * length / changes.diagonal : 0;
  }
  /// The largest of all surfaces: of model faces where both have all of them, else of interfaces;
  /// infinite where one of these is in one mesh alone.
  [[nodiscard]] measure::SetDistance largest() const {
    const auto& list = all_measured(changes.surfaces()) ? changes.surfaces() : changes.interfaces;
    constexpr double none = std::numeric_limits<double>::infinity();
    if (!all_measured(list)) return {none, none};
    measure::SetDistance all;
    for (const bool boundary : {true, false})
      if (const auto part = measure::distance_over(list, boundary))
        all = {std::max(all.rms, part->rms), std::max(all.max, part->max)};
    return all;
  }
};

Compared compared(const CompareArguments& options, const Mesh& original, const Mesh& result) {
  const int threads = thread_count(options.threads);
  Progress progress(options.quiet);
  progress.show("measuring " + options.original);
  VolumeSide before(options.original, original, threads);
  progress.show("measuring " + options.result);
  VolumeSide after(options.result, result, threads);
  progress.show("measuring distances");
  Compared c{std::move(before), std::move(after), {}, {}, 0};
  c.changes =
      measure::compare_volumes(c.original.volume, c.result.volume, options.samples, threads);
  const measure::Surface skin(c.original.skin, threads);
  c.flips = measure::measure_normals(skin.tree(), c.result.skin, threads).flips;
  return c;
}

std::size_t not_kept(const auto& changes) {
  return static_cast<std::size_t>(
      std::count_if(changes.begin(), changes.end(), [](const auto& c) { return !c.kept(); }));
}

std::vector<std::string> objections(const Compared& c, const CompareArguments& options) {
  Objections list;
  list.limit(options.max_distance, c.percent(c.largest().max), "largest distance", " %");
  list.limit(options.max_rms, c.percent(c.largest().rms), "rms distance", " %");
  list.limit(options.max_flips, c.flips, "number of flips", "");
  list.limit(options.max_intersections, c.result.self_intersections, "number of self-intersections",
             "");
  if (options.same_topology && not_kept(c.changes.regions) + not_kept(c.changes.surfaces()) > 0)
    list.add("the topology differs");
  return list.list();
}

// -----------------------------------------------------------------------------------------------
// JSON --

Json pair_json(const auto& before, const auto& after, auto&& value) {
  return {before ? Json(value(*before)) : Json(nullptr),
          after ? Json(value(*after)) : Json(nullptr)};
}

Json change_json(const RegionChange& c) {
  const auto pair = [&c](auto&& value) { return pair_json(c.before, c.after, value); };
  return {{"tag", region_json(c.model())},
          {"regions", pair([](const auto& f) { return f.regions; })},
          {"volume", pair([](const auto& f) { return f.volume; })},
          {"volume_change_pct", c.volume_percent()},
          {"euler", pair([](const auto& f) { return f.euler; })},
          {"parts", pair([](const auto& f) { return f.parts; })},
          {"kept", c.kept()}};
}

Json distance_json(const Compared& c, const measure::SetDistance& d) {
  return {{"rms_pct", c.percent(d.rms)}, {"hausdorff_pct", c.percent(d.max)}};
}

Json sampled_json(const Compared& c, const measure::Distance& d) {
  return {{"rms_pct", c.percent(d.rms)},
          {"hausdorff_pct", c.percent(d.max)},
          {"samples", d.samples},
          {"worst_point", {d.worst.x, d.worst.y, d.worst.z}}};
}

Json change_json(const Compared& c, const InterfaceChange& i) {
  const auto pair = [&i](auto&& value) { return pair_json(i.before, i.after, value); };
  const Json outside("outside");
  Json json{
      {"between", {i.on.boundary ? outside : region_json(i.on.first), region_json(i.on.second)}},
      {"model_face", region_json(i.on.face)},
      {"faces", pair([](const auto& f) { return f.faces; })},
      {"area", pair([](const auto& f) { return f.area; })},
      {"euler", pair([](const auto& f) { return f.euler; })},
      {"kept", i.kept()}};
  if (!i.measured()) return json;
  json.update(distance_json(c, i.distance()));
  json["original_to_result"] = sampled_json(c, i.to_result);
  json["result_to_original"] = sampled_json(c, i.to_original);
  return json;
}

Json list_json(const Compared& c, const std::vector<InterfaceChange>& changes) {
  Json list = Json::array();
  for (const InterfaceChange& change : changes) list.push_back(change_json(c, change));
  return list;
}

Json total_json(const Compared& c, const std::vector<InterfaceChange>& changes, bool boundary) {
  const auto distance = measure::distance_over(changes, boundary);
  return distance ? distance_json(c, *distance) : Json(nullptr);
}

Json curves_json(const Compared& c) {
  const measure::CurveChange& curves = c.changes.curves;
  Json json{{"edges", {curves.edges_before, curves.edges_after}},
            {"length", {curves.length_before, curves.length_after}}};
  if (curves.edges_before == 0 || curves.edges_after == 0) return json;
  json.update(distance_json(c, curves.both));
  json["original_to_result"] = distance_json(c, curves.to_result);
  json["result_to_original"] = distance_json(c, curves.to_original);
  return json;
}

Json vertices_json(const measure::ModelVertexChange& v) {
  Json lost = Json::array();
  for (const Vertex vertex : v.lost) lost.push_back(vertex.index);
  return {{"original", v.before},
          {"result", v.after},
          {"kept", v.kept},
          {"within_0.1_pct", v.near},
          {"lost", lost}};
}

Json side_json(const VolumeSide& side) {
  Json json = counts_json(side.file, side.counts);
  json["self_intersections"] = side.self_intersections;
  json["volume"] = volume_json(side.volume.complex, side.quality);
  json["volume"]["dihedral"]["histogram"] = {
      {"low_deg", 0}, {"high_deg", 90}, {"counts", side.dihedrals.counts}};
  return json;
}

Json comparison_json(const Compared& c, const std::vector<std::string>& objections) {
  Json regions = Json::array();
  for (const RegionChange& change : c.changes.regions) regions.push_back(change_json(change));
  return {{"schema", 1},
          {"hausdorff_pct", c.percent(c.largest().max)},
          {"rms_pct", c.percent(c.largest().rms)},
          {"flips", c.flips},
          {"self_intersections", c.result.self_intersections},
          {"euler", c.result.counts.euler},
          {"diagonal", c.changes.diagonal},
          {"boundary", total_json(c, c.changes.interfaces, true)},
          {"interface", total_json(c, c.changes.interfaces, false)},
          {"model_faces_on_boundary", total_json(c, c.changes.model_faces, true)},
          {"model_faces_inside", total_json(c, c.changes.model_faces, false)},
          {"model_regions", regions},
          {"interfaces", list_json(c, c.changes.interfaces)},
          {"model_faces", list_json(c, c.changes.model_faces)},
          {"model_edges", curves_json(c)},
          {"model_vertices", vertices_json(c.changes.vertices)},
          {"fields", differences_json(c.fields)},
          {"original", side_json(c.original)},
          {"result", side_json(c.result)},
          {"objections", objections}};
}

// -----------------------------------------------------------------------------------------------
// text --

template <typename... Values>
void columns(const std::string& label, const Values&... values) {
  std::cout << "  " << std::left << std::setw(24) << label << std::right;
  ((std::cout << ' ' << std::setw(15) << values), ...) << '\n';
}

std::string interface_name(const measure::Interface& on) {
  const std::string name =
      (on.boundary ? "outside" : region_name(on.first)) + " | " + region_name(on.second);
  return on.face.valid() ? name + ", face " + std::to_string(on.face.tag()) : name;
}

std::string both(const auto& before, const auto& after, auto&& value) {
  const auto text = [&](const auto& facts) {
    return facts ? std::to_string(value(*facts)) : std::string("-");
  };
  const std::string a = text(before), b = text(after);
  return a == b ? a : a + " -> " + b;
}

void print_rest(std::size_t shown, std::size_t all) {
  if (shown < all) std::cout << "  and " << all - shown << " more; --json has all\n";
}

void print_region_changes(const Compared& c) {
  columns("model region", "volume", "change, %", "regions", "Euler number", "parts");
  const std::size_t shown = std::min(c.changes.regions.size(), most_lines);
  for (std::size_t i = 0; i < shown; ++i) {
    const RegionChange& r = c.changes.regions[i];
    std::cout << std::defaultfloat << std::setprecision(6);
    columns("  " + region_name(r.model()), r.before ? r.before->volume : r.after->volume,
            r.volume_percent(), both(r.before, r.after, [](const auto& f) { return f.regions; }),
            both(r.before, r.after, [](const auto& f) { return f.euler; }),
            both(r.before, r.after, [](const auto& f) { return f.parts; }));
  }
  print_rest(shown, c.changes.regions.size());
}

void print_total(const Compared& c, const char* label, bool boundary) {
  if (const auto d = measure::distance_over(c.changes.surfaces(), boundary))
    columns(label, c.percent(d->rms), c.percent(d->max));
}

// The farthest first, after what one of the two lacks.
std::vector<InterfaceChange> worst_first(std::vector<InterfaceChange> list) {
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
    if (a.kept() != b.kept()) return b.kept();
    return a.distance().max > b.distance().max;
  });
  return list;
}

void print_interface(const Compared& c, const InterfaceChange& i) {
  const std::string euler = both(i.before, i.after, [](const auto& f) { return f.euler; });
  const std::string faces = both(i.before, i.after, [](const auto& f) { return f.faces; });
  const std::string name = "  " + interface_name(i.on);
  if (!i.measured()) return columns(name, i.before ? "lost" : "new", "", faces, euler);
  columns(name, c.percent(i.distance().rms), c.percent(i.distance().max), faces, euler);
}

void print_surfaces(const Compared& c) {
  std::cout << std::fixed << std::setprecision(4);
  columns("distance, % of diagonal", "rms", "max", "faces", "Euler number");
  print_total(c, "  boundary", true);
  print_total(c, "  interfaces", false);
  if (c.changes.curves.edges_before > 0 && c.changes.curves.edges_after > 0)
    columns("  model edges", c.percent(c.changes.curves.both.rms),
            c.percent(c.changes.curves.both.max));
  const std::vector<InterfaceChange> list = worst_first(c.changes.surfaces());
  const std::size_t shown = std::min(list.size(), most_lines);
  for (std::size_t i = 0; i < shown; ++i) print_interface(c, list[i]);
  print_rest(shown, list.size());
}

/// One line of the part that shows both meshes.
template <typename Value>
void sides(const char* label, const Compared& c, Value&& value) {
  columns(label, value(c.original), value(c.result));
}

void print_sides(const Compared& c) {
  std::cout << std::setprecision(2);
  columns("", "original", "result");
  sides("regions", c, [](const VolumeSide& s) { return s.counts.regions; });
  sides("vertices in use", c,
        [](const VolumeSide& s) { return s.counts.vertices - s.counts.unused_vertices; });
  sides("Euler number", c, [](const VolumeSide& s) { return s.counts.euler; });
  columns("model edges", c.changes.curves.edges_before, c.changes.curves.edges_after);
  columns("model vertices", c.changes.vertices.before, c.changes.vertices.after);
  columns("  kept where they were", "", c.changes.vertices.kept);
  sides("smallest dihedral", c, [](const VolumeSide& s) { return s.quality.min_dihedral_deg; });
  sides("  5 % are below", c, [](const VolumeSide& s) { return s.quality.p5_dihedral_deg; });
  sides("  mean", c, [](const VolumeSide& s) { return s.quality.mean_dihedral_deg; });
  sides("% regions below 10 deg", c,
        [](const VolumeSide& s) { return s.quality.regions_below_10deg_pct; });
  sides("inverted regions", c, [](const VolumeSide& s) { return s.quality.inverted.size(); });
  sides("repeated regions", c,
        [](const VolumeSide& s) { return s.volume.complex.repeated.size(); });
  sides("non-conforming faces", c,
        [](const VolumeSide& s) { return s.volume.complex.crowded.size(); });
  sides("folded faces", c, [](const VolumeSide& s) { return s.volume.complex.folded.size(); });
  sides("self-intersections", c, [](const VolumeSide& s) { return s.self_intersections; });
}

void print_histograms(const Compared& c) {
  columns("smallest dihedral, deg", "original, %", "result, %");
  const measure::Histogram &a = c.original.dihedrals, &b = c.result.dihedrals;
  const auto share = [](const measure::Histogram& h, std::size_t bin) {
    return 100 * static_cast<double>(h.counts[bin]) / static_cast<double>(h.total);
  };
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (a.counts[bin] == 0 && b.counts[bin] == 0) continue;
    const int low = static_cast<int>(a.bound(bin)), high = static_cast<int>(a.bound(bin + 1));
    columns("  " + std::to_string(low) + " to " + std::to_string(high), share(a, bin),
            share(b, bin));
  }
}

void print(const Compared& c) {
  std::cout << c.original.file << " and " << c.result.file << '\n';
  print_region_changes(c);
  print_surfaces(c);
  print_differences(std::cout, c.fields, "volume");
  print_sides(c);
  print_histograms(c);
}

}  // namespace

Json volume_comparison_json(const CompareArguments& options, const Mesh& original,
                            const Mesh& result, std::vector<measure::FieldDifference> fields) {
  Compared c = compared(options, original, result);
  c.fields = std::move(fields);
  return comparison_json(c, objections(c, options));
}

int compare_volumes(const CompareArguments& options, const Mesh& original, const Mesh& result,
                    std::vector<measure::FieldDifference> fields) {
  Compared c = compared(options, original, result);
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

}  // namespace aomd::cli
