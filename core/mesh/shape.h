#pragma once
// The templates (paper, section 2.2): how the vertices of an entity form its lower entities.

#include <array>
#include <cstdint>
#include <string_view>

#pragma GCC visibility push(default)

namespace aomd {

/// The type of an entity. Values from `builtin_shapes` on belong to templates that a program adds.
enum class Shape : std::uint8_t {
  Point,
  Line,
  Triangle,
  Quad,
  Tetrahedron,
  Pyramid,
  Prism,
  Hexahedron
};

inline constexpr std::size_t builtin_shapes = 8;
inline constexpr std::size_t max_shapes = 32;
inline constexpr int max_shape_vertices = 12;
inline constexpr int max_shape_edges = 18;
inline constexpr int max_shape_faces = 8;
inline constexpr int max_face_vertices = 6;

/// Vertices of a lower entity as positions in the vertex list of the whole one.
struct SubEntity {
  Shape shape = Shape::Point;
  std::array<std::uint8_t, max_face_vertices> vertices{};
};

/// One template: the lower entities of a shape, oriented as in Gmsh and VTK (faces of a region look
/// outward).
struct ShapeTemplate {
  std::string_view name;  ///< must outlive the program's use of the template
  int dimension = 0;
  int vertex_count = 0;
  int edge_count = 0;
  int face_count = 0;
  std::array<SubEntity, max_shape_edges> edges{};
  std::array<SubEntity, max_shape_faces> faces{};

  /// How many lower entities of dimension `dim` there are (dim < dimension).
  [[nodiscard]] int count(int dim) const {
    return dim == 0 ? vertex_count : dim == 1 ? edge_count : dim == 2 ? face_count : 0;
  }
  /// The i-th lower entity of dimension `dim`, 1 or 2.
  [[nodiscard]] const SubEntity& sub(int dim, int i) const {
    return dim == 1 ? edges[static_cast<std::size_t>(i)] : faces[static_cast<std::size_t>(i)];
  }
};

namespace detail {
extern std::array<ShapeTemplate, max_shapes> shape_templates;
}

/// The template of a shape. O(1).
[[nodiscard]] inline const ShapeTemplate& shape_template(Shape shape) {
  return detail::shape_templates[static_cast<std::size_t>(shape)];
}
/// How many shapes there are: the built-in ones and those added so far.
[[nodiscard]] std::size_t shape_count();

/// Adds a template for faces or regions and returns its shape. Templates are shared by all meshes
/// of the program and not locked: add them before meshes use them. Throws std::invalid_argument
/// when the template contradicts itself (limits above, positions out of range, a face that does not
/// follow the edges, edges or faces listed twice) and std::length_error when all max_shapes are
/// taken.
Shape add_template(const ShapeTemplate& shape);
/// Replaces the template of a shape that no mesh uses, a built-in one included: to number its lower
/// entities differently. Vertex count and dimension must stay. Throws as add_template does.
void override_template(Shape shape, const ShapeTemplate& replacement);

/// The face shape with `n` vertices: triangle, quad, or the first added one. Throws
/// std::invalid_argument where there is none.
[[nodiscard]] Shape face_shape(std::size_t n);

/// For each vertex of a template, the set of lower entities of dimension `dim` on which it lies:
/// bit i for the i-th. Where the sets differ, the vertices can be told from those entities alone.
[[nodiscard]] std::array<std::uint32_t, max_shape_vertices> side_masks(const ShapeTemplate& shape,
                                                                       int dim);
/// True where they differ and none is empty.
[[nodiscard]] bool told_by_sides(const ShapeTemplate& shape, int dim);

}  // namespace aomd

#pragma GCC visibility pop
