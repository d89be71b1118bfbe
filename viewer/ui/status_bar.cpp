#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {

namespace {

/// For who is new here, and more quietly for who has not been through all of them.
void lessons_link(Frame& frame) {
  using Hint = scene::LessonPlayer::Hint;
  const scene::LessonPlayer& player = frame.session.lesson;
  if (player.suggested == Hint::None) return;
  const bool first = player.suggested == Hint::First;
  ImGui::PushStyleColor(ImGuiCol_Text, first ? frame.colors.accent : frame.colors.text_muted);
  text(first ? std::string("New here? Lessons: F2")
             : "Lessons: " + std::to_string(player.completed.size()) + " of " +
                   std::to_string(scene::lessons().size()) + " done (F2)");
  ImGui::PopStyleColor();
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsItemClicked()) frame.emit("dialog lessons");
  tooltip(
      "Ten short lessons on small meshes: what is stored, why a collapse is refused, what a sweep "
      "does, how "
      "to judge a result. Help > Lessons lists them at any time.",
      "dialog lessons");
  ImGui::SameLine(0, 1.5f * em());
}

}  // namespace

void status_bar(Frame& frame) {
  std::string right;
  if (frame.has_mesh()) {
    const scene::MeshFacts& facts = frame.session.sheet().facts();
    right = facts.regions > 0 ? scene::counted(facts.regions, "region")
                              : scene::counted(facts.faces, "face");
    const auto loaded = static_cast<double>(frame.session.sheet().loaded_facts().faces);
    if (facts.regions == 0 && facts.faces != frame.session.sheet().loaded_facts().faces &&
        loaded > 0)
      right +=
          " (" + scene::short_number(100.0 * static_cast<double>(facts.faces) / loaded, 1) + " %)";
  }
  lessons_link(frame);
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  const float left_width = ImGui::GetContentRegionAvail().x - right_width - em();
  muted(frame, fitted(frame.session.status, left_width));
  ImGui::SameLine();
  text_right(right);
}

}  // namespace aomd::ui
