#pragma once
// The adjacency status tensor T(I,J) (paper, section 2) and the relations that it says are stored.

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/relation.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Which relations are stored, who wants them, and their rows. Mesh owns one and keeps it true.
class Representation {
 public:
  [[nodiscard]] bool stored(int i, int j) const {
    return i > j ? down(i, j).stored() : up(i, j).stored();
  }
  [[nodiscard]] std::size_t bytes(int i, int j) const {
    return i > j ? down(i, j).bytes() : up(i, j).bytes();
  }
  /// Downward rows, i > j.
  [[nodiscard]] const DownRows& down(int i, int j) const { return down_[index(i, j)]; }
  [[nodiscard]] DownRows& down(int i, int j) { return down_[index(i, j)]; }
  /// Upward rows, i < j.
  [[nodiscard]] const UpRows& up(int i, int j) const { return up_[index(j, i)]; }
  [[nodiscard]] UpRows& up(int i, int j) { return up_[index(j, i)]; }

  /// How many entities a stored row has, on average; for downward rows at most.
  [[nodiscard]] double average_row(int i, int j) const {
    if (i > j) return down(i, j).stride();
    const UpRows& rows = up(i, j);
    return rows.rows() == 0
               ? 0
               : static_cast<double>(rows.entries()) / static_cast<double>(rows.rows());
  }

  /// Who keeps a relation alive: the user (set), algorithms (requests), or both.
  struct Demand {
    bool user = false;
    int requests = 0;
    std::vector<const char*> by = {};  ///< the names that the requests gave, in their order
    [[nodiscard]] bool wanted() const { return user || requests > 0; }
  };
  [[nodiscard]] const Demand& demand(int i, int j) const { return demand_[at(i, j)]; }
  [[nodiscard]] Demand& demand(int i, int j) { return demand_[at(i, j)]; }

  /// What became of a relation since the mesh was made.
  struct Record {
    std::uint32_t builds = 0, frees = 0;
    double build_ms = 0;          ///< what the last building took
    std::size_t freed_bytes = 0;  ///< what the last freeing gave back
  };
  [[nodiscard]] const Record& record(int i, int j) const { return records_[at(i, j)]; }
  [[nodiscard]] Record& record(int i, int j) { return records_[at(i, j)]; }

  /// True when some downward relation of the level is stored: its entities exist in the database.
  [[nodiscard]] bool has_level(int level) const {
    if (level == 0) return true;
    for (int j = 0; j < level; ++j)
      if (down(level, j).stored()) return true;
    return false;
  }

 private:
  static constexpr std::size_t index(int high, int low) {  // (1,0) (2,0) (2,1) (3,0) (3,1) (3,2)
    constexpr std::uint8_t places[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 5, 0};
    return places[at(high, low)];
  }
  static constexpr std::size_t at(int i, int j) {
    return static_cast<std::size_t>(4 * i + j) & 15u;
  }

  std::array<DownRows, 6> down_;
  std::array<UpRows, 6> up_;
  std::array<Demand, 16> demand_{};
  std::array<Record, 16> records_{};
};

}  // namespace aomd

#pragma GCC visibility pop
