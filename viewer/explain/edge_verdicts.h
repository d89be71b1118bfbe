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
#include "viewer/drawing/palette.h"

namespace aomd::scene {

/// By edge: a Reason, or `unjudged`. Four bits of CornerFlag hold one.
using EdgeCodes = Column<Edge, std::uint8_t>;
inline constexpr std::uint8_t unjudged = 15;
static_assert(reason_count <= unjudged);

/// A reason as commands name it, the keys of reports in small letters: "angle".
[[nodiscard]] std::string reason_word(Reason reason);
/// The colour of an edge with this code; safe for colour-blind eyes as far as eleven can be.
[[nodiscard]] Color verdict_color(std::uint8_t code);

/// Judges edges in slices of time, first all of them, then those whose surroundings have changed.
class VerdictField {
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
