#include "tests/support/viewer_window.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "core/io/png.h"
#include "core/measure/image_diff.h"
#include "core/samples/samples.h"
#include "tests/support/places.h"
#include "viewer/commands/commands.h"

namespace aomd::test {
namespace {

namespace fs = std::filesystem;

/// Only full lines: the last one may be half written.
std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::string text = bytes_of(file);
  for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
    lines.push_back(text.substr(0, end));
  return lines;
}

void unavailable(const std::string& why) {
  const std::string sentence = "No real window is tested: " + why + ".";
  if (std::getenv("AOMD_REQUIRE_WINDOW") != nullptr) FAIL() << sentence;
  GTEST_SKIP() << sentence;
}

}  // namespace

void ViewerWindow::SetUp() {
  try {
    screen_ = std::make_unique<XScreen>(glm::ivec2(1400, 900), folder_ / "screen.txt");
  } catch (const std::runtime_error& error) {
    unavailable(error.what());
  }
}

std::vector<std::string> ViewerWindow::environment() const {
  const std::string home = (folder_ / "home").string();
  return {"DISPLAY=" + screen_->name(),
          "HOME=" + home,
          "XDG_CONFIG_HOME=" + home + "/config",
          "XDG_STATE_HOME=" + home + "/state",
          "LIBGL_ALWAYS_SOFTWARE=1",
          "WAYLAND_DISPLAY="};
}

