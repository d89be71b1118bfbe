#include <array>
#include <string>

#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

struct PageTitle {
  scene::Page page;
  const char* title;
  const char* line;
};
constexpr std::array<PageTitle, 3> pages = {{
    {scene::Page::Decimation, "Decimation", "panel decimation on"},
    {scene::Page::Adjacency, "Adjacencies", "panel adjacency on"},
    {scene::Page::Histograms, "Histograms", "panel histograms on"},
}};
constexpr float between_ems = 0.9f;

/// A title that turns to its page; the one that is up is underlined.
void page_title(Frame& frame, const PageTitle& page, ImFont* font, bool up) {
  ImGui::PushFont(frame.fonts.heading);
  const float height = ImGui::GetFontSize(), line = 0.3f * em();
  ImGui::PopFont();
  ImGui::PushFont(font);
  const ImVec2 size{ImGui::CalcTextSize(page.title).x, height};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(page.title, {size.x, height + line});
  const ImVec4 color = up || ImGui::IsItemHovered() ? frame.colors.text : frame.colors.text_muted;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, ImGui::GetColorU32(color), page.title);
  if (up)
    list.AddRectFilled({at.x, at.y + size.y + 0.16f * em()}, {at.x + size.x, at.y + size.y + 0.3f * em()},
                       ImGui::GetColorU32(frame.colors.accent));
  ImGui::PopFont();
  if (pressed) frame.emit(page.line);
}

/// As large as headings where they have the room, else as the text, else smaller.
ImFont* title_font(const Frame& frame) {
  for (ImFont* font : {frame.fonts.heading, frame.fonts.text}) {
    ImGui::PushFont(font);
    float width = static_cast<float>(pages.size() - 1) * between_ems * em();
    for (const PageTitle& page : pages) width += ImGui::CalcTextSize(page.title).x;
    ImGui::PopFont();
    if (width <= ImGui::GetContentRegionAvail().x) return font;
  }
  return frame.fonts.small;
}

void page_titles(Frame& frame) {
  ImFont* font = title_font(frame);
  for (const PageTitle& page : pages) {
    if (page.page != pages[0].page) ImGui::SameLine(0, between_ems * em());
    page_title(frame, page, font, page.page == frame.session.view.panels.page);
    command_tooltip(page.line);
  }
}

}  // namespace

void side_panel(Frame& frame, DecimationDrafts& drafts, HistogramDrafts& histograms) {
  page_titles(frame);
  switch (frame.session.view.panels.page) {
    case scene::Page::Decimation:
      return decimation_panel(frame, drafts);
    case scene::Page::Adjacency:
      return adjacency_panel(frame);
    case scene::Page::Histograms:
      return histogram_panel(frame, histograms);
  }
}

}  // namespace aomd::ui
