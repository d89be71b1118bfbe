#include "core/measure/crowded_pairs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/io/weld.h"
#include "core/measure/directions.h"

namespace aomd::measure {
namespace {

using glm::dvec3;

// So many triangles at one corner are compared with each other; more are a crowd.
constexpr std::uint32_t most_at_a_corner = 256;
constexpr std::size_t nodes_a_share = 512;
constexpr std::size_t least_slots = 1024;

// Mixed from above as well: coordinates that were floats end in zeros.
std::uint64_t hash(const dvec3& p) {
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

class CrowdedPairs {
 public:
  CrowdedPairs(std::span<const Triangle> triangles, int threads,
               const std::function<void(std::uint32_t, std::uint32_t)>& visit)
      : triangles_(triangles), threads_(threads), visit_(visit) {}

  void run() {
    io::detail::Welder welder;
    std::vector<Item> items(triangles_.size());
    for (std::uint32_t i = 0; i < items.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) items[i].points[k] = welder.add(triangles_[i][k]);
    for (std::uint32_t i = 0; i < items.size(); ++i) items[i].triangle = i;
    uses_.assign(welder.size(), 0);
    points_ = welder.take();
    meet(items, 0);
  }

 private:
  struct Item {
    std::uint32_t triangle = 0;
    std::array<std::uint32_t, 3> points{};  ///< its corners, those that all have in common first
  };

  [[nodiscard]] auto visiting(const std::vector<Item>& x, const BoxTree& of_x,
                              const std::vector<Item>& y, const BoxTree& of_y) const {
    return [&](std::uint32_t n, std::uint32_t m) {
      visit_(x[of_x.source(n)].triangle, y[of_y.source(m)].triangle);
    };
  }

  // All pairs of items whose first `shared` corners are the same.
  void meet(const std::vector<Item>& items, std::size_t shared) {
    std::vector<std::vector<Item>> parts = parted(items, shared);
    std::vector<BoxTree> trees;
    trees.reserve(parts.size());
    for (const auto& part : parts)
      trees.push_back(tree_of(part, [&](const Item& item) { return box_of(item, shared); }));
    if (shared != 1 || parts.size() == 1 || !meet_along(parts[0], parts[1][0]))
      meet_themselves(parts[0], trees[0]);
    for (std::size_t i = 0; i < trees.size(); ++i)
      for (std::size_t j = i + 1; j < trees.size(); ++j)
        if (shared > 1 || !meet_in_view(parts[i], trees[i].box(), parts[j], trees[j].box(), shared))
          trees[i].touching_pairs(trees[j], visiting(parts[i], trees[i], parts[j], trees[j]));
    trees.clear();
    for (std::size_t i = 1; i < parts.size(); ++i) meet(parts[i], shared + 1);
  }

  void meet_themselves(const std::vector<Item>& items, const BoxTree& tree) const {
    parallel_for(tree.nodes(), threads_, nodes_a_share, [&](std::size_t b, std::size_t e) {
      tree.touching_pairs(b, e, visiting(items, tree, items, tree));
    });
  }

  // The pairs of those at a corner, seen along a crowded edge there; false where that tells no more
  // of them apart.
  [[nodiscard]] bool meet_along(const std::vector<Item>& items, const Item& at_edge) const {
    const auto along = [&](const Item& item) { return view_along(item, at_edge); };
    const auto from_corner = [&](const Item& item) { return box_of(item, 1); };
    if (overlapping(items, items, along) >= overlapping(items, items, from_corner)) return false;
    meet_themselves(items, tree_of(items, along));
    return true;
  }

  // The pairs of a crowd and others that come as near to it in great numbers, told apart as they
  // are seen from the corner of the crowd, or along its edge: triangles around two corners or edges
  // pile up in any boxes. False where there are few.
  bool meet_in_view(const std::vector<Item>& others, const Box& around_others,
                    const std::vector<Item>& crowd, const Box& around_crowd, std::size_t shared) {
    const std::vector<Item> x = touching(others, around_crowd, shared);
    const std::vector<Item> y = touching(crowd, around_others, shared);
    if (std::min(x.size(), y.size()) <= most_at_a_corner) return false;
    if (shared == 1)
      meet_along(x, y, shared);
    else
      meet_in_views(parted(x, 1), parted(y, 1));
    return true;
  }

  // Two sets, each in its crowds at edges and the rest, the second around one corner.
  void meet_in_views(const std::vector<std::vector<Item>>& xs,
                     const std::vector<std::vector<Item>>& ys) const {
    for (std::size_t j = 1; j < ys.size(); ++j)
      for (const auto& x : xs) meet_along(x, ys[j], 0);
    if (ys[0].empty()) return;
    for (std::size_t i = 1; i < xs.size(); ++i) meet_along(ys[0], xs[i], 0);
    const std::uint32_t corner = ys[0][0].points[0];
    meet_as_seen(xs[0], ys[0], 0, [&](const Item& item) { return view_of(item, corner); });
  }

  // A crowd at an edge and others, seen in the way that tells more of them apart.
  void meet_along(const std::vector<Item>& others, const std::vector<Item>& crowd,
                  std::size_t shared) const {
    if (others.empty()) return;
    const auto along = [&](const Item& item) { return view_along(item, crowd[0]); };
    const auto from_corner = [&](const Item& item) {
      return shared == 0 ? view_of(item, crowd[0].points[0]) : box_of(item, shared);
    };
    if (overlapping(others, crowd, along) < overlapping(others, crowd, from_corner))
      meet_as_seen(others, crowd, shared, along);
    else
      meet_as_seen(others, crowd, shared, from_corner);
  }

  // Of pairs of a few, how many overlap.
  template <typename View>
  [[nodiscard]] static std::size_t overlapping(const std::vector<Item>& x,
                                               const std::vector<Item>& y, const View& view) {
    const auto few = [&](const std::vector<Item>& items) {
      constexpr std::size_t most = 64;
      std::vector<Box> boxes;
      for (std::size_t i = 0; i < std::min(most, items.size()); ++i)
        boxes.push_back(view(items[i * items.size() / std::min(most, items.size())]));
      return boxes;
    };
    const std::vector<Box> of_x = few(x), of_y = few(y);
    std::size_t count = 0;
    for (const Box& box : of_x)
      for (const Box& other : of_y) count += box.touches(other) ? 1 : 0;
    return count;
  }

  template <typename View>
  void meet_as_seen(const std::vector<Item>& x, const std::vector<Item>& y, std::size_t shared,
                    const View& view) const {
    const BoxTree of_x = tree_of(x, view), of_y = tree_of(y, view);
    of_x.touching_pairs(of_y, [&](std::uint32_t n, std::uint32_t m) {
      const Item &s = x[of_x.source(n)], &t = y[of_y.source(m)];
      if (box_of(s, shared).touches(box_of(t, shared))) visit_(s.triangle, t.triangle);
    });
  }

  [[nodiscard]] std::vector<Item> touching(const std::vector<Item>& items, const Box& box,
                                           std::size_t shared) const {
    std::vector<Item> near;
    if (box.empty()) return near;
    for (const Item& item : items)
      if (box_of(item, shared).touches(box)) near.push_back(item);
    return near;
  }

  [[nodiscard]] Box view_of(const Item& item, std::uint32_t corner) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (item.points[k] == corner) {
        const dvec3& from = points_[corner];
        return arc_box(direction(from, points_[item.points[(k + 1) % 3]]),
                       direction(from, points_[item.points[(k + 2) % 3]]));
      }
    return view_box(points_[corner], triangles_[item.triangle]);
  }

  [[nodiscard]] Box view_along(const Item& item, const Item& at_edge) const {
    return turn_box(points_[at_edge.points[0]], points_[at_edge.points[1]],
                    triangles_[item.triangle]);
  }

  // The crowd at each crowded corner, behind the rest. An item goes to the fullest of its corners,
  // which becomes the last of those that its crowd has in common.
  [[nodiscard]] std::vector<std::vector<Item>> parted(const std::vector<Item>& items,
                                                      std::size_t shared) {
    count_uses(items, shared, 1);
    std::vector<std::vector<Item>> parts(1);
    std::unordered_map<std::uint32_t, std::size_t> part_at;
    for (Item item : items) {
      const auto fullest = std::max_element(
          item.points.begin() + static_cast<std::ptrdiff_t>(shared), item.points.end(),
          [&](std::uint32_t p, std::uint32_t q) { return uses_[p] < uses_[q]; });
      const bool crowd = shared < 2 && uses_[*fullest] > most_at_a_corner;
      const std::size_t part =
          crowd ? part_at.try_emplace(*fullest, parts.size()).first->second : 0;
      if (part == parts.size()) parts.emplace_back();
      if (crowd) std::swap(*fullest, item.points[shared]);
      parts[part].push_back(item);
    }
    count_uses(items, shared, 0);
    return parts;
  }

  // Counts the items at each corner that not all have in common, or forgets the counts.
  void count_uses(const std::vector<Item>& items, std::size_t shared, std::uint32_t step) {
    for (const Item& item : items)
      for (std::size_t k = shared; k < 3; ++k) {
        std::uint32_t& uses = uses_[item.points[k]];
        uses = step == 0 ? 0 : uses + step;
      }
  }

  template <typename BoxOf>
  [[nodiscard]] BoxTree tree_of(const std::vector<Item>& items, const BoxOf& box_of) const {
    std::vector<BoxTree::Item> places;
    places.reserve(items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
      const Box box = box_of(items[i]);
      places.push_back({box.low + box.high, i});
    }
    BoxTree tree(places, threads_);
    std::vector<Box> boxes;
    boxes.reserve(items.size());
    for (const BoxTree::Item& place : places) boxes.push_back(box_of(items[place.source]));
    tree.fit(std::move(boxes));
    return tree;
  }

  [[nodiscard]] Box box_of(const Item& item, std::size_t shared) const {
    const auto& [a, b, c] = item.points;
    if (shared > 0) {
      const dvec3 first = direction(points_[a], points_[b]);
      const dvec3 second = direction(points_[a], points_[c]);
      return shared == 1 ? arc_box(first, second) : half_plane_box(first, second);
    }
    return aomd::box_of(triangles_[item.triangle]);
  }

  std::span<const Triangle> triangles_;
  int threads_;
  const std::function<void(std::uint32_t, std::uint32_t)>& visit_;
  std::vector<dvec3> points_;
  std::vector<std::uint32_t> uses_;  ///< of each point, while items are parted
};

}  // namespace

bool crowded(std::span<const Triangle> triangles) {
  // About 20 uses a slot: few enough, and the table stays in the cache.
  std::vector<std::uint32_t> uses(std::bit_ceil(std::max(triangles.size() / 8, least_slots)), 0);
  const std::size_t mask = uses.size() - 1;
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](const dvec3& p) { return ++uses[hash(p) & mask] > most_at_a_corner; });
  });
}

void crowded_pairs(std::span<const Triangle> triangles, int threads,
                   const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  CrowdedPairs(triangles, threads, visit).run();
}

}  // namespace aomd::measure
