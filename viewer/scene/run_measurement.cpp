#include "viewer/scene/run_measurement.h"

#include "core/measure/distance.h"
#include "core/mesh/mesh.h"

namespace aomd::scene {

RunMeasurement::RunMeasurement(MeshData original, double unit, std::vector<MeasuredRun> runs) {
  state_->runs = std::move(runs);
  const auto measure_all = [state = state_, data = std::move(original), unit](const std::stop_token& stop) {
    try {
      const Mesh mesh(data);
      const measure::Surface before(mesh);
      for (MeasuredRun& run : state->runs) {
        if (stop.stop_requested()) break;
        const Mesh result(*run.data);
        const auto distance = measure::mutual_distance(before, measure::Surface(result), samples);
        run.distance = {100 * distance.rms() / unit, 100 * distance.max() / unit};
      }
    } catch (...) {
      state->error = std::current_exception();
    }
    state->finished = true;
  };
  thread_ = std::jthread(measure_all);
}

const std::vector<MeasuredRun>& RunMeasurement::results() const {
  if (state_->error) std::rethrow_exception(state_->error);
  return state_->runs;
}

}  // namespace aomd::scene
