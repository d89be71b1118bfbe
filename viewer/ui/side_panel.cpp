#include <string>

#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

/// A title that turns to its page; the one that is up is underlined.
void page_title(Frame& frame, const char* title, const std::string& line, bool up) {
  ImGui::PushFont(frame.fonts.heading);
  const ImVec2 size = ImGui::CalcTextSize(title);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(title, {size.x, size.y + 0.3f * em()});
  const ImVec4 color = up || ImGui::IsItemHovered() ? frame.colors.text : frame.colors.text_muted;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, ImGui::GetColorU32(color), title);
  if (up)
    list.AddRectFilled({at.x, at.y + size.y + 0.16f * em()}, {at.x + size.x, at.y + size.y + 0.3f * em()},
                       ImGui::GetColorU32(frame.colors.accent));
  ImGui::PopFont();
  if (pressed) frame.emit(line);
  command_tooltip(line);
}

}  // namespace

void side_panel(Frame& frame, DecimationDrafts& drafts) {
  const scene::Page page = frame.session.view.panels.page;
  page_title(frame, "Decimation", "panel decimation on", page == scene::Page::Decimation);
  ImGui::SameLine(0, 0.9f * em());
  page_title(frame, "Adjacencies", "panel adjacency on", page == scene::Page::Adjacency);
  ImGui::SameLine(0, 0.9f * em());
  page_title(frame, "Selection", "panel selection on", page == scene::Page::Selection);
  if (page == scene::Page::Decimation) decimation_panel(frame, drafts);
  if (page == scene::Page::Adjacency) adjacency_panel(frame);
  if (page == scene::Page::Selection) inspector_panel(frame);
}

}  // namespace aomd::ui
