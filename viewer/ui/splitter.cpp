#include "viewer/ui/splitter.h"

#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

/// A strip along x that can be dragged; `width_at` says how wide the panel is with its border
/// there.
template <typename WidthAt>
void splitter(Frame& frame, const char* panel, float x, const Area& beside, WidthAt&& width_at) {
  const float grip = 0.5f * em();
  ImGui::SetNextWindowPos({x - 0.5f * grip, beside.position.y});
  ImGui::SetNextWindowSize({grip, beside.size.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing;
  const std::string line = std::string("panel-width ") + panel;
  if (ImGui::Begin((line + "##splitter").c_str(), nullptr, flags)) {
    ImGui::InvisibleButton("border", {grip, beside.size.y});
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    if (active || hovered) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      ImGui::GetWindowDrawList()->AddLine({x, beside.position.y},
                                          {x, beside.position.y + beside.size.y},
                                          ImGui::GetColorU32(frame.colors.accent), 0.12f * em());
    }
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      frame.emit(line + " usual");
    else if (active && ImGui::GetIO().MouseDelta.x != 0)
      frame.emit(
          line + " " +
          scene::short_number(clamped_panel_ems(width_at(ImGui::GetIO().MousePos.x) / em()), 2));
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

void draw_splitters(Frame& frame, const Layout& layout) {
  const float right = ImGui::GetIO().DisplaySize.x;
  if (layout.mesh.size.x > 1)
    splitter(frame, "mesh", layout.mesh.size.x, layout.mesh, [](float x) { return x; });
  if (layout.side.size.x > 1)
    splitter(frame, "side", layout.side.position.x, layout.side,
             [=](float x) { return right - x; });
}

}  // namespace aomd::ui
