#include "core/measure/intersections.h"

#include <algorithm>
#include <array>
#include <bit>
#include <mutex>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/model/triangle_intersection.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {

namespace {

constexpr std::size_t nodes_a_piece = 512;

/// The triangles that have area, those on the same three corners as one: any number of copies can
/// then be counted without being looked at two by two.
struct Distinct {
  std::vector<Triangle> corners;
  std::vector<std::uint32_t> begin;  ///< of each triangle's faces, and the end of the last
  std::vector<Face> all_faces;       ///< of one triangle after the other, each in ascending order
  [[nodiscard]] std::span<const Face> faces(std::size_t i) const {
    return {all_faces.data() + begin[i], all_faces.data() + begin[i + 1]};
  }
};

// The same for all triangles on the same corners, in any order.
std::uint64_t key_of(const Triangle& t) {
  std::uint64_t sum = 0;
  for (const glm::dvec3& p : t) {
    std::uint64_t x = 0;
    for (int k = 0; k < 3; ++k)  // + 0.0: both zeros are one place
      x = (x ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9E3779B97F4A7C15u, x ^= x >> 29;
    sum += x;
  }
  return sum;
}

bool same_corners(const Triangle& s, const Triangle& t) {
  return std::is_permutation(s.begin(), s.end(), t.begin());
}

// By triangle the first one on the same corners; a half of a quad is like no other.
std::vector<std::uint32_t> find_first_alike(const Mesh& mesh, const Triangles& all) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  std::vector<std::uint32_t> first(all.corners.size());
  std::iota(first.begin(), first.end(), 0u);
  for (const std::uint32_t n : first)
    if (mesh.shape(all.faces[n]) == Shape::Triangle) keys.emplace_back(key_of(all.corners[n]), n);
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0, begin = 0; i < keys.size(); ++i) {
    if (keys[i].first != keys[begin].first) begin = i;
    std::size_t like = begin;
    while (!same_corners(all.corners[keys[like].second], all.corners[keys[i].second])) ++like;
    first[keys[i].second] = keys[like].second;
  }
  return first;
}

Distinct distinct_triangles(const Mesh& mesh) {
  const Triangles all = triangles_of(mesh);
  const std::vector<std::uint32_t> first = find_first_alike(mesh, all);
  std::vector<std::uint32_t> place(first.size(), no_index);
  Distinct result;
  for (std::uint32_t n = 0; n < first.size(); ++n) {
    if (first[n] != n || without_area(all.corners[n])) continue;
    place[n] = static_cast<std::uint32_t>(result.corners.size());
    result.corners.push_back(all.corners[n]);
  }
  result.begin.assign(result.corners.size() + 2, 0);
  for (const std::uint32_t n : first)
    if (place[n] != no_index) ++result.begin[place[n] + 2];
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  result.all_faces.resize(result.begin.back());
  for (std::uint32_t n = 0; n < first.size(); ++n)
    if (const std::uint32_t i = place[first[n]]; i != no_index)
      result.all_faces[result.begin[i + 1]++] = all.faces[n];
  result.begin.pop_back();
  return result;
}

// Pairs of distinct triangles that intersect, as indices into `all`; of two faces only one pair.
std::vector<std::array<std::uint32_t, 2>> intersecting(const Distinct& all, int threads) {
  using Pair = std::array<std::uint32_t, 2>;
  const TriangleTree tree(all.corners, threads);
  std::vector<Pair> pairs;
  std::mutex mutex;
  parallel_for(tree.nodes(), threads, nodes_a_piece, [&](std::size_t begin, std::size_t end) {
    tree.touching_pairs(begin, end, [&](std::uint32_t n, std::uint32_t m) {
      const std::uint32_t i = tree.source(n), j = tree.source(m);
      if (all.faces(i)[0] == all.faces(j)[0] || !intersect(tree.triangle(n), tree.triangle(m)))
        return;
      const std::scoped_lock lock(mutex);
      pairs.push_back({std::min(i, j), std::max(i, j)});
    });
  });
  const auto faces = [&](const Pair& p) {
    return std::pair(all.faces(p[0])[0], all.faces(p[1])[0]);
  };
  std::sort(pairs.begin(), pairs.end(),
            [&](const Pair& a, const Pair& b) { return faces(a) < faces(b); });
  pairs.erase(std::unique(pairs.begin(), pairs.end(),
                          [&](const Pair& a, const Pair& b) { return faces(a) == faces(b); }),
              pairs.end());
  return pairs;
}

}  // namespace

std::vector<IntersectingPair> self_intersections(const Mesh& mesh, int threads) {
  const Distinct all = distinct_triangles(mesh);
  std::vector<IntersectingPair> pairs;
  for (const auto& [i, j] : intersecting(all, threads))
    for (const Face f : all.faces(i))
      for (const Face g : all.faces(j)) pairs.push_back({std::min(f, g), std::max(f, g)});
  for (std::size_t n = 0; n < all.corners.size(); ++n)
    for (const Face f : all.faces(n))
      for (const Face g : all.faces(n))
        if (f < g) pairs.push_back({f, g});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::uint64_t count_self_intersections(const Mesh& mesh, int threads) {
  const Distinct all = distinct_triangles(mesh);
  std::uint64_t count = 0;
  for (const auto& [i, j] : intersecting(all, threads))
    count += std::uint64_t{all.faces(i).size()} * all.faces(j).size();
  for (std::size_t n = 0; n < all.corners.size(); ++n)
    count += std::uint64_t{all.faces(n).size()} * (all.faces(n).size() - 1) / 2;
  return count;
}

}  // namespace aomd::measure
