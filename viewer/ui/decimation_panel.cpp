#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "viewer/scene/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::grouped;
using scene::short_number;

void label(const Frame& frame, const char* name, const char* help) {
  ImGui::AlignTextToFramePadding();
  muted(frame, name);
  tooltip(help);
}

void factor_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Length factor",
        "How many times longer edges become (\u00d7 their average length at the start) where the angle does "
        "not bind.");
  same_line_right(6.1f * em());
  bool coarsest = options.coarsest;
  if (ImGui::Checkbox("Coarsest", &coarsest)) frame.emit(coarsest ? "coarsest on" : "coarsest off");
  tooltip("No limit on length: only the angle and the model stop a collapse.");
  ImGui::BeginDisabled(options.coarsest);
  double factor = options.factor;
  if (number_control("factor", factor, {1, 32, "%.2f \u00d7", true}))
    frame.emit("factor " + short_number(factor));
  ImGui::EndDisabled();
}

/// Beside a name: the panel just fits a window of 800x600.
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
      "Smoothing puts every vertex that it moves back onto the model face or edge that it lies on: of the "
      "CAD "
      "model when one is given, or else onto the facets of the mesh as opened (distance 0 but for rounding, "
      "in the mesh's units of length). Off: it may leave the model, and round shapes shrink.");
}

void angle_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Angle limit", "How far the normal of a face may turn in one operation, in degrees.");
  snap_control(frame);
  double angle = options.angle_deg;
  if (number_control("angle", angle, {1, 90, "%.1f\u00b0"})) frame.emit("angle " + short_number(angle));
}

/// Deriving the classification takes longer than a frame on large meshes: only when the value is let go.
void feature_angle_control(Frame& frame, DecimationDrafts& drafts) {
  const auto present = frame.document().classify_options().feature_angle_deg;
  if (!drafts.editing_feature_angle) drafts.feature_angle_deg = present.value_or(20);
  label(frame, "Feature angle",
        "Edges whose faces meet at more than this angle (degrees) become model edges, which collapses "
        "respect.");
  same_line_right(6.1f * em());
  bool on = present.has_value();
  if (ImGui::Checkbox("Features", &on))
    frame.emit(on ? "feature-angle " + short_number(drafts.feature_angle_deg) : "feature-angle off");
  tooltip("Off: only boundaries, non-manifold edges and borders between model faces are model edges.");
  ImGui::BeginDisabled(!on);
  ImGui::BeginGroup();
  const bool changed = number_control("feature", drafts.feature_angle_deg, {1, 90, "%.1f\u00b0"});
  ImGui::EndGroup();
  ImGui::EndDisabled();
  drafts.editing_feature_angle = (drafts.editing_feature_angle || changed) && on;
  if (drafts.editing_feature_angle && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    drafts.editing_feature_angle = false;
    frame.emit("feature-angle " + short_number(drafts.feature_angle_deg));
  }
}

void topology_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Topology", "");
  if (ImGui::GetContentRegionAvail().x > 14.5f * em())
    ImGui::SameLine(6.2f * em());
  else
    ImGui::SameLine(0, 0.4f * em());
  const bool safe = options.topology == TopologyRule::Safe;
  if (ImGui::RadioButton("Safe", safe)) frame.emit("topology safe");
  tooltip("A collapse must keep the topology: link condition, so the Euler number stays.");
  ImGui::SameLine();
  if (ImGui::RadioButton("Paper", !safe)) frame.emit("topology paper");
  tooltip("As printed in the paper, without that check: thin parts may fuse or vanish.");
}

void passes_control(Frame& frame, const DecimationOptions& options) {
  label(frame, "Improve passes", "How many sweeps are followed by edge swaps and vertex smoothing.");
  same_line_right(6.1f * em());
  ImGui::SetNextItemWidth(-1);
  int passes = options.improve_passes;
  if (ImGui::InputInt("##passes", &passes, 1, 1))
    frame.emit("improve-passes " + std::to_string(std::max(0, passes)));
}

float half_width() { return 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x); }

