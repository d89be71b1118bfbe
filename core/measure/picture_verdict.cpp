#include "core/measure/picture_verdict.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/base/text.h"
#include "core/measure/ssim.h"

namespace aomd::measure {
namespace {

constexpr int tile_size = PictureVerdict::tile_size;
constexpr double edge_budget = 1.0 / 256;  ///< of a tile, in pixels from black to white

int largest_difference(const std::uint8_t* p, const std::uint8_t* q) {
  int largest = 0;
  for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(int{p[c]} - int{q[c]}));
  return largest;
}

void copy_pixel(const io::Image& from, io::Image& to, int x, int y) {
  std::copy_n(from.pixel(x, y), 4, to.pixel(x, y));
}

/// The part of an area that lies in the picture.
PixelArea clipped(const PixelArea& area, const io::Image& image) {
  const int left = std::clamp(area.x, 0, image.width), top = std::clamp(area.y, 0, image.height);
  const auto end = [](int start, int length, int most) {
    return static_cast<int>(std::clamp<long long>(0LL + start + length, 0, most));
  };
  return {left, top, std::max(0, end(area.x, area.width, image.width) - left),
          std::max(0, end(area.y, area.height, image.height) - top)};
}

template <typename Visit>
void for_each_pixel(const PixelArea& area, Visit&& visit) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) visit(x, y);
}

/// Whether each channel of a pixel lies between the least and the greatest that the other picture
/// has within one pixel of it, or beyond by a quarter of what these differ by: so much more or less
/// of a thin line may fall into one pixel.
bool explained(const std::uint8_t* p, const io::Image& other, int x, int y) {
  std::array<std::uint8_t, 4> low{255, 255, 255, 255}, high{};
  for (int v = std::max(0, y - 1); v <= std::min(other.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(other.width - 1, x + 1); ++u) {
      const std::uint8_t* q = other.pixel(u, v);
      for (std::size_t c = 0; c < 4; ++c) {
        low[c] = std::min(low[c], q[c]);
        high[c] = std::max(high[c], q[c]);
      }
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    const int beyond = (high[c] - low[c]) / 4;
    if (p[c] < low[c] - beyond || p[c] > high[c] + beyond) return false;
  }
  return true;
}

/// The result as it is compared: forgiven pixels are those of the baseline.
class Forgiveness {
 public:
  Forgiveness(const io::Image& baseline, const io::Image& result, const PictureLimits& limits)
      : baseline_(baseline), result_(result), forgiven_(result), judged_(result.pixel_count()) {
    for (const PixelArea& mask : limits.masks) apply_mask(clipped(mask, result));
    judged_ -= static_cast<std::size_t>(std::count(masked_.begin(), masked_.end(), true));
    if (baseline == result) return;  // as most are: nothing is left to be forgiven
    forgive_noise(limits.noise);
    for (int y = 0; limits.edges && y < result.height; y += tile_size)
      for (int x = 0; x < result.width; x += tile_size)
        forgive_edges(clipped({x, y, tile_size, tile_size}, result));
  }

  [[nodiscard]] const io::Image& picture() const { return forgiven_; }
  [[nodiscard]] std::size_t judged() const { return judged_; }

 private:
  void apply_mask(const PixelArea& area) {
    masked_.resize(result_.pixel_count());
    for_each_pixel(area, [&](int x, int y) {
      copy_pixel(baseline_, forgiven_, x, y);
      masked_[static_cast<std::size_t>(y) * static_cast<std::size_t>(result_.width) +
              static_cast<std::size_t>(x)] = true;
    });
  }
  void forgive_noise(int noise) {
    for_each_pixel({0, 0, result_.width, result_.height}, [&](int x, int y) {
      if (largest_difference(baseline_.pixel(x, y), forgiven_.pixel(x, y)) <= noise)
        copy_pixel(baseline_, forgiven_, x, y);
    });
  }
  void forgive_edges(const PixelArea& tile) {
    std::vector<std::array<int, 2>> found;
    int sum = 0;
    for_each_pixel(tile, [&](int x, int y) {
      const int difference = largest_difference(baseline_.pixel(x, y), forgiven_.pixel(x, y));
      if (difference == 0 || !explained(result_.pixel(x, y), baseline_, x, y) ||
          !explained(baseline_.pixel(x, y), result_, x, y))
        return;
      found.push_back({x, y});
      sum += difference;
    });
    if (sum > edge_budget * 255 * tile.width * tile.height) return;
    for (const auto& [x, y] : found) copy_pixel(baseline_, forgiven_, x, y);
  }

  const io::Image& baseline_;
  const io::Image& result_;
  io::Image forgiven_;
  std::vector<bool> masked_;  ///< empty where nothing is masked
  std::size_t judged_;
};

void count_differences(const io::Image& a, const io::Image& b, PictureVerdict& verdict) {
  verdict.largest = 0;
  if (a == b) return;
  for_each_pixel({0, 0, a.width, a.height}, [&](int x, int y) {
    const int difference = largest_difference(a.pixel(x, y), b.pixel(x, y));
    if (difference > 0) ++verdict.differing;
    if (difference <= verdict.largest) return;
    verdict.largest = difference;
    verdict.largest_at = {x, y, 1, 1};
  });
}

/// A window counts for the tile that its middle lies in.
void find_worst_tile(const io::Image& a, const io::Image& b, PictureVerdict& verdict) {
  struct Sum {
    double values = 0;
    int count = 0;
  };
  const SsimWindows windows = ssim_windows(a, b);
  const auto tile_of = [](int start) { return (start + SsimWindows::size / 2) / tile_size; };
  const int tiles_in_row = tile_of(a.width) + 1;
  std::vector<Sum> tiles(static_cast<std::size_t>(tiles_in_row * (tile_of(a.height) + 1)));
  auto value = windows.values.begin();
  for (const int y : windows.rows) {
    for (const int x : windows.columns) {
      Sum& sum = tiles[static_cast<std::size_t>(tile_of(y) * tiles_in_row + tile_of(x))];
      sum.values += *value++;
      ++sum.count;
    }
  }
  verdict.worst_tile = 1;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (tiles[i].count == 0 || tiles[i].values / tiles[i].count >= verdict.worst_tile) continue;
    verdict.worst_tile = tiles[i].values / tiles[i].count;
    const int at = static_cast<int>(i);
    verdict.tile = clipped(
        {at % tiles_in_row * tile_size, at / tiles_in_row * tile_size, tile_size, tile_size}, a);
  }
}

