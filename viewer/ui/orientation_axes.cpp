#include "viewer/ui/orientation_axes.h"

#include <algorithm>
#include <array>
#include <string>

#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

struct AxisEnd {
  int axis = 0;
  bool positive = true;
  glm::dvec3 place{0};  ///< to the right, upward, and towards the eye; the axis is 1 long
};

constexpr std::array<const char*, 3> letters = {"X", "Y", "Z"};

std::array<AxisEnd, 6> ends_of(const scene::Camera& camera) {
  std::array<AxisEnd, 6> ends;
  for (int i = 0; i < 6; ++i) {
    AxisEnd& end = ends[static_cast<std::size_t>(i)];
    end.axis = i / 2;
    end.positive = i % 2 == 0;
    glm::dvec3 direction(0);
    direction[end.axis] = end.positive ? 1 : -1;
    end.place = {glm::dot(direction, camera.right()), glm::dot(direction, camera.up()),
                 -glm::dot(direction, camera.forward())};
  }
  std::sort(ends.begin(), ends.end(),
            [](const AxisEnd& a, const AxisEnd& b) { return a.place.z < b.place.z; });
  return ends;
}

ImVec4 color_of(const Frame& frame, int axis) {
  const bool dark = frame.session.view.theme == scene::Theme::Dark;
  const std::array<ImVec4, 3> on_light = {
      {{0.80f, 0.22f, 0.27f, 1}, {0.16f, 0.53f, 0.29f, 1}, {0.14f, 0.42f, 0.76f, 1}}};
  const std::array<ImVec4, 3> on_dark = {
      {{0.94f, 0.42f, 0.44f, 1}, {0.45f, 0.78f, 0.50f, 1}, {0.44f, 0.67f, 0.98f, 1}}};
  return (dark ? on_dark : on_light)[static_cast<std::size_t>(axis)];
}

void draw_end(const Frame& frame, const AxisEnd& end, ImVec2 middle, ImVec2 at, bool hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = ImGui::GetColorU32(color_of(frame, end.axis));
  const float radius = (end.positive ? 0.58f : 0.38f) * em();
  if (end.positive) list.AddLine(middle, at, color, 0.14f * em());
  list.AddCircleFilled(at, radius, end.positive ? color : ImGui::GetColorU32(frame.colors.panel));
  list.AddCircle(at, radius, hovered ? ImGui::GetColorU32(frame.colors.text) : color, 0,
                 0.11f * em());
  if (!end.positive) return;
  ImGui::PushFont(frame.fonts.small);
  const char* letter = letters[static_cast<std::size_t>(end.axis)];
  const ImVec2 size = ImGui::CalcTextSize(letter);
  list.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, ImGui::GetColorU32(frame.colors.panel),
               letter);
  ImGui::PopFont();
}

void draw_ends(Frame& frame, ImVec2 middle, float reach) {
  const scene::Camera& camera = frame.session.view.camera;
  for (const AxisEnd& end : ends_of(camera)) {
    const ImVec2 at{middle.x + reach * static_cast<float>(end.place.x),
                    middle.y - reach * static_cast<float>(end.place.y)};
    const std::string name =
        std::string(end.positive ? "+" : "-") + letters[static_cast<std::size_t>(end.axis)];
    const float half = 0.6f * em();
    ImGui::SetCursorScreenPos({at.x - half, at.y - half});
    const std::string view(scene::view_from(end.axis, end.positive, camera.up_axis));
    ImGui::SetItemAllowOverlap();
    if (ImGui::InvisibleButton(name.c_str(), {2 * half, 2 * half})) frame.emit("camera " + view);
    draw_end(frame, end, middle, at, ImGui::IsItemHovered());
    tooltip("Looks from the side of " + name + ".", "camera " + view);
  }
}

}  // namespace

void orientation_axes(Frame& frame, const Area& viewport) {
  if (!frame.session.view.axes || !frame.has_mesh()) return;
  const float reach = 1.9f * em(), half = reach + 0.7f * em(), margin = 0.5f * em();
  if (viewport.size.x < 8 * half || viewport.size.y < 5 * half) return;
  const ImVec2 corner{viewport.position.x + margin,
                      viewport.position.y + viewport.size.y - margin - 2 * half};
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize({2 * half, 2 * half});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const bool visible = ImGui::Begin(
      "##axes", nullptr,
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
          ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus |
          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (visible) draw_ends(frame, {corner.x + half, corner.y + half}, reach);
  ImGui::End();
}

}  // namespace aomd::ui
