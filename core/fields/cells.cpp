#include "core/fields/cells.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/mesh/tet_geometry.h"

namespace aomd::fields {

Cells::Cells(const MeshData& mesh, int dimension) : mesh_(mesh), dimension_(dimension) {
  starts_.reserve(list().size() + 1);
  starts_.push_back(0);
  for (const Shape shape : list().shapes)
    starts_.push_back(starts_.back() +
                      static_cast<std::size_t>(shape_template(shape).vertex_count));
}

glm::dvec3 Cells::centre(std::uint32_t i) const {
  glm::dvec3 sum(0);
  for (const std::uint32_t v : vertices(i)) sum += mesh_.positions[v];
  return sum / static_cast<double>(vertices(i).size());
}

glm::dvec3 Cells::area_normal(std::uint32_t i) const {
  glm::dvec3 normal(0);
  for (std::size_t k = 2; k < vertices(i).size(); ++k)
    normal += glm::cross(corner(i, k - 1) - corner(i, 0), corner(i, k) - corner(i, 0));
  return normal;
}

double Cells::measure(std::uint32_t i) const {
  if (dimension_ == 1) return glm::distance(corner(i, 0), corner(i, 1));
  if (dimension_ == 3) return volume(i);
  return glm::length(area_normal(i)) / 2;
}

double Cells::volume(std::uint32_t i) const {
  if (shape(i) == Shape::Tetrahedron)
    return std::abs(six_volumes(corner(i, 0), corner(i, 1), corner(i, 2), corner(i, 3))) / 6;
  const ShapeTemplate& whole = shape_template(shape(i));
  double sum = 0;
  for (int f = 0; f < whole.face_count; ++f) {
    const SubEntity& side = whole.sub(2, f);
    const auto at = [&](std::size_t k) { return corner(i, side.vertices[k]); };
    for (std::size_t k = 2; k < static_cast<std::size_t>(shape_template(side.shape).vertex_count);
         ++k)
      sum += six_volumes(at(0), at(k - 1), at(k), corner(i, 0));
  }
  return std::abs(sum) / 6;
}

std::vector<double> measures(const MeshData& mesh, int dimension) {
  if (dimension > 0) {
    const Cells cells(mesh, dimension);
    std::vector<double> result(cells.size());
    for (std::uint32_t i = 0; i < cells.size(); ++i) result[i] = cells.measure(i);
    return result;
  }
  const Cells cells(mesh, !mesh.regions.empty() ? 3 : !mesh.faces.empty() ? 2 : 1);
  std::vector<double> result(mesh.positions.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const auto corners = cells.vertices(i);
    const double share = cells.measure(i) / static_cast<double>(corners.size());
    for (const std::uint32_t v : corners) result[v] += share;
  }
  return result;
}

}  // namespace aomd::fields
