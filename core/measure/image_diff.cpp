#include "core/measure/image_diff.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aomd::measure {
namespace {

constexpr int window_size = 8;
constexpr int window_step = 4;
constexpr int full_red_at = 16;

/// One value a pixel, 0..255, on black where the picture is transparent.
std::vector<double> luminance(const io::Image& image) {
  std::vector<double> result(image.pixel_count());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::uint8_t* p = image.rgba.data() + 4 * i;
    result[i] = (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) * p[3] / 255.0;
  }
  return result;
}

/// Sums over one window of two luminance planes, and the index that follows from them.
struct WindowSums {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  int count = 0;

  void add(double x, double y) {
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
    ++count;
  }
  [[nodiscard]] double ssim() const {
    constexpr double c1 = (0.01 * 255) * (0.01 * 255);
    constexpr double c2 = (0.03 * 255) * (0.03 * 255);
    const double mean_a = a / count;
    const double mean_b = b / count;
    const double var_a = std::max(0.0, aa / count - mean_a * mean_a);
    const double var_b = std::max(0.0, bb / count - mean_b * mean_b);
    const double cov = ab / count - mean_a * mean_b;
    return ((2 * mean_a * mean_b + c1) * (2 * cov + c2)) /
           ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
  }
};

/// First columns (or rows) of the windows along a side; the last window touches the far border.
std::vector<int> window_starts(int length) {
  std::vector<int> starts;
  const int last = std::max(0, length - window_size);
  for (int s = 0; s < last; s += window_step) starts.push_back(s);
  starts.push_back(last);
  return starts;
}

double mean_ssim(const io::Image& a, const io::Image& b) {
  const std::vector<double> la = luminance(a);
  const std::vector<double> lb = luminance(b);
  double sum = 0;
  std::size_t windows = 0;
  for (const int y0 : window_starts(a.height)) {
    for (const int x0 : window_starts(a.width)) {
      WindowSums sums;
      for (int y = y0; y < std::min(a.height, y0 + window_size); ++y) {
        for (int x = x0; x < std::min(a.width, x0 + window_size); ++x) {
          const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                         static_cast<std::size_t>(x);
          sums.add(la[i], lb[i]);
        }
      }
      sum += sums.ssim();
      ++windows;
    }
  }
  return sum / static_cast<double>(windows);
}

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
  result.ssim = result.differing_pixels == 0 ? 1.0 : mean_ssim(a, b);
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
