#pragma once
// How far kept states are from the mesh as loaded, measured in the background.

#include <atomic>
#include <exception>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::scene {

/// The larger of both ways, percent of the diagonal of the box of the mesh as loaded.
struct RunDistance {
  double rms_pct = 0;
  double max_pct = 0;
};

/// One state: its number and its mesh, and what came out.
struct MeasuredRun {
  unsigned number = 0;
  std::shared_ptr<const MeshData> data;
  RunDistance distance;
};

/// Measures one after the other on copies in a thread of its own: see measure::mutual_distance.
class RunMeasurement {
 public:
  static constexpr std::size_t samples = 100'000;  ///< on each surface, besides all vertices

  /// `unit` is the length that is 100 %.
  RunMeasurement(MeshData original, double unit, std::vector<MeasuredRun> runs);
  /// Waits for the one that is being measured.
  ~RunMeasurement() = default;
  RunMeasurement(const RunMeasurement&) = delete;
  RunMeasurement& operator=(const RunMeasurement&) = delete;

  [[nodiscard]] bool finished() const { return state_->finished; }
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  /// Once finished. Throws what measuring threw.
  [[nodiscard]] const std::vector<MeasuredRun>& results() const;

 private:
  struct State {
    std::atomic<bool> finished = false;
    std::vector<MeasuredRun> runs;
    std::exception_ptr error;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
  std::jthread thread_;  ///< last: stopped and joined before the rest goes
};

}  // namespace aomd::scene
