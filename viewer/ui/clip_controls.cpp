#include <array>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};

std::string clip_line(const scene::Clip& clip) {
  return std::string("clip ") + axis_names[static_cast<std::size_t>(clip.axis)] + " " +
         scene::short_number(clip.position, 4) + (clip.cells ? " cells" : " cut") +
         (clip.flip ? " flip" : "");
}

/// A small button that looks pressed while it is what holds.
bool toggle(const Frame& frame, const char* name, bool on) {
  ImGui::PushStyleColor(ImGuiCol_Button,
                        on ? frame.colors.accent : ImGui::GetStyle().Colors[ImGuiCol_Button]);
  ImGui::PushStyleColor(
      ImGuiCol_ButtonHovered,
      on ? frame.colors.accent : ImGui::GetStyle().Colors[ImGuiCol_ButtonHovered]);
  ImGui::PushStyleColor(ImGuiCol_Text, on ? on_accent(frame) : frame.colors.text);
  const bool pressed = ImGui::SmallButton(name);
  ImGui::PopStyleColor(3);
  return pressed;
}

void clip_buttons(Frame& frame, const scene::Clip& present) {
  scene::Clip clip = present;
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SameLine(0, (axis > 0 ? 0.15f : 0.5f) * em());
    if (toggle(frame, axis_names[static_cast<std::size_t>(axis)], clip.axis == axis))
      clip.axis = axis, changed = true;
    tooltip("The axis that the plane stands across.");
  }
  ImGui::SameLine(0, 0.4f * em());
  if (toggle(frame, "cells", clip.cells)) clip.cells = !clip.cells, changed = true;
  tooltip("Whole faces and regions, by their middles; else they are cut through.");
  ImGui::SameLine(0, 0.15f * em());
  if (toggle(frame, "flip", clip.flip)) clip.flip = !clip.flip, changed = true;
  tooltip("Hides the other side.");
  ImGui::SameLine(0, 0.15f * em());
  if (changed) frame.emit(clip_line(clip));
  // A narrow panel has no room for it in the same row.
  if (ImGui::GetContentRegionAvail().x < 1.2f * em()) ImGui::NewLine();
  if (ImGui::SmallButton("\u00d7")) frame.emit("clip off");
  tooltip("Ends clipping.");
}

void clip_rows(Frame& frame) {
  if (!frame.session.view.clip) return;
  scene::Clip clip = *frame.session.view.clip;
  heading(frame, "Clip");
  command_tooltip("clip");
  clip_buttons(frame, clip);
  if (number_control("clip", clip.position, {.low = 0, .high = 1, .format = "%.3f"}))
    frame.emit(clip_line(clip));
  tooltip("Where the plane stands: from 0 to 1 through the box of the mesh as loaded.");
}

void shrink_rows(Frame& frame) {
  double shrink = frame.session.view.shrink;
  if (shrink == 0) return;
  heading(frame, "Shrink");
  command_tooltip("shrink");
  ImGui::SameLine(0, 0.5f * em());
  if (ImGui::SmallButton("\u00d7##shrink")) frame.emit("shrink 0");
  tooltip("Ends shrinking.");
  if (number_control("shrink", shrink, {.low = 0.01, .high = 0.9, .format = "%.2f"}))
    frame.emit("shrink " + scene::short_number(shrink, 4));
}

}  // namespace

void clip_controls(Frame& frame) {
  const scene::View& view = frame.session.view;
  if (!frame.has_mesh() || (!view.clip && view.shrink == 0)) return;
  clip_rows(frame);
  shrink_rows(frame);
  gap();
}

}  // namespace aomd::ui
