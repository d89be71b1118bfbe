#include "core/mesh/shape.h"

#include <algorithm>
#include <bitset>
#include <stdexcept>
#include <string>

namespace aomd {
namespace {

constexpr SubEntity edge(std::uint8_t a, std::uint8_t b) { return {Shape::Line, {a, b}}; }
constexpr SubEntity tri(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
  return {Shape::Triangle, {a, b, c}};
}
constexpr SubEntity quad(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
  return {Shape::Quad, {a, b, c, d}};
}

std::size_t added = 0;

using VertexSet = std::bitset<max_shape_vertices>;

VertexSet vertex_set(const SubEntity& sub) {
  VertexSet set;
  for (int k = 0; k < shape_template(sub.shape).vertex_count; ++k)
    set.set(sub.vertices[static_cast<std::size_t>(k)]);
  return set;
}

void require(bool condition, const ShapeTemplate& shape, const char* what) {
  if (!condition)
    throw std::invalid_argument("template \"" + std::string(shape.name) + "\": " + what);
}

// Positions in range and different, no lower entity twice.
void check_subs(const ShapeTemplate& shape, int dim) {
  for (int i = 0; i < shape.count(dim); ++i) {
    const SubEntity& sub = shape.sub(dim, i);
    require(static_cast<std::size_t>(sub.shape) < shape_count() &&
                shape_template(sub.shape).dimension == dim,
            shape, "a lower entity has a shape of another dimension");
    const int n = shape_template(sub.shape).vertex_count;
    for (int k = 0; k < n; ++k)
      require(sub.vertices[static_cast<std::size_t>(k)] < shape.vertex_count, shape,
              "a position is out of range");
    require(vertex_set(sub).count() == static_cast<std::size_t>(n), shape,
            "a lower entity repeats a vertex");
    for (int k = 0; k < i; ++k)
      require(vertex_set(shape.sub(dim, k)) != vertex_set(sub), shape,
              "a lower entity is listed twice");
  }
}

bool has_edge(const ShapeTemplate& shape, std::uint8_t a, std::uint8_t b) {
  VertexSet set;
  set.set(a).set(b);
  return std::any_of(shape.edges.begin(), shape.edges.begin() + shape.edge_count,
                     [&](const SubEntity& e) { return vertex_set(e) == set; });
}

void check(const ShapeTemplate& shape) {
  require(shape.dimension == 2 || shape.dimension == 3, shape, "the dimension is 2 or 3");
  const bool face = shape.dimension == 2;
  require(shape.vertex_count >= 3 &&
              shape.vertex_count <= (face ? max_face_vertices : max_shape_vertices),
          shape, "too few or too many vertices");
  require(shape.edge_count >= 3 && shape.edge_count <= max_shape_edges, shape,
          "too few or too many edges");
  require(
      face ? shape.face_count == 0 : shape.face_count >= 3 && shape.face_count <= max_shape_faces,
      shape, "too few or too many faces");
  check_subs(shape, 1);
  check_subs(shape, 2);
  for (int k = 0; face && k < shape.vertex_count; ++k)
    require(
        shape.edge_count == shape.vertex_count &&
            shape.edges[static_cast<std::size_t>(k)].vertices[0] == k &&
            shape.edges[static_cast<std::size_t>(k)].vertices[1] == (k + 1) % shape.vertex_count,
        shape, "edge k of a face joins its vertices k and k + 1");
  for (int i = 0; i < shape.face_count; ++i) {
    const SubEntity& f = shape.sub(2, i);
    const int n = shape_template(f.shape).vertex_count;
    for (int k = 0; k < n; ++k)
      require(has_edge(shape, f.vertices[static_cast<std::size_t>(k)],
                       f.vertices[static_cast<std::size_t>((k + 1) % n)]),
              shape, "a face has a side that is no edge of the shape");
  }
}

}  // namespace

// Vertex numbering of the regions, as in Gmsh and VTK:
//
//   tetrahedron        pyramid            prism              hexahedron
//        3                 4               3-----5            7------6
//       /|\              / | \             |\   /|           /|     /|
//      / | \            3--|--2            | \ / |          4------5 |
//     0--|--2          /   | /             |  4  |          | 3----|-2
//      \ | /          0-----1              0--|--2          |/     |/
//        1                                  \ | /           0------1
//                                             1
constinit std::array<ShapeTemplate, max_shapes> detail::shape_templates = {{
    {"vertex", 0, 1, 0, 0, {}, {}},
    {"edge", 1, 2, 0, 0, {}, {}},
    {"triangle", 2, 3, 3, 0, {edge(0, 1), edge(1, 2), edge(2, 0)}, {}},
    {"quad", 2, 4, 4, 0, {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0)}, {}},
    {"tetrahedron",
     3,
     4,
     6,
     4,
     {edge(0, 1), edge(1, 2), edge(2, 0), edge(0, 3), edge(1, 3), edge(2, 3)},
     {tri(0, 2, 1), tri(0, 1, 3), tri(1, 2, 3), tri(2, 0, 3)}},
    {"pyramid",
     3,
     5,
     8,
     5,
     {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0), edge(0, 4), edge(1, 4), edge(2, 4),
      edge(3, 4)},
     {quad(0, 3, 2, 1), tri(0, 1, 4), tri(1, 2, 4), tri(2, 3, 4), tri(3, 0, 4)}},
    {"prism",
     3,
     6,
     9,
     5,
     {edge(0, 1), edge(1, 2), edge(2, 0), edge(3, 4), edge(4, 5), edge(5, 3), edge(0, 3),
      edge(1, 4), edge(2, 5)},
     {tri(0, 2, 1), tri(3, 4, 5), quad(0, 1, 4, 3), quad(1, 2, 5, 4), quad(2, 0, 3, 5)}},
    {"hexahedron",
     3,
     8,
     12,
     6,
     {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0), edge(4, 5), edge(5, 6), edge(6, 7),
      edge(7, 4), edge(0, 4), edge(1, 5), edge(2, 6), edge(3, 7)},
     {quad(0, 3, 2, 1), quad(4, 5, 6, 7), quad(0, 1, 5, 4), quad(1, 2, 6, 5), quad(2, 3, 7, 6),
      quad(3, 0, 4, 7)}},
}};

