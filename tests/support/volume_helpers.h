#pragma once
// Small meshes with regions, and facts about them.

#include <glm/geometric.hpp>

#include <algorithm>

#include "core/io/formats.h"
#include "tests/support/io_helpers.h"

namespace aomd::test {

/// Each region once, a quad, a triangle, and edges; classified, with attributes of every dimension.
/// The pyramid stands on the hexahedron, the prism on one of its sides, the tetrahedron on the
/// prism.
inline MeshData one_of_each() {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},     {0, 1, 0}, {0, 0, 1},     {1, 0, 1},
                    {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}, {2, 0, 0}, {2, 0.1, 1.0}, {3, 0.3, 0}};
  mesh.edges.add(Shape::Line, {0, 1}, ModelRef(1, 1));
  mesh.edges.add(Shape::Line, {1, 2}, ModelRef(1, 2));
  mesh.faces.add(Shape::Quad, {0, 3, 2, 1}, ModelRef(2, 1));
  mesh.faces.add(Shape::Triangle, {4, 5, 8}, ModelRef(2, 2));
  mesh.regions.add(Shape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}, ModelRef(3, 1));
  mesh.regions.add(Shape::Pyramid, {4, 5, 6, 7, 8}, ModelRef(3, 1));
  mesh.regions.add(Shape::Prism, {1, 9, 2, 5, 10, 6}, ModelRef(3, 2));
  mesh.regions.add(Shape::Tetrahedron, {9, 11, 2, 10}, ModelRef(3, 3));
  mesh.vertex_classes = {{0, 1}, {1, 1}, {1, 2}, {2, 1}, {2, 2}, {2, 2},
                         {3, 1}, {3, 1}, {2, 2}, {3, 2}, {3, 2}, {3, 3}};
  return mesh;
}

/// Three times the signed volume at a region's first corner: positive where its faces look outward.
template <class Use>
void for_each_corner_volume(const MeshData& mesh, Use&& use) {
  std::size_t i = 0;
  io::detail::for_each_entity(mesh.regions, [&](auto v, ModelRef) {
    const Shape shape = mesh.regions.shapes[i++];
    const bool quad_base = shape == Shape::Pyramid || shape == Shape::Hexahedron;
    const auto at = [&](std::size_t k) { return mesh.positions[v[k]] - mesh.positions[v[0]]; };
    const std::size_t top = quad_base ? 4 : 3, side = quad_base ? 3 : 2;
    use(shape, glm::dot(glm::cross(at(1), at(side)), at(top)));
  });
}

inline std::size_t count(const EntityList& list, Shape shape) {
  return static_cast<std::size_t>(std::count(list.shapes.begin(), list.shapes.end(), shape));
}

/// What is written under this name and read again.
inline io::ReadResult written_and_read(const char* name, const MeshData& mesh,
                                       std::optional<bool> binary = {}) {
  const TemporaryFolder folder;
  io::write(folder / name, mesh, {.binary = binary});
  return io::read(folder / name);
}

/// Expects equality, part by part.
inline void expect_same(const MeshData& a, const MeshData& b) {
  EXPECT_TRUE(a.positions == b.positions);
  EXPECT_TRUE(a.vertex_classes == b.vertex_classes);
  for (int d = 1; d <= 3; ++d) {
    EXPECT_TRUE(a.list(d).shapes == b.list(d).shapes) << d;
    EXPECT_TRUE(a.list(d).vertices == b.list(d).vertices) << d;
    EXPECT_TRUE(a.list(d).classes == b.list(d).classes) << d;
  }
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    EXPECT_EQ(a.attributes[i].name, b.attributes[i].name);
    EXPECT_TRUE(a.attributes[i] == b.attributes[i])
        << a.attributes[i].name << ' ' << a.attributes[i].dimension;
  }
  EXPECT_TRUE(a.model == b.model);
}

}  // namespace aomd::test
