#pragma once
// Edge and face removals around poor tetrahedra, judged by several threads before their turn comes.

#include <cstdint>
#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/column.h"
#include "core/mesh/id_pool.h"
#include "core/operators/edge_removal.h"
#include "core/operators/face_removal.h"

namespace aomd {

/// Which of the six edges and four faces of a tetrahedron are worth judging at its turn. The others
/// were refused for what lies around them, which holds until a removal changes a tetrahedron there:
/// each of those has both ends of the edge, or the corners of the face. Positions must not change
/// meanwhile. Whether two vertices are joined elsewhere is no such reason. Where removals follow
/// each other closely little holds for long, and what was judged ahead would be judged twice: then
/// it leaves some tetrahedra to their turn.
class RemovalsAhead {
 public:
  /// Bit i: the i-th of all removals, edges first.
  using Removals = std::uint16_t;
  static constexpr Removals all = 0x3ff;

  /// Nothing is known any more.
  void forget() {
    begin_ = end_ = 0;
    asked_ = saved_ = 0;
    rests_ = 0;
  }
  [[nodiscard]] bool covers(Region r) const { return begin_ <= r.index && r.index < end_; }
  /// Judges what is alive from an id on, as far as it is `wanted`, which threads ask at once; or
  /// nothing, where that did not pay before.
  template <typename Wanted>
  void judge(const Mesh& mesh, std::uint32_t from, const RemovalRules& rules, int threads,
             const Wanted& wanted) {
    begin(mesh, from, threads);
    if (rests_ == 0)
      parallel_for(end_ - begin_, threads, regions_a_piece,
                   [&](std::size_t first, std::size_t last) {
                     EdgeRemoval edge;
                     FaceRemoval face;
                     each_alive(mesh.ids(3), begin_ + first, begin_ + last, [&](std::uint32_t id) {
                       if (wanted(Region(id)))
                         open_[id - begin_] = worth_judging(mesh, Region(id), rules, edge, face);
                     });
                   });
  }
  [[nodiscard]] Removals of(const Mesh& mesh, Region r);

  /// A removal was made: the vertices of the tetrahedra that it changed.
  void changed(const EdgeRemoval& plan);
  void changed(const FaceRemoval& plan);

 private:
  static constexpr std::uint32_t batch = 16'384;  ///< 10 ms of work
  static constexpr std::size_t regions_a_piece = 256;
  void begin(const Mesh& mesh, std::uint32_t from, int threads);
  [[nodiscard]] static Removals worth_judging(const Mesh& mesh, Region r, const RemovalRules& rules,
                                              EdgeRemoval& edge, FaceRemoval& face);
  void touch(Vertex v) {
    if (begin_ < end_) touched_[v] = stamp_;
  }

  std::uint32_t begin_ = 0, end_ = 0;  ///< ids that are covered
  std::vector<Removals> open_;
  Column<Vertex, std::uint32_t> touched_;  ///< == stamp_: since they were judged
  std::uint32_t stamp_ = 0;
  std::uint64_t asked_ = 0, saved_ = 0;  ///< judgements of this batch, at their turn
  int rests_ = 0;                        ///< batches that are left to their turn
};

}  // namespace aomd
