// The window on the screen, by GLFW 3.3. GLFW's handles stay in this file.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <deque>
#include <optional>
#include <utility>

#include <glm/common.hpp>

#include "viewer/app/imgui_keys.h"
#include "viewer/app/window.h"

namespace aomd::app {
namespace {

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

int held_modifiers(GLFWwindow* window) {
  const auto either = [&](int left, int right, int bit) {
    const bool down =
        glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
    return down ? bit : 0;
  };
  return either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
         either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
         either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT) |
         either(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER, GLFW_MOD_SUPER);
}

/// GLFW, initialised while this lives.
struct GlfwLibrary {
  GlfwLibrary() {
    glfwInitHint(GLFW_COCOA_CHDIR_RESOURCES, GLFW_FALSE);
    if (glfwInit() == GLFW_FALSE) throw WindowError("cannot open a window: " + last_glfw_error());
  }
  ~GlfwLibrary() { glfwTerminate(); }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

class GlfwWindow : public Window {
 public:
  GlfwWindow(const std::string& title, glm::ivec2 size);
  ~GlfwWindow() override;
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  [[nodiscard]] glm::ivec2 size() const override;
  [[nodiscard]] glm::ivec2 framebuffer_size() const override;
  [[nodiscard]] float content_scale() const override;
  [[nodiscard]] render::GetProcAddress get_proc_address() const override {
    return &glfwGetProcAddress;
  }
  [[nodiscard]] std::string_view kind() const override { return "GLFW"; }
  Events poll(ImGuiIO& io, double wait_s) override;
  void present() override { glfwSwapBuffers(window_); }
  [[nodiscard]] bool should_close() const override {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
  }
  void cancel_close() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
  void set_title(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
  [[nodiscard]] std::optional<ui::WindowPlace> place() const override;
  void move_to(const ui::WindowPlace& place) override;

 private:
  /// A change of a key or a mouse button, and where the mouse was, kept until poll() may tell
  /// ImGui.
  struct Switch {
    int code = 0;
    bool down = false;
    ImVec2 place{0, 0};
  };

  void connect_callbacks();
  void connect_imgui(ImGuiIO& io);
  void send_frame(ImGuiIO& io);
  void send_mouse(ImGuiIO& io);
  void send_keyboard(ImGuiIO& io);
  void update_cursor(const ImGuiIO& io);
  void on_key(int key, int scancode, int action);
  void remember_place();

  GlfwLibrary library_;
  GLFWwindow* window_ = nullptr;
  std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors_{};
  Events events_;
  std::deque<Switch> keys_;
  std::deque<Switch> buttons_;
  std::vector<unsigned> text_;
  glm::vec2 wheel_{0};
  ImVec2 mouse_{-FLT_MAX, -FLT_MAX};  ///< where it was last seen
  double last_time_ = 0;
  bool connected_ = false;
  ui::WindowPlace place_;  ///< the last one while it was not maximised
};

GlfwWindow& self(GLFWwindow* window) {
  return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

GlfwWindow::GlfwWindow(const std::string& title, glm::ivec2 size) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr)
    throw WindowError("cannot open a window with OpenGL 3.3: " + last_glfw_error());
  glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  connect_callbacks();
}

GlfwWindow::~GlfwWindow() {
  for (GLFWcursor* cursor : cursors_)
    if (cursor != nullptr) glfwDestroyCursor(cursor);
  glfwDestroyWindow(window_);
}

glm::ivec2 GlfwWindow::size() const {
  glm::ivec2 size{0};
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 GlfwWindow::framebuffer_size() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float GlfwWindow::content_scale() const {
  // Where the system already counts in scaled units (macOS, Wayland) the framebuffer is larger than
  // the window.
  float scale = 1;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  const int width = size().x;
  const float pixels_per_unit =
      width > 0 ? static_cast<float>(framebuffer_size().x) / static_cast<float>(width) : 1.0f;
  return std::clamp(scale / std::max(pixels_per_unit, 1.0f), 1.0f, 4.0f);
}

/// Whether enough of a window would show to get hold of it.
bool on_a_screen(const ui::WindowPlace& place) {
  constexpr int enough = 64;
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    glm::ivec2 at{0}, size{0};
    glfwGetMonitorWorkarea(monitors[i], &at.x, &at.y, &size.x, &size.y);
    const glm::ivec2 from = glm::max(at, place.position);
    const glm::ivec2 to = glm::min(at + size, place.position + place.size);
    if (to.x - from.x >= enough && to.y - from.y >= enough && place.position.y >= at.y - enough / 4)
      return true;
  }
  return false;
}

void GlfwWindow::remember_place() {
  if (glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE ||
      glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE)
    return;
  glfwGetWindowPos(window_, &place_.position.x, &place_.position.y);
  place_.size = size();
}

std::optional<ui::WindowPlace> GlfwWindow::place() const {
  ui::WindowPlace place = place_;
  place.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
  if (place.size.x < 1) return {};
  return place;
}

void GlfwWindow::move_to(const ui::WindowPlace& place) {
  if (!on_a_screen(place)) return;
  glfwSetWindowSize(window_, place.size.x, place.size.y);
  glfwSetWindowPos(window_, place.position.x, place.position.y);
  if (place.maximized) glfwMaximizeWindow(window_);
}

Events GlfwWindow::poll(ImGuiIO& io, double wait_s) {
  if (!connected_) connect_imgui(io);
  // What waits for a frame of its own is a reason not to sleep.
  const bool idle = keys_.empty() && buttons_.empty();
  if (wait_s > 0 && idle)
    glfwWaitEventsTimeout(wait_s);
  else
    glfwPollEvents();
  send_frame(io);
  send_mouse(io);
  send_keyboard(io);
  update_cursor(io);
  remember_place();
  return std::exchange(events_, {});
}

void GlfwWindow::connect_callbacks() {
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) self(w).events_.dropped_files.emplace_back(paths[i]);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    self(w).events_.input = true;
    self(w).wheel_ += glm::vec2(x, y);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned c) {
    self(w).events_.input = true;
    self(w).text_.push_back(c);
  });
  // glfwGetCursorPos() asks where the mouse is now, which may be far from where a button went down.
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    self(w).events_.input = true;
    self(w).mouse_ = ImVec2(static_cast<float>(x), static_cast<float>(y));
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w).events_.input = true; });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
    self(w).on_key(key, scancode, action);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    self(w).events_.input = true;
    if (button < 5) self(w).buttons_.push_back({button, action == GLFW_PRESS, self(w).mouse_});
  });
}

