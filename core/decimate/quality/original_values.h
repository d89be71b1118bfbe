#pragma once
// The numbers that count beside the shape of the surface that a decimation started from: at its
// points, and at any place near one of them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/buckets.h"
#include "core/decimate/counted_values.h"
#include "core/decimate/quality/original_surface.h"

namespace aomd {

/// Made of the same mesh as the original surface, which must outlive it. Holds the original's
/// faces: 24 bytes each.
class OriginalValues {
 public:
  /// O(vertices + faces).
  OriginalValues(const Mesh& mesh, const OriginalSurface& original, const CountedValues& given);

  [[nodiscard]] std::size_t components() const { return components_; }
  /// Whether the mesh has not changed since.
  [[nodiscard]] bool made_of(const Mesh& mesh) const { return mesh.revision() == revision_; }
  /// The points that the vertices of the original's n-th face are.
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::size_t n) const {
    return faces_[n];
  }
  /// At the original's i-th point; NaN where nothing counts.
  [[nodiscard]] std::span<const float> at_point(std::size_t i) const {
    return std::span(values_).subspan(components_ * i, components_);
  }
  /// Of all points.
  [[nodiscard]] std::span<const float> all() const { return values_; }
  /// At the place nearest to `p` on the original's faces around the i-th point.
  void at(const glm::dvec3& p, std::size_t i, std::span<float> values) const;
  /// How each component changes along the surface at the i-th point: the mean over the faces
  /// around, by their areas; 0 where nothing is known.
  void gradients(std::size_t i, std::span<glm::vec3> gradients) const;

 private:
  using Corners = std::array<std::uint32_t, 3>;  ///< the points that a face's vertices are

  OriginalValues(const Mesh& mesh, const OriginalSurface& original, const CountedValues& given,
                 const Column<Vertex, std::uint32_t>& point_of);
  [[nodiscard]] std::span<const std::uint32_t> faces_at(std::size_t i) const {
    return around_[home_[i]];
  }
  [[nodiscard]] std::array<glm::dvec3, 3> positions(const Corners& face) const;

  const OriginalSurface& original_;
  std::uint64_t revision_;
  std::size_t components_;
  std::vector<float> values_;
  std::vector<std::uint32_t> home_;  ///< by point: itself, or a corner of the face it is inside of
  std::vector<Corners> faces_;
  Buckets<std::uint32_t> around_;  ///< faces by their points
};

/// How the linear function with these values at a triangle's corners changes inside it; 0 where the
/// triangle has no area.
[[nodiscard]] glm::dvec3 gradient_of(const std::array<glm::dvec3, 3>& corners,
                                     const std::array<double, 3>& values);

}  // namespace aomd
