#pragma once
// What collapses cost by the numbers that count beside the shape (after Hoppe 1999).

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/decimate/quadric.h"
#include "core/mesh/handle.h"
#include "core/operators/collapse.h"

namespace aomd {

/// Every face that a vertex stands for says by its linear functions what the numbers are to be at
/// any place. The error of a place is the squared distance of these, by area, from their mean: the
/// number that the vertex would have there. Everything is as seen from the vertex.
class AttributeQuadrics {
 public:
  /// Nothing is known of any vertex.
  void reset(std::size_t vertices, std::size_t components);

  /// A part of the surface says that a component is `value` at the vertex and changes so from
  /// there.
  void add(Vertex v, std::size_t component, float value, const glm::vec3& gradient, float area);
  /// Of two vertices as one, seen from `w`; `along` leads from there to `v`.
  [[nodiscard]] LocalQuadric together(Vertex v, Vertex w, const glm::vec3& along) const;
  /// A vertex takes in what another one stands for; both are to be seen from its new place, which
  /// is so far from each.
  void merge(Vertex deleted, const glm::vec3& from_deleted, Vertex kept,
             const glm::vec3& from_kept);

 private:
  /// Sums over all that says something of a component, by area.
  struct Sums {
    glm::vec3 gradient{0.0f};
    float value = 0, area = 0;
  };
  [[nodiscard]] std::span<const Sums> sums(Vertex v) const {
    return std::span(sums_).subspan(components_ * v.index, components_);
  }
  [[nodiscard]] std::span<Sums> sums(Vertex v) {
    return std::span(sums_).subspan(components_ * v.index, components_);
  }

  std::size_t components_ = 0;
  std::vector<LocalQuadric> squares_;  ///< by vertex: of what is said, all components together
  std::vector<Sums> sums_;
};

}  // namespace aomd
