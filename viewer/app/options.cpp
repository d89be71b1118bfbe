#include "viewer/app/options.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <optional>
#include <vector>

#include "viewer/app/named_files.h"
#include "viewer/base/picture_size.h"
#include "viewer/commands/commands.h"

namespace aomd::app {
namespace {

/// "out.png" and "diff" give "out.diff.png".
std::filesystem::path beside(const std::filesystem::path& picture, const std::string& what) {
  return picture.parent_path() / (picture.stem().string() + "." + what + ".png");
}

/// CLI11 would take the word after a bare --headless for its value.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = argc - 1; i > 0; --i) {
    const std::string word = argv[i];
    words.push_back(word == "--headless" ? "--headless=auto" : word);
  }
  return words;  // from last to first, as CLI11 wants them
}

std::string check_size(const std::string& text) {
  glm::ivec2 size;
  return scene::read_picture_size(text, size);
}

std::string clash_of_files(const Options& options) {
  std::vector<NamedFile> written = {{"--record", options.record},
                                    {"--screenshot", options.screenshot}};
  if (!options.compare.empty()) {
    if (options.screenshot.empty())
      written.push_back({"the picture for --compare", picture_for_comparison(options)});
    written.push_back({"the difference for --compare", picture_of_difference(options)});
  }
  return clash_of_files({{"FILE", options.file},
                         {"--model", options.model},
                         {"--script", options.script},
                         {"--compare", options.compare}},
                        written);
}

/// What CLI11 fills in before it becomes Options.
struct Raw {
  Options options;
  HeadlessKind headless = HeadlessKind::Auto;
  std::string size = "1280x800";
  bool no_ui = false;
  std::string recovery;
  bool markdown = false;
};

void add_options(CLI::App& app, Raw& raw) {
  const std::map<std::string, HeadlessKind> kinds = {
      {"auto", HeadlessKind::Auto}, {"osmesa", HeadlessKind::OsMesa}, {"egl", HeadlessKind::Egl}};
  const std::map<std::string, scene::Theme> themes = {{"light", scene::Theme::Light},
                                                      {"dark", scene::Theme::Dark}};
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  app.add_option(
      "FILE", raw.options.file,
      "The mesh to show: OBJ, PLY, OFF, STL, glTF, Gmsh MSH, Medit, VTK, VTU or SU2; a sample "
      "when none is given");
  app.add_option("--model", raw.options.model,
                 "The CAD model that FILE lies on, as the command model: .step, .stp, .brep, "
                 ".iges, .igs or .geo")
      ->type_name("CAD");
  app.add_option("--headless", raw.headless,
                 "No window: draw with OSMesa or EGL, whichever works or the one named")
      ->transform(CLI::CheckedTransformer(kinds))
      ->option_text("[=osmesa|egl]");
  app.add_option("--size", raw.size, "Size of the window or picture in pixels (default 1280x800)")
      ->type_name("WxH")
      ->check(check_size);
  app.add_option("--script", raw.options.script, "Commands to carry out, one a line")
      ->type_name("FILE");
  app.add_option("--screenshot", raw.options.screenshot,
                 "Write a picture and end; implies --headless")
      ->type_name("OUT.png");
  app.add_option("--camera", raw.options.camera,
                 "As the command camera: \"iso\", \"front orthographic zoom=2\"")
      ->type_name("SPEC");
  app.add_option("--compare", raw.options.compare,
                 "Compare the picture with this one; implies --headless")
      ->type_name("BASELINE.png");
  app.add_option("--threshold", raw.options.threshold,
                 "Structural similarity that each tile of 32x32 pixels must have; 1 is identical "
                 "(default 0.98)")
      ->check(CLI::Range(0.0, 1.0))
      ->option_text("0..1");
  app.add_flag("--transparent", raw.options.transparent,
               "Leave out what is behind the mesh in these pictures");
  app.add_option("--scale", raw.options.scale,
                 "How large text, controls, lines and points are: 0.5 to 4; without it as the "
                 "screen is set, "
                 "1 without a window")
      ->check(CLI::Range(0.5, 4.0))
      ->option_text("F");
  app.add_option("--record", raw.options.record,
                 "Write every command that is carried out: a script for later")
      ->type_name("FILE");
  app.add_option("--shaders", raw.options.shaders, "Read the shaders from this folder")
      ->type_name("DIR");
  app.add_option("--theme", raw.options.theme,
                 "light or dark; as the window was left where it is not given")
      ->transform(CLI::CheckedTransformer(themes))
      ->option_text("light|dark");
  app.add_option("--recovery", raw.recovery,
                 "Keep unsaved work in this folder while it is being done, for the next start to "
                 "restore; off: "
                 "do not. A window without a script does so by itself")
      ->type_name("DIR|off");
  app.add_flag("--no-ui", raw.no_ui, "The mesh alone, without panels");
  app.add_flag("--commands-markdown", raw.markdown, "Print docs/COMMANDS.md and end");
  app.set_version_flag("--version", "aomd-view " AOMD_VERSION);
  app.footer(
      "\naomd-view test SUITE.toml draws many pictures and compares them (aomd-view test "
      "--help).\n\n" +
      scene::commands_help());
}

}  // namespace

std::filesystem::path picture_for_comparison(const Options& options) {
  if (!options.screenshot.empty()) return options.screenshot;
  return beside(options.compare.filename(), "result");
}

std::filesystem::path picture_of_difference(const Options& options) {
  return beside(picture_for_comparison(options), "diff");
}

ParsedOptions parse_options(int argc, char** argv) {
  CLI::App app("Shows a mesh and what decimation does to it.", "aomd-view");
  Raw raw;
  add_options(app, raw);
  try {
    app.parse(words_of(argc, argv));
  } catch (const CLI::ParseError& error) {
    const bool asked = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (asked) return {{}, app.exit(error)};
    std::cerr << "aomd-view: " << error.what() << " (--help lists the options)\n";
    return {{}, exit_usage};
  }
  if (raw.markdown) {
    std::cout << scene::commands_markdown();
    return {{}, exit_done};
  }
  (void)scene::read_picture_size(raw.size, raw.options.size);
  raw.options.interface = !raw.no_ui;
  raw.options.size_given = app.count("--size") > 0;
  if (raw.recovery == "off")
    raw.options.recovery.emplace();
  else if (!raw.recovery.empty())
    raw.options.recovery = raw.recovery;
  const bool pictures = !raw.options.screenshot.empty() || !raw.options.compare.empty();
  if (app.count("--headless") > 0 || pictures) raw.options.headless = raw.headless;
  if (const std::string clash = clash_of_files(raw.options); !clash.empty()) {
    std::cerr << "aomd-view: " << clash << ", which would be written over\n";
    return {{}, exit_usage};
  }
  return {raw.options, exit_done};
}

}  // namespace aomd::app
