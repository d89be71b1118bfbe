#include "core/measure/ssim.h"

#include <algorithm>
#include <numeric>

namespace aomd::measure {
namespace {

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

std::vector<int> window_starts(int length) {
  std::vector<int> starts;
  const int last = std::max(0, length - SsimWindows::size);
  for (int s = 0; s < last; s += SsimWindows::step) starts.push_back(s);
  starts.push_back(last);
  return starts;
}

}  // namespace

double SsimWindows::mean() const {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

SsimWindows ssim_windows(const io::Image& a, const io::Image& b) {
  const std::vector<double> la = luminance(a);
  const std::vector<double> lb = luminance(b);
  SsimWindows result{window_starts(a.width), window_starts(a.height), {}};
  for (const int y0 : result.rows) {
    for (const int x0 : result.columns) {
      WindowSums sums;
      for (int y = y0; y < std::min(a.height, y0 + SsimWindows::size); ++y) {
        for (int x = x0; x < std::min(a.width, x0 + SsimWindows::size); ++x) {
          const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                         static_cast<std::size_t>(x);
          sums.add(la[i], lb[i]);
        }
      }
      result.values.push_back(sums.ssim());
    }
  }
  return result;
}

}  // namespace aomd::measure
