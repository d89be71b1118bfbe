#pragma once
// The vertices of a glTF file: those of a mesh, split where values on corners jump.

#include <cstdint>
#include <vector>

#include "core/io/corner_values.h"
#include "core/io/gltf_arrays.h"

namespace aomd::io::detail {

/// Rows of accessors: first one for each vertex of the mesh, in its order, then those that vertices
/// need besides.
class GltfRows {
 public:
  GltfRows(const MeshData& mesh, const std::vector<GltfArray>& arrays);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] std::uint32_t vertex(std::size_t row) const { return vertices_[row]; }
  [[nodiscard]] static std::uint32_t first_of(std::uint32_t vertex) { return vertex; }
  /// The row of a corner of the faces.
  [[nodiscard]] std::uint32_t of_corner(std::size_t corner) const { return of_corner_[corner]; }
  /// Whether an array says something of a row, and what.
  [[nodiscard]] bool known(std::size_t array, std::size_t row) const;
  [[nodiscard]] double value(std::size_t array, std::size_t row, int component) const;
  /// True where vertices are told apart by more than their places, as 32-bit floats.
  [[nodiscard]] bool places_repeat() const { return places_repeat_; }

 private:
  void split(const MeshData& mesh);
  [[nodiscard]] std::uint32_t row_of(std::uint32_t vertex, std::size_t corner);
  [[nodiscard]] bool same(std::size_t row, std::size_t corner) const;
  [[nodiscard]] std::uint32_t item(std::size_t array, std::size_t row) const;

  const std::vector<GltfArray>& arrays_;
  std::vector<IndexedValues> lists_;  ///< of arrays on corners; empty for the others
  std::vector<std::uint32_t> vertices_, corner_of_row_, next_, of_corner_;
  bool places_repeat_ = false;
};

}  // namespace aomd::io::detail
