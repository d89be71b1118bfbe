#pragma once
// Words that emit a line when they are clicked.

#include <string>

#include "core/mesh/names.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {

/// Links one after the other, in as many lines as they need.
class LinkFlow {
 public:
  explicit LinkFlow(Frame& frame)
      : frame_(frame), right_(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x) {}

  void add(const std::string& label, const std::string& line, const char* help) {
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    if (!first_ && ImGui::GetItemRectMax().x + 0.6f * em() + width < right_)
      ImGui::SameLine(0, 0.6f * em());
    first_ = false;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton((label + line).c_str(), {width, em()});
    const ImU32 color = ImGui::GetColorU32(frame_.colors.accent);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(at, color, label.c_str());
    if (ImGui::IsItemHovered())
      list.AddLine({at.x, at.y + em()}, {at.x + width, at.y + em()}, color);
    tooltip(help);
    if (pressed) frame_.emit(line);
  }

  /// Selects an entity.
  void add(const std::string& label, EntityRef e, const char* help) {
    add(label, "select " + name_of(e), help);
  }

 private:
  Frame& frame_;
  float right_;
  bool first_ = true;
};

}  // namespace aomd::ui
