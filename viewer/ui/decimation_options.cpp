// The options of the page Decimation.

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::short_number;

void label(const Frame& frame, const char* name, const char* help) {
  ImGui::AlignTextToFramePadding();
  muted(frame, name);
  tooltip(help);
}

/// Where what stands beside a name begins.
float name_width() { return 5.4f * em(); }

constexpr const char* spacing_help =
    "The spacing: how long edges become, in the units of the mesh as opened, then Enter. A file "
    "with a "
    "number "
    "for each vertex; curvature: longer where it is flatter; or a formula of x, y, z, h (mean "
    "length of the "
    "edges "
    "there), k (curvature) and diag (diagonal of the box), like x < 0 ? 2 * h : 8 * h.";

constexpr const char* factor_help =
    "The spacing as a factor: how many times longer edges become (\u00d7 their mean length at the "
    "start) "
    "where "
    "the angle does not bind.";
constexpr const char* faces_help =
    "Stops at this many faces, or where nothing more may go. A share of those as opened: the "
    "command target-faces 10%.";
constexpr const char* tetrahedra_help =
    "Stops at this many tetrahedra, or where nothing more may go. A share of those as opened: the "
    "command target-faces 10%.";
constexpr const char* distance_help =
    "No operation takes the surface farther than this from the mesh as opened, percent of the "
    "diagonal of its box; 0 is no limit. It is guaranteed, and runs take several times as long.";
constexpr const char* least_angle_help =
    "No face gets a smaller angle than this, degrees, unless it had one; 0 is no limit. Costs "
    "next to no time, and leaves some faces more.";
constexpr const char* least_dihedral_help =
    "No tetrahedron gets a smaller angle between two of its faces than this, degrees, unless one "
    "as bad was around it; 0 is no limit. Costs next to no time, and leaves some tetrahedra more.";
constexpr const char* intersections_help =
    "No operation makes faces cut each other that did not. Runs take several times as long.";
constexpr const char* volumes_help =
    "No model region changes by more than 0.1 % of its volume. Costs next to no time; without it "
    "a few more tetrahedra can go.";
constexpr const char* angle_help =
    "How far the normal of a face may turn in one operation, in degrees.";
constexpr const char* feature_help =
    "Edges whose faces meet at more than this angle (degrees) become model edges, which collapses "
    "respect.";
constexpr const char* regularity_help =
    "0: accuracy first, the surface stays as close to the mesh as opened as its faces allow. 1: "
    "regular "
    "faces "
    "first, closer to equilateral, for a larger distance. No unit.";
constexpr const char* passes_help =
    "How many sweeps are followed by edge swaps and vertex smoothing: a number of sweeps.";

void strategy_control(Frame& frame, const DecimationOptions& options) {
  constexpr Choice choices[] = {{"Paper",
                                 "The loop as printed in the paper: edges in their order, in "
                                 "sweeps; a collapse leaves the other "
                                 "vertex "
                                 "where it is."},
                                {"Quality",
                                 "What costs least goes first, the vertex that stays is put where "
                                 "the error is least, and the result "
                                 "is fitted to the mesh as opened."}};
  label(frame, "Strategy", "How to choose what goes.");
  ImGui::SameLine(name_width());
  ImGui::SetNextItemWidth(-1);
  const std::size_t present = options.strategy == Strategy::Paper ? 0 : 1;
  if (const auto chosen = choice_control("##strategy", choices, present))
    frame.emit(*chosen == 0 ? "strategy paper" : "strategy quality");
}

enum class Aim : std::size_t { Factor, Faces, Lengths, Coarsest };

Aim aim_of(const DecimationOptions& options) {
  if (options.target_faces > 0) return Aim::Faces;
  if (options.spacing) return Aim::Lengths;
  return options.coarsest ? Aim::Coarsest : Aim::Factor;
}

bool is_volume(const Frame& frame) {
  return frame.has_mesh() && frame.document().content().volume();
}

