#include "viewer/ui/command_palette.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "viewer/commands/line_help.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::size_t longest_text = 1024;

/// What the field is told while it is edited.
struct FieldWishes {
  bool& caret_to_end;
  std::string completion;  ///< what Tab makes of the text
};

/// Emptied, or completed, from outside: ImGui would select it all, so that the next key replaced
/// it.
int edit_field(ImGuiInputTextCallbackData* data) {
  FieldWishes& wishes = *static_cast<FieldWishes*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, wishes.completion.c_str());
    return 0;
  }
  if (!std::exchange(wishes.caret_to_end, false)) return 0;
  data->CursorPos = data->BufTextLen;
  data->SelectionStart = data->SelectionEnd = data->CursorPos;
  return 0;
}

std::string_view without_blank(std::string_view line) {
  return line.ends_with(' ') ? line.substr(0, line.size() - 1) : line;
}

/// What the manual says after the name, where the line has no arguments yet.
std::string_view missing_arguments(const scene::CommandMatch& match) {
  return without_blank(match.line) == match.command->name ? match.command->arguments
                                                          : std::string_view();
}

float row_height() { return 2.5f * em(); }

}  // namespace

void CommandPalette::begin(const Frame& frame) {
  text_ = frame.session.view.palette_text;
  matches_ = scene::find_commands(text_, recent);
  searched_ = text_;
  chosen_ = 0;
  sent_.clear();
  focus_ = caret_to_end_ = scroll_ = true;
}

void CommandPalette::remember(const std::string& line) {
  std::erase(recent, line);
  recent.insert(recent.begin(), line);
  if (recent.size() > most_recent) recent.resize(most_recent);
}

void CommandPalette::choose(Frame& frame, const scene::CommandMatch& match) {
  focus_ = caret_to_end_ = true;
  if (!match.complete) {
    text_ = match.line;
    return;
  }
  sent_ = match.line;
  frame.emit("dismiss");
  frame.emit(sent_);
}

void CommandPalette::move_choice() {
  if (matches_.empty()) return;
  const std::size_t before = chosen_;
  if (key_pressed(ImGuiKey_DownArrow)) chosen_ = std::min(chosen_ + 1, matches_.size() - 1);
  if (key_pressed(ImGuiKey_UpArrow) && chosen_ > 0) --chosen_;
  if (key_pressed(ImGuiKey_PageDown)) chosen_ = std::min(chosen_ + 8, matches_.size() - 1);
  if (key_pressed(ImGuiKey_PageUp)) chosen_ -= std::min<std::size_t>(chosen_, 8);
  scroll_ = scroll_ || chosen_ != before;
}

void CommandPalette::draw_field(const Frame& frame) {
  std::array<char, longest_text> buffer{};
  std::strncpy(buffer.data(), text_.c_str(), buffer.size() - 1);
  if (frame.interactive && std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways |
                     ImGuiInputTextFlags_CallbackCompletion;
  FieldWishes wishes{caret_to_end_, chosen_ < matches_.size() ? matches_[chosen_].line : text_};
  entered_ = ImGui::InputTextWithHint("##text", "Type a command, or what it is to do",
                                      buffer.data(), buffer.size(), flags, edit_field, &wishes);
  text_ = buffer.data();
  if (text_ == searched_) return;
  matches_ = scene::find_commands(text_, recent);
  searched_ = text_;
  chosen_ = 0;
  scroll_ = true;
}

bool CommandPalette::draw_row(const Frame& frame, const scene::CommandMatch& match, bool chosen) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const bool pressed =
      ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_None, {0, row_height()});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = from.x + 0.5f * em(), top = from.y + 0.25f * em();
  const std::string_view line = without_blank(match.line);
  const std::string key(match.key);
  const float key_width = ImGui::CalcTextSize(key.c_str()).x;
  const ImU32 strong = ImGui::GetColorU32(frame.colors.text),
              weak = ImGui::GetColorU32(frame.colors.text_muted);
  const std::string help = (match.recent ? "Recent. " : "") + std::string(scene::line_help(line));
  const std::string shown = shortened(help, width - key_width - 2 * em());
  list.AddText({left, top}, strong, shown.c_str());
  list.AddText({from.x + width - key_width - 0.5f * em(), top}, weak, key.c_str());
  ImGui::PushFont(frame.fonts.mono);
  std::string command(line);
  if (const std::string_view more = missing_arguments(match); !more.empty())
    command += " " + std::string(more);
  list.AddText({left, top + 1.1f * em()}, weak, fitted(command, width - em()).c_str());
  ImGui::PopFont();
  if (shown != help) tooltip(help);
  return pressed;
}

void CommandPalette::draw_list(Frame& frame) {
  const float below = 1.9f * em();
  if (ImGui::BeginChild("##commands",
                        {0, std::max(row_height(), ImGui::GetContentRegionAvail().y - below)})) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0.1f * em()});
    std::optional<std::size_t> pressed;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (draw_row(frame, matches_[i], i == chosen_)) pressed = i;
      if (i == chosen_ && std::exchange(scroll_, false) && i > 0) ImGui::SetScrollHereY();
      ImGui::PopID();
    }
    ImGui::PopStyleVar();
    if (matches_.empty()) muted(frame, "No command has that in its name or help.");
    if (pressed) choose(frame, matches_[*pressed]);
  }
  ImGui::EndChild();
}

void CommandPalette::draw_footer(const Frame& frame) {
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.1f * em());
  if (!frame.session.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.bad);
    text(shortened(frame.session.error, ImGui::GetContentRegionAvail().x));
    ImGui::PopStyleColor();
    return tooltip(frame.session.error);
  }
  muted(frame, "Enter runs it, Tab completes it, up and down choose, Escape closes.");
}

void CommandPalette::draw(Frame& frame) {
  if (!sent_.empty()) {
    if (frame.session.error.empty()) {
      remember(sent_);
      frame.emit("dialog none");
    }
    sent_.clear();
  }
  move_choice();
  draw_field(frame);
  draw_list(frame);
  draw_footer(frame);
  if (entered_ && chosen_ < matches_.size()) choose(frame, scene::CommandMatch(matches_[chosen_]));
}

}  // namespace aomd::ui
