#include "viewer/ui/layout.h"

#include <algorithm>
#include <cmath>

namespace aomd::ui {
namespace {

constexpr float menu_ems = 1.66f;
constexpr float status_ems = 1.9f;
constexpr float timeline_ems = 6.6f;
constexpr float runs_ems = 10.5f;
constexpr float runs_share = 0.4f;  // of the height that is left, at most
constexpr float mesh_ems = 17.5f;
constexpr float side_ems = 18.5f;
constexpr float usual_share = 0.3f;  // of the window's width, at most
constexpr float largest_share = 0.42f;

float panel_width(float chosen_ems, float usual_ems, float display, float em) {
  const bool chosen = chosen_ems > 0;
  return std::min(std::round((chosen ? chosen_ems : usual_ems) * em),
                  std::round((chosen ? largest_share : usual_share) * display));
}

}  // namespace

float clamped_panel_ems(float ems) { return std::clamp(ems, 8.0f, 60.0f); }
Area picture_area(const Area& viewport, bool side_by_side, bool right) {
  if (!side_by_side) return viewport;
  Area half = viewport;
  half.size.x = std::max(1.0f, std::floor(0.5f * (viewport.size.x - 1)));
  if (right) half.position.x += viewport.size.x - half.size.x;
  return half;
}

Layout make_layout(ImVec2 display, const scene::Panels& panels, bool bars, float em) {
  Layout layout;
  const float menu = bars && panels.menus ? std::round(menu_ems * em) : 0;
  const float status = bars && panels.menus ? std::round(status_ems * em) : 0;
  const float timeline = bars && panels.timeline ? std::round(timeline_ems * em) : 0;
  const float left =
      bars && panels.mesh ? panel_width(panels.mesh_ems, mesh_ems, display.x, em) : 0;
  const float right =
      bars && panels.side ? panel_width(panels.side_ems, side_ems, display.x, em) : 0;
  const float height = std::max(1.0f, display.y - menu - status - timeline);
  layout.menu = {{0, 0}, {display.x, menu}};
  layout.mesh = {{0, menu}, {left, height}};
  layout.side = {{display.x - right, menu}, {right, height}};
  layout.timeline = {{0, menu + height}, {display.x, timeline}};
  layout.status = {{0, display.y - status}, {display.x, status}};
  const float width = std::max(1.0f, display.x - left - right);
  const float runs =
      bars && panels.runs ? std::round(std::min(runs_ems * em, runs_share * height)) : 0;
  layout.viewport = {{left, menu}, {width, height - runs}};
  layout.runs = {{left, menu + height - runs}, {width, runs}};
  return layout;
}

}  // namespace aomd::ui
