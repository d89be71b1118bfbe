// What the window remembers, and that nothing else does.

#include <gtest/gtest.h>

#include "tests/support/io_helpers.h"
#include "viewer/ui/layout.h"
#include "viewer/ui/settings.h"

namespace aomd::ui::settings_test {
namespace {

using aomd::test::TemporaryFolder;

Settings some() {
  Settings s;
  s.theme = scene::Theme::Dark;
  s.panels.mesh = false;
  s.panels.page = scene::Page::Selection;
  s.panels.side_ems = 24.25f;
  s.text_scale = 1.25;
  s.occlusion = s.ground = true;
  s.window = WindowPlace{{-1200, 40}, {1500, 900}, true};
  s.recent_commands = {"factor 3", "show edges on"};
  s.play_speed = {2.5, 40};
  return s;
}

TEST(Settings, ComeBackAsTheyWere) {
  const TemporaryFolder folder;
  write_settings(folder / "deep/settings", some());
  EXPECT_EQ(read_settings(folder / "deep/settings"), some());
  EXPECT_EQ(parse_settings(settings_text({})), Settings());
}

TEST(Settings, BringTheWindowBackWhetherItWasMaximisedOrNot) {
  Settings left = some();
  left.window->maximized = false;
  EXPECT_EQ(parse_settings(settings_text(left)), left);
  const std::optional<WindowPlace> expected = WindowPlace{{10, 20}, {800, 600}, false};
  EXPECT_EQ(parse_settings("window=10 20 800 600").window, expected);
  EXPECT_EQ(parse_settings("window=10 20 800").window, std::nullopt);
}

TEST(Settings, AreTheUsualOnesWithoutAFile) {
  EXPECT_EQ(read_settings("/nowhere/settings"), Settings());
  EXPECT_NO_THROW(write_settings("/proc/nowhere/settings", some()));
}

TEST(Settings, WhatMakesNoSenseIsPassedOver) {
  const Settings odd = parse_settings(
      "theme=mauve\nmesh-panel=perhaps\nmesh-width=-4\nside-width=1e9\nwindow=1 2\nwindow=0 0 5 5\n"
      "window=0 0 999999999 1\nsize\n=\nfuture=yes\ntimeline=off\nplay-speed=-1\n"
      "play-whole=0\nplay-speed=nan\ntext-size=0\ntext-size=9\n");
  Settings expected;
  expected.panels.timeline = false;
  EXPECT_EQ(odd, expected);
}

TEST(Settings, KeepNoMoreCommandsThanThePaletteDoes) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "command=factor " + std::to_string(i + 1) + "\n";
  EXPECT_EQ(parse_settings(text).recent_commands.size(), 8u);
}

TEST(PanelWidths, AreWhatTheUserChoseAsFarAsThereIsRoom) {
  scene::Panels panels;
  const ImVec2 display{1280, 800};
  const float em = 16;
  const float usual = make_layout(display, panels, true, em).mesh.size.x;
  panels.mesh_ems = 25;
  EXPECT_EQ(make_layout(display, panels, true, em).mesh.size.x, 400);
  EXPECT_EQ(make_layout(display, panels, true, em).side.size.x,
            make_layout(display, scene::Panels(), true, em).side.size.x);
  panels.mesh_ems = panels.side_ems = 60;
  const Layout full = make_layout({480, 320}, panels, true, em);
  EXPECT_GT(full.viewport.size.x, 60);
  EXPECT_EQ(full.mesh.size.x + full.viewport.size.x + full.side.size.x, 480);
  panels.mesh_ems = 0;
  EXPECT_EQ(make_layout(display, panels, true, em).mesh.size.x, usual);
}

}  // namespace
}  // namespace aomd::ui::settings_test
