#pragma once
// All points within a distance of a surface or a curve, and whether a triangle lies in it wholly.

#include <cstdint>
#include <span>
#include <vector>

#include "core/decimate/guard/patches.h"
#include "core/decimate/guard/triangle_cuts.h"
#include "core/model/triangle_tree.h"

namespace aomd {

/// The points within a distance of given triangles, which are copied; a segment is a triangle (a,
/// b, b).
class Envelope {
 public:
  /// O(n log n); about 200 bytes a triangle. The distance is at least 0. `vertices`, those of each
  /// triangle, say which triangles are neighbours; without them answers are the same, but for fine
  /// surfaces slower.
  Envelope(std::span<const Triangle> triangles, double distance,
           std::span<const std::array<std::uint32_t, 3>> vertices = {});

  [[nodiscard]] const TriangleTree& tree() const { return tree_; }
  [[nodiscard]] double distance() const { return distance_; }

  struct Answer {
    bool inside = false;
    double distance = 0;  ///< where not inside: of a point outside, or of one that may be near such
  };
  /// Whether a point lies within the distance. `hint` as below. About 0.3 us.
  [[nodiscard]] Answer contains(const glm::dvec3& p, std::uint32_t& hint) const;
  /// Whether every point of `t` certainly lies within the distance. What has its corners in one
  /// convex set of near points, around one triangle or over a patch, lies in it altogether, and so
  /// does what has near triangles over all of it along its normal; what has not is cut along the
  /// sides of the nearest triangle, or in halves, until each part does.
  /// Says no at the first point outside, for parts smaller than 1/16 of the distance, and where it
  /// would take more than 4096 parts. `hint` is a triangle of the tree that may be near, or
  /// no_index; it receives the last one found. About 0.1 us where the first set holds `t`, else 0.3
  /// us for each part; there are about as many as patches under `t`.
  [[nodiscard]] Answer contains(const Triangle& t, std::uint32_t& hint);

 private:
  struct Part {
    Triangle corners;
    std::uint32_t hint;
  };
  [[nodiscard]] bool near(const Triangle& t, std::uint32_t n);
  [[nodiscard]] bool small_patch(std::uint32_t n);
  [[nodiscard]] bool laid_over(const Triangle& t) const;
  [[nodiscard]] double locate(const glm::dvec3& p, bool surely, std::uint32_t& near) const;
  [[nodiscard]] TriangleParts cut(const Triangle& t, std::uint32_t nearest, double distance2,
                                  double longest2);

  TriangleTree tree_;
  double distance_, reach_, reach2_;  ///< reach: the distance less what rounding may lose
  Patches patches_;
  std::vector<Part> parts_;
};

}  // namespace aomd
