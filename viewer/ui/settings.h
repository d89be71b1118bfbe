#pragma once
// How the user left the window, kept between sessions beside the recent files.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/drawing/view.h"

namespace aomd::ui {

/// Of a window on the screen, in the system's units.
struct WindowPlace {
  glm::ivec2 position{0};
  glm::ivec2 size{0};  ///< while it is not maximised
  bool maximized = false;
  friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

struct Settings {
  scene::Theme theme = scene::Theme::Light;
  scene::Panels panels;
  double text_scale = 1;
  bool occlusion = false;
  bool ground = false;
  std::optional<WindowPlace> window;
  std::vector<std::string> recent_commands;  ///< of the palette, newest first
  scene::PlaySpeed play_speed;
  std::vector<std::string> lessons_done;  ///< by name
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// From lines "name=value"; those that nobody knows, or that make no sense, are passed over, so
/// that an old, a newer or a damaged file only forgets.
[[nodiscard]] Settings parse_settings(const std::string& text);
[[nodiscard]] std::string settings_text(const Settings& settings);

/// The usual settings where there is no such file.
[[nodiscard]] Settings read_settings(const std::filesystem::path& file);
/// Whole or not at all; failing to write is not worth a message.
void write_settings(const std::filesystem::path& file, const Settings& settings);

/// Beside the recent files; empty where these have no place.
[[nodiscard]] std::filesystem::path settings_path();

}  // namespace aomd::ui
