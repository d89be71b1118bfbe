#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <map>

#include "core/mesh/side_index.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// A face as its round from the smallest vertex, the smaller of its neighbours first.
struct Round {
  std::uint32_t low, face;
  std::uint64_t tag;  ///< exact for triangles, else a hash
  bool forward;
};

std::vector<std::uint32_t> canonical(std::span<const std::uint32_t> v, bool forward) {
  std::vector<std::uint32_t> round(v.begin(), v.end());
  if (!forward) std::reverse(round.begin(), round.end());
  std::rotate(round.begin(), std::min_element(round.begin(), round.end()), round.end());
  return round;
}

Round round_of(const Surface& surface, std::uint32_t f) {
  const auto v = surface.vertices(f);
  const FaceKey key(v);
  Round round{key.low, f, key.tag, key.forward};
  if (v.size() > 3) {  // the key of a polygon does not tell the order of its vertices
    round.tag = v.size();
    for (const std::uint32_t u : canonical(v, key.forward))
      round.tag = (round.tag ^ u) * 0x9e3779b97f4a7c15u;
  }
  return round;
}

bool same_round(const Surface& surface, const Round& a, const Round& b) {
  if (a.low != b.low || a.tag != b.tag) return false;
  const auto u = surface.vertices(a.face), v = surface.vertices(b.face);
  return u.size() == v.size() &&
         (u.size() == 3 || canonical(u, a.forward) == canonical(v, b.forward));
}

// A pair of faces that cancel each other.
struct Pair {
  std::uint32_t group;  ///< the first face on these vertices
  std::uint32_t first, second;
};

class Coinciding {
 public:
  Coinciding(Surface& surface, bool repeated, bool opposite)
      : surface_(surface), repeated_(repeated), opposite_(opposite) {}

  Coincident run() {
    const std::vector<Round> rounds = sorted_rounds();
    for (std::size_t i = 0, j = 0; i < rounds.size(); i = j) {
      for (j = i + 1; j < rounds.size() && same_round(surface_, rounds[i], rounds[j]);) ++j;
      if (j - i > 1) mend(std::span(rounds).subspan(i, j - i));
    }
    return cancelled_.empty() && repeats_.empty() ? Coincident() : remove();
  }

 private:
  [[nodiscard]] std::vector<Round> sorted_rounds() const {
    std::vector<std::uint32_t> at(surface_.vertex_count() + std::size_t{1}, 0);
    surface_.each_face([&](std::uint32_t f) {
      const auto v = surface_.vertices(f);
      ++at[*std::min_element(v.begin(), v.end()) + 1];
    });
    for (std::size_t v = 1; v < at.size(); ++v) at[v] += at[v - 1];
    std::vector<Round> rounds(at.back());
    surface_.each_face([&](std::uint32_t f) {
      const Round round = round_of(surface_, f);
      rounds[at[round.low]++] = round;
    });
    for (std::size_t v = 0, from = 0; v + 1 < at.size(); from = at[v++])
      std::sort(rounds.begin() + static_cast<std::ptrdiff_t>(from), rounds.begin() + at[v],
                [](const Round& a, const Round& b) {
                  return a.tag != b.tag ? a.tag < b.tag : a.face < b.face;
                });
    return rounds;
  }

  // Pairs first: what stays bounds what all of them together bounded. The first listed stay.
  void mend(std::span<const Round> group) {
    std::vector<std::uint8_t> gone(group.size(), 0);
    if (opposite_) cancel(group, gone);
    if (!repeated_) return;
    std::array<std::size_t, 2> first{group.size(), group.size()};  // that stays, by direction
    for (std::size_t i = group.size(); i-- > 0;)
      if (!gone[i]) first[group[i].forward] = i;
    for (std::size_t i = group.size(); i-- > 0;)
      if (!gone[i] && i > first[group[i].forward]) repeats_.push_back(group[i].face);
  }

  // From the last face on, each cancels the nearest before it that looks the other way and lies on
  // the same model face. Those that wait for a partner all look the same way.
  void cancel(std::span<const Round> group, std::vector<std::uint8_t>& gone) {
    std::map<ModelRef, std::deque<std::size_t>> waiting;
    std::vector<std::array<std::size_t, 2>> pairs;
    for (std::size_t i = group.size(); i-- > 0;) {
      auto& queue = waiting[surface_.face_class(group[i].face)];
      if (queue.empty() || group[queue.front()].forward == group[i].forward) {
        queue.push_back(i);
        continue;
      }
      pairs.push_back({queue.front(), i});
      gone[queue.front()] = gone[i] = 1;
      queue.pop_front();
    }
    std::sort(pairs.begin(), pairs.end(), std::greater<>());
    for (const auto& [last, first] : pairs)
      cancelled_.push_back({group[0].face, group[first].face, group[last].face});
  }

  Coincident remove() {
    Coincident result;
    DisjointSets pieces = pieces_of(surface_);
    for (const std::uint32_t f : repeats_) surface_.remove(f), result.repeated.add(f);
    for (const Pair& pair : cancelled_) surface_.remove(pair.first), surface_.remove(pair.second);
    std::vector<std::uint32_t> pairs(surface_.vertex_count(),
                                     0);  // of each piece, while nothing else is left
    for (const Pair& pair : cancelled_) ++pairs[piece_of(pieces, pair)];
    surface_.each_face([&](std::uint32_t f) { pairs[pieces.find(surface_.vertices(f)[0])] = 0; });
    for (const Pair& pair : cancelled_) {
      // A piece of several pairs of which nothing would stay is a sheet listed from both sides.
      const bool sheet = pairs[piece_of(pieces, pair)] > 1;
      if (sheet && !surface_.alive(pair.group)) surface_.restore(pair.group);
      for (const std::uint32_t f : {pair.first, pair.second})
        if (!surface_.alive(f)) (sheet ? result.sheets : result.opposite).add(f);
    }
    return result;
  }

  [[nodiscard]] std::uint32_t piece_of(DisjointSets& pieces, const Pair& pair) const {
    return pieces.find(std::as_const(surface_).vertices(pair.group)[0]);
  }

  Surface& surface_;
  bool repeated_, opposite_;
  std::vector<Pair> cancelled_;
  std::vector<std::uint32_t> repeats_;
};

}  // namespace

Coincident mend_coincident(Surface& surface, bool repeated, bool opposite) {
  return Coinciding(surface, repeated, opposite).run();
}

}  // namespace aomd::repair_detail
