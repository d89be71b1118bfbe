#pragma once
// How the panels look: fonts, colours, spacing.

#include <imgui.h>

#include "viewer/render/renderer.h"

namespace aomd::ui {

enum class ThemeKind { Light, Dark };

/// The faces of the font; never null after load_fonts().
struct Fonts {
  ImFont* text = nullptr;
  ImFont* heading = nullptr;  ///< bold, slightly larger
  ImFont* mono = nullptr;     ///< for commands and numbers in columns
  ImFont* small = nullptr;    ///< for what has to fit into a cell
};

/// Colours with a meaning, for panels that draw something of their own.
struct ThemeColors {
  ImVec4 accent;
  ImVec4 text;
  ImVec4 text_muted;
  ImVec4 panel;
  ImVec4 border;
  ImVec4 good;     ///< a yes
  ImVec4 warning;  ///< worth a look
  ImVec4 bad;      ///< a refusal, an error
};

/// Replaces the fonts of the current ImGui context: by those that are part of the program, else the
/// first found of Inter, Open Sans and DejaVu Sans, else ImGui's own. `scale` is the window's
/// content scale. Call it before the frame, then ImGuiLayer::update_fonts().
Fonts load_fonts(float scale);

/// Sets the style of the current ImGui context: colours, and sizes times `scale`.
void apply_theme(ThemeKind kind, float scale);

[[nodiscard]] ThemeColors theme_colors(ThemeKind kind);

/// The scene's colours that go with it.
[[nodiscard]] render::SceneTheme scene_theme(ThemeKind kind);

}  // namespace aomd::ui
