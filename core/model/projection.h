#pragma once
// Closest points of a curve or surface of which only the parametrisation is known.

#include <functional>
#include <vector>

#include "core/model/model.h"

namespace aomd {

/// Position and derivatives at a pair of parameters; those by v are 0 on a curve.
struct Jet {
  glm::dvec3 p{}, u{}, v{}, uu{}, vv{}, uv{};
};

/// Finds closest points from samples of the parametrisation and refines them by Newton's method,
/// kept inside the range. A local method with many starts: it finds the nearest point where the
/// samples show every hollow of the distance.
class Projection {
 public:
  using Evaluate = std::function<Jet(const glm::dvec2&)>;

  /// Where samples have to be evaluated: `across` cell centres in each direction of the range (one
  /// on a curve in y). Never on the border, where parametrisations may collapse to a point.
  [[nodiscard]] static std::vector<glm::dvec2> sample_places(const ParameterRange& range,
                                                             int dimension, int across);

  Projection() = default;
  /// `samples` are the points at the sample places.
  Projection(const ParameterRange& range, int dimension, int across,
             std::vector<glm::dvec3> samples);

  [[nodiscard]] const ParameterRange& range() const { return range_; }
  /// The nearest point and its parameters. O(samples) and a few evaluations.
  [[nodiscard]] ClosestPoint closest(const Evaluate& evaluate, const glm::dvec3& point) const;

 private:
  struct Start {
    double distance;
    std::size_t sample;
  };
  [[nodiscard]] std::vector<Start> starts(const glm::dvec3& point) const;
  [[nodiscard]] std::size_t neighbour(std::size_t i, int du, int dv) const;
  [[nodiscard]] glm::dvec2 refine(const Evaluate& evaluate, const glm::dvec3& point,
                                  glm::dvec2 t) const;
  [[nodiscard]] glm::dvec2 inside(glm::dvec2 t) const;

  ParameterRange range_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<glm::dvec3> samples_;
  double spacing_ = 0;  ///< the largest distance between neighbouring samples
};

}  // namespace aomd
