// aomd-view: see docs/COMMANDS.md for its commands and --help for its options.

#include <malloc.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string_view>

#include "core/io/png.h"
#include "core/measure/image_diff.h"
#include "core/measure/picture_verdict.h"
#include "viewer/app/test_command.h"
#include "viewer/app/viewer.h"
#include "viewer/commands/commands.h"

namespace aomd::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* fallback_picture = "aomd-view.png";

/// Of a program that ends with its pictures. What loading lets go of is of use to drawing as it is;
/// given back, the system would have to fill it with zeros again.
void keep_freed_memory() {
  constexpr int all = std::numeric_limits<int>::max();
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, all);
  mallopt(M_TRIM_THRESHOLD, all);
}

int compare(const Options& options, const io::Image& result) {
  const io::Image baseline = io::read_png(options.compare);
  const measure::PictureVerdict verdict = measure::judge_pictures(
      baseline, result, measure::PictureLimits::with_threshold(options.threshold));
  if (verdict.same) return exit_done;
  const fs::path picture = picture_for_comparison(options);
  if (options.screenshot.empty()) io::write_png(picture, result);
  const fs::path shown = picture_of_difference(options);
  io::write_png(shown, measure::difference_picture(baseline, result));
  std::cerr << "aomd-view: not as " << options.compare.string() << ": " << verdict.why
            << "; result " << picture.string() << ", difference " << shown.string() << "\n";
  return exit_no;
}

/// Carries out the script. An expectation that it misses is no reason to leave no picture: it is
/// returned. Throws all else that goes wrong.
std::exception_ptr missed_expectation(Viewer& viewer) {
  try {
    viewer.run_headless();
  } catch (const std::exception& error) {
    if (exit_code_of(error) != exit_no) throw;
    return std::current_exception();
  }
  return nullptr;
}

int run_headless(scene::Session& session, const Options& options, HeadlessKind kind) {
  const auto window = make_headless_window(kind, options.size);
  Viewer viewer(*window, session, options, true);
  const std::exception_ptr missed = missed_expectation(viewer);
  int code = exit_done;
  if (!options.screenshot.empty() || !options.compare.empty()) {
    const io::Image picture = viewer.picture(options.size, options.transparent);
    if (!options.screenshot.empty()) io::write_png(options.screenshot, picture);
    if (!options.compare.empty()) code = compare(options, picture);
  }
  if (missed) std::rethrow_exception(missed);
  return code;
}

/// The window, or nothing where there is no display.
std::unique_ptr<Window> window_or_none(const Options& options) {
  try {
    return make_window("AOMD Studio", options.size);
  } catch (const WindowError& error) {
    std::cerr << "aomd-view: " << error.what() << "; drawing without a window\n";
    return nullptr;
  }
}

int run(Options options) {
  // Loading starts before the context and its shaders are made: with two processors neither waits
  // for the other.
  if (options.headless) keep_freed_memory();
  scene::Session session;
  const bool alone = !options.headless && options.script.empty();
  if (const fs::path folder =
          options.recovery.value_or(alone ? scene::recovery_folder() : fs::path());
      !folder.empty())
    session.keep_work(folder);
  if (const std::string first = first_command(options); !first.empty())
    scene::execute(session, first);
  if (options.headless) return run_headless(session, options, *options.headless);
  if (const auto window = window_or_none(options)) {
    Viewer viewer(*window, session, options, false);
    viewer.run_window();
    return exit_done;
  }
  if (options.screenshot.empty()) options.screenshot = fallback_picture;
  const int code = run_headless(session, options, HeadlessKind::Auto);
  std::cout << "The picture is in " << fs::absolute(options.screenshot).string() << std::endl;
  return code;
}

}  // namespace
}  // namespace aomd::app

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string_view(argv[1]) == "test") {
      aomd::app::keep_freed_memory();
      return aomd::app::test_command(argc - 1, argv + 1);
    }
    const aomd::app::ParsedOptions parsed = aomd::app::parse_options(argc, argv);
    return parsed.options ? aomd::app::run(*parsed.options) : parsed.exit_code;
  } catch (const std::exception& error) {
    std::cerr << "aomd-view: " << error.what() << "\n";
    return aomd::app::exit_code_of(error);
  }
}
