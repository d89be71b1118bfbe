// How the window looks and from where the mesh is seen: what stays, and what comes back.

#include <gtest/gtest.h>

#include "tests/support/session_helpers.h"

namespace aomd::scene::looks_test {
namespace {

using test::drive;

TEST(TextSize, GoesByPercentAndBySteps) {
  Session s;
  drive(s, {"text-size 150"});
  EXPECT_EQ(s.view.text_scale, 1.5);
  drive(s, {"text-size larger"});
  EXPECT_EQ(s.view.text_scale, 2);
  drive(s, {"text-size smaller", "text-size smaller"});
  EXPECT_EQ(s.view.text_scale, 1.25);
  drive(s, {"text-size 300", "text-size larger"});
  EXPECT_EQ(s.view.text_scale, 3);
  drive(s, {"text-size 50", "text-size smaller"});
  EXPECT_EQ(s.view.text_scale, 0.5);
  drive(s, {"text-size usual"});
  EXPECT_EQ(s.view.text_scale, 1);
  EXPECT_THROW(execute(s, "text-size 20"), CommandError);
  EXPECT_THROW(execute(s, "text-size"), CommandError);
}

TEST(Presentation, HidesAllButTheLessonAndBringsItBack) {
  Session s;
  drive(s, {"sample sphere 8", "panel runs on"});
  const Panels before = s.view.panels;
  drive(s, {"presentation on", "presentation on"});
  EXPECT_FALSE(s.view.panels.menus || s.view.panels.side || s.view.panels.timeline ||
               s.view.panels.runs || s.view.panels.mesh);
  drive(s, {"presentation off"});
  EXPECT_TRUE(s.view.panels == before);
  drive(s, {"lesson stored", "presentation on"});
  EXPECT_TRUE(s.view.panels.mesh);
  EXPECT_FALSE(s.view.panels.side);
}

TEST(Presentation, OutlivesTheLessonThatItBeganIn) {
  Session s;
  drive(s, {"sample sphere 8", "text-size 125", "lesson stored", "presentation on", "lesson next",
            "lesson off"});
  EXPECT_TRUE(s.view.presenting);
  EXPECT_FALSE(s.view.panels.menus);
  EXPECT_EQ(s.view.text_scale, 1.25);
  drive(s, {"lesson stored", "presentation off", "lesson off"});
  EXPECT_FALSE(s.view.presenting);
  EXPECT_TRUE(s.view.panels.menus);
}

TEST(RecentCameras, LeadBackToWhereTheCameraJumpedFrom) {
  Session s;
  drive(s, {"sample sphere 8", "camera recent"});
  EXPECT_EQ(s.status, "The camera has not jumped yet");
  drive(s, {"orbit 20 5"});
  const Camera turned = s.view.camera;
  drive(s, {"camera front"});
  const Camera front = s.view.camera;
  drive(s, {"camera recent"});
  EXPECT_TRUE(s.view.camera == turned);
  drive(s, {"camera recent"});
  EXPECT_TRUE(s.view.camera == front);
  drive(s, {"zoom 3", "fit", "camera top", "camera recent 3"});
  EXPECT_TRUE(s.view.camera == turned);
  EXPECT_THROW(execute(s, "camera recent 9"), CommandError);
  EXPECT_THROW(execute(s, "camera recent 1 2"), CommandError);
  for (int i = 0; i < 20; ++i) drive(s, {i % 2 == 0 ? "camera left" : "camera right"});
  EXPECT_EQ(s.cameras_before().size(), 8u);
  drive(s, {"sample torus 6"});
  EXPECT_TRUE(s.cameras_before().empty()) << "they looked at another mesh";
}

TEST(RefusedEdge, AClickOnItsColourOpensItsReason) {
  Session s;
  drive(s, {"sample cylinder 2", "camera front"});
  std::string inside;  // a face, away from its edges
  for (int i = 0; i < 20 && s.sheet().selection.single().dimension != 2; ++i) {
    inside = "pick 0.05 " + std::to_string(0.02 * i);
    drive(s, {inside});
  }
  ASSERT_EQ(s.sheet().selection.single().dimension, 2);
  EXPECT_EQ(s.view.panels.page, Page::Decimation);
  drive(s, {"panel decimation off", "color verdict", inside});
  EXPECT_EQ(s.sheet().selection.single().dimension, 1) << "the whole diamond is its edge's";
  EXPECT_TRUE(s.view.panels.side);
  EXPECT_EQ(s.view.panels.page, Page::Selection);
}

}  // namespace
}  // namespace aomd::scene::looks_test
