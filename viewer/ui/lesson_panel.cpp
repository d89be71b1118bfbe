#include <algorithm>
#include <string>

#include "viewer/ui/panels.h"
#include "viewer/ui/rich_text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::LessonPlayer;

/// A piece for each page; those that lie behind are full.
void page_marks(const Frame& frame, const LessonPlayer& player) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::size_t pages = player.lesson()->pages.size();
  const float space = 0.2f * em(), height = 0.22f * em();
  const float width = (ImGui::GetContentRegionAvail().x - space * static_cast<float>(pages - 1)) /
                      static_cast<float>(pages);
  for (std::size_t i = 0; i < pages; ++i) {
    const float x = at.x + static_cast<float>(i) * (width + space);
    const ImU32 color = i <= player.page_number() ? ImGui::GetColorU32(frame.colors.accent)
                                                  : ImGui::GetColorU32(ImGuiCol_FrameBg);
    ImGui::GetWindowDrawList()->AddRectFilled({x, at.y}, {x + width, at.y + height}, color,
                                              0.5f * height);
  }
  ImGui::Dummy({1, height});
}

void paragraphs(Frame& frame, const std::vector<scene::Paragraph>& list) {
  for (const scene::Paragraph& each : list) {
    rich_text(frame, each, frame.colors.text);
  }
}

void check_rows(Frame& frame, const LessonPlayer& player) {
  const auto& checks = player.page().checks;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const bool met = player.done() || player.met()[i];
    tick_sign(frame, ImGui::GetCursorScreenPos(), met);
    ImGui::Indent(1.35f * em());
    rich_text(frame, checks[i].label, met ? frame.colors.text_muted : frame.colors.text);
    ImGui::Unindent(1.35f * em());
  }
}

void small_link(Frame& frame, const char* words, const char* line) {
  ImGui::PushFont(frame.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.accent);
  text(words);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsItemClicked()) frame.emit(line);
  command_tooltip(line);
}

void help_with_task(Frame& frame, const LessonPlayer& player) {
  if (player.done()) return;
  if (!player.page().hint.empty()) {
    small_link(frame, player.hinted ? "Hide the hint" : "Give me a hint", "lesson hint");
    ImGui::SameLine(0, 1.2f * em());
  }
  small_link(frame, "Do it for me", "lesson solve");
  if (player.hinted && !player.page().hint.empty())
    rich_text(frame, player.page().hint, frame.colors.text_muted);
}

/// What is to be done, with a line along its left side.
void task_box(Frame& frame, const LessonPlayer& player) {
  if (player.page().task.empty()) return;
  gap(0.1f);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Indent(0.75f * em());
  ImGui::PushStyleColor(ImGuiCol_Text, player.done() ? frame.colors.good : frame.colors.accent);
  heading(frame, player.done() ? "Done" : "Your turn");
  ImGui::PopStyleColor();
  paragraphs(frame, player.page().task);
  check_rows(frame, player);
  help_with_task(frame, player);
  ImGui::Unindent(0.75f * em());
  const float end = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
  const ImVec4 color = player.done() ? frame.colors.good : frame.colors.accent;
  ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + 0.2f * em(), end},
                                            ImGui::GetColorU32(color), 0.1f * em());
}

void next_button(Frame& frame, const LessonPlayer& player, float width) {
  if (!player.last_page()) return primary_button(frame, "Next", "lesson next", width);
  const auto all = scene::lessons();
  const auto next = static_cast<std::size_t>(player.lesson() - all.data()) + 1;
  if (next < all.size())
    return primary_button(frame, "Next lesson", "lesson " + all[next].name, width);
  primary_button(frame, "All lessons", "dialog lessons", width);
}

void buttons(Frame& frame, const LessonPlayer& player) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float half = 0.5f * (ImGui::GetContentRegionAvail().x - spacing);
  command_button(frame, "Back", "lesson back", half, player.page_number() > 0);
  ImGui::SameLine();
  next_button(frame, player, half);
  small_link(frame, "Begin this page again", "lesson restart");
  ImGui::PushFont(frame.fonts.small);
  same_line_right(ImGui::CalcTextSize("Leave the lesson").x);
  ImGui::PopFont();
  small_link(frame, "Leave the lesson", "lesson off");
}

}  // namespace

bool lesson_titles(Frame& frame) {
  const LessonPlayer& player = frame.session.lesson;
  if (player.lesson() == nullptr) return false;
  if (tab_title(frame, "Lesson", frame.fonts.heading, player.shown)) frame.emit("lesson show");
  command_tooltip("lesson show");
  ImGui::SameLine(0, em());
  if (tab_title(frame, "Mesh", frame.fonts.heading, !player.shown)) frame.emit("lesson hide");
  command_tooltip("lesson hide");
  gap(0.1f);
  return player.shown;
}

void lesson_panel(Frame& frame) {
  const LessonPlayer& player = frame.session.lesson;
  ImGui::PushFont(frame.fonts.small);
  muted(frame, fitted(player.lesson()->title, ImGui::GetContentRegionAvail().x - 4.5f * em()));
  ImGui::SameLine();
  text_right(std::to_string(player.page_number() + 1) + " of " +
             std::to_string(player.lesson()->pages.size()));
  ImGui::PopFont();
  page_marks(frame, player);
  gap(0.1f);
  const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  const float height = std::max(3 * em(), ImGui::GetContentRegionAvail().y - below);
  if (ImGui::BeginChild("page", {0, height})) {
    ImGui::PushID(static_cast<int>(player.page_number()));
    ImGui::PushTextWrapPos(0);
    heading(frame, player.page().title.c_str());
    ImGui::PopTextWrapPos();
    paragraphs(frame, player.page().text);
    task_box(frame, player);
    ImGui::PopID();
  }
  ImGui::EndChild();
  buttons(frame, player);
}

}  // namespace aomd::ui
