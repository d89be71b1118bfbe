#include "viewer/scene/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {

namespace {

/// For who is new here.
void lessons_link(Frame& frame) {
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.accent);
  text("New here? Lessons: F2");
  ImGui::PopStyleColor();
  if (ImGui::IsItemClicked()) frame.emit("dialog lessons");
  tooltip("Ten short lessons on small meshes: what is stored, why a collapse is refused, what a sweep does.");
  ImGui::SameLine(0, 1.5f * em());
}

}  // namespace

void status_bar(Frame& frame) {
  std::string right;
  if (frame.has_mesh()) {
    const scene::MeshFacts& facts = frame.session.facts();
    right = facts.regions > 0 ? scene::grouped(facts.regions) + " regions"
                              : scene::grouped(facts.faces) + " faces";
    const auto loaded = static_cast<double>(frame.session.loaded_facts().faces);
    if (facts.regions == 0 && facts.faces != frame.session.loaded_facts().faces && loaded > 0)
      right += " (" + scene::short_number(100.0 * static_cast<double>(facts.faces) / loaded, 1) + " %)";
  }
  if (frame.session.lesson.suggested) lessons_link(frame);
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  const float left_width = ImGui::GetContentRegionAvail().x - right_width - em();
  muted(frame, fitted(frame.session.status, left_width));
  ImGui::SameLine();
  text_right(right);
}

}  // namespace aomd::ui
