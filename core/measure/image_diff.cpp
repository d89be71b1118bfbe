#include "core/measure/image_diff.h"

#include <algorithm>
#include <cmath>

#include "core/measure/ssim.h"

namespace aomd::measure {
namespace {

constexpr int full_red_at = 16;

int pixel_difference(const std::uint8_t* p, const std::uint8_t* q) {
  int largest = 0;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(int{p[c]} - int{q[c]}));
  return largest;
}

bool inside(const io::Image& image, int x, int y) { return x < image.width && y < image.height; }

/// Writes one pixel of the difference picture: dimmed grey `base`, drowned in red by `amount` in
/// [0,1].
void paint(std::uint8_t* out, double base, double amount) {
  const double dim = 0.35 * base;
  out[0] = static_cast<std::uint8_t>(std::lround(dim + (255.0 - dim) * amount));
  out[1] = static_cast<std::uint8_t>(std::lround(dim * (1.0 - amount)));
  out[2] = out[1];
  out[3] = 255;
}

}  // namespace

ImageDifference compare_images(const io::Image& a, const io::Image& b) {
  ImageDifference result;
  result.pixels = std::max(a.pixel_count(), b.pixel_count());
  result.same_size = a.width == b.width && a.height == b.height;
  if (!result.same_size) {
    result.largest_channel_difference = 255;
    result.differing_pixels = result.pixels;
    return result;
  }
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    const int difference = pixel_difference(a.rgba.data() + i, b.rgba.data() + i);
    result.largest_channel_difference = std::max(result.largest_channel_difference, difference);
    if (difference > 0) ++result.differing_pixels;
  }
  result.ssim = result.differing_pixels == 0 ? 1.0 : ssim_windows(a, b).mean();
  return result;
}

io::Image difference_picture(const io::Image& a, const io::Image& b) {
  io::Image result(std::max(a.width, b.width), std::max(a.height, b.height));
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      double base = 0;
      double amount = 1;
      if (inside(a, x, y)) {
        const std::uint8_t* p = a.pixel(x, y);
        base = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
      }
      if (inside(a, x, y) && inside(b, x, y))
        amount = std::min(
            1.0, static_cast<double>(pixel_difference(a.pixel(x, y), b.pixel(x, y))) / full_red_at);
      paint(result.pixel(x, y), base, amount);
    }
  }
  return result;
}

}  // namespace aomd::measure
