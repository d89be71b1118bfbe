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
      "Short lessons on small meshes: what is stored, why a collapse is refused, what a sweep "
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
    const scene::MeshFacts& then = frame.session.sheet().loaded_facts();
    const bool volume = then.regions > 0;
    const std::int64_t cells = volume ? facts.regions : facts.faces;
    const std::int64_t loaded = volume ? then.regions : then.faces;
    right = scene::counted(cells, volume ? "region" : "face");
    if (cells != loaded && loaded > 0)
      right +=
          " (" +
          scene::short_number(100.0 * static_cast<double>(cells) / static_cast<double>(loaded), 1) +
          " %)";
  }
  lessons_link(frame);
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  const float left_width = ImGui::GetContentRegionAvail().x - right_width - em();
  muted(frame, fitted(frame.session.status, left_width));
  ImGui::SameLine();
  text_right(right);
}

}  // namespace aomd::ui