void ViewerWindow::start(const std::vector<std::string>& arguments) {
  fs::create_directories(folder_ / "home");
  fs::remove(folder_ / "record.aomd");
  std::vector<std::string> words = {
      AOMD_VIEW, "--record", (folder_ / "record.aomd").string(), "--size",
      std::to_string(usual_size.x) + "x" + std::to_string(usual_size.y)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  program_ = std::make_unique<Child>(words, environment(), folder_ / "said.txt");
  if (!waits_for([&] { return screen_->find_window(); })) {
    if (said().find("drawing without a window") != std::string::npos)
      return unavailable("there is no OpenGL 3.3 under Xvfb");
    FAIL() << "no window" << said();
  }
  ASSERT_TRUE(waits_for([&] { return screen_->title() != "AOMD Studio"; }))
      << "nothing opened" << said();
  settle();
}

std::string ViewerWindow::mesh_file(const std::string& sample, int size, const char* name) const {
  const fs::path file = folder_ / name;
  io::write(file, make_sample(sample, size));
  return file.string();
}

bool ViewerWindow::waits_for(const std::function<bool()>& condition) {
  return program_->waits_for(condition);
}

std::vector<std::string> ViewerWindow::recorded() const {
  return lines_of(folder_ / "record.aomd");
}

bool ViewerWindow::carries_out(const std::string& line, int count) {
  return waits_for([&] {
    const std::vector<std::string> lines = recorded();
    return std::count(lines.begin(), lines.end(), line) >= count;
  });
}

bool ViewerWindow::ends(int code) {
  return waits_for([&] { return !program_->running(); }) && program_->result() == code;
}

bool ViewerWindow::keeps_work() const {
  std::error_code none;
  fs::directory_iterator it(folder_ / "home/state/aomd", none);
  for (; !none && it != fs::directory_iterator(); it.increment(none))
    if (it->path().extension() == ".json") return true;
  return false;
}

std::string ViewerWindow::said() const {
  std::string text = "\nIt said: " + bytes_of(folder_ / "said.txt") + "\nIt carried out:";
  for (const std::string& line : recorded()) text += "\n  " + line;
  return text;
}

void ViewerWindow::press(std::string_view chord) {
  screen_->press(chord);
  settle();
}

void ViewerWindow::press_at(glm::ivec2 at) {
  screen_->move_mouse(at);
  settle();
  screen_->button(1, true);
  settle();
}

void ViewerWindow::click(glm::ivec2 at) {
  press_at(at);
  screen_->button(1, false);
  settle();
}

void ViewerWindow::drag(glm::ivec2 from, glm::ivec2 to, unsigned button) {
  screen_->move_mouse(from);
  settle();
  screen_->button(button, true);
  settle();
  for (int i = 1; i <= 4; ++i) {
    screen_->move_mouse(from + (to - from) * i / 4);
    ASSERT_TRUE(screen_->settle(2));
  }
  screen_->button(button, false);
  settle();
}

void ViewerWindow::command(const std::string& line) {
  const auto before = recorded();
  const int count = static_cast<int>(std::count(before.begin(), before.end(), line)) + 1;
  const int closed = static_cast<int>(std::count(before.begin(), before.end(), "dialog none")) + 1;
  press("Ctrl+Shift+P");
  screen_->type(line);
  settle();
  press("Return");
  ASSERT_TRUE(carries_out(line, count)) << "not carried out: " << line << said();
  ASSERT_TRUE(carries_out("dialog none", closed)) << said();
  settle();
}

void ViewerWindow::replay(scene::Session& session) const {
  for (const std::string& line : recorded()) {
    scene::execute(session, line);
    session.finish();
  }
}

glm::ivec2 ViewerWindow::place_of(const std::string& line, glm::ivec2 size,
                                  const std::string& asked) const {
  scene::Session session;
  if (keeps_work()) session.keep_work(folder_ / "home/state/aomd");
  replay(session);
  if (!scene::asks_first(session, asked)) scene::execute(session, asked);
  const std::optional<glm::ivec2> place = test::place_of(
      session, size, line, {{0, 0}, {static_cast<float>(size.x), static_cast<float>(size.y)}});
  if (!place) throw std::runtime_error("no click emits " + line);
  return *place;
}

ui::Layout ViewerWindow::layout(glm::ivec2 size) const {
  scene::Session session;
  replay(session);
  return layout_of(session, size);
}

void ViewerWindow::expect_headless_picture(glm::ivec2 size) {
  const std::string number = std::to_string(++pictures_);
  const std::string mine = (folder_ / ("window" + number + ".png").c_str()).string();
  const std::string other = (folder_ / ("headless" + number + ".png").c_str()).string();
  screen_->move_mouse({3, size.y - 3});  // what the mouse points at is not in the script
  settle();
  press("Ctrl+P");
  ASSERT_TRUE(carries_out("dialog screenshot", pictures_)) << said();
  settle();
  screen_->type(mine);
  settle();
  press("Return");
  ASSERT_TRUE(carries_out("screenshot \"" + mine + "\"")) << said();
  ASSERT_TRUE(waits_for([&] { return fs::exists(mine); })) << said();

  std::ofstream script(folder_ / "replay.aomd");
  for (std::string line : recorded())
    script << (line == "screenshot \"" + mine + "\"" ? "screenshot \"" + other + "\"" : line)
           << '\n';
  script.close();
  Child replayer({AOMD_VIEW, "--headless", "--script", (folder_ / "replay.aomd").string(), "--size",
                  std::to_string(size.x) + "x" + std::to_string(size.y)},
                 environment(), folder_ / "said.txt");
  ASSERT_TRUE(replayer.waits_for([&] { return !replayer.running(); }));
  ASSERT_EQ(replayer.result(), 0) << said();

  const io::Image a = io::read_png(mine), b = io::read_png(other);
  const measure::ImageDifference difference = measure::compare_images(b, a);
  RecordProperty("ssim", std::to_string(difference.ssim));
  if (difference.same_size && difference.ssim >= 0.995) return;
  const fs::path kept =
      fs::path(AOMD_PICTURES) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::create_directories(kept);
  io::write_png(kept / ("window" + number + ".png"), a);
  io::write_png(kept / ("headless" + number + ".png"), b);
  if (difference.same_size)
    io::write_png(kept / ("diff" + number + ".png"), measure::difference_picture(b, a));
  ADD_FAILURE()
      << "the window's picture is not that of the same lines without a window: similarity "
      << difference.ssim << ", pictures in " << kept << said();
}

}  // namespace aomd::test