void operation_buttons(Frame& frame) {
  const bool ready = frame.can_decimate() && !frame.document().running();
  const float width = half_width();
  command_button(frame, "Step", "step", width, ready);
  ImGui::SameLine();
  command_button(frame, "Sweep", "sweep", width, ready);
  command_button(frame, "Swap", "swap", width, ready);
  ImGui::SameLine();
  command_button(frame, "Smooth", "smooth", width, ready);
  command_button(frame, "Improve", "improve", width, ready);
  ImGui::SameLine();
  command_button(frame, "Reset", "reset", width, ready && frame.document().can_undo());
}

void run_controls(Frame& frame) {
  const scene::Document& document = frame.document();
  if (!document.running()) {
    primary_button(frame, "Run", "run", -1, frame.can_decimate());
    return;
  }
  command_button(frame, "Cancel", "cancel", -1);
  const Decimation& decimation = *document.decimation();
  gap(0.15f);
  bar(document.run_progress(), ImGui::GetColorU32(frame.colors.accent), 0.5f);
  muted(frame, "Sweep " + std::to_string(decimation.sweeps().size()) + ": " + phase_name(decimation.phase()) +
                   ", " + std::to_string(static_cast<int>(100 * document.run_progress())) + " %");
}

struct Refusal {
  Reason reason;
  const char* name;
  const char* help;
};

constexpr std::array<Refusal, 6> refusals = {{
    {Reason::Spacing, "Long enough",
     "The edge has reached the wanted length: a larger factor would let it go."},
    {Reason::Classification, "Shape of the model",
     "Its vertex lies on a model vertex, or on a model edge that this edge leaves: collapsing it would cut a "
     "corner off."},
    {Reason::Topology, "Topology", "The surface would be pinched, doubled or torn (link condition)."},
    {Reason::Flat, "Flat face", "A face would lose its area."},
    {Reason::Angle, "Angle", "A face would turn by more than the angle limit."},
    {Reason::Quality, "Quality", "The triangles would not get a better shape."},
}};

void refusal_row(const Frame& frame, const Refusal& refusal, std::uint32_t count, std::uint32_t most) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  text(refusal.name);
  tooltip(refusal.help);
  ImGui::TableNextColumn();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.35f * em());
  ImGui::PushID(refusal.name);
  ImVec4 color = frame.colors.bad;
  color.w = 0.75f;
  bar(static_cast<double>(count) / most, ImGui::GetColorU32(color), 0.42f);
  tooltip(refusal.help);
  ImGui::PopID();
  ImGui::TableNextColumn();
  text_right(grouped(count));
}

void refusal_table(const Frame& frame, const SweepStatistics& sweep) {
  std::uint32_t most = 1;
  for (const Refusal& r : refusals) most = std::max(most, sweep.refused[static_cast<std::size_t>(r.reason)]);
  if (!ImGui::BeginTable("refusals", 3, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("reason", ImGuiTableColumnFlags_WidthFixed, 8.0f * em());
  ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("count", ImGuiTableColumnFlags_WidthFixed, 3.8f * em());
  for (const Refusal& r : refusals)
    if (const std::uint32_t n = sweep.refused[static_cast<std::size_t>(r.reason)]; n > 0)
      refusal_row(frame, r, n, most);
  ImGui::EndTable();
}

void last_sweep_section(const Frame& frame) {
  const SweepStatistics* sweep = frame.document().last_sweep();
  if (sweep == nullptr) return;
  gap();
  heading(frame, "Last sweep");
  std::string made = grouped(sweep->collapses) + " collapses";
  if (sweep->swaps > 0) made += ", " + grouped(sweep->swaps) + " swaps";
  if (sweep->smooths > 0) made += ", " + grouped(sweep->smooths) + " smoothed";
  ImGui::PushTextWrapPos(0);
  muted(frame, made + ". Edges it left, by reason:");
  ImGui::PopTextWrapPos();
  refusal_table(frame, *sweep);
}

}  // namespace

void decimation_panel(Frame& frame, DecimationDrafts& drafts) {
  const DecimationOptions& options = frame.document().options();
  if (const std::string_view why = frame.document().hindrance(); !why.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.warning);
    text(why);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
  }
  ImGui::BeginDisabled(frame.has_mesh() && !frame.can_decimate());
  factor_control(frame, options);
  angle_control(frame, options);
  feature_angle_control(frame, drafts);
  topology_control(frame, options);
  passes_control(frame, options);
  gap();
  operation_buttons(frame);
  run_controls(frame);
  ImGui::EndDisabled();
  last_sweep_section(frame);
}

}  // namespace aomd::ui
