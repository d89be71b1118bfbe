#include "tools/aomd/decimate_options.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/blocks/block_cut.h"
#include "core/decimate/spacing/spacing_expression.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

CLI::Validator angle_or_off() {
  const auto check = [](std::string& text) {
    if (lower(text) == "off") text = "off";
    const bool fits = text == "off" || angle()(text).empty();
    return fits ? std::string()
                : "must be off, or more than 0 and less than 180 degrees, not " + text;
  };
  return CLI::Validator(check, "");
}

/// The share that a text like "10%" names, in percent; nothing for what is none.
std::optional<double> parse_share(const std::string& text) {
  if (!text.ends_with('%')) return {};
  const auto share = parse_number(text.substr(0, text.size() - 1));
  return share && *share > 0 && *share <= 100 ? share : std::nullopt;
}

CLI::Validator number_or_share() {
  const auto check = [](const std::string& text) {
    const auto faces = parse_whole_number(text);
    const bool fits = parse_share(text) || (faces && *faces > 0 && *faces < no_index);
    return fits
               ? std::string()
               : "must be a whole number from 1 to 4294967294, or a share such as 10%, not " + text;
  };
  return CLI::Validator(check, "");
}

std::vector<std::string> idea_names() {
  std::vector<std::string> names;
  names.reserve(idea_count);
  for (int i = 0; i < idea_count; ++i) names.emplace_back(idea_name(static_cast<Idea>(i)));
  return names;
}

