#include "core/io/tile_weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/base/box.h"

namespace aomd::io::detail {
namespace {

/// Two places of different tiles, in the order of their vertices.
struct Near {
  double distance = 0;
  std::uint32_t first = 0, second = 0;

  friend bool operator<(const Near& a, const Near& b) {
    return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
  }
};

/// Places by cells that are no smaller than the tolerance.
class WeldGrid {
 public:
  WeldGrid(std::span<const TilePlace> places, double tolerance) {
    Box box;
    for (const TilePlace& p : places) box.add(p.position);
    low_ = box.low;
    constexpr double most_cells = 1 << 20;  // along a side
    cell_ = std::max(tolerance, box.diagonal() / most_cells);
    for (std::uint32_t i = 0; i < places.size(); ++i)
      order_.emplace_back(key(cell_of(places[i].position)), i);
    std::sort(order_.begin(), order_.end());
  }

  /// Calls visit(i) for all places in the cells at p and around it.
  template <typename Visit>
  void each_around(const glm::dvec3& p, const Visit& visit) const {
    const Cell cell = cell_of(p);
    for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x)
      for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
        const std::uint64_t from = key({x, y, cell[2] - 1}), to = key({x, y, cell[2] + 1});
        auto at = std::lower_bound(order_.begin(), order_.end(), std::pair(from, 0u));
        for (; at != order_.end() && at->first <= to; ++at) visit(at->second);
      }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell cell_of(const glm::dvec3& p) const {
    const auto along = [&](int k) {
      return cell_ > 0 && std::isfinite(cell_) ? static_cast<std::int64_t>((p[k] - low_[k]) / cell_)
                                               : 0;
    };
    return {along(0), along(1), along(2)};
  }
  /// One more than the cell's own numbers, so that those around it have one too.
  [[nodiscard]] static std::uint64_t key(const Cell& cell) {
    const auto part = [](std::int64_t n) { return static_cast<std::uint64_t>(n + 1); };
    return part(cell[0]) << 42 | part(cell[1]) << 21 | part(cell[2]);
  }

  glm::dvec3 low_{0.0};
  double cell_ = 0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order_;
};

bool has_tile_twice(std::span<const TilePlace> at_one) {
  const auto same_tile = [](const TilePlace& a, const TilePlace& b) { return a.tile == b.tile; };
  return std::adjacent_find(at_one.begin(), at_one.end(), same_tile) != at_one.end();
}

std::vector<Near> pairs_within(std::span<const TilePlace> places, double tolerance) {
  constexpr std::size_t most = 64;
  const WeldGrid grid(places, tolerance);
  std::vector<Near> pairs;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    grid.each_around(places[i].position, [&](std::uint32_t k) {
      if (k <= i || places[k].tile == places[i].tile) return;
      const double distance = glm::distance(places[i].position, places[k].position);
      if (distance <= tolerance) pairs.push_back({distance, i, k});
    });
    if (pairs.size() > most * places.size()) throw WeldTooWide();
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Sets of places that are one, each with its first as the root.
class WeldedSets {
 public:
  WeldedSets(std::span<const TilePlace> places, double tolerance)
      : places_(places), tolerance_(tolerance), root_(places.size()), members_(places.size()) {
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      root_[i] = i;
      members_[i] = {i};
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t into = std::min(root_[a], root_[b]), from = std::max(root_[a], root_[b]);
    if (into == from || !fit(into, from)) return;
    for (const std::uint32_t m : members_[from]) root_[m] = into;
    members_[into].insert(members_[into].end(), members_[from].begin(), members_[from].end());
    members_[from].clear();
  }

  [[nodiscard]] std::uint32_t root(std::uint32_t i) const { return root_[i]; }

 private:
  [[nodiscard]] bool fit(std::uint32_t into, std::uint32_t from) const {
    return std::all_of(members_[from].begin(), members_[from].end(), [&](std::uint32_t m) {
      const bool near = glm::distance(places_[into].position, places_[m].position) <= tolerance_;
      return near &&
             std::none_of(members_[into].begin(), members_[into].end(), [&](std::uint32_t other) {
               return places_[other].tile == places_[m].tile;
             });
    });
  }

  std::span<const TilePlace> places_;
  double tolerance_;
  std::vector<std::uint32_t> root_;
  std::vector<std::vector<std::uint32_t>> members_;
};

}  // namespace

TileReplacements join_places(std::vector<TilePlace> places, double tolerance) {
  const auto at = [](const TilePlace& p) {
    return std::tuple(p.position.x, p.position.y, p.position.z);
  };
  std::sort(places.begin(), places.end(), [&](const TilePlace& a, const TilePlace& b) {
    return std::pair(at(a), a.vertex) < std::pair(at(b), b.vertex);
  });
  TileReplacements replacements;
  std::vector<TilePlace> apart;  // but for places where a tile has two
  for (std::size_t i = 0, end = 0; i < places.size(); i = end) {
    while (end < places.size() && at(places[end]) == at(places[i])) ++end;
    const auto at_one = std::span<const TilePlace>(places).subspan(i, end - i);
    if (has_tile_twice(at_one)) continue;
    if (tolerance > 0) apart.insert(apart.end(), at_one.begin(), at_one.end());
    for (const TilePlace& p : at_one.subspan(1))
      replacements.emplace_back(p.vertex, at_one[0].vertex);
  }
  return tolerance > 0 ? weld_places(apart, tolerance) : replacements;
}

TileReplacements weld_places(std::span<const TilePlace> given, double tolerance) {
  std::vector<TilePlace> places(given.begin(), given.end());
  std::sort(places.begin(), places.end(),
            [](const TilePlace& a, const TilePlace& b) { return a.vertex < b.vertex; });
  WeldedSets sets(places, tolerance);
  for (const Near& near : pairs_within(places, tolerance)) sets.join(near.first, near.second);
  TileReplacements replacements;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    if (sets.root(i) != i) replacements.emplace_back(places[i].vertex, places[sets.root(i)].vertex);
  return replacements;
}

}  // namespace aomd::io::detail
