#include "viewer/ui/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/io/io.h"
#include "viewer/base/text.h"
#include "viewer/lessons/lesson.h"
#include "viewer/ui/command_palette.h"
#include "viewer/ui/recent_files.h"

namespace aomd::ui {
namespace {

constexpr int farthest = 100'000;  // no screen is that far away

/// By scene::Page.
constexpr std::array<const char*, 4> page_names = {"decimation", "adjacency", "histograms",
                                                   "selection"};

void take_page(const std::string& value, scene::Page& page) {
  const auto found = std::find(page_names.begin(), page_names.end(), value);
  if (found != page_names.end()) page = static_cast<scene::Page>(found - page_names.begin());
}

const char* on_off(bool on) { return on ? "on" : "off"; }

void take_width(const std::string& value, float& width) {
  float ems = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), ems);
  if (error == std::errc{} && (ems == 0 || (ems >= 8 && ems <= 60))) width = ems;
}

void take_number(const std::string& value, double least, double most, double& target) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error == std::errc{} && number >= least && number <= most) target = number;
}

void take_window(const std::string& value, Settings& settings) {
  std::istringstream in(value);
  WindowPlace place;
  in >> place.position.x >> place.position.y >> place.size.x >> place.size.y;
  const bool sensible = in && std::abs(place.position.x) < farthest &&
                        std::abs(place.position.y) < farthest && place.size.x >= 100 &&
                        place.size.y >= 100 && place.size.x < farthest && place.size.y < farthest;
  std::string state;
  in >> state;
  place.maximized = state == "maximized";
  if (sensible) settings.window = place;
}

void take(const std::string& name, const std::string& value, Settings& settings) {
  const auto flag = [&](const char* wanted, bool& target) {
    if (name == wanted && (value == "on" || value == "off")) target = value == "on";
  };
  scene::Panels& panels = settings.panels;
  if (name == "theme") settings.theme = value == "dark" ? scene::Theme::Dark : scene::Theme::Light;
  flag("mesh-panel", panels.mesh);
  flag("side-panel", panels.side);
  flag("timeline", panels.timeline);
  flag("runs", panels.runs);
  flag("occlusion", settings.occlusion);
  flag("ground", settings.ground);
  if (name == "page") take_page(value, panels.page);
  if (name == "mesh-width") take_width(value, panels.mesh_ems);
  if (name == "side-width") take_width(value, panels.side_ems);
  if (name == "text-size")
    take_number(value, scene::least_text_scale, scene::largest_text_scale, settings.text_scale);
  scene::PlaySpeed& speed = settings.play_speed;
  using scene::PlaySpeed;
  if (name == "play-speed") take_number(value, PlaySpeed::slowest, PlaySpeed::fastest, speed.per_s);
  if (name == "play-whole")
    take_number(value, PlaySpeed::shortest_s, PlaySpeed::longest_s, speed.whole_s);
  if (name == "window") take_window(value, settings);
  if (name == "command" && settings.recent_commands.size() < CommandPalette::most_recent)
    settings.recent_commands.push_back(value);
  if (name == "lesson" && scene::find_lesson(value) != nullptr)
    settings.lessons_done.push_back(value);
}

}  // namespace

Settings parse_settings(const std::string& text) {
  Settings settings;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (const std::size_t equals = line.find('='); equals != std::string::npos)
      take(line.substr(0, equals), line.substr(equals + 1), settings);
  return settings;
}

std::string settings_text(const Settings& settings) {
  const scene::Panels& panels = settings.panels;
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += name + ("=" + value) + "\n";
  };
  add("theme", settings.theme == scene::Theme::Dark ? "dark" : "light");
  add("mesh-panel", on_off(panels.mesh));
  add("side-panel", on_off(panels.side));
  add("timeline", on_off(panels.timeline));
  add("runs", on_off(panels.runs));
  add("page", page_names[static_cast<std::size_t>(panels.page)]);
  add("mesh-width", scene::short_number(panels.mesh_ems, 2));
  add("side-width", scene::short_number(panels.side_ems, 2));
  add("occlusion", on_off(settings.occlusion));
  add("ground", on_off(settings.ground));
  add("text-size", scene::short_number(settings.text_scale, 4));
  add("play-speed", scene::short_number(settings.play_speed.per_s, 7));
  add("play-whole", scene::short_number(settings.play_speed.whole_s, 7));
  if (const auto& w = settings.window) {
    std::string place = std::to_string(w->position.x) + " " + std::to_string(w->position.y) + " " +
                        std::to_string(w->size.x) + " " + std::to_string(w->size.y);
    add("window", place + (w->maximized ? " maximized" : ""));
  }
  for (const std::string& line : settings.recent_commands) add("command", line);
  for (const std::string& lesson : settings.lessons_done) add("lesson", lesson);
  return text;
}

Settings read_settings(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  return parse_settings(text.str());
}

void write_settings(const std::filesystem::path& file, const Settings& settings) {
  if (file.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  try {
    io::write_file(file, settings_text(settings));
  } catch (const io::WriteError&) {
  }
}

std::filesystem::path settings_path() {
  const std::filesystem::path recent = recent_files_path();
  return recent.empty() ? recent : recent.parent_path() / "settings";
}

}  // namespace aomd::ui
