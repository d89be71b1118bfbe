#include "core/measure/intersections.h"

#include <algorithm>
#include <mutex>

#include "core/base/parallel.h"
#include "core/model/triangle_intersection.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {

namespace {

constexpr std::size_t nodes_a_piece = 512;

}  // namespace

std::vector<IntersectingPair> self_intersections(const Mesh& mesh, int threads) {
  Triangles all = triangles_of(mesh);
  std::vector<Triangle> corners;
  std::vector<Face> faces;
  corners.reserve(all.corners.size());
  faces.reserve(all.corners.size());
  for (std::size_t i = 0; i < all.corners.size(); ++i) {
    if (without_area(all.corners[i])) continue;
    corners.push_back(all.corners[i]);
    faces.push_back(all.faces[i]);
  }
  const TriangleTree tree(corners, threads);
  std::vector<IntersectingPair> pairs;
  std::mutex mutex;
  parallel_for(tree.nodes(), threads, nodes_a_piece, [&](std::size_t begin, std::size_t end) {
    tree.touching_pairs(begin, end, [&](std::uint32_t n, std::uint32_t m) {
      const Face f = faces[tree.source(n)], g = faces[tree.source(m)];
      if (f == g || !intersect(tree.triangle(n), tree.triangle(m))) return;
      const std::scoped_lock lock(mutex);
      pairs.push_back({std::min(f, g), std::max(f, g)});
    });
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace aomd::measure
