#pragma once
// How far the present surface is off the original in the numbers that count beside the shape.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/lanes.h"
#include "core/decimate/quality/original_values.h"
#include "core/fields/fitted_values.h"
#include "core/operators/star.h"

namespace aomd {

/// Knows the numbers at the vertices of the present mesh: of fitted components those that fit best
/// between the vertices too (fields::fit_values), of others those of the original nearby.
class AttributeFit {
 public:
  /// The mesh must be the original still. Mesh and original must outlive it.
  AttributeFit(const Mesh& mesh, const OriginalSurface& original, const CountedValues& given)
      : mesh_(mesh), surface_(original), original_(mesh, original, given), fitted_(given.fitted) {
    fitted_.resize(given.components);
  }

  [[nodiscard]] const OriginalValues& original() const { return original_; }

  /// Finds the numbers at all vertices; the points of the original must have been located.
  /// O(points + vertices).
  void locate();
  /// By how much the squared differences at the points on the faces around a vertex would grow, by
  /// area, if it moved.
  [[nodiscard]] double propose(Vertex v, const Star& star, const glm::dvec3& target);
  /// The vertex of the last proposal is about to move: it gets the numbers that were proposed.
  void move(Vertex v);

  /// The squared difference at a point of the original from the numbers at three corners, by
  /// weight.
  [[nodiscard]] double error(const OriginalPoint& point, const std::array<Vertex, 3>& corners,
                             const glm::vec3& barycentric) const;

 private:
  /// What the points around a vertex that moves say of one of its components, as a function of the
  /// number x there: the squared differences come to squares x^2 - 2 sum x + rest.
  struct Wish {
    double pulls = 0, squares = 0, sum = 0, rest = 0;
    double before = 0;  ///< the squared differences as long as it stays
    [[nodiscard]] double error(double x) const { return (squares * x - 2 * sum) * x + rest; }
    /// Where that is least, held where it was as fit_values() holds it.
    [[nodiscard]] double best(double present) const {
      const double hold = fields::fit_hold * pulls;
      return (sum + hold * present) / (squares + hold);
    }
  };

  [[nodiscard]] std::span<const float> at(Vertex v) const {
    return std::span(present_).subspan(original_.components() * v.index, original_.components());
  }
  [[nodiscard]] std::span<const float> at(const OriginalPoint& point) const {
    return original_.at_point(number_of(point));
  }
  [[nodiscard]] std::size_t number_of(const OriginalPoint& point) const {
    return static_cast<std::size_t>(&point - surface_.points().data());
  }
  /// Returns which vertices have left their places in the original.
  std::vector<bool> find_all();
  void fit_all(const std::vector<bool>& moved);
  [[nodiscard]] std::vector<fields::FitPoint> fit_points() const;
  [[nodiscard]] std::size_t n_fitted() const {
    return static_cast<std::size_t>(std::count(fitted_.begin(), fitted_.end(), true));
  }
  void find(const Star& star, const glm::dvec3& target, std::span<float> values) const;
  void add_wishes(Vertex v, const StarFace& f, const glm::dvec3& target);

  const Mesh& mesh_;
  const OriginalSurface& surface_;
  OriginalValues original_;
  std::vector<bool> fitted_;    ///< by component
  std::vector<float> present_;  ///< by vertex; NaN where nothing is known
  std::vector<Wish> wishes_;    ///< by component, of the last proposal
  std::vector<float> proposed_;
};

}  // namespace aomd
