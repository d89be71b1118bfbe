#pragma once
// The few building blocks that all panels are made of.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <imgui.h>

#include "viewer/ui/frame.h"

namespace aomd::ui {

/// The size of the present font: all distances are multiples of it, so that they follow the scale.
[[nodiscard]] inline float em() { return ImGui::GetFontSize(); }

void text(std::string_view s);
void muted(const Frame& frame, std::string_view s);
/// A text with line ends instead of blanks, so that no line is wider; numbers are never cut as
/// ImGui does.
[[nodiscard]] std::string broken_at_blanks(std::string_view s, float width);
/// A text in as many lines as it needs.
void wrapped(std::string_view s, const ImVec4& color);
/// A muted text in as many lines as it needs.
void wrapped(const Frame& frame, std::string_view s);
/// Right-aligned in the present column.
void text_right(std::string_view s);
/// A table of names and values, `columns` wide (3: with changes). False where nothing of it shows:
/// then without end_values().
[[nodiscard]] bool begin_values(const char* id, int columns);
void end_values();
/// One row of it.
void value_row(const Frame& frame, const char* label, std::string_view value,
               std::string_view help);
/// The next item stands on the same line, at its right end, `width` wide.
void same_line_right(float width);
/// A panel's or section's title.
void heading(const Frame& frame, const char* title);
void gap(float ems = 0.35f);
/// For the last item, wrapped, also while it is disabled. Empty text shows nothing.
void tooltip(std::string_view s);
/// For the last item: what it is for, then more quietly the command that does the same.
void tooltip(std::string_view help, std::string_view line);
/// What the line does, its key, and the line itself, for scripts.
void command_tooltip(std::string_view line);

/// A button that emits `line`; it fills `width` (0: its text, negative: what is left).
void command_button(Frame& frame, const char* label, std::string_view line, float width,
                    bool enabled = true);
/// For text on the accent colour.
[[nodiscard]] ImVec4 on_accent(const Frame& frame);
/// A small sign that emits `copy TABLE`, at the right end of the present line.
void copy_button(Frame& frame, const char* table);
/// In the accent colour: the one thing to do.
void primary_button(Frame& frame, const char* label, std::string_view line, float width,
                    bool enabled = true);
/// A title that turns to its page; the one that is up is underlined. True when it is pressed.
[[nodiscard]] bool tab_title(const Frame& frame, const char* title, ImFont* font, bool up);
/// A menu entry that emits `line` and shows its key.
void command_item(Frame& frame, const char* label, const std::string& line, bool selected = false,
                  bool enabled = true);

enum class Icon { First, Back, Play, Pause, Forward, Last, Undo, Redo };
/// A square button with a drawn sign.
[[nodiscard]] bool icon_button(const char* id, Icon icon, bool enabled);

/// A thin horizontal bar of `share` (0..1) of the width that is left.
void bar(double share, ImU32 color, float height_ems);

/// A slider and a field to type into, side by side. True while the value changes.
struct NumberStyle {
  double low = 0, high = 1;
  const char* format = "%.1f";
  bool logarithmic = false;
  const char* help = "";  ///< what it is and in which unit: for both tooltips
};
[[nodiscard]] bool number_control(const char* id, double& value, const NumberStyle& style);

/// For a string of any length up to a path's; `hint` stands in it while it is empty. True when it
/// is entered.
[[nodiscard]] bool text_input(const char* id, std::string& value, const char* hint = "");

/// One of the rows of a list that drops down, with what its tooltip says.
struct Choice {
  const char* name;
  const char* help;
  bool enabled = true;
};
/// Shows the present one; what is chosen instead, if anything.
[[nodiscard]] std::optional<std::size_t> choice_control(const char* id,
                                                        std::span<const Choice> choices,
                                                        std::size_t present);

/// Whether a key that ImGui knows went down in this frame, or repeats.
[[nodiscard]] bool key_pressed(ImGuiKey key);

/// `a` shortened at its end so that it is at most `width` wide.
[[nodiscard]] std::string shortened(const std::string& a, float width);
/// `a` shortened in its middle so that it is at most `width` wide.
[[nodiscard]] std::string fitted(const std::string& a, float width);

}  // namespace aomd::ui