/// Faces, or tetrahedra, as opened: the upper end of the slider.
std::int64_t cells_at_most(const Frame& frame) {
  if (!frame.has_mesh()) return 100'000;
  const scene::MeshFacts& facts = frame.session.sheet().loaded_facts();
  const std::int64_t cells =
      is_volume(frame) ? facts.shapes[static_cast<std::size_t>(Shape::Tetrahedron)] : facts.faces;
  return std::max<std::int64_t>(cells, 8);
}

void take_aim(Frame& frame, Aim aim) {
  const DecimationOptions& options = frame.document().options();
  switch (aim) {
    case Aim::Factor:
      return frame.emit("factor " + short_number(options.factor));
    case Aim::Faces:
      return frame.emit("target-faces " +
                        std::to_string(std::max<std::int64_t>(cells_at_most(frame) / 10, 4)));
    case Aim::Lengths:
      return frame.emit("spacing curvature");
    case Aim::Coarsest:
      return frame.emit("coarsest on");
  }
}

/// What a number of faces means, and which share of those as opened it is.
std::string cells_help(const Frame& frame, double cells) {
  const auto most = cells_at_most(frame);
  return std::string(is_volume(frame) ? tetrahedra_help : faces_help) + " Now " +
         short_number(100 * cells / static_cast<double>(most), 1) + " % of " +
         scene::grouped(most) + ".";
}

void aim_value(Frame& frame, const DecimationOptions& options, DecimationDrafts& drafts) {
  switch (aim_of(options)) {
    case Aim::Factor: {
      double factor = options.factor;
      if (number_control("factor", factor, {1, 32, "%.2f \u00d7", true, factor_help}))
        frame.emit("factor " + short_number(factor));
      return;
    }
    case Aim::Faces: {
      double faces = options.target_faces;
      const auto most = static_cast<double>(cells_at_most(frame));
      const std::string help = cells_help(frame, faces);
      if (number_control("faces", faces, {4, most, "%.0f", true, help.c_str()}))
        frame.emit("target-faces " + std::to_string(std::llround(faces)));
      return;
    }
    case Aim::Lengths: {
      if (const auto source = frame.document().spacing_source(); drafts.spacing_source != source)
        drafts.spacing = drafts.spacing_source = source;
      ImGui::SetNextItemWidth(-1);
      if (text_input("##spacing", drafts.spacing))
        frame.emit("spacing " + scene::as_rest(drafts.spacing));
      tooltip(spacing_help);
      return;
    }
    case Aim::Coarsest:
      ImGui::AlignTextToFramePadding();
      return muted(frame, "Angle and model decide.");
  }
}

void aim_control(Frame& frame, const DecimationOptions& options, DecimationDrafts& drafts) {
  const Choice choices[] = {
      {"Spacing factor", factor_help},
      is_volume(frame) ? Choice{"Number of tetrahedra", tetrahedra_help}
                       : Choice{"Number of faces", faces_help},
      {"Spacing", spacing_help, frame.can_decimate()},
      {"Coarsest", "No spacing: only the angle and the model stop a collapse."}};
  label(frame, "Aim at",
        "How far to go: to a spacing of edges, to a number of faces, or as far as the limits let "
        "it.");
  ImGui::SameLine(name_width());
  ImGui::SetNextItemWidth(-1);
  const Aim present = aim_of(options);
  if (const auto chosen = choice_control("##aim", choices, static_cast<std::size_t>(present)))
    take_aim(frame, static_cast<Aim>(*chosen));
  aim_value(frame, options, drafts);
}

