#include "viewer/ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "viewer/commands/commands.h"
#include "viewer/commands/line_help.h"

namespace aomd::ui {
namespace {

constexpr float tooltip_ems = 22;

void draw_bar_sign(ImDrawList& list, ImVec2 c, float r, float x, ImU32 color) {
  list.AddRectFilled({c.x + x - 0.13f * r, c.y - 0.8f * r}, {c.x + x + 0.13f * r, c.y + 0.8f * r},
                     color);
}

void draw_arrow_sign(ImDrawList& list, ImVec2 c, float r, float direction, ImU32 color) {
  list.AddTriangleFilled({c.x - 0.55f * direction * r, c.y - 0.8f * r},
                         {c.x + 0.75f * direction * r, c.y},
                         {c.x - 0.55f * direction * r, c.y + 0.8f * r}, color);
}

/// Three quarters of a turn with an arrow head; mirrored for redo.
void draw_turn_sign(ImDrawList& list, ImVec2 c, float r, float direction, ImU32 color) {
  constexpr int pieces = 14;
  for (int i = 0; i <= pieces; ++i) {
    const float angle = -2.6f + 3.9f * static_cast<float>(i) / pieces;
    list.PathLineTo({c.x + direction * 0.75f * r * std::cos(angle),
                     c.y + 0.1f * r + 0.75f * r * std::sin(angle)});
  }
  list.PathStroke(color, false, 0.28f * r);
  const ImVec2 tip{c.x - direction * 0.68f * r, c.y - 0.25f * r};
  list.AddTriangleFilled({tip.x - direction * 0.4f * r, tip.y - 0.55f * r},
                         {tip.x + direction * 0.65f * r, tip.y - 0.1f * r},
                         {tip.x - direction * 0.25f * r, tip.y + 0.55f * r}, color);
}

void draw_icon(Icon icon, ImVec2 c, float r, ImU32 color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  switch (icon) {
    case Icon::First:
    case Icon::Last: {
      const float side = icon == Icon::First ? -1.0f : 1.0f;
      draw_bar_sign(list, c, r, 0.7f * side * r, color);
      draw_arrow_sign(list, {c.x - 0.1f * side * r, c.y}, r, side, color);
      return;
    }
    case Icon::Back:
    case Icon::Forward: {
      const float side = icon == Icon::Back ? -1.0f : 1.0f;
      draw_bar_sign(list, c, r, -0.65f * side * r, color);
      draw_arrow_sign(list, {c.x + 0.2f * side * r, c.y}, 0.85f * r, side, color);
      return;
    }
    case Icon::Play:
      return draw_arrow_sign(list, c, 1.1f * r, 1, color);
    case Icon::Pause:
      draw_bar_sign(list, c, 1.2f * r, -0.4f * r, color);
      draw_bar_sign(list, c, 1.2f * r, 0.4f * r, color);
      return;
    case Icon::Undo:
      return draw_turn_sign(list, c, r, 1, color);
    case Icon::Redo:
      return draw_turn_sign(list, c, r, -1, color);
  }
}

/// Without a tooltip.
void emitting_button(Frame& frame, const char* label, std::string_view line, float width,
                     bool enabled) {
  ImGui::BeginDisabled(!enabled);
  if (ImGui::Button(label, {width, 0})) frame.emit(std::string(line));
  ImGui::EndDisabled();
}

/// The mouse is on the last item, and has moved since the last click: whoever clicked knows, and
/// wants to see what comes of it.
bool tooltip_due() {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 from = io.MouseClickedPos[ImGuiMouseButton_Left];
  const bool clicked_here = std::abs(io.MousePos.x - from.x) + std::abs(io.MousePos.y - from.y) < 4;
  return !clicked_here && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
}

/// Beside the menu, whose next entries are to be read as well.
void menu_tooltip(std::string_view help) {
  if (help.empty() || !tooltip_due()) return;
  const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth(),
              gap = 0.3f * em();
  const bool fits = right + gap + tooltip_ems * em() < ImGui::GetIO().DisplaySize.x;
  ImGui::SetNextWindowPos({fits ? right + gap : left - gap, ImGui::GetItemRectMin().y},
                          ImGuiCond_Always, {fits ? 0.0f : 1.0f, 0});
  tooltip(help);
}

}  // namespace

void text(std::string_view s) { ImGui::TextUnformatted(s.data(), s.data() + s.size()); }

void muted(const Frame& frame, std::string_view s) {
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
  text(s);
  ImGui::PopStyleColor();
}

std::string broken_at_blanks(std::string_view s, float width) {
  std::string result, line;
  for (std::size_t at = 0; at < s.size();) {
    const std::size_t end = std::min(s.find(' ', at), s.size());
    const std::string word(s.substr(at, end - at));
    const std::string longer = line.empty() ? word : line + ' ' + word;
    const bool fits = line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= width;
    if (!fits) result += line + '\n';
    line = fits ? longer : word;
    at = end + 1;
  }
  return result + line;
}

void wrapped(std::string_view s, const ImVec4& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  text(broken_at_blanks(s, ImGui::GetContentRegionAvail().x));
  ImGui::PopStyleColor();
}

void wrapped(const Frame& frame, std::string_view s) { wrapped(s, frame.colors.text_muted); }

void text_right(std::string_view s) {
  const float width = ImGui::CalcTextSize(s.data(), s.data() + s.size()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
  text(s);
}

bool begin_values(const char* id, int columns) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.25f * em(), 0.12f * em()));
  if (!ImGui::BeginTable(id, columns, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::PopStyleVar();
    return false;
  }
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("now", ImGuiTableColumnFlags_WidthFixed, 3.9f * em());
  if (columns == 3)
    ImGui::TableSetupColumn("change", ImGuiTableColumnFlags_WidthFixed, 4.0f * em());
  return true;
}

