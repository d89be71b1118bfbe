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
constexpr std::array<PageTitle, 4> pages = {{
    {scene::Page::Decimation, "Decimation", "panel decimation on"},
    {scene::Page::Adjacency, "T(I,J)", "panel adjacency on"},
    {scene::Page::Histograms, "Histograms", "panel histograms on"},
    {scene::Page::Selection, "Selection", "panel selection on"},
}};
constexpr float between_ems = 0.6f;

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
    if (tab_title(frame, page.title, font, page.page == frame.session.view.panels.page))
      frame.emit(page.line);
    command_tooltip(page.line);
  }
}

void page(Frame& frame, DecimationDrafts& drafts, HistogramDrafts& histograms) {
  switch (frame.session.view.panels.page) {
    case scene::Page::Decimation:
      return decimation_panel(frame, drafts);
    case scene::Page::Adjacency:
      return adjacency_panel(frame);
    case scene::Page::Histograms:
      return histogram_panel(frame, histograms);
    case scene::Page::Selection:
      return inspector_panel(frame);
  }
}

}  // namespace

/// The titles stay where the page scrolls.
void side_panel(Frame& frame, DecimationDrafts& drafts, HistogramDrafts& histograms) {
  page_titles(frame);
  ImGui::BeginChild("page");
  page(frame, drafts, histograms);
  ImGui::EndChild();
}

}  // namespace aomd::ui
