#pragma once
// The viewer: a session, an interface and a renderer in a window, or without one.

#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/picture_verdict.h"
#include "viewer/app/graphics.h"
#include "viewer/app/options.h"
#include "viewer/app/window.h"
#include "viewer/commands/script.h"
#include "viewer/session/session.h"
#include "viewer/ui/imgui_layer.h"
#include "viewer/ui/interface.h"

struct ImGuiContext;

namespace aomd::app {

/// The command that the program starts with: what opens FILE or the first sample; empty where a
/// script decides.
[[nodiscard]] std::string first_command(const Options& options);

/// Window and headless share everything but how the loop waits.
class Viewer {
 public:
  /// Shows `session`, which must outlive it, and may be loading already. Without `graphics` of the
  /// window's context it makes its own. Throws render::GlError, io::ReadError (a script).
  Viewer(Window& window, scene::Session& session, const Options& options, bool headless,
         std::shared_ptr<Graphics> graphics = nullptr);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Until the user or the script quits.
  void run_window();
  /// Loads, carries out the script, and returns. Throws what went wrong.
  void run_headless();
  /// Everything as a picture of `size` pixels; without a background where asked.
  [[nodiscard]] io::Image picture(glm::ivec2 size, bool transparent = false, double scale = 1);
  /// The scene alone, whatever panels there are. What they show goes on as it was.
  [[nodiscard]] io::Image scene_picture(glm::ivec2 size, bool transparent = false,
                                        double scale = 1);
  /// Where the scene stands in a picture of so many pixels, with the panels as they were last.
  [[nodiscard]] measure::PixelArea scene_area(glm::ivec2 pixels) const;

 private:
  struct ImGuiScope {
    ImGuiScope();
    ~ImGuiScope();
    ImGuiContext* context;
  };

  [[nodiscard]] bool remembers() const;
  void restore_settings();
  void save_settings();
  void connect_clipboard();
  void begin_record();
  void ask_to_close();
  void execute(const std::string& line);
  void clear_for_picture(std::string_view line);
  void execute_or_tell(const std::string& line);
  void tick(double frame_s);
  void take_model(const std::string& line);
  void after_loading();
  void finish();
  void advance_script();
  void take_events(const Events& events);
  void take_screenshots();
  void tell_warnings();
  void print_log();
  [[nodiscard]] float drawing_scale() const;
  void choose_detail();
  void update_look();
  void update_aspect();
  [[nodiscard]] double farther(double before, double now) const;
  /// The panels of the next frame, not drawn yet: a picture lets them settle first, which costs no
  /// drawing.
  void lay_out_frame();
  void draw_frame(glm::ivec2 pixels, GLuint destination, bool transparent = false);
  void draw_scene(const scene::Camera& camera, const render::PixelRect& rect, GLuint destination,
                  bool transparent);
  void draw_scales(glm::ivec2 size, GLuint destination);
  [[nodiscard]] scene::Camera camera_for(double before, double now) const;
  void take_screenshots_or_tell();
  [[nodiscard]] render::RenderSettings settings(bool transparent) const;

  Window& window_;
  scene::Session& session_;
  Options options_;
  bool headless_;
  ImGuiScope imgui_;
  std::shared_ptr<Graphics> graphics_;
  const render::Gl& gl_;
  ui::Fonts fonts_;
  ui::ImGuiLayer layer_;
  render::DrawableBuffers buffers_;
  render::DrawableBuffers original_buffers_;  ///< filled where the mesh as loaded is shown
  ui::Interface interface_;
  scene::Script script_;
  std::ofstream record_;
  std::vector<std::string> lines_;  ///< what the interface emitted in the last frame
  float scale_ = 0;                 ///< what fonts and theme were made for
  double picture_scale_ = 1;        ///< how much larger a picture is drawn than the window
  scene::Theme theme_ = scene::Theme::Light;
  float em_ = 16;
  bool shown_any_ = false;  ///< a mesh has arrived already
  bool in_script_ = false;
  std::chrono::microseconds drawing_time_{0};  ///< of the last frame in the window
  std::chrono::microseconds full_time_{0};     ///< of the last with all faces
  scene::Camera drawn_from_;
  std::chrono::steady_clock::time_point moved_at_{};
  bool moving_ = false;  ///< fewer faces are drawn, because the camera moves
};

}  // namespace aomd::app
