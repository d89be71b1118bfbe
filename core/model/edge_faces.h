#pragma once
// The faces of all edges of a surface, for algorithms that look at each once: made in one pass over
// the faces, where T(1,2) is filled in two and keeps rows that can grow.

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd {

/// Up to two faces of each edge in place, further ones aside. Valid until the next edit.
class EdgeFaces {
 public:
  /// T(2,1) must be stored. O(entities).
  explicit EdgeFaces(const Mesh& mesh);

  /// How many there are; 3 stands for more, too.
  [[nodiscard]] int count(Edge e) const {
    const Pair& pair = pairs_[e.index];
    if (!pair.second.valid()) return pair.first.valid() ? 1 : 0;
    return pair.second.goes_on() ? 3 : 2;
  }
  /// The two with the smallest ids, in ascending order. There must be as many.
  [[nodiscard]] Face first(Edge e) const { return pairs_[e.index].first.face(); }
  [[nodiscard]] Face second(Edge e) const { return pairs_[e.index].second.face(); }
  /// Of two faces the other one.
  [[nodiscard]] Face across(Edge e, Face from) const {
    return first(e) == from ? second(e) : first(e);
  }
  /// Whether these two use the edge in the same direction, and so look to different sides.
  [[nodiscard]] bool same_direction(Edge e) const {
    return pairs_[e.index].first.along() == pairs_[e.index].second.along();
  }
  /// Calls visit(Face) for all of them, in ascending order.
  template <typename Visit>
  void each(Edge e, Visit&& visit) const {
    const Pair& pair = pairs_[e.index];
    if (pair.first.valid()) visit(pair.first.face());
    if (!pair.second.valid()) return;
    visit(pair.second.face());
    if (pair.second.goes_on())
      for (const auto& other : others_of(e)) visit(other.second);
  }
  /// The same for all but one of them.
  template <typename Visit>
  void each_other(Edge e, Face from, Visit&& visit) const {
    const Pair& pair = pairs_[e.index];
    if (pair.second.valid() && !pair.second.goes_on()) return visit(across(e, from));
    each(e, [&](Face f) {
      if (f != from) visit(f);
    });
  }

 private:
  // A face, whether it uses the edge in the edge's own direction, and whether others follow.
  class Use {
   public:
    Use() = default;
    Use(Face f, bool along) : bits_(f.index << 2 | std::uint32_t{along}) {}
    void go_on() { bits_ |= 2u; }
    [[nodiscard]] bool valid() const { return bits_ != no_index; }
    [[nodiscard]] Face face() const { return Face(bits_ >> 2); }
    [[nodiscard]] bool along() const { return (bits_ & 1u) != 0; }
    [[nodiscard]] bool goes_on() const { return (bits_ & 2u) != 0; }

   private:
    std::uint32_t bits_ = no_index;
  };
  struct Pair {
    Use first, second;
  };
  using Other = std::pair<Edge, Face>;

  [[nodiscard]] std::span<const Other> others_of(Edge e) const {
    const auto [begin, end] =
        std::equal_range(others_.begin(), others_.end(), Other(e, {}),
                         [](const Other& a, const Other& b) { return a.first < b.first; });
    return {begin, end};
  }

  std::vector<Pair> pairs_;    ///< by edge
  std::vector<Other> others_;  ///< by edge, then by face
};

}  // namespace aomd
