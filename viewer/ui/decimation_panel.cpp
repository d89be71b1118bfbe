#include <algorithm>
#include <cmath>
#include <string>

#include "core/decimate/explain/explanation.h"
#include "viewer/base/text.h"
#include "viewer/explain/edge_verdicts.h"
#include "viewer/ui/link_flow.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::grouped;

float half_width() {
  return 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
}

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
    const float rest = limits_button_width() + ImGui::GetStyle().ItemSpacing.x;
    primary_button(frame, "Run", "run", -rest, frame.can_decimate());
    ImGui::SameLine();
    return limits_button(frame);
  }
  command_button(frame, "Cancel", "cancel", -1);
  const Decimation& decimation = *document.decimation();
  gap(0.15f);
  bar(document.run_progress(), ImGui::GetColorU32(frame.colors.accent), 0.5f);
  muted(frame, "Sweep " + std::to_string(decimation.sweeps().size()) + ": " +
                   phase_name(decimation.phase()) + ", " +
                   std::to_string(static_cast<int>(100 * document.run_progress())) + " %");
}

void refusal_row(Frame& frame, Reason reason, std::uint32_t count, std::uint32_t most) {
  const ReasonWords words = reason_words(reason);
  const std::string help =
      std::string(words.help) + " Click to select the edges that would be refused for it now.";
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (ImGui::Selectable(words.name, false, ImGuiSelectableFlags_SpanAllColumns))
    frame.emit("select refused " + scene::reason_word(reason));
  tooltip(help);
  ImGui::TableNextColumn();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.35f * em());
  ImGui::PushID(words.name);
  ImVec4 color = frame.colors.bad;
  color.w = 0.75f;
  bar(static_cast<double>(count) / most, ImGui::GetColorU32(color), 0.42f);
  ImGui::PopID();
  ImGui::TableNextColumn();
  text_right(grouped(count));
}

void refusal_table(Frame& frame, const SweepStatistics& sweep) {
  const std::uint32_t most =
      std::max(1u, *std::max_element(sweep.refused.begin(), sweep.refused.end()));
  if (!ImGui::BeginTable("refusals", 3, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("reason", ImGuiTableColumnFlags_WidthFixed, 8.0f * em());
  ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("count", ImGuiTableColumnFlags_WidthFixed, 3.8f * em());
  for (std::size_t i = 1; i < sweep.refused.size(); ++i)
    if (const std::uint32_t n = sweep.refused[i]; n > 0)
      refusal_row(frame, static_cast<Reason>(i), n, most);
  ImGui::EndTable();
}

/// Why the run that ended here stopped, and where its figures stand.
void stop_section(Frame& frame) {
  const std::string_view stop = frame.document().stop();
  if (stop.empty()) return;
  gap();
  text(broken_at_blanks(stop, ImGui::GetContentRegionAvail().x));
  const std::size_t runs = frame.session.sheet().runs.size();
  if (frame.session.view.panels.runs || runs == 0) return;
  LinkFlow(frame).add(
      runs == 1 ? "1 run is kept" : std::to_string(runs) + " runs are kept: compare",
      "panel runs on", "The table of what runs came to, to go back to and to compare.");
}

void last_sweep_section(Frame& frame) {
  const SweepStatistics* sweep = frame.document().last_sweep();
  if (sweep == nullptr) return;
  gap();
  heading(frame, "Last sweep");
  copy_button(frame, "refusals");
  std::string made = scene::counted(sweep->collapses, "collapse");
  if (sweep->swaps > 0) made += ", " + scene::counted(sweep->swaps, "swap");
  if (sweep->smooths > 0) made += ", " + grouped(sweep->smooths) + " smoothed";
  ImGui::PushTextWrapPos(0);
  const bool refused = std::ranges::any_of(sweep->refused, [](std::uint32_t n) { return n > 0; });
  muted(frame, made + (refused ? ". What it refused, by reason:" : "; it refused no edge."));
  ImGui::PopTextWrapPos();
  if (refused) refusal_table(frame, *sweep);
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
  ImGui::EndDisabled();
  stop_section(frame);
  last_sweep_section(frame);
  ImGui::PopStyleVar();
}

}  // namespace aomd::ui
