// Triangles laid over a triangle: heights and completeness, by hand.

#include <gtest/gtest.h>

#include <random>

#include "core/decimate/guard/overlay.h"

namespace aomd::overlay_test {
namespace {

//   2 +           what is below: (0,0) (2,0) (0,2), at z = 1
//     | \         .
//     |   \       left of x = 1 and right of it
//   0 +--+--+
//     0  1  2
const Triangle below{glm::dvec3(0, 0, 1), {2, 0, 1}, {0, 2, 1}};
const Triangle right{glm::dvec3(1, -3, 1), {9, -3, 1.8}, {1, 5, 1}};  // z = 1 + (x - 1) / 10
const Triangle left{glm::dvec3(1, 5, 1), {-7, 1, 1}, {1, -3, 1}};

TEST(Overlay, WhatIsOverItAllIsComplete) {
  Overlay overlay(below, 0.011);
  EXPECT_NEAR(overlay.lay(right), 0.01, 1e-15) << "at (2,0)";
  EXPECT_FALSE(overlay.complete()) << "nothing on the left";
  EXPECT_NEAR(overlay.lay(left), 0, 1e-15);
  EXPECT_TRUE(overlay.complete());
}

TEST(Overlay, WhatIsOverItTwiceOrNotAtAllIsNot) {
  Overlay overlay(below, 1);
  EXPECT_LT(overlay.lay({glm::dvec3(3, 3, 1), {4, 3, 1}, {3, 4, 1}}), 0);
  EXPECT_FALSE(overlay.complete());
  for (const Triangle& t : {left, right, right}) overlay.lay(t);
  EXPECT_FALSE(overlay.complete());
}

TEST(Overlay, WhatIsOutOfReachCountsForNothing) {
  Overlay overlay(below, 0.009);
  EXPECT_LT(overlay.lay(right), 0);
  overlay.lay(left);
  EXPECT_FALSE(overlay.complete());
  Overlay plate(below, 0.011);  // its other side is too far off to be in the way
  for (const Triangle& t : {left, right}) plate.lay(t);
  for (Triangle t : {left, right}) {
    for (glm::dvec3& p : t) p.z -= 3;
    EXPECT_LT(plate.lay(t), 0);
  }
  EXPECT_TRUE(plate.complete());
}

TEST(Overlay, TheWayRoundDoesNotMatter) {
  Overlay overlay({below[0], below[2], below[1]}, 1);
  EXPECT_NEAR(overlay.lay({right[0], right[2], right[1]}), 0.01, 1e-15);
  overlay.lay(left);
  EXPECT_TRUE(overlay.complete());
}

// Their corners stand on one side of what is below or on the other by rounding alone.
TEST(Overlay, SliversAlongASideCoverNothing) {
  std::mt19937 random(1);
  const auto number = [&] { return double(random() % 10'001) / 1e4; };
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 a(number(), number(), number()), b(number(), number(), number()), c(3, 4, 5);
    Overlay overlay({a, b, c}, 1);
    const auto on_side = [&] { return a + (3 * number() - 1) * (b - a); };
    for (int k = 0; k < 4; ++k) overlay.lay({on_side(), on_side(), on_side()});
    EXPECT_FALSE(overlay.complete());
  }
}

TEST(Overlay, NothingIsOverWhatHasNoArea) {
  Overlay overlay({below[0], below[1], below[1]}, 1);
  overlay.lay(below);
  EXPECT_FALSE(overlay.complete());
}

}  // namespace
}  // namespace aomd::overlay_test
