#pragma once
// A screen that nobody sees, with a mouse and a keyboard that a test moves, and one window on it.
//
// Nothing waits for a time to pass: a window answers a ping of the window system once a frame, so
// that a few answers mean that everything sent before has been taken in and drawn.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "tests/support/child.h"

namespace aomd::test {

class XScreen {
 public:
  /// Starts Xvfb on a free display. Throws std::runtime_error with one sentence where that does not
  /// work.
  XScreen(glm::ivec2 size, const std::filesystem::path& log);
  ~XScreen();
  XScreen(const XScreen&) = delete;
  XScreen& operator=(const XScreen&) = delete;

  /// For DISPLAY: ":7".
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Looks for the window of a program that answers pings; true once there is one. It gets the
  /// keyboard.
  [[nodiscard]] bool find_window();
  [[nodiscard]] std::string title() const;
  /// Waits until the window has drawn that many frames after everything sent before; false when it
  /// does not answer within two minutes.
  [[nodiscard]] bool settle(int frames = 4);

  /// In pixels of the window, from its upper left corner.
  void move_mouse(glm::ivec2 to);
  /// 1 left, 2 middle, 3 right, 4 wheel up, 5 wheel down.
  void button(unsigned number, bool down);
  /// As the viewer names them: "Ctrl+Shift+P", "Escape", "Return", "S".
  void press(std::string_view chord);
  /// Characters of ASCII.
  void type(std::string_view text);

  /// Without asking a window manager: there is none.
  void resize(glm::ivec2 size);
  /// As the cross in a window's title does.
  void ask_to_close();
  /// Drags a file from another program to a place of the window and drops it. False when the window
  /// does not ask for it.
  [[nodiscard]] bool drop_file(const std::filesystem::path& file, glm::ivec2 to);

 private:
  struct Connection;  ///< keeps Xlib's names, many of them macros, out of here

  void key(unsigned long symbol, bool down);

  std::unique_ptr<Child> server_;
  std::string name_;
  std::unique_ptr<Connection> x_;
};

}  // namespace aomd::test
