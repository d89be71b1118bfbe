#include "viewer/document/run_measurement.h"

#include <utility>

#include "core/measure/distance.h"
#include "core/mesh/mesh.h"

namespace aomd::scene {

std::unique_ptr<Background<std::vector<MeasuredRun>>> start_measuring(
    MeshData original, double unit, std::vector<MeasuredRun> runs) {
  return std::make_unique<Background<std::vector<MeasuredRun>>>(
      [data = std::move(original), unit, runs = std::move(runs)](const std::stop_token& stop,
                                                                 std::atomic<double>&) mutable {
        const Mesh mesh(data);
        const measure::Surface before(mesh);
        for (MeasuredRun& run : runs) {
          if (stop.stop_requested()) break;
          const Mesh result(*run.data);
          const auto distance =
              measure::mutual_distance(before, measure::Surface(result), run_samples);
          run.distance = {100 * distance.rms() / unit, 100 * distance.max() / unit};
        }
        return std::move(runs);
      });
}

}  // namespace aomd::scene
