#include <string>

#include "viewer/base/entity_text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

/// In the upper left corner of a picture, on a plate of the panels' colour.
void label(const Frame& frame, const Area& area, const std::string& words) {
  const std::string shown = fitted(words, area.size.x - 2 * em());
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 from{area.position.x + 0.6f * em(), area.position.y + 0.6f * em()};
  const ImVec2 to{from.x + size.x + 0.9f * em(), from.y + size.y + 0.5f * em()};
  ImVec4 plate = frame.colors.panel;
  plate.w = 0.88f;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(from, to, ImGui::GetColorU32(plate), 0.3f * em());
  list.AddRect(from, to, ImGui::GetColorU32(frame.colors.border), 0.3f * em());
  list.AddText({from.x + 0.45f * em(), from.y + 0.25f * em()},
               ImGui::GetColorU32(frame.colors.text), shown.c_str());
}

}  // namespace

void picture_labels(const Frame& frame, const Area& viewport) {
  if (!frame.session.sheet().shows_reference()) return;
  const scene::Sheet& sheet = frame.session.sheet();
  const std::string before = sheet.reference_name() + ": " + sheet.reference_size();
  const std::string now = "now: " + scene::size_words(sheet.document.mesh());
  if (!sheet.side_by_side()) {
    label(frame, viewport, now + "; glass: " + before);
    return;
  }
  label(frame, picture_area(viewport, true, false), before);
  label(frame, picture_area(viewport, true, true), now);
}

}  // namespace aomd::ui
