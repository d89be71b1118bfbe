#pragma once
// What does not fit together in a volume: named before a run, and held against the result.

#include <optional>
#include <string>
#include <vector>

#include "core/measure/statistics.h"

namespace aomd::cli {

/// How much of each kind there is; `aomd check` names each.
struct VolumeFaults {
  /// `counts` are those of the mesh.
  VolumeFaults(const Mesh& mesh, const measure::Counts& counts);

  std::size_t regions;
  std::size_t inverted = 0;  ///< regions whose volume is zero or negative
  std::size_t crowded;       ///< faces of three or more regions
  std::size_t folded;        ///< faces of two regions on one side of them
};

/// Notes on what there is; `kind` is what the regions are called.
[[nodiscard]] std::vector<std::string> notes_of(const VolumeFaults& faults, const char* kind);

/// What a result has more of than its input, in words: no operation makes any.
[[nodiscard]] std::optional<std::string> made_worse(const VolumeFaults& before,
                                                    const VolumeFaults& after);

}  // namespace aomd::cli
