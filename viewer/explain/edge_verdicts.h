#pragma once
// Why each edge would be refused now: what the colours of `color verdict` and `select refused`
// read.

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/decimate/decimation.h"
#include "core/mesh/column.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/edge_codes.h"

namespace aomd::scene {

/// A reason as commands name it, the keys of reports in small letters: "angle".
[[nodiscard]] std::string reason_word(Reason reason);
/// Judges edges in slices of time, first all of them, then those whose surroundings have changed.
class EdgeVerdicts {
 public:
  /// All edges wait to be judged again.
  void start(const Mesh& mesh);
  /// Only those that changes have touched do: at vertices whose faces have changed.
  void note(const Mesh& mesh, const SurfaceChanges& changes);
  /// Goes on for about `budget`, without one to the end. Returns the edges whose code is another
  /// one now. About 2 us an edge, and what guards cost.
  std::vector<Edge> judge(Decimation& decimation, const Mesh& mesh,
                          std::optional<std::chrono::microseconds> budget);

  [[nodiscard]] bool pending() const { return next_ < queue_.size(); }
  [[nodiscard]] std::shared_ptr<const EdgeCodes> codes() const { return codes_; }
  /// How many edges each code has.
  [[nodiscard]] const std::array<std::int64_t, unjudged + 1>& counts() const { return counts_; }

 private:
  void set(Edge e, std::uint8_t code);

  std::shared_ptr<EdgeCodes> codes_ = std::make_shared<EdgeCodes>();
  std::array<std::int64_t, unjudged + 1> counts_{};
  std::vector<Edge> queue_;
  std::size_t next_ = 0;
};

}  // namespace aomd::scene
