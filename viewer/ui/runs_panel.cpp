// The table of what runs came to.

#include <array>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::KeptRun;
using scene::short_number;

struct Column {
  const char* title;
  float ems;
  const char* help;
};
constexpr std::array<Column, 9> run_columns = {
    {{"Run", 0, "A click leads back to it, on whichever branch it is."},
     {"Beside", 3.2f, "Puts it beside the present mesh, and into the histograms."},
     {"Strategy", 3.8f, "The strategy that it was made with."},
     {"Aim", 6.2f, "How far it was to go."},
     {"Angle", 3.0f, "How far the normal of a face could turn in one operation, degrees."},
     {"Faces", 4.0f, "How many are left: faces, of a volume regions."},
     {"Angles", 5.6f,
      "The smallest angle of all faces, and the mean of the smallest angles of each, degrees. Of a "
      "volume dihedral angles, of the regions."},
     {"Distance %", 6.4f,
      "To the mesh as loaded: root mean square, and the largest; percent of the diagonal of its "
      "box."},
     {"Time", 3.4f, "That the run took."}}};

constexpr std::size_t cells_column = 5;

std::string degrees_text(double deg) { return short_number(deg, 1) + "\u00b0"; }

std::string time_words(double seconds) {
  return seconds < 1 ? short_number(1000 * seconds, 0) + " ms" : scene::significant(seconds) + " s";
}

constexpr float name_ems = 6;  // where the columns need more than there is

float all_columns() {
  float ems = name_ems;
  for (const Column& column : run_columns) ems += column.ems + 0.6f;
  return ems * em();
}

/// `scrolls`: from side to side, past the name, which stays.
void header(const Frame& frame, bool scrolls) {
  ImGui::TableSetupScrollFreeze(scrolls ? 1 : 0, 1);
  for (const Column& column : run_columns) {
    const bool fixed = column.ems > 0 || scrolls;
    ImGui::TableSetupColumn(
        column.title, fixed ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
        (column.ems > 0 ? column.ems : name_ems) * em());
  }
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (std::size_t i = 0; i < run_columns.size(); ++i) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
    const bool cells = i == cells_column && frame.has_mesh() && frame.document().content().volume();
    if (i < 4)
      text(run_columns[i].title);
    else
      text_right(cells ? "Regions" : run_columns[i].title);
    ImGui::PopStyleColor();
    tooltip(run_columns[i].help);
  }
}

/// Only one is beside the present mesh: pressed again, nothing is.
void beside_cell(Frame& frame, const KeptRun& run) {
  const KeptRun* reference = frame.session.sheet().runs.reference();
  const bool on = frame.session.view.side_by_side &&
                  run.number == (reference == nullptr ? 0 : reference->number);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  if (ImGui::RadioButton("##beside", on)) {
    frame.emit("compare with " + (on || run.number == 0 ? "original" : std::to_string(run.number)));
    frame.emit(on ? "compare off" : "compare side");
  }
  ImGui::PopStyleVar();
  tooltip(on ? "Beside the present mesh. Click to end that." : run_columns[1].help);
}

void cell(const std::string& words) {
  ImGui::TableNextColumn();
  text_right(words);
}

void row_menu(Frame& frame, const KeptRun& run) {
  if (!ImGui::BeginPopupContextItem("menu")) return;
  const std::string number = std::to_string(run.number);
  command_item(frame, "Go back to it", "runs go " + number);
  command_item(frame, "Name it\u2026", "palette runs keep " + run.name, false,
               frame.session.sheet().runs.shown(frame.document()) == &run);
  command_item(frame, "Remove", "runs remove " + number);
  ImGui::EndPopup();
}

void run_row(Frame& frame, const KeptRun& run, bool here) {
  ImGui::PushID(static_cast<int>(run.number));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string title = run.from.empty() ? run.name : run.name + ", from " + run.from;
  if (ImGui::Selectable(title.c_str(), here)) frame.emit("runs go " + std::to_string(run.number));
  if (run.number > 0) row_menu(frame, run);
  tooltip(here ? "What is shown now." : run_columns[0].help);
  ImGui::TableNextColumn();
  beside_cell(frame, run);
  ImGui::TableNextColumn();
  text(run.strategy);
  ImGui::TableNextColumn();
  text(fitted(run.aim, ImGui::GetContentRegionAvail().x));
  tooltip(run.aim);
  cell(run.angle_deg ? degrees_text(*run.angle_deg) : "");
  cell(scene::grouped(run.cells));
  cell(degrees_text(run.worst_angle_deg) + ", " + degrees_text(run.mean_angle_deg));
  cell(run.distance ? scene::significant(run.distance->rms_pct) + ", " +
                          scene::significant(run.distance->max_pct)
                    : "");
  cell(run.seconds && frame.interactive ? time_words(*run.seconds) : "");
  ImGui::PopID();
}

void buttons(Frame& frame) {
  heading(frame, "Runs");
  const bool ready = frame.can_decimate() && !frame.document().running();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.6f * em(), 0.05f * em()});
  ImGui::SameLine(0, em());
  command_button(frame, "Keep this state", "runs keep", 0, ready);
  ImGui::SameLine();
  if (frame.session.sheet().measuring())
    command_button(frame, "Stop measuring", "cancel", 0);
  else
    command_button(frame, "Measure distances", "runs measure", 0,
                   ready && frame.session.sheet().runs.size() > 0);
  ImGui::PopStyleVar();
  copy_button(frame, "runs");
}

}  // namespace

void runs_panel(Frame& frame) {
  buttons(frame);
  if (frame.session.sheet().runs.size() == 0)
    wrapped(frame, "Each run that ends stands here, with what it came to.");
  ImGui::PushFont(frame.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.3f * em(), 0.1f * em()));
  const bool scrolls = ImGui::GetContentRegionAvail().x < all_columns();
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit |
                     ImGuiTableFlags_BordersInnerH |
                     (scrolls ? ImGuiTableFlags_ScrollX : ImGuiTableFlags_None);
  if (ImGui::BeginTable("runs", static_cast<int>(run_columns.size()), flags,
                        ImGui::GetContentRegionAvail())) {
    header(frame, scrolls);
    const KeptRun* shown =
        frame.has_mesh() ? frame.session.sheet().runs.shown(frame.document()) : nullptr;
    for (const KeptRun& run : frame.session.sheet().runs.rows()) run_row(frame, run, &run == shown);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace aomd::ui