std::string idea_list() {
  std::string text;
  for (const std::string& name : idea_names()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void put_into(const char* group, std::initializer_list<CLI::Option*> options) {
  for (CLI::Option* each : options) each->group(group);
}

void add_aims(CLI::App& command, DecimateOptions& o) {
  CLI::Option* target =
      command.add_option("--target-faces", o.target,
                         "Stops at this many faces, or at this share of the input's, or where\n"
                         "nothing more may go");
  target->type_name("N|P%")->check(number_or_share());
  CLI::Option* tets =
      command.add_option("--target-tets", o.target_tets, "The same of a volume's tetrahedra");
  tets->type_name("N|P%")->check(number_or_share())->excludes(target);
  CLI::Option* error = command.add_option(
      "--target-error", o.target_error_pct,
      "As coarse as possible within this distance from the original, measured both\nways on the "
      "result, percent of the diagonal");
  error->type_name("PCT")
      ->transform(percent())
      ->check(positive_number())
      ->excludes(target)
      ->excludes(tets);
  CLI::Option* reach = command.add_flag(
      "--reach", o.reach,
      "Where a target is missed, lets go of guards until it is met: of small angles,\nof facing, "
      "of features, then of corners; never of the topology");
  reach->excludes(error);
  CLI::Option* factor =
      command.add_option("--factor", o.decimation.factor, "Edges become this many times longer");
  factor->type_name("F")
      ->check(positive_number())
      ->capture_default_str()
      ->excludes(target)
      ->excludes(tets)
      ->excludes(error)
      ->each([&o](const std::string&) { o.factor_given = true; });
  CLI::Option* coarsest =
      command.add_flag("--coarsest", o.decimation.coarsest, "No limit on the length of edges");
  coarsest->excludes(factor)->excludes(error);
  CLI::Option* spacing = command.add_option(
      "--spacing", o.spacing,
      "How long edges become, in the mesh's units: a file with a number for each\n"
      "vertex; curvature (longer where it is flatter); surface (of a volume:\n"
      "--factor times what they are on model faces, growing inside); or a formula\n"
      "of x, y, z, h (mean length of the edges there), k (curvature) and diag\n"
      "(diagonal of the box): \"x < 0 ? 2 * h : 8 * h\"");
  spacing->type_name("FILE|EXPR|curvature|surface")
      ->check(not_empty())
      ->excludes(coarsest)
      ->excludes(error);
  CLI::Option* gradation = command.add_option(
      "--gradation", o.gradation,
      "How much the spacing may grow per unit of length; default " +
          number_text(default_spacing_growth) + " for\ncurvature and surface, else no limit");
  gradation->type_name("G")->check(positive_number())->needs(spacing);
  put_into("What to aim at", {target, tets, error, reach, factor, coarsest, spacing, gradation});
}

void add_ways(CLI::App& command, DecimateOptions& o) {
  CLI::Option* strategy =
      command.add_option("--strategy", o.strategy,
                         "quality: cheapest collapse first, vertices placed, fitted to "
                         "the original;\npaper: the loop as printed");
  strategy->type_name("paper|quality")
      ->transform(one_of({"paper", "quality"}))
      ->capture_default_str();
  CLI::Option* regularity =
      command.add_option("--regularity", o.decimation.regularity,
                         "For quality: 0 accuracy first .. 1 regular faces first");
  regularity->type_name("W")->check(between(0, 1))->capture_default_str();
  CLI::Option* features = command.add_option(
      "--feature-angle", o.feature_angle,
      "Edges whose faces meet at more than this become model edges; where that\nwould cost more "
      "than half of --target-faces, only from 50 degrees on unless\nit is given");
  features->type_name("DEG|off")->transform(angle_or_off())->capture_default_str();
  features->each([&o](const std::string&) { o.feature_angle_given = true; });
  CLI::Option* seams = command.add_option(
      "--seams", o.seams, "Whether edges where texture coordinates jump become model edges");
  seams->type_name("keep|ignore")->transform(one_of({"keep", "ignore"}))->capture_default_str();
  CLI::Option* attributes = command.add_option(
      "--attributes", o.attributes,
      "For quality: arrays that count beside the shape. At weight 1 a difference\n"
      "over the whole range counts like 0.1 % of the diagonal, at 0 it does not.\n"
      "Colours (3) and texture coordinates (1) do by themselves; after none only\n"
      "what follows");
  attributes->type_name("NAME[=WEIGHT],...|none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(not_empty());
  CLI::Option* improve =
      command.add_option("--improve", o.decimation.improve_passes,
                         "For paper: sweeps that are followed by swaps and smoothing");
  improve->type_name("N")->transform(whole_number(0, 1000))->capture_default_str();
  CLI::Option* exchange = command.add_flag(
      "--exchange", o.decimation.exchange,
      "For paper: T(0,2) makes way for T(0,1) and T(1,2) during swaps and smoothing;\nthe "
      "result is the same");
  CLI::Option* no_swap = command.add_flag("--no-swap", o.no_swap, "No edge swaps");
  CLI::Option* no_smooth = command.add_flag("--no-smooth", o.no_smooth, "No smoothing");
  CLI::Option* snap = command.add_option("--snap", o.snap,
                                         "model: smoothing puts vertices onto the model, that of "
                                         "--model or else\nthe facets of the input");
  snap->type_name("none|model")->transform(one_of({"none", "model"}))->capture_default_str();
  CLI::Option* model = command.add_option(
      "--model", o.model,
      "The CAD model that the mesh lies on: .step, .stp, .brep, .iges, .igs or .geo\n"
      "(with Gmsh); a mesh without classification is classified on it");
  model->type_name("FILE")->check(not_empty());
  CLI::Option* repair =
      command.add_flag("--repair", o.repair, "First mends what aomd repair mends by itself");
  CLI::Option* triangulate = command.add_flag("--triangulate", o.triangulate,
                                              "First cuts quads along the shorter diagonal");
  CLI::Option* split = command.add_flag(
      "--split-to-tets", o.split_to_tets,
      "First cuts hexahedra, prisms and pyramids into tetrahedra, without new vertices");
  CLI::Option* weld = add_weld(command, o.weld);
  CLI::Option* without = command.add_option(
      "--without", o.without,
      "For quality, to see what they are worth: leaves out ideas of docs/QUALITY.md:\n" +
          idea_list());
  without->type_name("IDEA,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(one_of(idea_names()));
  put_into("How", {strategy, regularity, features, seams, attributes, improve, exchange, no_swap,
                   no_smooth, snap, model, triangulate, split, repair, weld, without,
                   add_threads(command, o.threads)});
}

void add_guarantees(CLI::App& command, DecimateOptions& o) {
  CLI::Option* turn =
      command.add_option("--angle", o.angle_deg,
                         "How far a face may turn in one operation; default 10 for paper and\n"
                         "with --coarsest, else 60");
  turn->type_name("DEG")->check(angle());
  CLI::Option* smallest = command.add_option(
      "--min-angle", o.decimation.min_angle_deg,
      "No face gets an angle below it unless it had a smaller one (for paper: in\na collapse)");
  smallest->type_name("DEG")->check(between(0, 60));
  CLI::Option* dihedral = command.add_option(
      "--min-dihedral", o.decimation.min_dihedral_deg,
      "Of a volume: no tetrahedron gets an angle between two faces below it unless\none as bad was "
      "around it");
  dihedral->type_name("DEG")->check(between(0, 70))->each([&o](const std::string&) {
    o.min_dihedral_given = true;
  });
  CLI::Option* distance = command.add_option(
      "--max-distance", o.max_distance_pct,
      "No point of the result is further from the original, percent of the diagonal;\n"
      "of a volume each model face and edge by itself, and the other way round too");
  distance->type_name("PCT")
      ->transform(percent())
      ->check(positive_number())
      ->excludes(command.get_option("--target-error"));
  CLI::Option* intersections = command.add_flag("--no-intersections", o.decimation.no_intersections,
                                                "No faces cut each other that did not");
  CLI::Option* volume = command.add_option(
      "--volume", o.volume_rule,
      "For quality on tetrahedra. keep: no model region changes by more than 0.1 % of\nits volume; "
      "free: none of that is asked. keep by itself");
  volume->type_name("keep|free")->transform(one_of({"keep", "free"}));
  CLI::Option* topology = command.add_option(
      "--topology", o.topology, "safe: keeps the topology; paper: as printed, without that check");
  topology->type_name("safe|paper")->transform(one_of({"safe", "paper"}))->capture_default_str();
  CLI::Option* keep = command.add_option(
      "--keep", o.keep,
      "Vertices that stay where they are, one item a line: a vertex (123), a range\n"
      "(10-20), or a model entity and so all on it (vertex 3, edge 7, face 2)");
  CLI::Option* only = command.add_option(
      "--only", o.only,
      "All other vertices stay; a model entity lists the vertices on it, and not\n"
      "those of what bounds it (region 2: those inside)");
  for (CLI::Option* each : {keep, only}) each->type_name("FILE")->check(not_empty());
  put_into("Guarantees",
           {turn, smallest, dihedral, distance, intersections, volume, topology, keep, only});
}

// A block knows its own faces alone, and what is found in it has no numbers of the whole.
void add_blocks(CLI::App& command, DecimateOptions& o) {
  CLI::Option* blocks = command.add_option(
      "--blocks", o.blocks,
      "For surfaces that do not fit into memory (PLY, STL or VTU of bytes, a folder of\nsuch "
      "tiles, or .pvtu): cuts "
      "the input into so many pieces, makes one after the other coarser,\nthen all of it together");
  blocks->type_name("N")
      ->transform(whole_number(1, static_cast<int>(BlockCut::most_blocks)))
      ->capture_default_str()
      ->needs(command.get_option("--target-faces"));
  for (const char* other : {"--reach", "--spacing", "--attributes", "--model", "--snap", "--repair",
                            "--triangulate", "--split-to-tets", "--max-distance",
                            "--no-intersections", "--topology", "--keep", "--only", "--journal"})
    blocks->excludes(command.get_option(other));
  put_into("How", {blocks});
}

void add_outputs(CLI::App& command, DecimateOptions& o) {
  CLI::Option* report =
      command.add_option("--report", o.report, "What was done and measured, as JSON");
  CLI::Option* journal =
      command.add_option("--journal", o.journal, "Every operation, for aomd replay");
  for (CLI::Option* each : {report, journal}) each->type_name("FILE")->check(not_empty());
  CLI::Option* strict = command.add_flag(
      "--strict", o.strict, "Exit code 1 where the target is missed by more than 1 percent");
  CLI::Option* quiet = command.add_flag("--quiet", o.quiet, "Prints nothing but errors");
  put_into("Output", {report, journal, add_format(command, o.format), add_pieces(command, o.pieces),
                      strict, quiet});
}

bool by_surface(const std::optional<SpacingSource>& source) {
  return source && std::holds_alternative<SpacingBySurface>(source->from);
}

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

std::uint32_t DecimateOptions::target_count(bool volume, std::uint32_t input_count) const {
  if (volume && !target.empty())
    throw UsageError("--target-faces is for surfaces, and " + input +
                     " has regions: --target-tets says how many tetrahedra");
  if (!volume && !target_tets.empty())
    throw UsageError("--target-tets is for volumes, and " + input +
                     " has no regions: --target-faces says how many faces");
  const std::string& text = volume ? target_tets : target;
  if (text.empty()) return 0;
  if (const auto number = parse_whole_number(text)) return static_cast<std::uint32_t>(*number);
  const double share = *parse_share(text) / 100 * double(input_count);
  return std::max(1u, static_cast<std::uint32_t>(std::lround(share)));
}

void DecimateOptions::check_kind(bool volume) const {
  if (volume && topology == "paper")
    throw UsageError("--topology paper is for surfaces: tetrahedra always keep the topology");
  if (volume && target_error_pct > 0)
    throw UsageError("--target-error is for surfaces, and " + input + " has regions");
  if (!volume && !volume_rule.empty())
    throw UsageError("--volume is for volumes, and " + input + " has no regions");
  if (!volume && min_dihedral_given)
    throw UsageError("--min-dihedral is for volumes, and " + input +
                     " has no regions: --min-angle limits the angles of faces");
  if (!attributes.empty() && volume)
    throw UsageError("--attributes is for surfaces, and " + input + " has regions");
  if (!attributes.empty() && paper())
    throw UsageError("--attributes is for --strategy quality: the printed loop knows no cost");
  if (volume_rule == "keep" && paper())
    throw UsageError("--volume keep is for --strategy quality: the printed loop places no vertex");
  if (volume_rule == "keep" && snaps())
    throw UsageError("--volume keep excludes --snap model, which says where vertices lie");
  if (reach && target.empty() && target_tets.empty())
    throw UsageError("--reach is for --target-faces and --target-tets");
}

std::vector<NamedFile> DecimateOptions::inputs() const {
  std::error_code ignored;
  const bool from_file = std::filesystem::is_regular_file(spacing, ignored);
  return {{"IN", input},
          {"--model", model},
          {"--keep", keep},
          {"--only", only},
          {"--spacing", from_file ? spacing : std::string()}};
}

std::vector<NamedFile> DecimateOptions::outputs() const {
  return {{"OUT", output}, {"--journal", journal}, {"--report", report}};
}

DecimationOptions DecimateOptions::for_library() const {
  DecimationOptions result = decimation;
  result.strategy = paper() ? Strategy::Paper : Strategy::Quality;
  result.angle_deg = angle_deg.value_or(
      usual_angle_deg(paper() ? Strategy::Paper : Strategy::Quality, decimation.coarsest));
  result.keep_volumes = volume_rule != "free" && !snaps();
  result.topology = topology == "paper" ? TopologyRule::Paper : TopologyRule::Safe;
  for (int i = 0; i < idea_count; ++i)
    if (std::find(without.begin(), without.end(), idea_name(static_cast<Idea>(i))) != without.end())
      result.without |= 1u << i;
  result.threads = thread_count(threads);
  result.swap = !no_swap;
  result.smooth = !no_smooth;
  return result;
}

ClassifyOptions DecimateOptions::for_classification() const {
  ClassifyOptions result;
  result.feature_angle_deg = parse_number(feature_angle);  // nothing for "off"
  result.nonmanifold_edges = topology != "paper";
  return result;
}

std::optional<SpacingSource> DecimateOptions::spacing_source() const {
  if (spacing.empty()) return {};
  try {
    SpacingSource source = parse_spacing(spacing, decimation.factor);
    if (gradation) source.growth = gradation;
    return source;
  } catch (const std::invalid_argument& e) {
    throw UsageError(std::string("--spacing: ") + e.what());
  }
}

void DecimateOptions::check_spacing() const {
  if (weld.on() && !repair && blocks <= 1)
    throw UsageError("--weld requires --repair, or tiles with --blocks");
  const auto source = spacing_source();
  if (source && factor_given && !by_surface(source))
    throw UsageError("--factor excludes --spacing, unless that is surface");
}

Json DecimateOptions::json(const DecimationOptions& steps, bool volume) const {
  const auto source = spacing_source();
  const bool aims = steps.target_faces > 0 || target_error_pct > 0;
  const bool by_factor = by_surface(source) || (!steps.coarsest && !source && !aims);
  const Json aim = steps.target_faces > 0 ? Json(steps.target_faces) : Json(nullptr);
  return {
      {"strategy", strategy},
      {"regularity", steps.regularity},
      {"target_faces", volume ? Json(nullptr) : aim},
      {"target_tets", volume ? aim : Json(nullptr)},
      {"target_error_pct", target_error_pct > 0 ? Json(target_error_pct) : Json(nullptr)},
      {"reach", reach},
      {"factor", by_factor ? Json(steps.factor) : Json(nullptr)},
      {"coarsest", steps.coarsest},
      {"spacing", or_null(spacing)},
      {"gradation", or_null(source ? source->growth : std::nullopt)},
      {"angle_deg", steps.angle_deg},
      {"min_angle_deg", steps.min_angle_deg},
      {"min_dihedral_deg", volume ? Json(steps.min_dihedral_deg) : Json(nullptr)},
      {"max_distance_pct", max_distance_pct > 0 ? Json(max_distance_pct) : Json(nullptr)},
      {"no_intersections", steps.no_intersections},
      {"feature_angle_deg", or_null(for_classification().feature_angle_deg)},
      {"seams", seams},
      {"attributes", attributes},
      {"improve", steps.improve_passes},
      {"exchange", steps.exchange},
      {"without", without},
      {"swap", steps.swap},
      {"smooth", steps.smooth},
      {"threads", steps.threads},
      {"blocks", blocks},
      {"pieces", pieces},
      {"topology", topology},
      {"volume", volume && !paper() ? Json(steps.keep_volumes ? "keep" : "free") : Json(nullptr)},
      {"keep", or_null(keep)},
      {"only", or_null(only)},
      {"snap", snap},
      {"model", or_null(model)},
      {"triangulate", triangulate},
      {"split_to_tets", split_to_tets},
      {"repair", repair},
      {"weld", weld.on() ? Json(weld.text) : Json(nullptr)},
      {"journal", or_null(journal)}};
}

void add_decimate_options(CLI::App& command, DecimateOptions& options) {
  command.add_option("IN", options.input, "The mesh; - is standard input")
      ->required()
      ->type_name("FILE")
      ->check(not_empty());
  command
      .add_option(
          "OUT", options.output,
          "Where to write the result; the extension chooses the format; - is standard output")
      ->required()
      ->type_name("FILE")
      ->check(not_empty());
  command.get_formatter()->label("Excludes", "not with");
  command.get_formatter()->label("Needs", "with");
  add_aims(command, options);
  add_ways(command, options);
  add_guarantees(command, options);
  add_outputs(command, options);
  add_blocks(command, options);
}

}  // namespace aomd::cli
