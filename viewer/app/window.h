#pragma once
// What the program needs from a window, or from the lack of one.

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/render/gl.h"
#include "viewer/ui/settings.h"

struct ImGuiIO;

namespace aomd::app {

/// There is no display, no context, or no library for it; what() is one line.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What happened since the last poll, beyond what ImGui was told.
struct Events {
  std::vector<std::filesystem::path> dropped_files;
  /// Keys pressed or repeated, as chords: "Ctrl+Shift+Z", "F", "Space", "Left", "F1", "Delete",
  /// "+". Letters are those of the user's keyboard layout, upper case. Before ImGui had its say:
  /// look at ImGuiIO::WantCaptureKeyboard. The names are in imgui_keys.h.
  std::vector<std::string> chords;
  bool input = false;  ///< of whatever kind: the picture may change
};

/// A current OpenGL 3.3 core context with a framebuffer 0, and where its input comes from. One
/// thread only.
class Window {
 public:
  virtual ~Window() = default;

  /// In the unit of mouse positions. ImGui's display size.
  [[nodiscard]] virtual glm::ivec2 size() const = 0;
  /// In pixels; 0 x 0 while minimised.
  [[nodiscard]] virtual glm::ivec2 framebuffer_size() const = 0;
  /// How much larger than at 96 dpi things are to be drawn, relative to size().
  [[nodiscard]] virtual float content_scale() const = 0;
  [[nodiscard]] virtual render::GetProcAddress get_proc_address() const = 0;
  /// "GLFW", "OSMesa" or "EGL".
  [[nodiscard]] virtual std::string_view kind() const = 0;

  /// Tells ImGui what happened: display size, time step, mouse, keys, text. Waits up to `wait_s`
  /// seconds for the first event. Without a window nothing ever happens, and each step takes 1/60
  /// s.
  virtual Events poll(ImGuiIO& io, double wait_s = 0) = 0;
  /// Shows what was drawn.
  virtual void present() = 0;
  /// The user asked to close, and nobody took it back with cancel_close().
  [[nodiscard]] virtual bool should_close() const = 0;
  virtual void cancel_close() = 0;
  virtual void set_title(const std::string& title) = 0;
  /// Where it stands; none without a window.
  [[nodiscard]] virtual std::optional<ui::WindowPlace> place() const { return {}; }
  /// Moves it there, as far as a screen is still there to show it.
  virtual void move_to(const ui::WindowPlace&) {}
};

/// A window on the screen. Throws WindowError where there is no display or no OpenGL 3.3.
[[nodiscard]] std::unique_ptr<Window> make_window(const std::string& title, glm::ivec2 size);

enum class HeadlessKind { Auto, OsMesa, Egl };

/// A context without a window whose framebuffer 0 is `size` pixels large (1..16384 each way). Auto
/// takes the first that works, OSMesa then EGL; kind() says which. Never touches GLFW. Throws
/// WindowError with every reason.
[[nodiscard]] std::unique_ptr<Window> make_headless_window(HeadlessKind kind, glm::ivec2 size);

}  // namespace aomd::app
