#include "core/measure/image_diff.h"

#include <gtest/gtest.h>

namespace aomd::measure::image_diff_test {
namespace {

io::Image flat(int width, int height, std::uint8_t grey) {
  io::Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? 255 : grey;
  return image;
}

io::Image checkers(int width, int height, int cell) {
  io::Image image = flat(width, height, 40);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if ((x / cell + y / cell) % 2 == 0)
        image.pixel(x, y)[0] = image.pixel(x, y)[1] = image.pixel(x, y)[2] = 220;
  return image;
}

TEST(ImageDiff, EqualPicturesAreIdentical) {
  const ImageDifference d = compare_images(checkers(33, 21, 3), checkers(33, 21, 3));
  EXPECT_TRUE(d.identical());
  EXPECT_EQ(d.ssim, 1.0);
  EXPECT_EQ(d.largest_channel_difference, 0);
  EXPECT_EQ(d.pixels, 33u * 21u);
}

TEST(ImageDiff, OneChangedPixelIsCounted) {
  io::Image b = checkers(64, 64, 4);
  b.pixel(10, 20)[1] = static_cast<std::uint8_t>(b.pixel(10, 20)[1] - 25);
  const ImageDifference d = compare_images(checkers(64, 64, 4), b);
  EXPECT_EQ(d.differing_pixels, 1u);
  EXPECT_EQ(d.largest_channel_difference, 25);
  EXPECT_LT(d.ssim, 1.0);
  EXPECT_GT(d.ssim, 0.99);
}

TEST(ImageDiff, SsimOfFlatPicturesIsTheLuminanceTerm) {
  const double c1 = (0.01 * 255) * (0.01 * 255);
  const double expected = (2.0 * 100 * 50 + c1) / (100.0 * 100 + 50.0 * 50 + c1);
  EXPECT_NEAR(compare_images(flat(32, 32, 100), flat(32, 32, 50)).ssim, expected, 1e-9);
}

TEST(ImageDiff, InvertedStructureIsNegative) {
  io::Image b = checkers(64, 64, 4);
  for (std::size_t i = 0; i < b.rgba.size(); ++i)
    if (i % 4 != 3) b.rgba[i] = static_cast<std::uint8_t>(260 - b.rgba[i]);
  EXPECT_LT(compare_images(checkers(64, 64, 4), b).ssim, -0.8);
}

TEST(ImageDiff, IsSymmetric) {
  const io::Image a = checkers(50, 40, 5);
  const io::Image b = checkers(50, 40, 7);
  EXPECT_DOUBLE_EQ(compare_images(a, b).ssim, compare_images(b, a).ssim);
}

TEST(ImageDiff, SmallerThanAWindow) {
  EXPECT_EQ(compare_images(flat(1, 1, 7), flat(1, 1, 7)).ssim, 1.0);
  EXPECT_LT(compare_images(flat(3, 2, 7), flat(3, 2, 200)).ssim, 0.2);
}

TEST(ImageDiff, OtherSizesAreAResult) {
  const ImageDifference d = compare_images(flat(10, 10, 1), flat(10, 12, 1));
  EXPECT_FALSE(d.same_size);
  EXPECT_FALSE(d.identical());
  EXPECT_EQ(d.ssim, 0.0);
  EXPECT_EQ(d.differing_pixels, 120u);
}

TEST(ImageDiff, EmptyPicturesAreEqual) {
  EXPECT_TRUE(compare_images(io::Image(), io::Image()).identical());
}

TEST(ImageDiff, PictureIsRedWhereItDiffersAndDimGreyElsewhere) {
  io::Image b = flat(8, 8, 200);
  b.pixel(3, 4)[2] = 100;
  const io::Image d = difference_picture(flat(8, 8, 200), b);
  EXPECT_EQ(d.pixel(3, 4)[0], 255);
  EXPECT_EQ(d.pixel(3, 4)[1], 0);
  EXPECT_EQ(d.pixel(0, 0)[0], 70);
  EXPECT_EQ(d.pixel(0, 0)[0], d.pixel(0, 0)[2]);
}

TEST(ImageDiff, PictureCoversBothSizes) {
  const io::Image d = difference_picture(flat(8, 4, 10), flat(5, 9, 10));
  EXPECT_EQ(d.width, 8);
  EXPECT_EQ(d.height, 9);
  EXPECT_EQ(d.pixel(0, 0)[0], d.pixel(0, 0)[1]);
  EXPECT_EQ(d.pixel(7, 3)[0], 255);
  EXPECT_EQ(d.pixel(7, 8)[0], 255);
}

}  // namespace
}  // namespace aomd::measure::image_diff_test
