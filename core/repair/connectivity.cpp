#include "core/repair/connectivity.h"

#include <algorithm>

namespace aomd::repair_detail {

DisjointSets pieces_of(const Surface& surface) {
  DisjointSets sets(surface.vertex_count());
  surface.each_face([&](std::uint32_t f) {
    for (const std::uint32_t v : surface.vertices(f)) sets.unite(surface.vertices(f)[0], v);
  });
  return sets;
}

EdgeUses::EdgeUses(const Surface& surface) {
  std::vector<std::uint32_t> at(surface.vertex_count() + std::size_t{1}, 0);
  const auto each_side = [&](auto&& visit) {
    surface.each_corner(
        [&](std::uint32_t c) { visit(c, surface.vertex(c), surface.vertex(surface.next(c))); });
  };
  each_side([&](std::uint32_t, std::uint32_t a, std::uint32_t b) { ++at[std::min(a, b) + 1]; });
  std::partial_sum(at.begin(), at.end(), at.begin());
  uses_.resize(at.back());
  starts_.assign(at.back() + std::size_t{1}, 0);
  for (const std::uint32_t i : at) starts_[i] = 1;
  each_side([&](std::uint32_t c, std::uint32_t a, std::uint32_t b) {
    uses_[at[std::min(a, b)]++] = {std::max(a, b), c << 1 | std::uint32_t{a < b}};
  });
  for (std::size_t v = 0, from = 0; v + 1 < at.size(); from = at[v++])
    std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(from), uses_.begin() + at[v],
              [](const Use& x, const Use& y) {
                return x.high != y.high ? x.high < y.high : x.place < y.place;
              });
}

}  // namespace aomd::repair_detail
