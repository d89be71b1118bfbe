// The arrays that the renderer reads: packing, dirty ranges, palette, boxes.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include <glm/geometric.hpp>

#include "viewer/drawing/drawable.h"

namespace aomd::scene::scene_test {
namespace {

double luminance(Color c) {
  const glm::vec4 v = unpack_color(c);
  return 0.2126 * v.r + 0.7152 * v.g + 0.0722 * v.b;
}

TEST(Packing, NormalsComeBackWithinATenthOfADegree) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> part(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 n = glm::normalize(glm::vec3(part(random), part(random), part(random)));
    const glm::vec3 back = unpack_normal(pack_normal(n));
    EXPECT_LT(glm::length(glm::cross(n, glm::normalize(back))), std::sin(0.1 * 3.14159265 / 180));
    EXPECT_GT(glm::dot(n, back), 0);
  }
}

TEST(Packing, NormalsOfTheAxesAreExact) {
  EXPECT_EQ(pack_normal({0, 0, 0}), 0u);
  EXPECT_EQ(pack_normal({1, 0, 0}), 511u);
  EXPECT_EQ(pack_normal({0, -1, 0}), 0x201u << 10);
  EXPECT_EQ(unpack_normal(pack_normal({0, 0, -1})), glm::vec3(0, 0, -1));
}

TEST(Packing, ColorsKeepTheirBytesInOrder) {
  EXPECT_EQ(pack_color({1, 0, 0, 1}), 0xff0000ffu);
  EXPECT_EQ(rgb(0x112233), 0xff332211u);
  EXPECT_EQ(pack_color(unpack_color(0x80402010u)), 0x80402010u);
  EXPECT_EQ(pack_color({2, -1, 0.5f, 0}), 0x008000ffu);
  EXPECT_EQ(mix_colors(rgb(0x000000), rgb(0xffffff), 0.5f), rgb(0x808080));
}

TEST(Palette, IsDeterministicAndTellsNeighboursApart) {
  for (int dim = 0; dim < 4; ++dim) {
    std::set<Color> seen;
    for (int tag = 1; tag <= 24; ++tag) {
      EXPECT_EQ(color_of(ModelRef(dim, tag)), color_of(ModelRef(dim, tag)));
      seen.insert(color_of(ModelRef(dim, tag)));
    }
    EXPECT_EQ(seen.size(), 24u) << dim;
  }
}

TEST(Palette, EdgesAndVerticesAreDarkerThanTheirFaces) {
  for (int tag = 1; tag <= 24; ++tag) {
    EXPECT_LT(luminance(color_of(ModelRef(1, tag))) + 0.1, luminance(color_of(ModelRef(2, tag))))
        << tag;
    EXPECT_LT(luminance(color_of(ModelRef(0, tag))), luminance(color_of(ModelRef(2, tag)))) << tag;
  }
}

TEST(Palette, TheRampGetsLighterAllTheWay) {
  EXPECT_EQ(ramp_color(0), rgb(0x3e4989));
  EXPECT_EQ(ramp_color(1), rgb(0xfde725));
  EXPECT_EQ(ramp_color(-3), ramp_color(0));
  EXPECT_EQ(ramp_color(7), ramp_color(1));
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(luminance(ramp_color(0.01f * static_cast<float>(i))),
              luminance(ramp_color(0.01f * static_cast<float>(i + 1))))
        << i;
}

TEST(Palette, TakesEveryTagAndNone) {
  for (const int tag : {0, -1, -5, ModelRef::min_tag, ModelRef::max_tag})
    EXPECT_NE(color_of(ModelRef(2, tag)), unclassified_color()) << tag;
  EXPECT_EQ(color_of(ModelRef()), unclassified_color());
}

TEST(DirtyRanges, NearOnesJoinAndFarOnesStayApart) {
  DirtyRanges dirty;
  dirty.add({100, 103});
  dirty.add({10, 13});
  dirty.add({50, 50});
  ASSERT_EQ(dirty.ranges().size(), 2u);
  EXPECT_EQ(dirty.ranges()[0], (ElementRange{10, 13}));
  dirty.add({13, 20});
  dirty.add({18, 105});
  ASSERT_EQ(dirty.ranges().size(), 1u);
  EXPECT_EQ(dirty.ranges()[0], (ElementRange{10, 105}));
}

TEST(DirtyRanges, StayFewAndSortedAndCoverEverything) {
  DirtyRanges dirty;
  std::mt19937 random(2);
  std::set<std::size_t> marked;
  for (int i = 0; i < 2000; ++i) {
    const std::size_t at = random() % 100000;
    dirty.add({at, at + 3});
    marked.insert(at);
    ASSERT_LE(dirty.ranges().size(), DirtyRanges::max_ranges);
  }
  std::size_t before = 0;
  for (const ElementRange& r : dirty.ranges()) {
    EXPECT_TRUE(before == 0 || r.begin > before);
    EXPECT_LT(r.begin, r.end);
    before = r.end;
  }
  for (const std::size_t at : marked) {
    bool found = false;
    for (const ElementRange& r : dirty.ranges())
      found = found || (r.begin <= at && at + 3 <= r.end);
    ASSERT_TRUE(found) << at;
  }
}

TEST(Patched, RemembersWhatChanged) {
  Patched<int> array;
  array.assign({1, 2, 3, 4});
  ASSERT_EQ(array.dirty().size(), 1u);
  EXPECT_EQ(array.dirty()[0], (ElementRange{0, 4}));
  array.clean();
  array.set(2, 30);
  array.push_back(5);
  EXPECT_EQ(array.dirty()[0], (ElementRange{2, 5}));
  EXPECT_EQ(array[2], 30);
  array.resize(3);
  EXPECT_EQ(array.dirty()[0], (ElementRange{2, 3}));
  array.resize(2);
  EXPECT_TRUE(array.dirty().empty());
  for (int& value : array.edit(0, 2)) value = 7;
  EXPECT_EQ(array.dirty()[0], (ElementRange{0, 2}));
  EXPECT_EQ(array[1], 7);
}

TEST(Box, GrowsAndKnowsItsMeasures) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.diagonal(), 0);
  EXPECT_EQ(box.center(), glm::dvec3(0));
  box.add({1, 2, 3});
  EXPECT_FALSE(box.empty());
  box.add({4, 6, 3});
  EXPECT_DOUBLE_EQ(box.diagonal(), 5);
  EXPECT_DOUBLE_EQ(box.radius(), 2.5);
  box.set_radius(2);
  EXPECT_DOUBLE_EQ(box.radius(), 2);
  EXPECT_EQ(box.corners()[7], glm::dvec3(4, 6, 3));
}

}  // namespace
}  // namespace aomd::scene::scene_test
