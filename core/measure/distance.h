#pragma once
// How far two surfaces are from each other, measured from either side at many points.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/model/triangle_tree.h"

#pragma GCC visibility push(default)

namespace aomd::measure {

/// A surface with what measuring at it needs, built once: the faces of a mesh, which must outlive
/// it. O(n log n); about 200 bytes a face.
class Surface {
 public:
  explicit Surface(const Mesh& mesh, int threads = 1)
      : Surface(mesh, triangles_of(mesh), threads) {}

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  /// Its triangles; neighbours in the tree's order are mostly neighbours in space.
  [[nodiscard]] const TriangleTree& tree() const { return tree_; }
  /// The face that the n-th triangle of the tree is of.
  [[nodiscard]] Face face(std::uint32_t n) const { return faces_[tree_.source(n)]; }

 private:
  Surface(const Mesh& mesh, Triangles triangles, int threads)
      : mesh_(&mesh), tree_(triangles.corners, threads), faces_(std::move(triangles.faces)) {}

  const Mesh* mesh_;
  TriangleTree tree_;
  std::vector<Face> faces_;
};

/// Distances from points of one surface to the nearest point of another, in the meshes' unit of
/// length.
struct Distance {
  double max = 0;           ///< over the area samples and all vertices
  double rms = 0;           ///< root of the mean of the squares, over the area samples
  double mean = 0;          ///< over the area samples
  glm::dvec3 worst{};       ///< the point of the one surface where `max` was found
  glm::dvec3 nearest{};     ///< the point of the other that is nearest to `worst`
  std::size_t samples = 0;  ///< area samples; the vertices come on top
};

/// Measures from `from` to `to` at every vertex that a face of `from` uses and at `samples` points,
/// spread evenly over its area (surfaces without area: at the vertices alone). The points follow
/// from the surface and the number alone: equal input, equal result, for any number of threads.
/// `max` is a lower bound of the one-sided Hausdorff distance; the area that a sample stands for
/// tells how much may be missing: about the square root of area / samples. About a microsecond a
/// point. All zero when either surface has no faces. Sampling and definitions after Cignoni,
/// Rocchini, Scopigno: Metro (Computer Graphics Forum 17, 1998).
[[nodiscard]] Distance distance_from(const Surface& from, const Surface& to, std::size_t samples,
                                     int threads = 1);

/// Both ways. Each symmetric value is the larger of the two; their `max` is the Hausdorff distance.
struct MutualDistance {
  Distance to_result, to_original;
  [[nodiscard]] double max() const { return std::max(to_result.max, to_original.max); }
  [[nodiscard]] double rms() const { return std::max(to_result.rms, to_original.rms); }
  [[nodiscard]] double mean() const { return std::max(to_result.mean, to_original.mean); }
};

[[nodiscard]] MutualDistance mutual_distance(const Surface& original, const Surface& result,
                                             std::size_t samples, int threads = 1);

}  // namespace aomd::measure

#pragma GCC visibility pop
