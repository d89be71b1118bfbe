#include "viewer/app/case_runner.h"

#include <algorithm>
#include <chrono>

#include "core/base/text.h"
#include "core/io/png.h"
#include "core/measure/image_diff.h"
#include "viewer/app/viewer.h"
#include "viewer/commands/commands.h"

namespace aomd::app {
namespace {

namespace fs = std::filesystem;
using suite::Case;
using suite::CaseResult;
using suite::Outcome;

Options options_of(const Case& each) {
  Options options;
  options.file = each.mesh;
  options.model = each.model;
  options.script = each.script;
  options.commands = each.commands;
  options.commands_place = "commands";
  options.size = each.size;
  options.camera = each.camera;
  options.theme = each.dark ? scene::Theme::Dark : scene::Theme::Light;
  options.scale = each.scale;
  options.interface = each.panels;
  return options;
}

CaseResult broken(int code, const std::string& why) {
  CaseResult result;
  result.exit_code = code;
  result.why = printable(why);
  return result;
}

/// A wrong command is a fault of the suite's input, not of how the program was called.
int exit_code_of_case(const std::exception& error) {
  const int code = exit_code_of(error);
  return code == exit_usage ? exit_unreadable : code;
}

/// Carries out what a case says. Returns the expectation that does not hold, or nothing.
std::string carry_out(Viewer& viewer, scene::Session& session, const Case& each) {
  try {
    viewer.run_headless();
    for (const std::string& line : each.expect) scene::execute(session, "expect " + line);
  } catch (const std::exception& error) {
    if (exit_code_of(error) != exit_no) throw;
    return printable(error.what());
  }
  return {};
}

}  // namespace

/// What a case led to; `missed` is the expectation that does not hold.
struct CaseRunner::Drawn {
  io::Image picture;
  measure::PixelArea scene;
  std::string missed;
};

CaseResult CaseRunner::run(const Case& each) {
  const auto start = std::chrono::steady_clock::now();
  CaseResult result;
  try {
    result = each.problem.empty() ? draw_and_judge(each) : broken(exit_unreadable, each.problem);
  } catch (const std::exception& error) {
    result = broken(exit_code_of_case(error), error.what());
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void CaseRunner::provide_window(glm::ivec2 size) {
  if (window_ && window_->size() == size) return;
  graphics_.reset();
  window_.reset();
  window_ = make_headless_window(HeadlessKind::Auto, size);
  graphics_ = std::make_shared<Graphics>(*window_, fs::path());
}

CaseResult CaseRunner::draw_and_judge(const Case& each) {
  std::error_code error;
  fs::current_path(each.folder, error);
  if (error) throw io::ReadError(each.folder.string(), {}, error.message());
  const Options options = options_of(each);
  scene::Session session;
  session.spare = &spare_;
  if (const std::string first = first_command(options); !first.empty())
    scene::execute(session, first);
  provide_window(options.size);
  Viewer viewer(*window_, session, options, true, graphics_);
  Drawn drawn;
  drawn.missed = carry_out(viewer, session, each);
  drawn.picture = viewer.picture(options.size, each.transparent);
  drawn.scene = viewer.scene_area(options.size);
  spare_.keep(session.document().take_untouched());
  CaseResult result;
  if (update_ && drawn.missed.empty())
    make_baseline(each, drawn, result);
  else
    compare(each, drawn, result);
  return result;
}

void CaseRunner::compare(const Case& each, const Drawn& drawn, CaseResult& result) const {
  const fs::path file = suite_.baseline_of(each);
  const bool there = fs::exists(file);
  io::Image baseline;
  if (there) {
    baseline = io::read_png(file);
    result.judged = judge(each, baseline, drawn.picture, drawn.scene);
    result.why = why_differs(result.judged);
    result.outcome = result.why.empty() ? Outcome::Same : Outcome::Differs;
    result.exit_code = result.why.empty() ? exit_done : exit_no;
  } else {
    result.outcome = Outcome::Missing;
    result.exit_code = exit_unreadable;
    result.why = "there is no baseline; look at the picture that this makes: aomd-view test " +
                 printable(suite_.file.string()) + " --update " + each.name;
  }
  if (!drawn.missed.empty()) {
    result.outcome = Outcome::Missed;
    result.exit_code = std::max(result.exit_code, int{exit_no});
    result.why = drawn.missed + (result.why.empty() ? "" : "; ") + result.why;
  }
  keep_pictures(each, drawn, there ? &baseline : nullptr, result);
}

void CaseRunner::make_baseline(const Case& each, const Drawn& drawn, CaseResult& result) const {
  const fs::path file = suite_.baseline_of(each);
  result.outcome = fs::exists(file) ? Outcome::Updated : Outcome::New;
  if (result.outcome == Outcome::Updated) {
    try {
      if (io::read_png(file) == drawn.picture) result.outcome = Outcome::Same;
    } catch (const io::FileError&) {
      // What cannot be read is made anew.
    }
  }
  if (result.outcome == Outcome::Same) return;
  std::error_code error;
  fs::create_directories(suite_.baselines, error);
  if (error) throw io::WriteError(suite_.baselines.string(), {}, error.message());
  io::write_png(file, drawn.picture);
}

/// Where all is well, a picture that is its baseline pixel by pixel need not be kept.
void CaseRunner::keep_pictures(const Case& each, const Drawn& drawn, const io::Image* baseline,
                               CaseResult& result) const {
  if (result.well() && *baseline == drawn.picture) return;
  result.picture = work_ / (each.name + ".png");
  io::write_png(result.picture, drawn.picture);
  if (baseline == nullptr) return;
  result.difference = work_ / (each.name + ".diff.png");
  io::write_png(result.difference, measure::difference_picture(*baseline, drawn.picture));
}

}  // namespace aomd::app
