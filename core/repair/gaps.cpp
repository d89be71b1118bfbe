#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "core/repair/around.h"
#include "core/repair/near_points.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// Gaps are less than this share of the median border edge: what is wider may be meant.
constexpr double widest_gap = 0.1;
constexpr double bins_a_decade = 4;

double median_border_edge(const Surface& surface) {
  std::vector<double> lengths;
  EdgeUses(surface).each([&](std::span<const EdgeUses::Use> uses) {
    const std::uint32_t c = uses[0].corner();
    if (uses.size() == 1)
      lengths.push_back(glm::distance(surface.position(surface.vertex(c)),
                                      surface.position(surface.vertex(surface.next(c)))));
  });
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// The distance of each border vertex to the nearest other one that no face has as well, where that
// is at most `limit`.
std::vector<double> border_gaps(const Surface& surface, const std::vector<std::uint32_t>& border,
                                const NearPoints& points, double limit) {
  const Around around(surface);
  std::vector<double> gaps;
  for (const std::uint32_t v : border) {
    double least = std::numeric_limits<double>::infinity();
    points.each_near(surface.position(v), [&](std::uint32_t u) {
      const double d = glm::distance(surface.position(u), surface.position(v));
      if (u != v && d < least && !around.meet(v, u)) least = d;
    });
    if (least > 0 && least <= limit) gaps.push_back(least);
  }
  return gaps;
}

// The gaps between borders within a limit that is a quarter, a sixteenth and so on of the widest:
// where borders are crowded only what is close enough to tell neighbours apart.
std::vector<double> border_gaps(const Surface& surface, double limit) {
  constexpr std::size_t most_a_cell = 32, least_share = 100;
  constexpr int most_rounds = 20;
  const std::vector<std::uint32_t> border = border_vertices(surface);
  for (int round = 0; round < most_rounds; ++round, limit /= 4) {
    NearPoints points(limit, most_a_cell);
    for (const std::uint32_t v : border) points.add(v, surface.position(v));
    if (points.dropped() * least_share <= border.size())
      return border_gaps(surface, border, points, limit);
  }
  return {};
}

// A value rounded to two digits, and never down.
double rounded_up(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(1.001 * value / unit) * unit;
}

}  // namespace

double gap_tolerance(const Surface& surface) {
  const double limit = widest_gap * median_border_edge(surface);
  if (!(limit > 0) || !std::isfinite(limit)) return 0;
  std::map<int, std::vector<double>> histogram;
  for (const double gap : border_gaps(surface, limit))
    histogram[static_cast<int>(std::floor(bins_a_decade * std::log10(gap)))].push_back(gap);
  if (histogram.empty()) return 0;
  auto bin = std::max_element(histogram.begin(), histogram.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  for (auto next = std::next(bin); next != histogram.end() && next->first == bin->first + 1; ++next)
    bin = next;
  return rounded_up(*std::max_element(bin->second.begin(), bin->second.end()));
}

}  // namespace aomd::repair_detail