void GlfwWindow::on_key(int key, int scancode, int action) {
  events_.input = true;
  if (action != GLFW_RELEASE) {
    std::string chord = chord_name(key, glfwGetKeyName(key, scancode), held_modifiers(window_));
    if (!chord.empty()) events_.chords.push_back(std::move(chord));
  }
  // Each waits for a frame of its own: where frames are slow, Enter must not queue behind typed
  // letters.
  if (action != GLFW_REPEAT && is_imgui_key(key)) keys_.push_back({key, action == GLFW_PRESS, {}});
}

void GlfwWindow::connect_imgui(ImGuiIO& io) {
  connected_ = true;
  last_time_ = glfwGetTime();
  io.BackendPlatformName = "aomd_glfw";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  prepare_keys(io);
#if IMGUI_VERSION_NUM >= 19110
  ImGuiPlatformIO& platform = ImGui::GetPlatformIO();
  platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
    return glfwGetClipboardString(nullptr);
  };
  platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
    glfwSetClipboardString(nullptr, text);
  };
#else
  io.GetClipboardTextFn = [](void*) { return glfwGetClipboardString(nullptr); };
  io.SetClipboardTextFn = [](void*, const char* text) { glfwSetClipboardString(nullptr, text); };
#endif
  cursors_[ImGuiMouseCursor_Arrow] = glfwCreateStandardCursor(GLFW_ARROW_CURSOR);
  cursors_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
  cursors_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
}

void GlfwWindow::send_frame(ImGuiIO& io) {
  const glm::vec2 window_size(size());
  const glm::vec2 pixels(framebuffer_size());
  io.DisplaySize = ImVec2(window_size.x, window_size.y);
  if (window_size.x > 0 && window_size.y > 0)
    io.DisplayFramebufferScale = ImVec2(pixels.x / window_size.x, pixels.y / window_size.y);
  const double now = glfwGetTime();
  io.DeltaTime = static_cast<float>(std::clamp(now - last_time_, 1e-5, 0.25));
  last_time_ = now;
}

void GlfwWindow::send_mouse(ImGuiIO& io) {
  const bool here = glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE ||
                    glfwGetWindowAttrib(window_, GLFW_HOVERED) == GLFW_TRUE;
  const ImVec2 place = here ? mouse_ : ImVec2(-FLT_MAX, -FLT_MAX);
  const glm::vec2 wheel = std::exchange(wheel_, glm::vec2(0));
#if IMGUI_VERSION_NUM >= 18700
  for (const Switch& button : buttons_) {
    io.AddMousePosEvent(button.place.x, button.place.y);
    io.AddMouseButtonEvent(button.code, button.down);
  }
  buttons_.clear();
  io.AddMousePosEvent(place.x, place.y);
  io.AddMouseWheelEvent(wheel.x, wheel.y);
#else
  io.MousePos = place;
  io.MouseWheelH += wheel.x;
  io.MouseWheel += wheel.y;
  // One change of a button a frame, and where it happened: where frames are slow a short click
  // would be lost, or hit what the mouse has come to since.
  if (buttons_.empty()) return;
  io.MousePos = buttons_.front().place;
  io.MouseDown[buttons_.front().code] = buttons_.front().down;
  buttons_.pop_front();
#endif
}

void GlfwWindow::send_keyboard(ImGuiIO& io) {
  send_modifiers(io, held_modifiers(window_));
#if IMGUI_VERSION_NUM >= 18700
  for (const Switch& key : keys_) send_key(io, key.code, key.down);
  keys_.clear();
#else
  // One change of a key a frame, for the same reason as with buttons.
  std::vector<int> changed;
  while (!keys_.empty() &&
         std::find(changed.begin(), changed.end(), keys_.front().code) == changed.end()) {
    changed.push_back(keys_.front().code);
    send_key(io, keys_.front().code, keys_.front().down);
    keys_.pop_front();
  }
#endif
  for (const unsigned c : text_) io.AddInputCharacter(c);
  text_.clear();
}

void GlfwWindow::update_cursor(const ImGuiIO& io) {
  if ((io.ConfigFlags & ImGuiConfigFlags_NoMouseCursorChange) != 0) return;
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == ImGuiMouseCursor_None) return;
  GLFWcursor* cursor = cursors_[static_cast<std::size_t>(wanted)];
  glfwSetCursor(window_, cursor != nullptr ? cursor : cursors_[ImGuiMouseCursor_Arrow]);
}

}  // namespace

std::unique_ptr<Window> make_window(const std::string& title, glm::ivec2 size) {
  return std::make_unique<GlfwWindow>(title, size);
}

}  // namespace aomd::app
