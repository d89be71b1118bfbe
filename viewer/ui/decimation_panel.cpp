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

constexpr std::array<Refusal, 10> refusals = {{
    {Reason::Spacing, "Long enough",
     "The edge has reached the wanted length: a larger factor would let it go."},
    {Reason::Classification, "Shape of the model",
     "Its vertex lies on a model vertex, or on a model edge that this edge leaves: collapsing it would cut a "
     "corner off."},
    {Reason::Topology, "Topology", "The surface would be pinched, doubled or torn (link condition)."},
    {Reason::Flat, "Flat face", "A face would lose its area."},
    {Reason::Angle, "Angle", "A face would turn by more than the angle limit."},
    {Reason::Quality, "Quality", "The triangles would not get a better shape."},
    {Reason::Kept, "Kept", "Its vertices are to stay where they are."},
    {Reason::Shape, "Shape",
     "A face would get a smaller angle than is allowed: the least angle, and for quality at least 6 to 12 "
     "degrees."},
    {Reason::Distance, "Distance", "The surface would leave the original by more than the limit."},
    {Reason::Intersection, "Intersection", "The surface would cut itself where it did not."},
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
  tooltip(refusal.help);
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

void last_sweep_section(Frame& frame) {
  const SweepStatistics* sweep = frame.document().last_sweep();
  if (sweep == nullptr) return;
  gap();
  heading(frame, "Last sweep");
  copy_button(frame, "refusals");
  std::string made = grouped(sweep->collapses) + " collapses";
  if (sweep->swaps > 0) made += ", " + grouped(sweep->swaps) + " swaps";
  if (sweep->smooths > 0) made += ", " + grouped(sweep->smooths) + " smoothed";
  ImGui::PushTextWrapPos(0);
  muted(frame, made + ". Edges it left, by reason:");
  ImGui::PopTextWrapPos();
  refusal_table(frame, *sweep);
}

}  // namespace

/// Close together: down to Run it just fits a window of 800x600.
void decimation_panel(Frame& frame, DecimationDrafts& drafts) {
  if (const std::string_view why = frame.document().hindrance(); !why.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.warning);
    text(why);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
  }
  ImGui::BeginDisabled(frame.has_mesh() && !frame.can_decimate());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.3f * em()});
  decimation_options(frame, drafts);
  gap();
  operation_buttons(frame);
  run_controls(frame);
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  last_sweep_section(frame);
}

}  // namespace aomd::ui
