#pragma once
// The entities of plain arrays by number.

#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/tet_coordinates.h"
#include "core/mesh/mesh_data.h"

namespace aomd::fields {

/// The edges, faces or regions of a mesh, each with its vertices. The mesh must outlive it.
class Cells {
 public:
  Cells(const MeshData& mesh, int dimension);

  [[nodiscard]] const MeshData& mesh() const { return mesh_; }
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(list().size()); }
  [[nodiscard]] Shape shape(std::uint32_t i) const { return list().shapes[i]; }
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::uint32_t i) const {
    return std::span(list().vertices).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }
  /// Its first one among the corners of all.
  [[nodiscard]] std::size_t first_corner(std::uint32_t i) const { return starts_[i]; }
  /// Unclassified where the list has no classes.
  [[nodiscard]] ModelRef model(std::uint32_t i) const {
    return list().classes.empty() ? ModelRef() : list().classes[i];
  }
  [[nodiscard]] const glm::dvec3& corner(std::uint32_t i, std::size_t k) const {
    return mesh_.positions[list().vertices[starts_[i] + k]];
  }
  /// The corners of a tetrahedron.
  [[nodiscard]] Tet tet(std::uint32_t i) const {
    return {corner(i, 0), corner(i, 1), corner(i, 2), corner(i, 3)};
  }
  [[nodiscard]] glm::dvec3 centre(std::uint32_t i) const;
  /// Of a face, as a fan around its first vertex: its length is twice the area.
  [[nodiscard]] glm::dvec3 area_normal(std::uint32_t i) const;
  /// Length, area or volume, whichever way it stands; faces as fans around their first vertex.
  [[nodiscard]] double measure(std::uint32_t i) const;

 private:
  [[nodiscard]] const EntityList& list() const { return mesh_.list(dimension_); }
  [[nodiscard]] double volume(std::uint32_t i) const;

  const MeshData& mesh_;
  int dimension_;
  std::vector<std::size_t> starts_;  ///< one more than there are cells
};

/// How much of the mesh each entity of a dimension stands for: its measure, and for vertices a
/// share of that of every cell of the mesh's own dimension that they are a corner of.
[[nodiscard]] std::vector<double> measures(const MeshData& mesh, int dimension);

}  // namespace aomd::fields
