#include "viewer/ui/interface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui_internal.h>  // ClosePopupToLevel

#include "viewer/base/text.h"
#include "viewer/commands/commands.h"
#include "viewer/ui/menu_bar.h"
#include "viewer/ui/orientation_axes.h"
#include "viewer/ui/scales.h"
#include "viewer/ui/scene_labels.h"
#include "viewer/ui/splitter.h"
#include "viewer/ui/widgets.h"
#include "viewer/ui/work_dialogs.h"

namespace aomd::ui {
namespace {

constexpr auto fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                              ImGuiWindowFlags_NoSavedSettings |
                              ImGuiWindowFlags_NoBringToFrontOnFocus;

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

bool holds(const Area& area, ImVec2 p) {
  return p.x >= area.position.x && p.y >= area.position.y && p.x <= area.position.x + area.size.x &&
         p.y <= area.position.y + area.size.y;
}

std::string number(double value) { return scene::short_number(value, 5); }

constexpr ImGuiPopupFlags any_popup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;

/// What the hand moves by without meaning to.
bool still(ImVec2 from, ImVec2 to) {
  constexpr float still_px = 4;
  return std::abs(to.x - from.x) + std::abs(to.y - from.y) <= still_px;
}

constexpr double degrees_per_window = 180;  // what a drag across the shorter side turns

}  // namespace

std::vector<std::string> Interface::draw(const scene::Session& session, const Fonts& fonts) {
  Frame frame{session, fonts, theme_colors(theme_kind(session.view.theme)), interactive, {}};
  // Menus and lists that drop down; dialogs have a command for it.
  if (session.view.dialog == scene::Dialog::None && ImGui::IsPopupOpen("", any_popup) &&
      key_pressed(ImGuiKey_Escape))
    ImGui::ClosePopupToLevel(0, true);
  layout_ = make_layout(ImGui::GetIO().DisplaySize, session.view.panels, bars, em());
  present_ = picture_area(layout_.viewport, session.sheet().side_by_side(), true);
  scales(frame);
  scene_labels(frame, present_);
  neighbour_legend(frame, present_);
  if (bars) {
    picture_labels(frame, layout_.viewport);
    orientation_axes(frame, layout_.viewport);
    draw_panels(frame);
    draw_splitters(frame, layout_);
    draw_messages(frame, layout_.viewport);
    draw_dialogs(frame, dialogs_);
    draw_series_progress(frame);
  }
  picture_menu(frame, present_, picture_menu_);
  handle_mouse(frame);
  return std::move(frame.lines);
}

void Interface::scales(const Frame& frame) const {
  color_scale(frame, present_);
  length_scale(frame, present_);
}

void Interface::draw_scales(const scene::Session& session, const Fonts& fonts) {
  const Frame frame{session, fonts, theme_colors(theme_kind(session.view.theme)), false, {}};
  const Area before = present_;
  present_ =
      picture_area({{0, 0}, ImGui::GetIO().DisplaySize}, session.sheet().side_by_side(), true);
  scales(frame);
  ruler_labels(frame, present_);
  present_ = before;
}

void Interface::draw_panels(Frame& frame) {
  const ImVec2 narrow{0.75f * em(), 0.22f * em()}, usual = ImGui::GetStyle().WindowPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, narrow);
  docked("##menu", layout_.menu, ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar, [&] {
    if (!ImGui::BeginMenuBar()) return;
    // Menus that drop down have the usual distance to their border.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, usual);
    menu_bar(frame, recent, menu_bar_);
    ImGui::PopStyleVar();
    ImGui::EndMenuBar();
  });
  docked("##status", layout_.status, ImGuiWindowFlags_NoScrollbar, [&] { status_bar(frame); });
  ImGui::PopStyleVar();
  docked("##mesh", layout_.mesh, ImGuiWindowFlags_None, [&] {
    if (lesson_titles(frame)) return lesson_panel(frame);
    mesh_panel(frame);
    gap();
    clip_controls(frame);
    legend_panel(frame);
  });
  docked("##side", layout_.side, ImGuiWindowFlags_None,
         [&] { side_panel(frame, drafts_, histogram_drafts_); });
  docked("##runs", layout_.runs, ImGuiWindowFlags_NoScrollbar, [&] { runs_panel(frame); });
  docked("##timeline", layout_.timeline,
         ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse,
         [&] { timeline_panel(frame); });
}

