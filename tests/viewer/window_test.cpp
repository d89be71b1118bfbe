// The viewer in a real window under the mouse and the keyboard: what is done there is what the
// recorded commands do without one.

#include <algorithm>
#include <csignal>

#include "tests/support/viewer_window.h"

namespace aomd::test::window_test {
namespace {

/// The middle of what is left for the scene.
glm::ivec2 middle(const ui::Area& area) {
  return {static_cast<int>(area.position.x + 0.5f * area.size.x),
          static_cast<int>(area.position.y + 0.5f * area.size.y)};
}

TEST_F(ViewerWindow, OpensATypedPathSweepsByAClickAndUndoes) {
  start({mesh_file("cylinder", 8, "first.ply")});
  const std::string second = mesh_file("bracket", 5, "second.ply");
  press("Ctrl+O");
  ASSERT_TRUE(carries_out("dialog open")) << said();
  settle();
  screen_->type(second);
  press("Return");
  ASSERT_TRUE(carries_out("open \"" + second + "\"")) << said();
  ASSERT_TRUE(waits_for([&] { return screen_->title().starts_with("second.ply"); }))
      << screen_->title();
  click(place_of("sweep"));
  ASSERT_TRUE(carries_out("sweep")) << said();
  command("expect commands = 1");
  expect_headless_picture();
  press("Ctrl+Z");
  ASSERT_TRUE(carries_out("undo")) << said();
  command("expect cursor = 0");
}

TEST_F(ViewerWindow, AClickHitsWhereItWasMadeHoweverFastTheMouseGoesOn) {
  start({mesh_file("cylinder", 8, "first.ply")});
  screen_->move_mouse(place_of("sweep"));
  settle();
  for (const bool down : {true, false}) screen_->button(1, down);
  screen_->move_mouse(middle(layout().viewport));
  ASSERT_TRUE(carries_out("sweep")) << said();
  command("expect selected = 0");
}

TEST_F(ViewerWindow, TheScrubberEndsWhereTheMouseIsLetGoHoweverFastThatIs) {
  start({mesh_file("cylinder", 8, "first.ply")});
  command("step 4");
  const glm::ivec2 from = place_of("seek 1"), to = place_of("seek 3");
  screen_->move_mouse(from);
  settle();
  screen_->button(1, true);
  screen_->move_mouse(to);
  screen_->button(1, false);
  screen_->move_mouse(middle(layout().viewport));
  ASSERT_TRUE(carries_out("seek 3")) << said();
  command("expect cursor = 3");
}

TEST_F(ViewerWindow, EscapeClosesAMenu) {
  start({mesh_file("cylinder", 8, "first.ply")});
  const ui::Area menu = layout().menu;
  click({static_cast<int>(menu.position.x) + 25, middle(menu).y});
  settle();
  press("Escape");
  settle();
  click(place_of("sweep"));  // with the menu open it would only close that
  ASSERT_TRUE(carries_out("sweep")) << said();
}

TEST_F(ViewerWindow, RunsAndIsCancelled) {
  start({mesh_file("scan", 20000, "scan.ply")});
  press("R");
  ASSERT_TRUE(carries_out("run")) << said();
  press("Escape");
  ASSERT_TRUE(carries_out("cancel")) << said();
  command("expect commands = 1");
  press("Ctrl+Z");
  ASSERT_TRUE(carries_out("undo")) << said();
  command("expect cursor = 0");
}

TEST_F(ViewerWindow, SelectsWhatIsClickedAndOrbitsShiftsAndZooms) {
  start({mesh_file("bracket", 5, "bracket.ply")});
  const glm::ivec2 center = middle(layout().viewport);
  click(center);
  command("expect selected = 1");
  press("P");
  ASSERT_TRUE(carries_out("panel selection on")) << said();
  drag(center, center + glm::ivec2(80, -30));
  drag(center, center + glm::ivec2(-40, 20), 3);
  screen_->move_mouse(center + glm::ivec2(60, 40));
  settle();
  for (const bool down : {true, false}) screen_->button(4, down);
  settle();
  int orbits = 0, pans = 0, zooms = 0;
  for (const std::string& line : recorded()) {
    orbits += line.starts_with("orbit ");
    pans += line.starts_with("pan ");
    zooms += line.starts_with("zoom 1.15 ");
  }
  EXPECT_GT(orbits, 0) << said();
  EXPECT_GT(pans, 0) << said();
  EXPECT_EQ(zooms, 1) << said();
  expect_headless_picture();
}

TEST_F(ViewerWindow, TabCompletesACommandInThePalette) {
  start({mesh_file("cylinder", 8, "first.ply")});
  press("Ctrl+Shift+P");
  screen_->type("fact");
  settle();
  press("Tab");
  screen_->type("7");
  settle();
  press("Return");
  ASSERT_TRUE(carries_out("factor 7")) << said();
}

TEST_F(ViewerWindow, ARightClickOpensAMenuThatEscapeAndAClickElsewhereClose) {
  start({mesh_file("bracket", 5, "bracket.ply")});
  const glm::ivec2 center = middle(layout().viewport);
  const auto right_click = [&] {
    screen_->move_mouse(center);
    settle();
    for (const bool down : {true, false}) {
      screen_->button(3, down);
      settle();
    }
  };
  const auto opened = [&] {
    const std::vector<std::string> lines = recorded();
    return std::count_if(lines.begin(), lines.end(), [](const std::string& l) {
      return l.starts_with("menu ") && l != "menu off";
    });
  };
  right_click();
  ASSERT_TRUE(waits_for([&] { return opened() == 1; })) << said();
  press("Escape");
  ASSERT_TRUE(carries_out("menu off")) << said();
  command("expect selected = 1");
  right_click();
  ASSERT_TRUE(waits_for([&] { return opened() == 2; })) << said();
  click({center.x, static_cast<int>(layout().viewport.position.y) + 5});
  ASSERT_TRUE(carries_out("menu off", 2)) << said();
  command("expect selected = 1");
  right_click();
  ASSERT_TRUE(waits_for([&] { return opened() == 3; })) << said();
  click(place_of("fit selection"));
  ASSERT_TRUE(carries_out("fit selection")) << said();
  ASSERT_TRUE(carries_out("menu off", 3)) << said();
  drag(center, center + glm::ivec2(30, 30), 3);  // shifts the picture
  EXPECT_EQ(opened(), 3) << said();
  expect_headless_picture();
}

TEST_F(ViewerWindow, OpensAFileThatIsDropped) {
  start({mesh_file("cylinder", 8, "first.ply")});
  const std::string dropped = mesh_file("torus", 8, "dropped.ply");
  ASSERT_TRUE(screen_->drop_file(dropped, middle(layout().viewport)));
  ASSERT_TRUE(carries_out("open \"" + dropped + "\"")) << said();
  ASSERT_TRUE(waits_for([&] { return screen_->title().starts_with("dropped.ply"); }))
      << screen_->title();
  expect_headless_picture();
}

TEST_F(ViewerWindow, FollowsItsSizeItsBordersAndTab) {
  start({mesh_file("bracket", 5, "bracket.ply")});
  const ui::Layout before = layout();
  const int border = static_cast<int>(before.mesh.size.x);
  drag({border, 300}, {border + 60, 300});
  ASSERT_TRUE(waits_for([&] {
    for (const std::string& line : recorded())
      if (line.starts_with("panel-width mesh ")) return true;
    return false;
  })) << said();
  EXPECT_NEAR(layout().mesh.size.x, before.mesh.size.x + 60, 2) << said();
  constexpr glm::ivec2 larger{1240, 820};
  screen_->resize(larger);
  settle();
  press("F");
  ASSERT_TRUE(carries_out("fit")) << said();
  expect_headless_picture(larger);
  press("Tab");
  ASSERT_TRUE(carries_out("panel all toggle")) << said();
  press("F");
  ASSERT_TRUE(carries_out("fit", 2)) << said();
  expect_headless_picture(larger);
}

TEST_F(ViewerWindow, RecordsTheLookThatItRemembers) {
  const std::string mesh = mesh_file("bracket", 5, "bracket.ply");
  start({mesh});
  for (const char* line : {"theme dark", "panel adjacency on", "panel timeline off"}) command(line);
  screen_->ask_to_close();
  ASSERT_TRUE(ends(0)) << said();
  start({mesh});
  EXPECT_EQ(recorded(), (std::vector<std::string>{"theme dark", "panel adjacency on",
                                                  "panel timeline off", "open \"" + mesh + "\""}));
  expect_headless_picture();
}

TEST_F(ViewerWindow, AsksBeforeUnsavedWorkIsLost) {
  start({mesh_file("bracket", 5, "bracket.ply")});
  press("S");
  ASSERT_TRUE(carries_out("sweep")) << said();
  screen_->ask_to_close();
  settle();
  press("Escape");
  ASSERT_TRUE(carries_out("dialog none")) << said();
  ASSERT_TRUE(program_->running()) << said();
  screen_->ask_to_close();
  settle();
  press_at(place_of("unsaved discard", usual_size, "quit"));
  screen_->button(1, false);
  EXPECT_TRUE(ends(0)) << said();
}

TEST_F(ViewerWindow, ClosesAtOnceWhereNothingWouldBeLost) {
  start({mesh_file("bracket", 5, "bracket.ply")});
  screen_->ask_to_close();
  EXPECT_TRUE(ends(0)) << said();
}

/// The program dies in the middle of a run; the next one offers what it did.
class DyingViewerWindow : public ViewerWindow, public testing::WithParamInterface<int> {};

TEST_P(DyingViewerWindow, OffersItsWorkAtTheNextStart) {
  const std::string mesh = mesh_file("scan", 20000, "scan.ply");
  start({mesh});
  press("R");
  ASSERT_TRUE(carries_out("run")) << said();
  ASSERT_TRUE(waits_for([&] { return keeps_work(); })) << said();
  program_->send_signal(GetParam());
  ASSERT_TRUE(ends(-GetParam())) << said();
  std::filesystem::remove(folder_ / "record.aomd");
  const glm::ivec2 restore = place_of("recover 1", usual_size, "dialog recovery");
  start({mesh_file("cylinder", 8, "other.ply")});
  click(restore);
  ASSERT_TRUE(carries_out("recover 1")) << said();
  ASSERT_TRUE(waits_for([&] { return screen_->title().starts_with("scan.ply"); }))
      << screen_->title();
  settle();
  command("expect cursor > 0");
}

INSTANTIATE_TEST_SUITE_P(Signals, DyingViewerWindow, testing::Values(SIGKILL, SIGTERM),
                         [](const auto& which) {
                           return which.param == SIGKILL ? "Kill" : "Terminate";
                         });

}  // namespace
}  // namespace aomd::test::window_test
