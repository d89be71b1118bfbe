// Whether a picture is still its baseline: 200 pairs with the verdict of a person, and the limits
// one by one.

#include "core/measure/picture_verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/measure/image_diff.h"
#include "core/measure/ssim.h"
#include "tests/support/painted_scene.h"

namespace aomd::measure::picture_verdict_test {
namespace {

using test::paint;
using test::PaintedScene;

void add_to_pixel(io::Image& image, int x, int y, int by) {
  for (int c = 0; c < 3; ++c)
    image.pixel(x, y)[c] = static_cast<std::uint8_t>(std::clamp(image.pixel(x, y)[c] + by, 0, 255));
}

io::Image noisy(io::Image image, int by) {
  std::mt19937 random(7);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int step = static_cast<int>(random() % static_cast<unsigned>(2 * by + 1)) - by;
        image.pixel(x, y)[c] =
            static_cast<std::uint8_t>(std::clamp(image.pixel(x, y)[c] + step, 0, 255));
      }
  return image;
}

io::Image with_pixel(io::Image image, int by) {
  const bool up = image.pixel(image.width / 2, 4)[0] < 128;
  add_to_pixel(image, image.width / 2, 4, up ? by : -by);
  return image;
}

/// An edge of a face that looks at the eye.
int edge_in_front(const PaintedScene& scene) {
  return 2 * (scene.rows / 2 * 2 * scene.rows + scene.rows / 2);
}

/// What happens to a scene, and what a person says of it.
struct Change {
  std::string name;
  bool same;
  std::function<io::Image(PaintedScene, const io::Image&)> make;
};

template <typename Edit>
std::function<io::Image(PaintedScene, const io::Image&)> edited(Edit edit) {
  return [edit](PaintedScene scene, const io::Image&) {
    edit(scene);
    return paint(scene);
  };
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {
      {"the same again", true, edited([](PaintedScene&) {})},
      {"another driver places all by 1/64 pixel otherwise", true,
       edited([](PaintedScene& s) { s.shifted_px = 1.0 / 64; })},
      {"noise by 1", true, [](auto, const io::Image& a) { return noisy(a, 1); }},
      {"noise by 2", true, [](auto, const io::Image& a) { return noisy(a, 2); }},
      {"colours of faces by 1", true, edited([](PaintedScene& s) { s.brighter = 1; })},
      {"colours of faces by 2", true, edited([](PaintedScene& s) { s.brighter = 2; })},
      {"one pixel by 20", true, [](auto, const io::Image& a) { return with_pixel(a, 20); }},
      {"one pixel by 100", false, [](auto, const io::Image& a) { return with_pixel(a, 100); }},
      {"noise by 8", false, [](auto, const io::Image& a) { return noisy(a, 8); }},
      {"colours of faces by 4", false, edited([](PaintedScene& s) { s.brighter = 4; })},
      {"colours of faces by 12", false, edited([](PaintedScene& s) { s.brighter = 12; })},
      {"an edge moved by 1 pixel", false, edited([](PaintedScene& s) {
         s.moved_edge = edge_in_front(s);
         s.moved_px = 1;
       })},
      {"an edge moved by 3 pixels", false, edited([](PaintedScene& s) {
         s.moved_edge = edge_in_front(s);
         s.moved_px = 3;
       })},
      {"an edge gone", false, edited([](PaintedScene& s) {
         s.moved_edge = edge_in_front(s);
         s.moved_px = 1000;
       })},
      {"a face selected", false,
       edited([](PaintedScene& s) { s.selected_face = s.rows / 2 * 2 * s.rows + s.rows / 2; })},
      {"axes gone", false, edited([](PaintedScene& s) { s.axes = false; })},
      {"turned by 0.2 degrees", false, edited([](PaintedScene& s) { s.turned_deg = 0.2; })},
      {"turned by 2 degrees", false, edited([](PaintedScene& s) { s.turned_deg = 2; })},
      {"edges twice as wide", false, edited([](PaintedScene& s) { s.edge_px *= 2; })},
      {"another theme", false, edited([](PaintedScene& s) { s.dark = !s.dark; })},
  };
  return all;
}

std::vector<PaintedScene> scenes() {
  std::vector<PaintedScene> all;
  for (const bool dark : {false, true}) {
    all.push_back({.width = 240, .height = 160, .dark = dark});
    all.push_back({.width = 320, .height = 240, .dark = dark, .rows = 12});
    all.push_back({.width = 333, .height = 217, .dark = dark, .rows = 6, .edge_px = 2});
    all.push_back({.width = 400, .height = 300, .dark = dark, .rows = 20});
    all.push_back({.width = 256, .height = 256, .dark = dark, .rows = 4, .edge_px = 1.5});
  }
  return all;
}

TEST(PictureVerdict, SaysOfTwoHundredPairsWhatAPersonSays) {
  int pairs = 0;
  for (const PaintedScene& scene : scenes()) {
    const io::Image baseline = paint(scene);
    for (const Change& change : changes()) {
      const PictureVerdict verdict = judge_pictures(baseline, change.make(scene, baseline));
      EXPECT_EQ(verdict.same, change.same)
          << change.name << " at " << scene.width << "x" << scene.height
          << (scene.dark ? ", dark: " : ": ") << verdict.why << " (worst tile "
          << verdict.worst_tile << ", largest " << verdict.largest << ", share " << verdict.share()
          << ")";
      EXPECT_EQ(verdict.same, verdict.why.empty());
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 200);
}

TEST(PictureVerdict, OneIndexOfTheWholePictureLetsSmallLossesPass) {
  for (const char* name : {"axes gone", "an edge gone"}) {
    const PaintedScene scene{.width = 400, .height = 300, .rows = 20};
    const io::Image baseline = paint(scene);
    for (const Change& change : changes()) {
      if (change.name != name) continue;
      EXPECT_GT(compare_images(baseline, change.make(scene, baseline)).ssim, 0.99) << name;
    }
  }
}

/// The index of one window as the paper has it: means first, then variances about them.
double plain_ssim(const io::Image& a, const io::Image& b, int x0, int y0) {
  const int width = std::min(8, a.width), height = std::min(8, a.height), n = width * height;
  const auto grey = [](const io::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) * (p[3] / 255.0);
  };
  double mean_a = 0, mean_b = 0, var_a = 0, var_b = 0, cov = 0;
  for (int k = 0; k < n; ++k) {
    mean_a += grey(a, x0 + k % width, y0 + k / width) / n;
    mean_b += grey(b, x0 + k % width, y0 + k / width) / n;
  }
  for (int k = 0; k < n; ++k) {
    const double u = grey(a, x0 + k % width, y0 + k / width) - mean_a;
    const double v = grey(b, x0 + k % width, y0 + k / width) - mean_b;
    var_a += u * u / n;
    var_b += v * v / n;
    cov += u * v / n;
  }
  const double c1 = 6.5025, c2 = 58.5225;
  return (2 * mean_a * mean_b + c1) / (mean_a * mean_a + mean_b * mean_b + c1) *
         ((2 * cov + c2) / (var_a + var_b + c2));
}

TEST(PictureVerdict, SsimIsThatOfAPlainImplementation) {
  for (const auto& [width, height] : {std::pair{64, 48}, {61, 43}, {8, 8}, {5, 3}, {9, 200}}) {
    PaintedScene scene{.width = width, .height = height};
    const io::Image a = paint(scene);
    scene.turned_deg = 5;
    io::Image b = noisy(paint(scene), 20);
    for (std::size_t i = 3; i < b.rgba.size(); i += 28) b.rgba[i] = 100;
    const SsimWindows windows = ssim_windows(a, b);
    ASSERT_EQ(windows.values.size(), windows.rows.size() * windows.columns.size());
    EXPECT_EQ(windows.columns.back(), std::max(0, width - 8));
    EXPECT_EQ(windows.rows.back(), std::max(0, height - 8));
    double sum = 0;
    auto value = windows.values.begin();
    for (const int y : windows.rows)
      for (const int x : windows.columns) {
        const double expected = plain_ssim(a, b, x, y);
        EXPECT_NEAR(*value++, expected, 1e-6) << x << "," << y << " of " << width << "x" << height;
        sum += expected;
      }
    EXPECT_NEAR(compare_images(a, b).ssim, sum / static_cast<double>(windows.values.size()), 1e-6);
  }
}

TEST(PictureVerdict, TheWorstTileIsNamed) {
  const io::Image baseline = paint({});
  PaintedScene scene;
  scene.axes = false;
  const PictureVerdict verdict = judge_pictures(baseline, paint(scene));
  EXPECT_EQ(verdict.tile, (PixelArea{0, 128, 32, 32}));
  EXPECT_LT(verdict.worst_tile, 0.8);
  EXPECT_EQ(verdict.why.find("the tile at 0,128 has a similarity of 0."), 0u) << verdict.why;
}

TEST(PictureVerdict, EachLimitDecides) {
  const io::Image baseline = paint({});
  const io::Image pixel = with_pixel(baseline, 40);
  PictureLimits limits;
  limits.threshold = -1;
  EXPECT_TRUE(judge_pictures(baseline, pixel, limits).same);
  limits.largest = 39;
  EXPECT_EQ(judge_pictures(baseline, pixel, limits).why,
            "the pixel at 120,4 differs by 40 of 255, not 39 at most");
  limits.largest = 40;
  limits.share = 0;
  EXPECT_EQ(judge_pictures(baseline, pixel, limits).why,
            "1 pixel differs (0.0026 %), not 0 % at most");
  limits.noise = 40;
  EXPECT_TRUE(judge_pictures(baseline, pixel, limits).same);
  limits.noise = 39;
  EXPECT_EQ(judge_pictures(baseline, pixel, limits).differing, 1u);
}

TEST(PictureVerdict, MaskedIsNotJudged) {
  const io::Image baseline = paint({});
  PaintedScene scene;
  scene.axes = false;
  const io::Image result = paint(scene);
  PictureLimits limits;
  limits.masks = {{0, 120, 40, 40}};
  const PictureVerdict masked = judge_pictures(baseline, result, limits);
  EXPECT_TRUE(masked.same) << masked.why;
  EXPECT_EQ(masked.judged, 240u * 160u - 1600u);
  limits.masks = {{40, 0, 200, 160}};
  EXPECT_FALSE(judge_pictures(baseline, result, limits).same);
}

TEST(PictureVerdict, MasksMayOverlapAndReachOutOfThePicture) {
  PictureLimits limits;
  limits.masks = {{-10, -10, 20, 20},
                  {5, 5, 10, 10},
                  {230, 150, 2'000'000'000, 2'000'000'000},
                  {500, 500, 9, 9}};
  EXPECT_EQ(judge_pictures(paint({}), paint({}), limits).judged,
            240u * 160u - (100u + 100u - 25u) - 100u);
}

TEST(PictureVerdict, EdgesAreForgivenOnlyWhereAsked) {
  const io::Image baseline = paint({});
  PaintedScene scene;
  scene.shifted_px = 1.0 / 64;
  const io::Image result = paint(scene);
  EXPECT_EQ(judge_pictures(baseline, result).differing, 0u);
  PictureLimits limits;
  limits.edges = false;
  EXPECT_GT(judge_pictures(baseline, result, limits).differing, 50u);
}

TEST(PictureVerdict, WhatVanishesCountsAsWhatAppears) {
  const io::Image baseline = paint({});
  const io::Image pixel = with_pixel(baseline, 100);
  EXPECT_FALSE(judge_pictures(baseline, pixel).same);
  EXPECT_FALSE(judge_pictures(pixel, baseline).same);
}

TEST(PictureVerdict, ExactForgivesNothing) {
  const io::Image baseline = paint({});
  const io::Image pixel = with_pixel(baseline, 1);
  EXPECT_TRUE(judge_pictures(baseline, pixel).same);
  EXPECT_FALSE(judge_pictures(baseline, pixel, PictureLimits::with_threshold(1)).same);
  EXPECT_TRUE(judge_pictures(baseline, baseline, PictureLimits::with_threshold(1)).same);
  EXPECT_EQ(PictureLimits::with_threshold(0.9).threshold, 0.9);
}

TEST(PictureVerdict, OtherSizesAreNeverTheSame) {
  const PictureVerdict verdict = judge_pictures(io::Image(10, 10), io::Image(10, 12));
  EXPECT_FALSE(verdict.same);
  EXPECT_EQ(verdict.why, "the sizes differ: 10x10 and 10x12");
  EXPECT_EQ(verdict.differing, 120u);
}

TEST(PictureVerdict, EmptyPicturesAreTheSame) {
  EXPECT_TRUE(judge_pictures(io::Image(), io::Image()).same);
}

TEST(PictureVerdict, WhatIsTransparentCounts) {
  io::Image result = paint({});
  for (int x = 50; x < 90; ++x)
    for (int y = 50; y < 90; ++y) result.pixel(x, y)[3] = 0;
  const PictureVerdict verdict = judge_pictures(paint({}), result);
  EXPECT_FALSE(verdict.same);
  EXPECT_EQ(verdict.largest, 255);
}

}  // namespace
}  // namespace aomd::measure::picture_verdict_test
