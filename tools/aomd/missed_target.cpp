#include "tools/aomd/missed_target.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/decimate/explain/stop_words.h"
#include "core/repair/survey.h"
#include "tools/aomd/surface_lines.h"

namespace aomd::cli {
namespace {

// What keeps a smaller share of the edges is not worth loosening.
constexpr std::int64_t least_share = 20;

/// Looks for what loosens one reason. What --reach has let go of is no help any more.
class Loosening {
 public:
  Loosening(const DecimateOptions& given, const DecimationOptions& steps, const RunInput& input)
      : given_(given), steps_(steps), input_(input), original_(input.mesh) {}

  [[nodiscard]] std::string against(Reason reason) const {
    const bool volume = !original_.regions.empty();
    switch (reason) {
      case Reason::Spacing:
        return given_.spacing.empty() ? "" : "a larger --spacing";
      case Reason::Classification:
        return against_classification();
      case Reason::Topology:
        if (volume) return "";
        if (std::string mending = by_mending(); !mending.empty()) return mending;
        return steps_.topology == TopologyRule::Safe ? of_the_whole("--topology paper") : "";
      case Reason::Flat:
        return given_.repair || volume ? "" : given_.mending();
      case Reason::Angle:
        return against_angle();
      case Reason::Shape:
        return against_shape();
      case Reason::Kept:
        if (!given_.keep.empty()) return "fewer vertices in --keep";
        if (!given_.only.empty()) return "more vertices in --only";
        return has_other_shapes() ? "aomd convert --split-to-tets" : "";
      case Reason::Distance:
        if (given_.max_distance_pct == 0) return "";
        return "--max-distance " + number_text(2 * given_.max_distance_pct);
      case Reason::Intersection:
        return "leaving out --no-intersections";
      case Reason::Volume:
        return "--volume free";
      case Reason::None:
      case Reason::Quality:
      case Reason::Inverted:
      case Reason::Overshoot:
        break;
    }
    return "";
  }

  /// Borders that should be none.
  [[nodiscard]] std::string by_welding() const {
    if (input_.counts.boundary_edges > 0)
      for (const SurfaceFinding& finding : survey(original_))
        if (finding.remedy == Remedy::Weld) return "aomd repair " + weld_words(finding);
    return "";
  }

 private:
  [[nodiscard]] std::string against_angle() const {
    if (steps_.angle_deg >= 90) return "";
    return "--angle " + number_text(std::min(90.0, 2 * steps_.angle_deg));
  }

  [[nodiscard]] std::string against_shape() const {
    const bool dihedral = steps_.min_dihedral_deg > 0, angle = steps_.min_angle_deg > 0;
    if (dihedral) return std::string("a smaller --min-dihedral") + (angle ? " or --min-angle" : "");
    return angle ? "a smaller --min-angle" : "";
  }

  /// Borders that should be none, and edges of many faces, are model edges as features are. Those
  /// of a volume are mostly its interfaces, which no option takes away. Only --reach lets go of the
  /// corners of borders.
  [[nodiscard]] std::string against_classification() const {
    if (!original_.regions.empty()) return "";
    if (std::string mending = by_mending(); !mending.empty()) return mending;
    const bool by_file = !original_.faces.classes.empty() || !original_.edges.classes.empty();
    if (by_file) return "aomd classify --replace";  // then the angle has no say
    if (given_.reach) return "";
    if (input_.features) return "--feature-angle off";
    return of_the_whole("--reach");
  }

  /// Vertices of regions that are no tetrahedra stay.
  [[nodiscard]] bool has_other_shapes() const {
    const std::vector<Shape>& shapes = original_.regions.shapes;
    return std::any_of(shapes.begin(), shapes.end(),
                       [](Shape shape) { return shape != Shape::Tetrahedron; });
  }

  [[nodiscard]] std::string by_mending() const {
    if (std::string welding = by_welding(); !welding.empty()) return welding;
    return input_.counts.nonmanifold_edges > 0 && !given_.repair ? given_.mending() : "";
  }

  /// With blocks such options are refused.
  [[nodiscard]] std::string of_the_whole(const char* option) const {
    return given_.blocks > 1 ? "" : option;
  }

  const DecimateOptions& given_;
  const DecimationOptions& steps_;
  const RunInput& input_;
  const MeshData& original_;
};

/// "; --angle 20 would help, or --feature-angle off"
std::string words_of(const std::vector<Help>& help) {
  if (help.empty()) return "";
  std::string text = "; " + help.front().option + " would help";
  for (std::size_t i = 1; i < help.size(); ++i) text += ", or " + help[i].option;
  return text;
}

}  // namespace

bool misses(std::uint64_t faces, std::uint64_t target) {
  return target > 0 && 100 * faces > 101 * target;
}

std::uint64_t least_faces(const measure::Counts& input) {
  const std::uint64_t of_a_piece = input.boundary_edges == 0 ? 4 : 1;
  return of_a_piece * input.components;
}

std::vector<Help> what_would_help(const EdgesByReason& edges, const DecimateOptions& given,
                                  const DecimationOptions& steps, const RunInput& input,
                                  std::uint64_t faces) {
  const Loosening loosening(given, steps, input);
  std::vector<Help> help;
  const auto add = [&](Reason reason, std::string option) {
    const auto same = [&](const Help& each) { return each.option == option; };
    if (!option.empty() && std::none_of(help.begin(), help.end(), same))
      help.push_back({reason, std::move(option)});
  };
  if (faces <= least_faces(input.counts)) {
    add(Reason::None, loosening.by_welding());
    return help;
  }
  std::int64_t left = 0;
  for (const std::int64_t n : edges) left += n;
  for (const ReasonCount& each : by_number(edges))
    if (least_share * each.edges >= left) add(each.reason, loosening.against(each.reason));
  return help;
}

std::string sentence(const MissedTarget& missed, const DecimationOptions& steps,
                     std::uint64_t target, std::uint64_t cells, bool volume) {
  return grouped(cells) + (volume ? " tetrahedra" : " faces") + ", above the target of " +
         grouped(target) + ": " + words_of_edges_left(missed.edges, steps, volume) +
         words_of(missed.help);
}

Json refused_json(const EdgesByReason& edges) {
  Json refused = Json::object();
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i] > 0) refused[reason_name(static_cast<Reason>(i))] = edges[i];
  return refused;
}

Json help_json(const std::vector<Help>& help) {
  Json json = Json::object();
  for (const Help& each : help)
    if (each.reason != Reason::None) json[reason_name(each.reason)] = each.option;
  return json;
}

}  // namespace aomd::cli
