#include "viewer/ui/work_dialogs.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

std::string what_waits(const scene::Session& session) {
  const std::string& line = session.asked;
  if (line.empty() || line.rfind("quit", 0) == 0) return "The program is about to end.";
  return "Another mesh is about to take its place: " + line;
}

/// "22 Nov 2026, 12:34" in the user's time zone.
std::string time_text(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm parts{};
  std::array<char, 64> text{};
  if (localtime_r(&time, &parts) == nullptr) return {};
  std::strftime(text.data(), text.size(), "%d %b %Y, %H:%M", &parts);
  return text.data();
}

void work_row(Frame& frame, const scene::SavedWork& work, std::size_t number) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  text(fitted(work.name(), ImGui::GetContentRegionAvail().x));
  tooltip(work.source.file.empty() ? "A built-in sample" : work.source.file.string());
  muted(frame, scene::counted(work.cursor, "operation") + ", " + time_text(work.seconds));
  ImGui::TableNextColumn();
  const std::string n = std::to_string(number);
  ImGui::PushID(n.c_str());
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.4f * em());
  const float width = 5.5f * em();
  primary_button(frame, "Restore", "recover " + n, width);
  ImGui::SameLine();
  command_button(frame, "Discard", "recover discard " + n, width);
  ImGui::PopID();
}

}  // namespace

void unsaved_dialog(Frame& frame) {
  ImGui::PushTextWrapPos(0);
  const std::string name = frame.has_mesh() ? frame.document().content().name : "the mesh";
  text("The changes to " + name + " have not been saved.");
  gap(0.1f);
  muted(frame, fitted(what_waits(frame.session), 2 * ImGui::GetContentRegionAvail().x));
  ImGui::PopTextWrapPos();
  const float width = 6.5f * em();
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosY(ImGui::GetWindowHeight() - ImGui::GetFrameHeight() -
                       ImGui::GetStyle().WindowPadding.y);
  command_button(frame, "Discard", "unsaved discard", width);
  same_line_right(2 * width + spacing);
  command_button(frame, "Cancel", "unsaved cancel", width);
  ImGui::SameLine();
  const bool named = frame.has_mesh() && !frame.document().saved_file().empty();
  primary_button(frame, named ? "Save" : "Save as\u2026", "unsaved save", width, frame.has_mesh());
}

void recovery_dialog(Frame& frame) {
  const auto& found = frame.session.found_work.works;
  ImGui::PushTextWrapPos(0);
  muted(frame, found.empty()
                   ? "There is nothing to recover."
                   : "The program ended before this work was saved. What is not restored or "
                     "discarded now is offered again at the next start.");
  ImGui::PopTextWrapPos();
  const float below = ImGui::GetFrameHeightWithSpacing() + 0.9f * em();
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (ImGui::BeginTable("works", 2, flags,
                        {0, std::max(4 * em(), ImGui::GetContentRegionAvail().y - below)})) {
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("do", ImGuiTableColumnFlags_WidthFixed,
                            11 * em() + ImGui::GetStyle().ItemSpacing.x);
    for (std::size_t i = 0; i < found.size(); ++i) work_row(frame, *found[i], i + 1);
    ImGui::EndTable();
  }
}

void draw_series_progress(Frame& frame) {
  const scene::PictureSeries* series = frame.session.series();
  constexpr const char* title = "Exporting pictures";
  if (series == nullptr) return;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(26 * em(), display.x - 2 * em()), 0});
  const auto flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoScrollbar;
  if (!ImGui::BeginPopupModal(title, nullptr, flags)) return;
  text(std::to_string(series->made()) + " of " + std::to_string(series->count()));
  bar(static_cast<double>(series->made()) / series->count(),
      ImGui::GetColorU32(frame.colors.accent), 0.5f);
  muted(frame, fitted("To " + series->folder().string(), ImGui::GetContentRegionAvail().x));
  gap(0.1f);
  const float width = 6 * em();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
  command_button(frame, "Cancel", "cancel", width);
  ImGui::EndPopup();
}

}  // namespace aomd::ui
