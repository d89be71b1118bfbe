#pragma once
// In which order a pass goes through the faces or vertices of a surface in parts.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/parts/partition.h"

namespace aomd {

/// Every part goes through what lies inside it, in the order of ids. Then the surface is cut
/// elsewhere, and the new parts do what lay on the seams of the first; what lies on both comes last
/// and alone. What the parts of a cut do does not depend on each other: they may do it one after
/// the other or at once.
class PassTurns {
 public:
  /// A pass over all entities of a level, 0 or 2. T(2,0) must be stored.
  void begin(const Mesh& mesh, int level, std::size_t parts, int threads);
  /// The id whose turn it is; no_index at the end.
  [[nodiscard]] std::uint32_t next(const Mesh& mesh, int threads);
  /// The next id of a part; no_index where it has none any more.
  [[nodiscard]] std::uint32_t next_of(std::size_t part) {
    Part& p = parts_[part];
    return p.turn < p.ids.size() ? p.ids[p.turn++] : no_index;
  }

  /// Whether it is a part's turn, which must not touch the seam; and which part's.
  [[nodiscard]] bool in_part() const { return !alone() && part_ < parts_.size(); }
  [[nodiscard]] std::size_t part() const { return part_; }
  [[nodiscard]] const Partition& partition() const { return partition_; }
  /// A part leaves an entity to who comes after, since the seam is in the way.
  void leave(std::size_t part, std::uint32_t id);
  /// All parts of the present cut are done.
  void end_parts();
  /// The surface was changed from outside: what is left of the pass is done alone.
  void give_up_parts();

 private:
  struct alignas(64) Part {
    std::vector<std::uint32_t> ids;
    std::size_t turn = 0;
    std::vector<std::uint32_t> left;
  };
  static constexpr int cuts = 2;
  [[nodiscard]] bool alone() const { return cut_ >= cuts; }
  bool cut_again(const Mesh& mesh, int threads);
  void deal_out(const Mesh& mesh);
  [[nodiscard]] bool is_inside(const Mesh& mesh, std::uint32_t id) const;
  [[nodiscard]] std::size_t part_of(const Mesh& mesh, std::uint32_t id) const;

  int level_ = 0;
  std::size_t count_ = 1;  ///< of the parts of a cut
  int cut_ = 0;            ///< past the last one: alone
  Partition partition_;
  std::vector<Part> parts_;  ///< one for who is alone
  std::size_t part_ = 0;
  std::vector<std::uint32_t> left_;  ///< by the cuts before
};

}  // namespace aomd
