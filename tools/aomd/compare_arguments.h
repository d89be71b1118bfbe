#pragma once
// What `aomd compare` is asked, of surfaces and of volumes.

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/measure/distance.h"

namespace aomd::cli {

struct CompareArguments {
  std::string original, result;
  bool json = false, same_topology = false, quiet = false;
  std::size_t samples = 500'000;
  int threads = 0;  ///< 0: all cores
  std::optional<double> max_distance, max_rms;
  std::optional<std::size_t> max_flips, max_intersections;
};

/// The largest distance between two surfaces in percent of the original's diagonal, as `aomd
/// compare` measures it unless told otherwise.
[[nodiscard]] double largest_distance_pct(const measure::Surface& original, const Mesh& result,
                                          int threads);

/// Collects what goes beyond the limits that were given, one sentence each.
class Objections {
 public:
  template <typename Limit, typename Value>
  void limit(const Limit& largest, Value value, const char* what, const char* unit) {
    if (!largest || value <= *largest) return;
    std::ostringstream text;
    text << what << " " << value << unit << " is above the limit of " << *largest << unit;
    list_.push_back(text.str());
  }
  void add(const std::string& sentence) { list_.push_back(sentence); }
  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }

 private:
  std::vector<std::string> list_;
};

}  // namespace aomd::cli
