#include "core/io/gltf_rows.h"

#include <limits>
#include <numeric>

#include "core/io/weld.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {

GltfRows::GltfRows(const MeshData& mesh, const std::vector<GltfArray>& arrays) : arrays_(arrays) {
  for (const GltfArray& a : arrays_)
    lists_.push_back(a.on_corners ? indexed(*a.array, true, mesh) : IndexedValues());
  vertices_.resize(mesh.positions.size());
  std::iota(vertices_.begin(), vertices_.end(), 0u);
  split(mesh);
  Welder places;
  for (const glm::dvec3& p : mesh.positions) places.add(glm::dvec3(glm::vec3(p)));
  places_repeat_ = places.size() < mesh.positions.size();
}

void GltfRows::split(const MeshData& mesh) {
  corner_of_row_.assign(vertices_.size(), no_index);
  next_.assign(vertices_.size(), no_index);
  of_corner_.reserve(mesh.faces.vertices.size());
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c)
    of_corner_.push_back(row_of(mesh.faces.vertices[c], c));
}

/// The row of the vertex that says the same as the corner; rows of one vertex are a chain.
std::uint32_t GltfRows::row_of(std::uint32_t vertex, std::size_t corner) {
  std::uint32_t row = vertex;
  if (corner_of_row_[row] == no_index) corner_of_row_[row] = static_cast<std::uint32_t>(corner);
  while (!same(row, corner)) {
    if (next_[row] == no_index) {
      next_[row] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(vertex);
      corner_of_row_.push_back(static_cast<std::uint32_t>(corner));
      next_.push_back(no_index);
    }
    row = next_[row];
  }
  return row;
}

bool GltfRows::same(std::size_t row, std::size_t corner) const {
  const std::size_t other = corner_of_row_[row];
  for (const IndexedValues& list : lists_)
    if (!list.corners.empty() && list.corners[other] != list.corners[corner]) return false;
  return true;
}

/// Which value of an array on corners a row has.
std::uint32_t GltfRows::item(std::size_t array, std::size_t row) const {
  const std::uint32_t corner = corner_of_row_[row];
  return corner == no_index ? no_index : lists_[array].corners[corner];
}

bool GltfRows::known(std::size_t array, std::size_t row) const {
  if (arrays_[array].on_corners) return item(array, row) != no_index;
  return has_numbers(*arrays_[array].array, vertices_[row]);
}

double GltfRows::value(std::size_t array, std::size_t row, int component) const {
  const Attribute& a = *arrays_[array].array;
  const auto n = static_cast<std::size_t>(a.components), k = static_cast<std::size_t>(component);
  if (!arrays_[array].on_corners) return a.values[n * vertices_[row] + k];
  const std::uint32_t i = item(array, row);
  return i == no_index ? std::numeric_limits<double>::quiet_NaN()
                       : lists_[array].numbers[n * i + k];
}

}  // namespace aomd::io::detail
