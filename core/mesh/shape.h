#pragma once
// The templates (paper, section 2.2): how the vertices of an entity form its lower entities.

#include <array>
#include <cstdint>
#include <string_view>

namespace aomd {

/// The type of an entity. Values beyond the built-in ones belong to templates that a program adds.
enum class Shape : std::uint8_t { Point, Line, Triangle, Quad, Tetrahedron, Pyramid, Prism, Hexahedron };

inline constexpr int max_shape_vertices = 8;
inline constexpr int max_shape_edges = 12;
inline constexpr int max_shape_faces = 6;

/// Vertices of a lower entity as positions in the vertex list of the whole one.
struct SubEntity {
  Shape shape = Shape::Point;
  std::array<std::uint8_t, 4> vertices{};
};

/// One template: the lower entities of a shape, oriented as in Gmsh and VTK (faces of a region look outward).
struct ShapeTemplate {
  std::string_view name;
  int dimension = 0;
  int vertex_count = 0;
  int edge_count = 0;
  int face_count = 0;
  std::array<SubEntity, max_shape_edges> edges{};
  std::array<SubEntity, max_shape_faces> faces{};

  /// How many lower entities of dimension `dim` there are (dim < dimension).
  [[nodiscard]] constexpr int count(int dim) const {
    return dim == 0 ? vertex_count : dim == 1 ? edge_count : dim == 2 ? face_count : 0;
  }
  /// The i-th lower entity of dimension `dim`, 1 or 2.
  [[nodiscard]] constexpr const SubEntity& sub(int dim, int i) const {
    return dim == 1 ? edges[static_cast<std::size_t>(i)] : faces[static_cast<std::size_t>(i)];
  }
};

inline constexpr std::size_t shape_count = 8;
/// All templates, indexed by Shape.
extern const std::array<ShapeTemplate, shape_count> shape_templates;

/// The template of a shape. O(1).
[[nodiscard]] inline const ShapeTemplate& shape_template(Shape shape) {
  return shape_templates[static_cast<std::size_t>(shape)];
}

}  // namespace aomd