std::string place(const PixelArea& area) {
  return std::to_string(area.x) + "," + std::to_string(area.y);
}

/// All that is beyond its limit.
std::string reasons(const PictureVerdict& verdict, const PictureLimits& limits) {
  std::vector<std::string> found;
  if (verdict.worst_tile < limits.threshold)
    found.push_back("the tile at " + place(verdict.tile) + " has a similarity of " +
                    number_text(verdict.worst_tile) + ", not " + number_text(limits.threshold));
  if (verdict.largest > limits.largest)
    found.push_back("the pixel at " + place(verdict.largest_at) + " differs by " +
                    std::to_string(verdict.largest) + " of 255, not " +
                    std::to_string(limits.largest) + " at most");
  if (verdict.share() > limits.share)
    found.push_back(counted(verdict.differing, "pixel") +
                    (verdict.differing == 1 ? " differs (" : " differ (") +
                    number_text(100 * verdict.share(), 3) + " %), not " +
                    number_text(100 * limits.share, 3) + " % at most");
  return joined(found, " and ");
}

}  // namespace

PictureLimits PictureLimits::exact() { return {1, 0, 0, 0, false, {}}; }

PictureLimits PictureLimits::with_threshold(double threshold) {
  if (threshold >= 1) return exact();
  PictureLimits limits;
  limits.threshold = threshold;
  return limits;
}

PictureVerdict judge_pictures(const io::Image& baseline, const io::Image& result,
                              const PictureLimits& limits) {
  PictureVerdict verdict;
  verdict.same_size = baseline.width == result.width && baseline.height == result.height;
  if (!verdict.same_size) {
    verdict.judged = verdict.differing = std::max(baseline.pixel_count(), result.pixel_count());
    verdict.why = "the sizes differ: " + std::to_string(baseline.width) + "x" +
                  std::to_string(baseline.height) + " and " + std::to_string(result.width) + "x" +
                  std::to_string(result.height);
    return verdict;
  }
  const Forgiveness forgiveness(baseline, result, limits);
  verdict.judged = forgiveness.judged();
  count_differences(baseline, forgiveness.picture(), verdict);
  verdict.worst_tile = 1;
  if (verdict.differing > 0) find_worst_tile(baseline, forgiveness.picture(), verdict);
  verdict.why = reasons(verdict, limits);
  verdict.same = verdict.why.empty();
  return verdict;
}

}  // namespace aomd::measure
