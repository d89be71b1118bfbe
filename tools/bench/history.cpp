// aomd-history-bench MESH [OPERATIONS [COMMAND...]]: what moving through a history costs in the
// viewer. Makes OPERATIONS (100,000) operations, or as many as there are, carries out commands of
// the viewer ("clip x 0.5 cells"), and prints median, 99th percentile and maximum in ms: one
// operation back or forward with the scene brought up to date, its upload, what is said of the edge
// that the mouse points at, scrubbing to a random operation, and a frame of 1280x800, drawn by
// OSMesa where there is no other way. Without other work on the machine.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "viewer/app/window.h"
#include "viewer/commands/commands.h"
#include "viewer/render/picture_target.h"
#include "viewer/render/renderer.h"
#include "viewer/render/shader_sources.h"
#include "viewer/session/session.h"

namespace aomd {
namespace {

constexpr int samples = 100;

double milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

void print_row(const char* what, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double part) {
    return ms[static_cast<std::size_t>(part * static_cast<double>(ms.size() - 1))];
  };
  std::printf("| %-34s | %9.3f | %9.3f | %9.3f |\n", what, at(0.5), at(0.99), ms.back());
}

/// Everything that a window would have.
struct Stage {
  std::unique_ptr<app::Window> window =
      app::make_headless_window(app::HeadlessKind::Auto, {1280, 800});
  render::Gl gl = render::load_gl(window->get_proc_address());
  render::Renderer renderer{gl, render::load_shader_sources({})};
  render::DrawableBuffers buffers{gl};
  scene::Session session;

  void upload() {
    buffers.upload(session.sheet().drawing().drawable());
    gl.Finish();
  }
};

void carry_out(scene::Session& session, const std::string& line) {
  scene::execute(session, line);
  session.finish();
  session.refresh();
}

void measure_steps(Stage& stage) {
  scene::Document& document = stage.session.document();
  std::vector<double> moves, uploads;
  std::mt19937 random(1);
  for (int i = 0; i < samples; ++i) {
    document.seek(1 + random() % (document.journal().size() - 1));
    stage.session.refresh();
    stage.upload();
    for (const int way : {-1, 1}) {
      const std::size_t to = document.journal().cursor() + static_cast<std::size_t>(way);
      moves.push_back(milliseconds([&] {
        document.seek(to);
        stage.session.refresh();
      }));
      uploads.push_back(milliseconds([&] { stage.upload(); }));
    }
  }
  print_row("one operation, scene up to date", std::move(moves));
  print_row("its upload", std::move(uploads));
}

/// Over places all over the picture, where an edge lies.
void measure_hovering(Stage& stage) {
  std::vector<double> verdicts;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.9, 0.9);
  stage.session.view.pick_level = scene::PickLevel::Edge;
  scene::Sheet& sheet = stage.session.sheet();
  sheet.hover(glm::dvec2(0));  // what is made once for many
  for (int i = 0; i < 20 * samples && verdicts.size() < samples; ++i) {
    const glm::dvec2 at(place(random), place(random));
    const double ms = milliseconds([&] {
      sheet.hover(at);
      stage.session.refresh();
    });
    if (!sheet.inquiry().hovered_words().empty()) verdicts.push_back(ms);
  }
  if (!verdicts.empty()) print_row("the verdict on an edge pointed at", std::move(verdicts));
}

void measure_scrubbing(Stage& stage) {
  scene::Document& document = stage.session.document();
  std::vector<double> history, whole;
  std::mt19937 random(2);
  for (int i = 0; i < samples; ++i) {
    const std::size_t to = random() % (document.journal().size() + 1);
    const double moved = milliseconds([&] { document.seek(to); });
    history.push_back(moved);
    whole.push_back(moved + milliseconds([&] {
                      stage.session.refresh();
                      stage.upload();
                    }));
  }
  print_row("to any operation, mesh alone", std::move(history));
  print_row("to any operation, scene uploaded", std::move(whole));
}

void measure_frames(Stage& stage) {
  const render::PictureTarget target(stage.gl, {1280, 800});
  std::vector<double> frames;
  for (int i = 0; i < samples / 4; ++i) {
    stage.session.view.camera.orbit(3, 0);
    frames.push_back(milliseconds([&] {
      stage.renderer.render(stage.buffers, stage.session.view.camera, {}, {0, 0, 1280, 800},
                            target.framebuffer());
      stage.gl.Finish();
    }));
  }
  print_row("a frame of 1280x800", std::move(frames));
}

void measure_history(const std::string& file, const std::string& operations,
                     std::span<char* const> commands) {
  Stage stage;
  carry_out(stage.session, "open " + file);
  carry_out(stage.session, "step " + operations);
  for (const char* line : commands) carry_out(stage.session, line);
  const Journal& journal = stage.session.document().journal();
  if (journal.size() < 2) throw std::runtime_error(file + ": nothing to decimate");
  std::printf("%s: %zu operations, history %.0f MB\n\n", file.c_str(), journal.size(),
              1e-6 * static_cast<double>(journal.bytes()));
  std::printf("| ms                                 |    median |       p99 |       max |\n");
  std::printf("|------------------------------------|-----------|-----------|-----------|\n");
  stage.upload();
  measure_steps(stage);
  measure_hovering(stage);
  measure_scrubbing(stage);
  measure_frames(stage);
}

}  // namespace
}  // namespace aomd

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: aomd-history-bench MESH [OPERATIONS [COMMAND...]]\n");
    return 2;
  }
  try {
    aomd::measure_history(
        argv[1], argc > 2 ? argv[2] : "100000",
        std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 3 ? 3 : argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aomd-history-bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
