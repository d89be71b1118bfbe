#pragma once
// Where everything stands: one arrangement that follows the window's size.

#include <imgui.h>

#include "viewer/drawing/view.h"

namespace aomd::ui {

struct Area {
  ImVec2 position{0, 0};
  ImVec2 size{0, 0};
};

/// In ImGui's units. Areas of panels that are off are empty.
struct Layout {
  Area menu;
  Area mesh;      ///< left
  Area side;      ///< right
  Area timeline;  ///< bottom, from side to side
  Area runs;      ///< between the side panels, above the timeline
  Area status;
  Area viewport;  ///< what is left
};

/// What the command panel-width takes.
[[nodiscard]] float clamped_panel_ems(float ems);

/// Where a picture of the scene is: all of the viewport, or with two side by side the right half or
/// the left.
[[nodiscard]] Area picture_area(const Area& viewport, bool side_by_side, bool right);

/// Side panels take between a fifth and a third of the width, or what the user chose, up to 0.42 of
/// it, and give way in small windows. `em` is the font's size.
[[nodiscard]] Layout make_layout(ImVec2 display, const scene::Panels& panels, bool bars, float em);

}  // namespace aomd::ui
