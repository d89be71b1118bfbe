#pragma once
// In which order a pass goes through the edges, faces or vertices of a surface in parts.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
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
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

  /// A pass over all entities of a level, 0 or 2. T(2,0) must be stored.
  void begin(const Mesh& mesh, int level, std::size_t parts, int threads);
  /// A pass over other ids, as long as they are alive; corners(id) has the vertices of each. It
  /// takes away so many faces at most: each part may have its share of them, and the last few go
  /// alone, where it is for others to stop.
  template <typename Corners>
  void begin(const Mesh& mesh, const IdPool& ids, const Corners& corners, std::size_t parts,
             int threads, std::uint64_t faces = unlimited) {
    find_places_ = [&ids, corners](const Partition& partition, std::span<const std::uint32_t> of,
                                   std::uint16_t* places) {
      for (const std::uint32_t id : of)
        *places++ = ids.alive(id) ? place_of(partition, corners(id)) : on_seam;
    };
    begin_turns(mesh, ids, parts, threads, faces);
  }
  /// The id whose turn it is; no_index at the end.
  [[nodiscard]] std::uint32_t next(const Mesh& mesh, int threads);
  /// The next id of a part; no_index where it has none any more. It may have died meanwhile.
  [[nodiscard]] std::uint32_t next_of(std::size_t part) {
    Part& p = parts_[part];
    return p.turn < p.ids.size() && p.taken + faces_each <= p.share ? p.ids[p.turn++] : no_index;
  }

  /// Whether it is a part's turn, which must not touch the seam; and which part's.
  [[nodiscard]] bool in_part() const { return !alone() && part_ < parts_.size(); }
  [[nodiscard]] std::size_t part() const { return part_; }
  [[nodiscard]] const Partition& partition() const { return partition_; }
  /// A part leaves an entity to who comes after, since the seam is in the way.
  void leave(std::size_t part, std::uint32_t id);
  /// How many faces a part has taken away.
  void took(std::size_t part, std::size_t faces) { parts_[part].taken += faces; }
  /// All parts of the present cut are done. What had no turn is left, too.
  void end_parts();
  /// The surface was changed from outside: what is left of the pass is done alone.
  void give_up_parts();
  /// How much of the pass is done, in [0,1].
  [[nodiscard]] double progress() const;

 private:
  struct alignas(64) Part {
    std::vector<std::uint32_t> ids;
    std::size_t turn = 0;
    std::vector<std::uint32_t> left;
    std::uint64_t share = unlimited, taken = 0;  ///< of the faces that may go
  };
  static constexpr int cuts = 2;
  static constexpr std::uint64_t faces_each = 2;  ///< that go with most collapses
  [[nodiscard]] bool alone() const { return cut_ >= cuts; }
  static constexpr std::uint16_t on_seam = 0xFFFF;
  template <std::size_t N>
  [[nodiscard]] static std::uint16_t place_of(const Partition& partition,
                                              const std::array<Vertex, N>& corners) {
    const std::size_t part = partition.part_of(corners[0]);
    for (const Vertex v : corners)
      if (partition.on_seam(v) || partition.part_of(v) != part) return on_seam;
    return static_cast<std::uint16_t>(part);
  }
  void begin_turns(const Mesh& mesh, const IdPool& ids, std::size_t parts, int threads,
                   std::uint64_t faces);
  bool cut_again(const Mesh& mesh, int threads);
  void deal_out(int threads);
  void share_out();

  const IdPool* ids_ = nullptr;
  /// The part that each id lies in.
  std::function<void(const Partition&, std::span<const std::uint32_t>, std::uint16_t*)>
      find_places_;
  std::size_t count_ = 1;  ///< of the parts of a cut
  int cut_ = 0;            ///< past the last one: alone
  std::uint64_t faces_ = unlimited;
  std::size_t all_ = 0;  ///< that the pass began with
  Partition partition_;
  std::vector<Part> parts_;  ///< one for who is alone
  std::size_t part_ = 0;
  std::vector<std::uint32_t> left_;  ///< by the cuts before
};

}  // namespace aomd
