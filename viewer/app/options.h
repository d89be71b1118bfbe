#pragma once
// The command line of aomd-view.

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/app/window.h"
#include "viewer/drawing/view.h"

namespace aomd::app {

/// What the process ends with.
enum ExitCode : int {
  exit_done = 0,
  exit_no = 1,  ///< an expectation or a comparison says no
  exit_usage = 2,
  exit_unreadable = 3,
  exit_unwritten = 4,
  exit_limit = 5,
  exit_fault = 70,  ///< an internal one: of a process that drew a case
};

struct Options {
  std::filesystem::path file;  ///< empty: a sample, or what the script opens
  std::optional<HeadlessKind> headless;
  glm::ivec2 size{1280, 800};
  std::filesystem::path model;  ///< empty: none
  std::filesystem::path script;
  std::vector<std::string> commands;  ///< carried out after the script
  std::string commands_place;         ///< what errors in them begin with
  std::filesystem::path screenshot;
  std::filesystem::path compare;
  double threshold = 0.98;   ///< structural similarity that each tile must have
  bool transparent = false;  ///< leaves out what is behind the mesh in these pictures
  std::filesystem::path record;
  std::filesystem::path shaders;
  std::string camera;
  std::optional<scene::Theme> theme;  ///< none: as the user left it, or light
  std::optional<double> scale;        ///< of text, controls, lines and points; none: the screen's
  bool size_given = false;            ///< else a window is as large as the user left it
  bool interface = true;
  /// Where unsaved work is kept; none: in the user's own folder for a window, nowhere without one
  /// or for a script. Empty: nowhere.
  std::optional<std::filesystem::path> recovery;
};

/// The code for an error, or for what caused it where it stands around another one.
[[nodiscard]] int exit_code_of(const std::exception& error);

/// Where a picture goes that is not as its baseline, and where the difference goes.
[[nodiscard]] std::filesystem::path picture_for_comparison(const Options& options);
[[nodiscard]] std::filesystem::path picture_of_difference(const Options& options);

/// The options, or the code to end with at once (--help, --version, wrong usage: the message is
/// printed).
struct ParsedOptions {
  std::optional<Options> options;
  int exit_code = exit_done;
};
[[nodiscard]] ParsedOptions parse_options(int argc, char** argv);

}  // namespace aomd::app
