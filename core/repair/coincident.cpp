#include <algorithm>

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

// Two faces that cancel each other.
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
    std::vector<Round> living(group.begin(), group.end());
    for (std::size_t i = opposite_ ? living.size() : 0; i-- > 1;) {
      std::size_t j = i;
      while (j > 0 && !cancel(living[j - 1], living[i])) --j;
      if (j == 0) continue;
      cancelled_.push_back({group[0].face, living[j - 1].face, living[i].face});
      living.erase(living.begin() + static_cast<std::ptrdiff_t>(i));
      living.erase(living.begin() + static_cast<std::ptrdiff_t>(j - 1));
      --i;  // two have gone, one of them below
    }
    for (std::size_t i = repeated_ ? living.size() : 0; i-- > 1;)
      if (std::any_of(living.begin(), living.begin() + static_cast<std::ptrdiff_t>(i),
                      [&](const Round& r) { return r.forward == living[i].forward; }))
        repeats_.push_back(living[i].face);
  }

  [[nodiscard]] bool cancel(const Round& a, const Round& b) const {
    return a.forward != b.forward && surface_.face_class(a.face) == surface_.face_class(b.face);
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
