#include "core/fields/fitted_values.h"

#include <algorithm>
#include <cmath>

#include "core/base/buckets.h"

namespace aomd::fields {
namespace {

/// A point as seen from one corner of its triangle.
struct Share {
  std::uint32_t point;
  float weight, pull;  ///< of the corner; times the point's area
};

class Fit {
 public:
  Fit(std::size_t components, std::span<const FitPoint> points, const std::vector<bool>& is_free,
      std::span<const double> wanted, std::span<double> values)
      : n_(components),
        values_(values),
        start_(values.begin(), values.end()),
        low_(start_),
        high_(start_),
        off_(wanted.begin(), wanted.end()),
        sums_(components),
        around_(is_free.size(), [&](const auto& file) {
          for (std::uint32_t i = 0; i < points.size(); ++i)
            if (is_sound(points[i], i)) share_out(points[i], i, is_free, file);
        }) {
    find_ranges();
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < 3; ++j)
        add(i, -double(points[i].weights[static_cast<int>(j)]), &start_[n_ * points[i].corners[j]]);
  }

  /// One vertex after the other: what comes later looks at what came before.
  void pass() {
    for (std::size_t v = 0; v < around_.count(); ++v)
      if (!around_[v].empty()) improve(v);
  }

 private:
  [[nodiscard]] bool is_finite(const std::vector<double>& numbers, std::size_t i) const {
    double sum = 0;
    for (std::size_t k = 0; k < n_; ++k) sum += numbers[n_ * i + k];
    return std::isfinite(sum);
  }
  [[nodiscard]] bool is_sound(const FitPoint& point, std::size_t i) const {
    return point.area > 0 && is_finite(off_, i) && is_finite(start_, point.corners[0]) &&
           is_finite(start_, point.corners[1]) && is_finite(start_, point.corners[2]);
  }

  template <typename File>
  static void share_out(const FitPoint& point, std::uint32_t i, const std::vector<bool>& is_free,
                        const File& file) {
    for (std::size_t j = 0; j < 3; ++j) {
      const float weight = point.weights[static_cast<int>(j)];
      if (is_free[point.corners[j]] && weight > 0)
        file(std::size_t{point.corners[j]}, Share{i, weight, weight * point.area});
    }
  }

  void find_ranges() {
    for (std::size_t v = 0; v < around_.count(); ++v)
      for (const Share& share : around_[v])
        for (std::size_t k = 0; k < n_; ++k) {
          const double wanted = off_[n_ * share.point + k];
          low_[n_ * v + k] = std::min(low_[n_ * v + k], wanted);
          high_[n_ * v + k] = std::max(high_[n_ * v + k], wanted);
        }
  }

  void add(std::size_t point, double factor, const double* numbers) {
    for (std::size_t k = 0; k < n_; ++k) off_[n_ * point + k] += factor * numbers[k];
  }

  void improve(std::size_t v) {
    double pulls = 0, squares = 0;
    std::fill(sums_.begin(), sums_.end(), 0);
    for (const Share& share : around_[v]) {
      pulls += double(share.pull);
      squares += double(share.pull) * double(share.weight);
      for (std::size_t k = 0; k < n_; ++k)
        sums_[k] += double(share.pull) * off_[n_ * share.point + k];
    }
    const double hold = fit_hold * pulls;
    for (std::size_t k = 0; k < n_; ++k) {
      double& value = values_[n_ * v + k];
      const double change = (sums_[k] + hold * (start_[n_ * v + k] - value)) / (squares + hold);
      const double next = std::clamp(value + change, low_[n_ * v + k], high_[n_ * v + k]);
      sums_[k] = next - value;
      value = next;
    }
    for (const Share& share : around_[v]) add(share.point, -double(share.weight), sums_.data());
  }

  std::size_t n_;
  std::span<double> values_;
  std::vector<double> start_, low_, high_;  ///< of vertices
  std::vector<double> off_;                 ///< of points: what is wanted less what is there
  std::vector<double> sums_;                ///< by component; scratch
  Buckets<Share> around_;                   ///< by vertex
};

}  // namespace

void fit_values(std::size_t components, std::span<const FitPoint> points,
                const std::vector<bool>& is_free, std::span<const double> wanted,
                std::span<double> values) {
  constexpr int passes = 2;  // most of what there is to gain comes with the first
  Fit fit(components, points, is_free, wanted, values);
  for (int pass = 0; pass < passes; ++pass) fit.pass();
}

}  // namespace aomd::fields
