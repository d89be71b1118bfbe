#pragma once
// How coarse a surface may become within an error that is measured on each result: a search over
// what the distance guard is told.

#include <cstdint>
#include <limits>
#include <optional>

namespace aomd {

/// Finds the limit of a distance guard with which a decimation ends as coarse as possible and with
/// a measured error within `limit`. The guard holds the result against the original, not the
/// original against the result, so that the error follows it up to a factor and some noise. Who
/// searches makes a run for each guard that next() names, and tells it what came out.
class ErrorSearch {
 public:
  explicit ErrorSearch(double limit) : limit_(limit) {}

  /// The guard to try next; none when it is over.
  [[nodiscard]] std::optional<double> next() const;
  /// A run with this guard ended at so many faces, with this error.
  void tried(double guard, std::uint32_t faces, double error);

  /// The guard whose run kept to the limit with the fewest faces; none where no run did.
  [[nodiscard]] std::optional<double> best() const { return best_; }
  [[nodiscard]] int tries() const { return tries_; }

 private:
  double limit_;
  double fits_ = 0, fails_ = std::numeric_limits<double>::infinity();  ///< it looks between these
  double guard_ = 0, error_ = 0;                                       ///< of the last run
  std::optional<double> best_;
  std::uint32_t best_faces_ = 0;
  bool met_ = false;  ///< nearly at the limit, or something else than the guard stops the runs
  int tries_ = 0;
};

}  // namespace aomd