void end_values() {
  ImGui::EndTable();
  ImGui::PopStyleVar();
}

void value_row(const Frame& frame, const char* label, std::string_view value,
               std::string_view help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  muted(frame, label);
  tooltip(help);
  ImGui::TableNextColumn();
  text_right(value);
  tooltip(help);
}

void same_line_right(float width) {
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
}

void heading(const Frame& frame, const char* title) {
  ImGui::PushFont(frame.fonts.heading);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
}

void gap(float ems) { ImGui::Dummy({0, ems * em()}); }

void tooltip(std::string_view s) { tooltip(s, {}); }

void tooltip(std::string_view help, std::string_view line) {
  if (help.empty() || !tooltip_due()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(tooltip_ems * em());
  text(help);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  if (!line.empty()) text(line);
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void command_tooltip(std::string_view line) {
  std::string help(scene::line_help(line));
  if (const auto chord = scene::chord_of_line(line); !chord.empty())
    help += " (" + std::string(chord) + ")";
  tooltip(help, line);
}

void command_button(Frame& frame, const char* label, std::string_view line, float width,
                    bool enabled) {
  emitting_button(frame, label, line, width, enabled);
  command_tooltip(line);
}

ImVec4 on_accent(const Frame& frame) {
  const ImVec4 a = frame.colors.accent;
  const bool dark_text = 0.3f * a.x + 0.6f * a.y + 0.1f * a.z > 0.5f;
  return dark_text ? ImVec4(0.05f, 0.08f, 0.12f, 1) : ImVec4(1, 1, 1, 1);
}

void primary_button(Frame& frame, const char* label, std::string_view line, float width,
                    bool enabled) {
  const ImVec4 a = frame.colors.accent;
  const auto lighter = [&](float by) {
    return ImVec4(a.x + (1 - a.x) * by, a.y + (1 - a.y) * by, a.z + (1 - a.z) * by, 1);
  };
  ImGui::PushStyleColor(ImGuiCol_Button, a);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, lighter(0.15f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, lighter(0.3f));
  ImGui::PushStyleColor(ImGuiCol_Text, on_accent(frame));
  emitting_button(frame, label, line, width, enabled);
  ImGui::PopStyleColor(4);  // before the tooltip, whose text is on another colour
  command_tooltip(line);
}

bool tab_title(const Frame& frame, const char* title, ImFont* font, bool up) {
  ImGui::PushFont(frame.fonts.heading);
  const float height = ImGui::GetFontSize(), line = 0.3f * em();
  ImGui::PopFont();
  ImGui::PushFont(font);
  const ImVec2 size{ImGui::CalcTextSize(title).x, height};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(title, {size.x, height + line});
  const ImVec4 color = up || ImGui::IsItemHovered() ? frame.colors.text : frame.colors.text_muted;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(at, ImGui::GetColorU32(color), title);
  if (up)
    list.AddRectFilled({at.x, at.y + size.y + 0.16f * em()},
                       {at.x + size.x, at.y + size.y + 0.3f * em()},
                       ImGui::GetColorU32(frame.colors.accent));
  ImGui::PopFont();
  return pressed;
}

void command_item(Frame& frame, const char* label, const std::string& line, bool selected,
                  bool enabled) {
  const std::string chord(scene::chord_of_line(line));
  if (ImGui::MenuItem(label, chord.empty() ? nullptr : chord.c_str(), selected, enabled))
    frame.emit(line);
  menu_tooltip(scene::own_help(line));
}

bool icon_button(const char* id, Icon icon, bool enabled) {
  const float side = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!enabled);
  ImGui::PushID(id);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::Button("##icon", {1.25f * side, side});
  draw_icon(icon, {corner.x + 0.625f * side, corner.y + 0.5f * side}, 0.24f * side,
            ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::PopID();
  ImGui::EndDisabled();
  return pressed;
}

void bar(double share, ImU32 color, float height_ems) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = height_ems * em();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = 0.5f * height;
  list.AddRectFilled(from, {from.x + width, from.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     radius);
  const float filled = static_cast<float>(std::clamp(share, 0.0, 1.0)) * width;
  if (filled > 0)
    list.AddRectFilled(from, {from.x + std::max(filled, height), from.y + height}, color, radius);
  ImGui::Dummy({width, height});
}

void copy_button(Frame& frame, const char* table) {
  const float side = 1.05f * em();
  same_line_right(side);
  ImGui::PushID(table);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("copy", {side, side})) frame.emit(std::string("copy ") + table);
  const ImVec4 color = ImGui::IsItemHovered() ? frame.colors.accent : frame.colors.text_muted;
  const float w = 0.5f * em(), h = 0.62f * em(), shift = 0.2f * em();
  const ImVec2 back{at.x + 0.16f * em(), at.y + 0.12f * em()};
  const ImVec2 front{back.x + shift, back.y + shift};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect(back, {back.x + w, back.y + h}, ImGui::GetColorU32(color), 0.1f * em());
  list.AddRectFilled(front, {front.x + w, front.y + h}, ImGui::GetColorU32(frame.colors.panel),
                     0.1f * em());
  list.AddRect(front, {front.x + w, front.y + h}, ImGui::GetColorU32(color), 0.1f * em());
  command_tooltip(std::string("copy ") + table);
  ImGui::PopID();
}

bool key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(key);
#else
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

bool number_control(const char* id, double& value, const NumberStyle& style) {
  const float field = 4.6f * em();
  ImGui::PushID(id);
  ImGui::SetNextItemWidth(std::max(
      3 * em(), ImGui::GetContentRegionAvail().x - field - ImGui::GetStyle().ItemInnerSpacing.x));
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_NoInput |
      (style.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  bool changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &style.low,
                                     &style.high, "", flags);
  tooltip(style.help);
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::SetNextItemWidth(field);
  double typed = value;
  if (ImGui::InputDouble(
          "##field", &typed, 0, 0, style.format,
          ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue)) {
    value = std::clamp(typed, style.low, style.high);
    changed = true;
  }
  if (*style.help != '\0') tooltip(std::string(style.help) + " Type a value, then Enter.");
  ImGui::PopID();
  return changed;
}

bool text_input(const char* id, std::string& value, const char* hint) {
  std::array<char, 4096> buffer{};
  std::strncpy(buffer.data(), value.c_str(), buffer.size() - 1);
  const bool entered = ImGui::InputTextWithHint(id, hint, buffer.data(), buffer.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  value = buffer.data();
  return entered;
}

std::optional<std::size_t> choice_control(const char* id, std::span<const Choice> choices,
                                          std::size_t present) {
  std::optional<std::size_t> chosen;
  const bool open = ImGui::BeginCombo(id, choices[present].name);
  if (!open) tooltip(choices[present].help);
  if (!open) return chosen;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto flags =
        choices[i].enabled ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    if (ImGui::Selectable(choices[i].name, i == present, flags) && i != present) chosen = i;
    tooltip(choices[i].help);
  }
  ImGui::EndCombo();
  return chosen;
}

std::string shortened(const std::string& a, float width) {
  if (ImGui::CalcTextSize(a.c_str()).x <= width) return a;
  for (std::size_t keep = a.size(); keep > 0; --keep) {
    if ((static_cast<unsigned char>(a[keep]) & 0xc0u) == 0x80u) continue;  // within a character
    std::string shorter = a.substr(0, keep) + "\u2026";
    if (ImGui::CalcTextSize(shorter.c_str()).x <= width) return shorter;
  }
  return "\u2026";
}

std::string fitted(const std::string& a, float width) {
  if (ImGui::CalcTextSize(a.c_str()).x <= width) return a;
  for (std::size_t keep = a.size(); keep > 4; --keep) {
    // Names with bytes beyond ASCII are cut between characters.
    const auto inside = [&](std::size_t i) {
      return (static_cast<unsigned char>(a[i]) & 0xc0u) == 0x80u;
    };
    std::size_t head = keep / 2;
    std::size_t tail = a.size() - (keep - head);
    while (head > 0 && inside(head)) --head;
    while (tail < a.size() && inside(tail)) ++tail;
    std::string shorter = a.substr(0, head) + "\u2026" + a.substr(tail);
    if (ImGui::CalcTextSize(shorter.c_str()).x <= width) return shorter;
  }
  return "\u2026";
}

}  // namespace aomd::ui
