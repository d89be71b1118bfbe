#pragma once
// The numbers of a run, as JSON (schema 1) and as text.

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/decimate/decimation.h"
#include "core/measure/statistics.h"
#include "core/measure/volume_statistics.h"

namespace aomd::cli {

using Json = nlohmann::ordered_json;

/// Counts of one mesh with the file it belongs to: "input" and "output" of a report.
[[nodiscard]] Json counts_json(const std::string& file, const measure::Counts& counts);

/// "quality": angles of a surface; the entries about regions are null without regions.
[[nodiscard]] Json quality_json(const measure::Quality& quality);
/// Fills in what only meshes with regions have.
void add_volume_quality(Json& quality, const measure::VolumeQuality& volume);

/// "sweeps": what each did and what it refused, by reason.
[[nodiscard]] Json sweeps_json(const std::vector<SweepStatistics>& sweeps);

/// Largest memory of this process so far, in bytes.
[[nodiscard]] std::size_t peak_bytes();

/// Gives freed memory back to the system, so that what one stage of work needs does not add to what
/// the next one does. Within another program only: that of `aomd` goes back by itself (main.cpp).
void give_back_memory();

/// JSON as text that ends with a newline: indented, or all in one line.
[[nodiscard]] std::string text_of(const Json& json, bool in_one_line = false);

/// Measures stages of work by the wall clock.
class Stopwatch {
 public:
  /// Seconds since construction or the last lap.
  double lap();
  /// Seconds since construction.
  [[nodiscard]] double total() const { return seconds(start_); }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] static double seconds(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  }
  Clock::time_point start_ = Clock::now(), lap_ = start_;
};

}  // namespace aomd::cli
