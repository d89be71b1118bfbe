#include "viewer/ui/interface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/scene/commands.h"
#include "viewer/scene/text.h"
#include "viewer/ui/menu_bar.h"
#include "viewer/ui/splitter.h"
#include "viewer/ui/widgets.h"
#include "viewer/ui/work_dialogs.h"

namespace aomd::ui {
namespace {

constexpr auto fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A window that fills an area; draws nothing where the area is empty.
template <typename Content>
void docked(const char* id, const Area& area, ImGuiWindowFlags flags, Content&& content) {
  if (area.size.x < 1 || area.size.y < 1) return;
  ImGui::SetNextWindowPos(area.position);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  const bool visible = ImGui::Begin(id, nullptr, fixed_window | flags);
  ImGui::PopStyleVar(2);
  if (visible) content();
  ImGui::End();
}

std::string number(double value) { return scene::short_number(value, 5); }

constexpr double degrees_per_window = 180;  // what a drag across the shorter side turns

}  // namespace

std::vector<std::string> Interface::draw(const scene::Session& session, const Fonts& fonts) {
  Frame frame{session, fonts, theme_colors(theme_kind(session.view.theme)), interactive, {}};
  layout_ = make_layout(ImGui::GetIO().DisplaySize, session.view.panels, bars, em());
  if (bars) {
    picture_labels(frame, layout_.viewport);
    draw_panels(frame);
    draw_splitters(frame, layout_);
    draw_messages(frame, layout_.viewport);
    draw_dialogs(frame, dialogs_);
    draw_series_progress(frame);
  }
  handle_mouse(frame);
  return std::move(frame.lines);
}

void Interface::draw_panels(Frame& frame) {
  const ImVec2 narrow{0.75f * em(), 0.22f * em()};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, narrow);
  docked("##menu", layout_.menu, ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar, [&] {
    if (!ImGui::BeginMenuBar()) return;
    menu_bar(frame, recent);
    ImGui::EndMenuBar();
  });
  docked("##status", layout_.status, ImGuiWindowFlags_NoScrollbar, [&] { status_bar(frame); });
  ImGui::PopStyleVar();
  docked("##mesh", layout_.mesh, ImGuiWindowFlags_None, [&] {
    mesh_panel(frame);
    gap();
    clip_controls(frame);
    legend_panel(frame);
  });
  docked("##side", layout_.side, ImGuiWindowFlags_None,
         [&] { side_panel(frame, drafts_, histogram_drafts_); });
  docked("##timeline", layout_.timeline, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse,
         [&] { timeline_panel(frame); });
}

std::string Interface::line_for_chord(const scene::Session& session, std::string_view chord) {
  if (session.series() != nullptr && session.view.dialog == scene::Dialog::None)
    return chord == "Escape" ? "cancel" : "";
  if (chord == "Escape" && session.view.dialog != scene::Dialog::None) return "dialog none";
  if (chord == "Escape" && !session.error.empty()) return "dismiss";
  if (session.view.dialog != scene::Dialog::None || ImGui::GetIO().WantTextInput) return {};
  return std::string(scene::line_of_chord(chord));
}

void Interface::handle_mouse(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool right = io.MousePos.x > layout_.viewport.position.x + 0.5f * layout_.viewport.size.x;
  const Area area = picture_area(layout_.viewport, frame.session.view.side_by_side, right);
  if (!frame.has_mesh() || area.size.x < 2 || area.size.y < 2) return;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool other =
      ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  if (!left && !other) dragging_ = false;
  if (!io.WantCaptureMouse) {
    for (const int button : {0, 1, 2}) dragging_ = dragging_ || ImGui::IsMouseClicked(button);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) frame.emit("fit");
    if (io.MouseWheel != 0) {
      const double x = 2 * (io.MousePos.x - area.position.x) / area.size.x - 1;
      const double y = 1 - 2 * (io.MousePos.y - area.position.y) / area.size.y;
      if (std::abs(x) <= 1 && std::abs(y) <= 1)
        frame.emit("zoom " + number(std::pow(1.15, io.MouseWheel)) + " " + number(x) + " " + number(y));
    }
  }
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (!dragging_ || !moved || (!left && !other)) return;
  if (other || io.KeyShift) {
    frame.emit("pan " + number(io.MouseDelta.x / area.size.x) + " " + number(-io.MouseDelta.y / area.size.y));
    return;
  }
  const double scale = degrees_per_window / std::min(area.size.x, area.size.y);
  frame.emit("orbit " + number(-io.MouseDelta.x * scale) + " " + number(io.MouseDelta.y * scale));
}

}  // namespace aomd::ui
