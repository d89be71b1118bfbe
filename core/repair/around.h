#pragma once
// The faces at each vertex, kept while single faces change.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/repair/surface.h"

namespace aomd::repair_detail {

/// How many faces have a side, and the first two of them.
class AtSide {
 public:
  void add(std::uint32_t face) {
    if (count_++ < first_.size()) first_[count_ - 1] = face;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::span<const std::uint32_t> first() const {
    return {first_.data(), std::min(count_, first_.size())};
  }

 private:
  std::array<std::uint32_t, 2> first_{};
  std::size_t count_ = 0;
};

/// Corners of faces around vertices. Reading everything once is O(faces); each change is O(1), and
/// what it costs to close the gaps that it leaves is paid when the row is read next.
class Around {
 public:
  explicit Around(const Surface& surface);

  /// The corners of living faces at a vertex. Valid until the next change.
  [[nodiscard]] std::span<const std::uint32_t> corners(std::uint32_t v) const;
  /// How many there are.
  [[nodiscard]] std::size_t count(std::uint32_t v) const;
  /// The living faces at both.
  [[nodiscard]] std::vector<std::uint32_t> faces(std::uint32_t a, std::uint32_t b) const;
  /// Whether there are any.
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const;
  /// The faces that have a side from a to b or from b to a.
  [[nodiscard]] AtSide at_side(std::uint32_t a, std::uint32_t b) const;
  /// The vertices that sides connect with v: one for each of the two sides of a face there.
  [[nodiscard]] std::vector<std::uint32_t> met(std::uint32_t v) const;
  /// The vertices that a side connects with v, each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  /// True when a side at v has one face only.
  [[nodiscard]] bool at_border(std::uint32_t v) const;

  /// A corner comes last at its vertex.
  void add(std::uint32_t corner);
  /// A corner is no longer at its vertex, which it still has.
  void remove(std::uint32_t corner);

 private:
  struct Row {
    std::vector<std::uint32_t> corners;  ///< no_index: a gap
    std::uint32_t gaps = 0;
  };
  template <typename Visit>
  void each_face(std::uint32_t a, std::uint32_t b, Visit&& visit) const;
  Row& changed(std::uint32_t v);
  void close_gaps(Row& row) const;

  const Surface& surface_;
  std::vector<std::uint32_t> begin_, corners_;  ///< as read
  std::vector<std::uint32_t> changed_at_;       ///< of each vertex, in rows_; empty until a change
  mutable std::vector<Row> rows_;               ///< those that changed
  mutable std::vector<std::uint32_t> place_;    ///< of each corner in its row that changed
};

}  // namespace aomd::repair_detail
