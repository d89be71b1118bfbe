#pragma once
// The paper's two ways to store adjacencies during decimation (its section 4), measured on a mesh:
// T(0,1) and T(0,2) kept throughout, or T(0,2) given up for T(0,1) and T(1,2) whenever edges are
// swapped and vertices smoothed.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/decimate/options.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_data.h"
#include "viewer/base/background.h"

namespace aomd::scene {

/// What the collapses, or the swaps and smoothing, of one way came to.
struct StoragePart {
  double ms = 0;
  std::size_t bytes = 0;  ///< of adjacencies and hash sets, at the end of the part's last phase
  std::size_t peak = 0;   ///< the most of it, looked at every 64 candidates
};

struct StorageRun {
  StoragePart collapses, improvement;
  std::uint32_t exchanges = 0;            ///< how often relations made way for others
  std::array<std::uint32_t, 3> counts{};  ///< vertices, edges, faces of the result

  [[nodiscard]] double ms() const { return collapses.ms + improvement.ms; }
  [[nodiscard]] std::size_t peak() const { return std::max(collapses.peak, improvement.peak); }
};

struct StorageComparison {
  std::array<StorageRun, 2> ways;  ///< keep, exchange
  bool same = false;               ///< both led to the same mesh: entities, vertices and positions
};

/// "Keep T(0,2)", "Exchange it"
inline constexpr std::array<const char*, 2> way_names = {"Keep T(0,2)", "Exchange it"};

/// Both ways on the calling thread. `going_on` is told the progress, 0..1, now and then; where it
/// says no, this returns early with what there is.
[[nodiscard]] StorageComparison compare_storage(const MeshData& data,
                                                const DecimationOptions& options,
                                                const std::function<bool(double)>& going_on = {});

/// Both ways on copies of the mesh, in the background, with these options by the paper's strategy;
/// no model is snapped to. O(size) on the calling thread.
[[nodiscard]] std::unique_ptr<Background<StorageComparison>> start_comparing(
    const Mesh& mesh, const DecimationOptions& options);

/// A line of titles, then one line a way and part; columns separated by tabs.
[[nodiscard]] std::string storage_table(const StorageComparison& result);
[[nodiscard]] std::string storage_json(const StorageComparison& result);

}  // namespace aomd::scene
