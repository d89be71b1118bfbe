#pragma once
// How far the present surface is off the original in the numbers that count beside the shape.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/decimate/quality/original_values.h"
#include "core/operators/star.h"

namespace aomd {

/// Knows the numbers at the vertices of the present mesh: those of the original nearby.
class AttributeFit {
 public:
  /// The mesh must be the original still. Mesh and original must outlive it.
  AttributeFit(const Mesh& mesh, const OriginalSurface& original, const CountedValues& given)
      : mesh_(mesh), surface_(original), original_(mesh, original, given) {}

  [[nodiscard]] const OriginalValues& original() const { return original_; }

  /// Finds the numbers at all vertices; the points of the original must have been located.
  /// O(points + vertices).
  void locate();
  /// A vertex is about to move: the points on the faces around it say what its numbers will be.
  void move(Vertex v, const Star& star, const glm::dvec3& target);

  /// The squared difference at a point of the original from the numbers at three corners, by
  /// weight.
  [[nodiscard]] double error(const OriginalPoint& point, const std::array<Vertex, 3>& corners,
                             const glm::vec3& barycentric) const;
  /// By how much the squared differences at the points on the faces around a vertex would grow, by
  /// area, if it moved.
  [[nodiscard]] double growth(Vertex v, const Star& star, const glm::dvec3& target) const;

 private:
  [[nodiscard]] std::span<const float> at(Vertex v) const {
    return std::span(present_).subspan(original_.components() * v.index, original_.components());
  }
  [[nodiscard]] std::span<const float> at(const OriginalPoint& point) const {
    return original_.at_point(number_of(point));
  }
  [[nodiscard]] std::size_t number_of(const OriginalPoint& point) const {
    return static_cast<std::size_t>(&point - surface_.points().data());
  }
  void find(const Star& star, const glm::dvec3& target, std::span<float> values) const;

  const Mesh& mesh_;
  const OriginalSurface& surface_;
  OriginalValues original_;
  std::vector<float> present_;  ///< by vertex; NaN where nothing is known
};

}  // namespace aomd
