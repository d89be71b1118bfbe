#include "viewer/ui/lessons_dialog.h"

#include <algorithm>
#include <string>

#include "viewer/lessons/lesson.h"
#include "viewer/ui/rich_text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

void lesson_row(Frame& frame, const scene::Lesson& lesson, std::size_t number, bool done) {
  const float height = 2.75f * em();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(lesson.name.c_str());
  if (ImGui::Selectable("##row", false, ImGuiSelectableFlags_None, {0, height}))
    frame.emit("lesson " + lesson.name);
  ImGui::PopID();
  const ImVec2 after = ImGui::GetCursorScreenPos();
  tick_sign(frame, {at.x + 0.3f * em(), at.y + 0.3f * em()}, done);
  const std::string minutes = std::to_string(lesson.minutes) + " min";
  const float right = ImGui::CalcTextSize(minutes.c_str()).x + 0.6f * em();
  ImGui::SetCursorScreenPos({at.x + 1.9f * em(), at.y + 0.22f * em()});
  heading(frame, (std::to_string(number) + "  " + lesson.title).c_str());
  ImGui::SetCursorScreenPos({at.x + width - right, at.y + 0.3f * em()});
  muted(frame, minutes);
  ImGui::SetCursorScreenPos({at.x + 1.9f * em(), at.y + 1.45f * em()});
  muted(frame, shortened(lesson.about, width - 2.3f * em()));
  ImGui::SetCursorScreenPos(after);
}

}  // namespace

void lessons_dialog(Frame& frame) {
  muted(frame, "Each takes a few minutes and ends with something to try.");
  const float below = ImGui::GetFrameHeightWithSpacing() + 0.9f * em();
  if (ImGui::BeginChild("list",
                        {0, std::max(6 * em(), ImGui::GetContentRegionAvail().y - below)})) {
    const auto all = scene::lessons();
    for (std::size_t i = 0; i < all.size(); ++i)
      lesson_row(frame, all[i], i + 1, frame.session.lesson.completed.contains(all[i].name));
    ImGui::Dummy({1, 1});
  }
  ImGui::EndChild();
}

}  // namespace aomd::ui