void snap_control(Frame& frame) {
  const scene::Document& document = frame.document();
  const char* name = "Snap to model";
  same_line_right(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                  ImGui::CalcTextSize(name).x);
  ImGui::BeginDisabled(document.running());
  bool on = document.snaps();
  if (ImGui::Checkbox(name, &on)) frame.emit(on ? "snap model" : "snap none");
  ImGui::EndDisabled();
  tooltip(
      "Smoothing puts every vertex that it moves back onto the model face or edge that it lies on: "
      "of the "
      "CAD "
      "model when one is given, or else onto the facets of the mesh as opened (distance 0 but for "
      "rounding, "
      "in the mesh's units of length). Off: it may leave the model, and round shapes shrink.");
}

void angle_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Angle limit", angle_help);
  snap_control(frame);
  double angle = options.angle_deg;
  if (number_control("angle", angle, {1, 90, "%.1f\u00b0", false, angle_help}))
    frame.emit("angle " + short_number(angle));
}

/// Deriving the classification takes longer than a frame on large meshes: only when the value is
/// let go.
void feature_angle_control(Frame& frame, DecimationDrafts& drafts) {
  const auto present = frame.document().classify_options().feature_angle_deg;
  const scene::FeatureTrial* trial = frame.document().trial();
  if (!drafts.editing_feature_angle)
    drafts.feature_angle_deg = trial != nullptr ? trial->angle_deg : present.value_or(20);
  label(frame, "Feature angle", feature_help);
  same_line_right(6.1f * em());
  bool on = present.has_value();
  if (ImGui::Checkbox("Features", &on))
    frame.emit(on ? "feature-angle " + short_number(drafts.feature_angle_deg)
                  : "feature-angle off");
  tooltip(
      "Off: only boundaries, non-manifold edges and borders between model faces are model edges.");
  ImGui::BeginDisabled(!on);
  ImGui::BeginGroup();
  const bool changed = number_control("feature", drafts.feature_angle_deg,
                                      {1, 90, "%.1f\u00b0", false, feature_help});
  ImGui::EndGroup();
  ImGui::EndDisabled();
  drafts.editing_feature_angle = (drafts.editing_feature_angle || changed) && on;
  const bool can_try = frame.has_mesh() && !frame.document().content().skin &&
                       !frame.document().content().classified_by_file();
  if (changed && can_try) frame.emit("feature-preview " + short_number(drafts.feature_angle_deg));
  if (trial != nullptr)
    muted(frame, "gives " + scene::counted(trial->preview.model_edges, "model edge") + ", " +
                     scene::counted(trial->preview.model_vertices, "vertex"));
  if (drafts.editing_feature_angle && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    drafts.editing_feature_angle = false;
    frame.emit("feature-angle " + short_number(drafts.feature_angle_deg));
  }
}

double distance_percent(const Frame& frame) {
  const double diagonal = frame.has_mesh() ? frame.document().content().bounds.diagonal() : 0;
  return diagonal > 0 ? 100 * frame.document().options().max_distance / diagonal : 0;
}

/// "distance, angles": which are set.
std::string limits_that_hold(const Frame& frame, const DecimationOptions& options) {
  std::string set;
  const auto add = [&](bool on, const char* name) {
    if (on) set += (set.empty() ? "" : ", ") + std::string(name);
  };
  add(options.max_distance > 0, "distance");
  add((is_volume(frame) ? options.min_dihedral_deg : options.min_angle_deg) > 0, "angles");
  add(options.no_intersections, "intersections");
  add(is_volume(frame) && !options.keep_volumes, "volumes free");
  return set;
}

void limit_number(Frame& frame, const char* name, const char* command, double value,
                  const NumberStyle& style) {
  label(frame, name, style.help);
  ImGui::SameLine(name_width());
  ImGui::BeginGroup();
  if (number_control(command, value, style))
    frame.emit(std::string(command) + " " + short_number(value, 4));
  ImGui::EndGroup();
}