std::size_t shape_count() { return builtin_shapes + added; }

Shape add_template(const ShapeTemplate& shape) {
  check(shape);
  if (shape_count() == max_shapes) throw std::length_error("no room for another template");
  const std::size_t place = builtin_shapes + added;
  detail::shape_templates[place] = shape;
  ++added;
  return static_cast<Shape>(place);
}

void override_template(Shape shape, const ShapeTemplate& replacement) {
  const ShapeTemplate& present = shape_template(shape);
  check(replacement);
  require(static_cast<std::size_t>(shape) < shape_count() &&
              replacement.dimension == present.dimension &&
              replacement.vertex_count == present.vertex_count,
          replacement, "dimension and vertex count must stay");
  detail::shape_templates[static_cast<std::size_t>(shape)] = replacement;
}

Shape face_shape(std::size_t n) {
  for (std::size_t s = 0; s < shape_count(); ++s)
    if (detail::shape_templates[s].dimension == 2 &&
        detail::shape_templates[s].vertex_count == static_cast<int>(n))
      return static_cast<Shape>(s);
  throw std::invalid_argument("no face template has " + std::to_string(n) + " vertices");
}

std::array<std::uint32_t, max_shape_vertices> side_masks(const ShapeTemplate& shape, int dim) {
  std::array<std::uint32_t, max_shape_vertices> masks{};
  for (int i = 0; i < shape.count(dim); ++i) {
    const SubEntity& sub = shape.sub(dim, i);
    for (int k = 0; k < shape_template(sub.shape).vertex_count; ++k)
      masks[sub.vertices[static_cast<std::size_t>(k)]] |= 1u << i;
  }
  return masks;
}

bool told_by_sides(const ShapeTemplate& shape, int dim) {
  auto masks = side_masks(shape, dim);
  const auto end = masks.begin() + shape.vertex_count;
  std::sort(masks.begin(), end);
  return masks[0] != 0 && std::adjacent_find(masks.begin(), end) == end;
}

}  // namespace aomd
