#pragma once
// How far kept states are from the mesh as loaded, measured in the background.

#include <memory>
#include <vector>

#include "core/mesh/mesh_data.h"
#include "viewer/base/background.h"

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

inline constexpr std::size_t run_samples = 100'000;  ///< on each surface, besides all vertices

/// Measures one after the other on copies, in the background: see measure::mutual_distance. `unit`
/// is the length that is 100 %. Stopped, it ends after the one that is being measured.
[[nodiscard]] std::unique_ptr<Background<std::vector<MeasuredRun>>> start_measuring(
    MeshData original, double unit, std::vector<MeasuredRun> runs);

}  // namespace aomd::scene
