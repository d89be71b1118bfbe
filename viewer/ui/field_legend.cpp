#include <array>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

void ramp_bar(scene::ColorMap map) {
  constexpr int parts = 14;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.8f * em();
  const auto color_at = [&](int i) {
    return scene::ramp_color(static_cast<float>(i) / parts, map);
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < parts; ++i) {
    const auto x = [&](int k) { return from.x + width * static_cast<float>(k) / parts; };
    const ImU32 left = color_at(i), right = color_at(i + 1);
    list.AddRectFilledMultiColor({x(i), from.y}, {x(i + 1), from.y + height}, left, right, right,
                                 left);
  }
  ImGui::Dummy({width, height});
}

/// The smallest value, the one in the middle of the colours, and the largest.
void ramp_numbers(const scene::FieldScale& scale) {
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  for (const float part : {0.0f, 0.5f, 1.0f}) {
    std::string text = scene::significant(scale.at(part));
    if (scale.beyond && part == 0) text = "\u2264 " + text;
    if (scale.beyond && part == 1) text = "\u2265 " + text;
    if (part > 0) ImGui::SameLine();
    ImGui::SetCursorPosX(left + part * (width - ImGui::CalcTextSize(text.c_str()).x));
    ImGui::TextUnformatted(text.c_str());
  }
}

const char* why_none(scene::Coloring coloring) {
  if (coloring == scene::Coloring::Distance)
    return "Nothing to compare: meshes with regions or quads stay as loaded.";
  return "Meshes with regions or quads are not decimated.";
}

}  // namespace

void field_legend(const Frame& frame) {
  const scene::Coloring coloring = frame.session.view.coloring;
  if (!scene::is_field(coloring)) return;
  const scene::FieldText words = scene::field_text(coloring);
  const scene::ScalarField* field = frame.session.sheet().field();
  heading(frame, std::string(words.title).c_str());
  tooltip(words.help);
  ImGui::PushTextWrapPos(0);
  if (field == nullptr) {
    muted(frame, why_none(coloring));
  } else if (field->scale.empty()) {
    muted(frame, coloring == scene::Coloring::Spacing ? "No limit."
                                                      : "Flat all over, or not measured yet.");
  } else if (coloring == scene::Coloring::Distance && field->scale.high == 0) {
    muted(frame, "None: all faces lie on it.");
  } else {
    ramp_bar(field->scale.map);
    ramp_numbers(field->scale);
    muted(frame, words.unit);
  }
  ImGui::PopTextWrapPos();
  gap();
}

}  // namespace aomd::ui
