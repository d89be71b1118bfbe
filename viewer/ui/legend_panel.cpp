#include <algorithm>
#include <string>
#include <vector>

#include "core/decimate/explain/explanation.h"
#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/drawing/palette.h"
#include "viewer/ui/class_controls.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

/// A title (ref is not valid) or a model entity.
struct Item {
  int dimension = 0;
  ModelRef ref;
  bool title = false;
  std::size_t count =
      0;  ///< model entities below a title; mesh entities of the same dimension on an entity
};

/// Highest first: regions are few, and faces are what one sees.
std::vector<Item> items_of(const Mesh& mesh) {
  std::vector<Item> items;
  for (const int dim : {3, 2, 1, 0}) {
    const std::size_t title = items.size();
    items.push_back({dim, {}, true, 0});
    for (const ModelRef ref : mesh.class_lists()->models(dim))
      if (ref.dimension() == dim || (!ref.valid() && dim >= 2))
        items.push_back({dim, ref, false, mesh.class_lists()->entities(dim, ref).size()});
    items[title].count = items.size() - title - 1;
    if (items[title].count == 0) items.pop_back();
  }
  return items;
}

void title_row(const Frame& frame, const Item& item) {
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  ImGui::PushFont(frame.fonts.heading);
  text(std::string("Model ") + entity_plural(item.dimension));
  ImGui::PopFont();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
  text_right(scene::grouped(item.count));
  ImGui::PopStyleColor();
}

/// Round for vertices, a line for edges, a square for faces and regions; only its outline where the
/// entity is hidden.
void swatch(const Item& item, bool hidden, scene::Color color) {
  const float side = 0.78f * em();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool line = item.dimension == 1;
  const ImVec2 from{corner.x, corner.y + 0.12f * em() + (line ? 0.28f * side : 0)};
  const ImVec2 to{from.x + side, from.y + (line ? 0.44f * side : side)};
  const float radius = item.dimension >= 2 ? 0.2f * side : 0.5f * (to.y - from.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!hidden) list.AddRectFilled(from, to, color, radius);
  if (hidden) list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_TextDisabled), radius);
  if (!hidden && item.dimension >= 2)
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_Text, 0.25f), radius);
}

void swatch_cell(Frame& frame, const Item& item, const std::string& name) {
  const bool hidden = frame.session.view.hidden.contains(item.ref);
  const bool colored = frame.session.view.coloring == scene::Coloring::Classification;
  swatch(item, hidden, colored ? scene::color_of(item.ref) : scene::unclassified_color());
  if (name.empty()) return;
  if (ImGui::InvisibleButton("swatch", {1.1f * em(), em()})) frame.emit("hide " + name + " toggle");
  tooltip(hidden ? "Hidden. Click to show it." : "Click to hide it.");
}

void entity_row(Frame& frame, const Item& item) {
  const std::string name = scene::model_entity_text(item.ref);
  const bool on = frame.session.view.highlighted == item.ref && item.ref.valid();
  const bool hidden = frame.session.view.hidden.contains(item.ref);
  ImGui::PushID(item.dimension);
  ImGui::PushID(static_cast<int>(item.ref.bits()));
  ImGui::TableNextColumn();
  swatch_cell(frame, item, name);
  ImGui::TableNextColumn();
  const std::string label = item.ref.valid() ? scene::model_entity_label(item.ref) : "Unclassified";
  if (hidden) ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
  if (ImGui::Selectable(label.c_str(), on, ImGuiSelectableFlags_None) && !name.empty())
    frame.emit(on ? "highlight" : "highlight " + name);
  if (hidden) ImGui::PopStyleColor();
  if (!name.empty()) model_entity_menu(frame, item.ref);
  tooltip(on ? "Highlighted. Click to end that."
             : "Click to highlight what lies on it; right click for more.");
  ImGui::TableNextColumn();
  text_right(scene::grouped(item.count));
  tooltip("Mesh entities of the same dimension on it");
  ImGui::PopID();
  ImGui::PopID();
}

void rows(Frame& frame, const std::vector<Item>& items) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(items.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Item& item = items[static_cast<std::size_t>(i)];
      ImGui::TableNextRow();
      if (item.title)
        title_row(frame, item);
      else
        entity_row(frame, item);
    }
  }
}

/// Why edges would be refused now: colour, reason, how many; a click selects them.
void verdict_legend(Frame& frame, const scene::EdgeVerdicts& verdicts) {
  heading(frame, "Verdicts on edges");
  tooltip(
      "Each face shows the colours of its three edges, a third for each: why decimation would "
      "refuse the "
      "edge "
      "now, with the present options.");
  const auto& counts = verdicts.counts();
  for (std::size_t i = 0; i < static_cast<std::size_t>(reason_count); ++i) {
    if (counts[i] == 0) continue;
    const auto reason = static_cast<Reason>(i);
    const ReasonWords words = reason_words(reason);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = 0.78f * em();
    if (ImGui::Selectable((std::string("     ") + words.name).c_str()))
      frame.emit("select refused " + scene::reason_word(reason));
    tooltip(std::string(words.help) + " Click to select these edges.");
    ImGui::GetWindowDrawList()->AddRectFilled(
        {at.x, at.y + 0.12f * em()}, {at.x + side, at.y + 0.12f * em() + side},
        scene::verdict_color(static_cast<std::uint8_t>(i)), 0.2f * side);
    const std::string count = scene::grouped(counts[i]);
    same_line_right(ImGui::CalcTextSize(count.c_str()).x);
    text(count);
  }
  if (verdicts.pending()) muted(frame, "judging ...");
  gap();
}

}  // namespace

void legend_panel(Frame& frame) {
  if (!frame.has_mesh()) return;
  field_legend(frame);
  if (const scene::EdgeVerdicts* verdicts = frame.session.sheet().verdicts())
    verdict_legend(frame, *verdicts);
  heading(frame, "Classification");
  tooltip("The model entities that the mesh lies on, with the number of mesh entities on each.");
  if (!frame.session.view.hidden.empty()) {
    ImGui::SameLine();
    if (ImGui::SmallButton("Show all")) frame.emit("hide");
    command_tooltip("hide");
  }
  copy_button(frame, "legend");
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.25f * em(), 0.12f * em()));
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  const float height = std::max(6 * em(), ImGui::GetContentRegionAvail().y);
  if (ImGui::BeginTable("legend", 3, flags, {0, height})) {
    ImGui::TableSetupColumn("swatch", ImGuiTableColumnFlags_WidthFixed, 1.1f * em());
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("count", ImGuiTableColumnFlags_WidthFixed, 4.3f * em());
    rows(frame, items_of(frame.document().mesh()));
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace aomd::ui
