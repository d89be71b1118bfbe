#include "viewer/commands/look_lines.h"

#include <gtest/gtest.h>

#include "tests/support/session_helpers.h"

namespace aomd::scene::look_lines_test {
namespace {

TEST(LookLines, TheUsualLookNeedsNone) {
  EXPECT_EQ(look_lines(Session().view), std::vector<std::string>());
}

TEST(LookLines, LeadToEachLook) {
  for (int bits = 0; bits < 32; ++bits)
    for (const Page page : {Page::Decimation, Page::Adjacency, Page::Histograms, Page::Selection}) {
      Session wanted, led;
      wanted.view.theme = (bits & 1) != 0 ? Theme::Dark : Theme::Light;
      wanted.view.panels.mesh = (bits & 2) != 0;
      wanted.view.panels.side = (bits & 4) != 0;
      wanted.view.panels.timeline = (bits & 8) != 0;
      wanted.view.panels.runs = (bits & 16) != 0;
      wanted.view.panels.page = page;
      wanted.view.occlusion = bits % 3 == 1;
      wanted.view.ground = bits % 5 == 1;
      wanted.view.text_scale = bits % 4 == 0 ? 1.25 : 1;
      wanted.view.panels.mesh_ems = bits % 3 == 0 ? 17.25f : 0;
      wanted.view.panels.side_ems = bits % 3 == 1 ? 33.5f : 0;
      for (const std::string& line : look_lines(wanted.view)) test::drive(led, {line});
      EXPECT_TRUE(led.view.panels == wanted.view.panels) << bits;
      EXPECT_EQ(led.view.theme, wanted.view.theme) << bits;
      EXPECT_EQ(led.view.occlusion, wanted.view.occlusion) << bits;
      EXPECT_EQ(led.view.ground, wanted.view.ground) << bits;
      EXPECT_EQ(led.view.text_scale, wanted.view.text_scale) << bits;
    }
}

}  // namespace
}  // namespace aomd::scene::look_lines_test