std::string Interface::line_for_chord(const scene::Session& session, std::string_view chord) {
  if (session.series() != nullptr && session.view.dialog == scene::Dialog::None)
    return chord == "Escape" ? "cancel" : "";
  if (chord == "Escape" && session.view.dialog != scene::Dialog::None) return "dialog none";
  if (chord == "Escape" && ImGui::IsPopupOpen("", any_popup)) return {};  // draw() closes it
  if (chord == "Escape" && !session.error.empty()) return "dismiss";
  if (chord == "Escape" && session.idle() && !session.sheet().selection.empty())
    return "select none";
  if (chord == "Escape" && session.idle() && session.view.presenting) return "presentation off";
  if (session.view.dialog != scene::Dialog::None || ImGui::GetIO().WantTextInput) return {};
  return std::string(scene::line_of_chord(chord));
}

std::string Interface::place_words(ImVec2 mouse) const {
  const double x = 2 * (mouse.x - present_.position.x) / present_.size.x - 1;
  const double y = 1 - 2 * (mouse.y - present_.position.y) / present_.size.y;
  return number(std::clamp(x, -1.0, 1.0)) + " " + number(std::clamp(y, -1.0, 1.0));
}

/// A press that stays where it is selects, with Ctrl a drag selects a box. The mesh as loaded,
/// beside the present one, is only looked at.
void Interface::handle_click(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && dragging_) {
    began_ = io.MousePos;
    moved_ = false;
    again_ = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    boxing_ = io.KeyCtrl && holds(present_, io.MousePos);
  }
  if (!dragging_) return;
  moved_ = moved_ || !still(began_, io.MousePos);
  if (boxing_ && moved_) selection_box(frame, began_, io.MousePos);
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  const char* adds = io.KeyShift ? " add" : "";
  if (!moved_ && !again_ && holds(present_, io.MousePos))
    frame.emit("pick " + place_words(io.MousePos) + adds);
  if (moved_ && boxing_)
    frame.emit("select box " + place_words(began_) + " " + place_words(io.MousePos) + adds);
}

/// A press that stays where it is opens the menu; a drag shifts the picture.
void Interface::handle_right_click(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    right_began_ = io.MousePos;
    right_still_ = !io.WantCaptureMouse && holds(present_, io.MousePos);
  }
  right_still_ = right_still_ && still(right_began_, io.MousePos);
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Right) || !right_still_) return;
  right_still_ = false;
  frame.emit("menu " + place_words(io.MousePos));
}

void Interface::handle_hover(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool points = holds(present_, io.MousePos) && !io.WantCaptureMouse && !dragging_ &&
                      io.MouseWheel == 0 && frame.session.idle();
  if (!points) {
    hovered_at_ = {-1, -1};
    if (interactive && frame.session.sheet().inquiry().hovered()) frame.emit("hover off");
    return;
  }
  const scene::Session& session = frame.session;
  const bool same = io.MousePos.x == hovered_at_.x && io.MousePos.y == hovered_at_.y &&
                    hovered_from_ == session.view.camera && hovered_after_ == session.executed;
  if (same) return;
  hovered_after_ = session.executed + 1;  // by the line below
  hovered_at_ = io.MousePos;
  hovered_from_ = session.view.camera;
  frame.emit("hover " + place_words(io.MousePos));
}

void Interface::handle_mouse(Frame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool right = io.MousePos.x > layout_.viewport.position.x + 0.5f * layout_.viewport.size.x;
  const Area area = picture_area(layout_.viewport, frame.session.sheet().side_by_side(), right);
  if (!frame.has_mesh() || area.size.x < 2 || area.size.y < 2) return;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool other =
      ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  if (!left && !other && !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) dragging_ = false;
  if (!io.WantCaptureMouse) {
    for (const int button : {0, 1, 2}) dragging_ = dragging_ || ImGui::IsMouseClicked(button);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      frame.emit(frame.session.sheet().selection.empty() ? "fit" : "fit selection");
    if (io.MouseWheel != 0) {
      const double x = 2 * (io.MousePos.x - area.position.x) / area.size.x - 1;
      const double y = 1 - 2 * (io.MousePos.y - area.position.y) / area.size.y;
      if (std::abs(x) <= 1 && std::abs(y) <= 1)
        frame.emit("zoom " + number(std::pow(1.15, io.MouseWheel)) + " " + number(x) + " " +
                   number(y));
    }
  }
  handle_click(frame);
  handle_right_click(frame);
  handle_hover(frame);
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (!dragging_ || !moved || (!left && !other) || (left && (boxing_ || !moved_))) return;
  if (other || io.KeyShift) {
    frame.emit("pan " + number(io.MouseDelta.x / area.size.x) + " " +
               number(-io.MouseDelta.y / area.size.y));
    return;
  }
  const double scale = degrees_per_window / std::min(area.size.x, area.size.y);
  frame.emit("orbit " + number(-io.MouseDelta.x * scale) + " " + number(io.MouseDelta.y * scale));
}

}  // namespace aomd::ui
