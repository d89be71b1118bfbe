#pragma once
// aomd-view in a window on a screen of its own, driven as a person drives it.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/io_helpers.h"
#include "tests/support/x_screen.h"
#include "viewer/session/session.h"
#include "viewer/ui/layout.h"

namespace aomd::test {

/// Each test has a screen, a folder that is the user's home, and programs that it starts. Skips
/// where there is no Xvfb or no OpenGL on it, and fails there where AOMD_REQUIRE_WINDOW is set.
class ViewerWindow : public testing::Test {
 protected:
  static constexpr glm::ivec2 usual_size{1000, 700};

  void SetUp() override;

  /// Starts the program and waits for its window and for what it opens.
  void start(const std::vector<std::string>& arguments);
  /// Writes a sample into the folder.
  [[nodiscard]] std::string mesh_file(const std::string& sample, int size, const char* name) const;

  /// Whether a condition comes true while the program runs, within two minutes.
  [[nodiscard]] bool waits_for(const std::function<bool()>& condition);
  /// Whether the program carries out a line as its `count`th of that text: see --record.
  [[nodiscard]] bool carries_out(const std::string& line, int count = 1);
  [[nodiscard]] std::vector<std::string> recorded() const;
  [[nodiscard]] bool ends(int code);
  /// Whether unsaved work lies in the user's folder.
  [[nodiscard]] bool keeps_work() const;

  void settle() { ASSERT_TRUE(screen_->settle()) << "the window does not answer" << said(); }
  void press(std::string_view chord);
  void press_at(glm::ivec2 at);
  void click(glm::ivec2 at);
  void drag(glm::ivec2 from, glm::ivec2 to, unsigned button = 1);
  /// Through the palette: opens it, types the line, Enter, and waits until it has been carried out.
  void command(const std::string& line);
  /// Where a click emits `line`, in a window that shows what the recorded lines and then `asked`,
  /// as a person asks for it, lead to. Throws std::runtime_error where there is no such place.
  [[nodiscard]] glm::ivec2 place_of(const std::string& line, glm::ivec2 size = usual_size,
                                    const std::string& asked = {}) const;
  [[nodiscard]] ui::Layout layout(glm::ivec2 size = usual_size) const;

  /// Has the window write a picture through its dialog, and compares it with that of the recorded
  /// lines without a window.
  void expect_headless_picture(glm::ivec2 size = usual_size);

  /// Everything that the program has printed, for messages.
  [[nodiscard]] std::string said() const;

  TemporaryFolder folder_;
  std::unique_ptr<XScreen> screen_;
  std::unique_ptr<Child> program_;

 private:
  void replay(scene::Session& session) const;
  [[nodiscard]] std::vector<std::string> environment() const;
  int pictures_ = 0;
};

}  // namespace aomd::test