void limits(Frame& frame, const DecimationOptions& options) {
  ImGui::BeginDisabled(!frame.has_mesh());
  limit_number(frame, "Distance", "max-distance", distance_percent(frame),
               {0, 5, "%.3f %%", false, distance_help});
  ImGui::EndDisabled();
  if (is_volume(frame))
    limit_number(frame, "Least angle", "min-dihedral", options.min_dihedral_deg,
                 {0, 70, "%.1f\u00b0", false, least_dihedral_help});
  else
    limit_number(frame, "Least angle", "min-angle", options.min_angle_deg,
                 {0, 60, "%.1f\u00b0", false, least_angle_help});
  bool cuts = options.no_intersections;
  if (ImGui::Checkbox("No new intersections", &cuts))
    frame.emit(cuts ? "no-intersections on" : "no-intersections off");
  tooltip(intersections_help);
  if (!is_volume(frame) || options.strategy != Strategy::Quality) return;
  bool keeps = options.keep_volumes;
  if (ImGui::Checkbox("Volumes of regions stay", &keeps))
    frame.emit(keeps ? "volume keep" : "volume free");
  tooltip(volumes_help);
}

void topology_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Topology", "");
  if (ImGui::GetContentRegionAvail().x > 14.5f * em())
    ImGui::SameLine(6.2f * em());
  else
    ImGui::SameLine(0, 0.4f * em());
  ImGui::BeginDisabled(is_volume(frame));
  const bool safe = options.topology == TopologyRule::Safe || is_volume(frame);
  if (ImGui::RadioButton("Safe", safe)) frame.emit("topology safe");
  tooltip("A collapse must keep the topology: link condition, so the Euler number stays.");
  ImGui::SameLine();
  if (ImGui::RadioButton("Paper", !safe)) frame.emit("topology paper");
  tooltip("As printed in the paper, without that check: thin parts may fuse or vanish.");
  ImGui::EndDisabled();
}

void regularity_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Regularity", regularity_help);
  ImGui::SameLine(name_width());
  double regularity = options.regularity;
  ImGui::BeginGroup();
  if (number_control("regularity", regularity, {0, 1, "%.2f", false, regularity_help}))
    frame.emit("regularity " + short_number(regularity));
  ImGui::EndGroup();
}

void passes_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Improve passes", passes_help);
  same_line_right(6.1f * em());
  ImGui::SetNextItemWidth(-1);
  int passes = options.improve_passes;
  if (ImGui::InputInt("##passes", &passes, 1, 1))
    frame.emit("improve-passes " + std::to_string(std::max(0, passes)));
  tooltip(passes_help);
}

}  // namespace

void decimation_options(Frame& frame, DecimationDrafts& drafts) {
  const DecimationOptions& options = frame.document().options();
  strategy_control(frame, options);
  aim_control(frame, options, drafts);
  angle_control(frame, options);
  feature_angle_control(frame, drafts);
  topology_control(frame, options);
  if (options.strategy == Strategy::Paper)
    passes_control(frame, options);
  else
    regularity_control(frame, options);
}

float limits_button_width() {
  return ImGui::CalcTextSize("Limits").x + 2 * ImGui::GetStyle().FramePadding.x;
}

void limits_button(Frame& frame) {
  const DecimationOptions& options = frame.document().options();
  const std::string set = limits_that_hold(frame, options);
  ImGui::PushStyleColor(ImGuiCol_Text, set.empty() ? frame.colors.text : frame.colors.accent);
  if (ImGui::Button("Limits", {limits_button_width(), 0})) ImGui::OpenPopup("limits");
  ImGui::PopStyleColor();
  tooltip("What no operation may do besides turning a face too far, and what holding that costs." +
          (set.empty() ? "" : " Set: " + set + "."));
  constexpr float wide_ems = 22;
  ImGui::SetNextWindowSizeConstraints({wide_ems * em(), 0}, {wide_ems * em(), FLT_MAX});
  if (!ImGui::BeginPopup("limits")) return;
  limits(frame, options);
  ImGui::EndPopup();
}

}  // namespace aomd::ui
