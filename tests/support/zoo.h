#pragma once
// The mesh zoo: tiny meshes, drawn, that every edit and every relation is tried on.

#include <cmath>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/samples/samples.h"

namespace aomd::zoo {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

inline MeshData make(std::vector<glm::dvec3> positions, const Triangles& triangles) {
  MeshData data;
  data.positions = std::move(positions);
  for (const auto& t : triangles) data.faces.add(Shape::Triangle, {t[0], t[1], t[2]});
  return data;
}

//  2
//  | \        .
//  0--1
inline MeshData triangle() { return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}); }

//  3--2
//  | /|
//  |/ |
//  0--1
inline MeshData square() {
  return make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

inline MeshData tetrahedron() {
  return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

// Two closed pyramids base to base.
inline MeshData octahedron() {
  return make(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

// Three triangles on one edge 0-1: a book with three pages.
inline MeshData book() {
  return make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 1, 0.5}, {-1, -1, 0.5}},
              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
}

// Two triangles that share one vertex only, and a vertex that nothing uses.
inline MeshData bow_tie() {
  return make({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}, {9, 9, 9}},
              {{0, 2, 1}, {0, 3, 4}});
}

// A grid of n x n squares in the plane, each cut in two; vertex (i, j) has index j * (n + 1) + i.
inline MeshData grid(std::uint32_t n) {
  std::vector<glm::dvec3> p;
  Triangles t;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) p.emplace_back(i, j, 0);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      t.push_back({v, v + 1, v + n + 2});
      t.push_back({v, v + n + 2, v + n + 1});
    }
  return make(p, t);
}

// A closed torus of n x m squares, each cut in two; gently bumpy so that no two vertices are alike.
inline MeshData torus(std::uint32_t n, std::uint32_t m) {
  std::vector<glm::dvec3> p;
  Triangles t;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m,
                   r = 1 + 0.05 * std::sin(3 * u + 5 * v);
      p.emplace_back((3 + r * std::cos(v)) * std::cos(u), (3 + r * std::cos(v)) * std::sin(u),
                     r * std::sin(v));
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % n) * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      t.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      t.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return make(p, t);
}

// Two copies of a face and a pocket: what dirty scans hold.
inline MeshData dirty() {
  MeshData data = grid(4);
  data.faces.add(Shape::Triangle, {0, 1, 6});    // repeated
  data.faces.add(Shape::Triangle, {6, 8, 7});    // the other way round than its neighbours
  data.faces.add(Shape::Triangle, {12, 13, 3});  // third face on an edge
  return data;
}

using Solids = std::vector<std::pair<Shape, std::vector<std::uint32_t>>>;

inline MeshData make_volume(std::vector<glm::dvec3> positions, const Solids& solids) {
  MeshData data;
  data.positions = std::move(positions);
  for (const auto& [shape, v] : solids) {
    data.regions.shapes.push_back(shape);
    data.regions.vertices.insert(data.regions.vertices.end(), v.begin(), v.end());
  }
  return data;
}

//      3
//     /|\       one tetrahedron, the corner of a cube
//    / | \      .
//   0--|--2
//    \ | /
//      1
inline MeshData one_tet() {
  return make_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{Shape::Tetrahedron, {0, 1, 2, 3}}});
}

//      3
//     /|\        .
//    / | \      region 0 = 0 1 2 3 and region 1 = 1 2 3 4 share the face 1 2 3; 4 lies behind it
//   0--|--2--4
//    \ | /
//      1
inline MeshData two_tets() {
  return make_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                     {{Shape::Tetrahedron, {0, 1, 2, 3}}, {Shape::Tetrahedron, {1, 2, 3, 4}}});
}

//   2   4
//   |\ /|       two tetrahedra that share only the edge 0-1, seen along it
//   | 0 |
//   |/ \|
//   3   5
inline MeshData tets_on_an_edge() {
  return make_volume({{0, 0, 0}, {0, 0, 1}, {-1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {1, -1, 0}},
                     {{Shape::Tetrahedron, {0, 1, 2, 3}}, {Shape::Tetrahedron, {0, 1, 5, 4}}});
}

// Two tetrahedra that share only vertex 0, point to point.
inline MeshData tets_on_a_vertex() {
  return make_volume(
      {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}},
      {{Shape::Tetrahedron, {2, 1, 3, 0}}, {Shape::Tetrahedron, {4, 5, 6, 0}}});
}

// From the front: a pyramid on a hexahedron, a prism at its right, a tetrahedron 11 on the
// pyramid's right side, and one, 12, on the prism's front.
//        8--.
//       / \  '-11
//   4(7)---5(6)
//    |      |  \           .
//   0(3)---1(2)-9(10)
//             12
inline MeshData hybrid() {
  MeshData data = make_volume({{0, 0, 0},
                               {1, 0, 0},
                               {1, 1, 0},
                               {0, 1, 0},
                               {0, 0, 1},
                               {1, 0, 1},
                               {1, 1, 1},
                               {0, 1, 1},
                               {0.5, 0.5, 1.5},
                               {2, 0, 0},
                               {2, 1, 0},
                               {1.7, 0.5, 1.2},
                               {1.3, -1, 0.3}},
                              {{Shape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}},
                               {Shape::Pyramid, {4, 5, 6, 7, 8}},
                               {Shape::Tetrahedron, {5, 6, 8, 11}},
                               {Shape::Prism, {1, 5, 9, 2, 6, 10}},
                               {Shape::Tetrahedron, {1, 9, 5, 12}}});
  data.regions.classes = {ModelRef(3, 1), ModelRef(3, 1), ModelRef(3, 2), ModelRef(3, 2),
                          ModelRef(3, 2)};
  data.faces.add(Shape::Quad, {1, 2, 6, 5}, ModelRef(2, 7));  // between the two model regions
  return data;
}

//     4
//    /|\        .
//   / 0 \      three tetrahedra around the edge 0-1, seen along it; the triangle 2 3 5 hangs on
//  / / \ \     one of them, the edge 5-6 on that
//  2-----3
//   \   /
//     5---6
inline MeshData fan() {
  MeshData data = make_volume(
      {{0, 0, 0}, {0, 0, 1}, {-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}, {0, -2, 0.5}, {1, -2, 0.5}},
      {{Shape::Tetrahedron, {0, 1, 2, 3}},
       {Shape::Tetrahedron, {0, 1, 3, 4}},
       {Shape::Tetrahedron, {0, 1, 4, 2}}});
  data.faces.add(Shape::Triangle, {2, 5, 3});
  data.edges.add(Shape::Line, {5, 6});
  return data;
}

// A sheet of 2 x 2 squares (see grid) with a tetrahedron standing on one of its triangles, upside
// down for it.
inline MeshData glued() {
  MeshData data = grid(2);
  data.positions.emplace_back(1.5, 0.5, 1);
  data.regions.add(Shape::Tetrahedron, {1, 2, 5, 9}, ModelRef(3, 1));
  return data;
}

struct Animal {
  std::string name;
  MeshData data;
};

inline std::vector<Animal> all() {
  return {{"triangle", triangle()},
          {"square", square()},
          {"tetrahedron", tetrahedron()},
          {"octahedron", octahedron()},
          {"book", book()},
          {"bow_tie", bow_tie()},
          {"grid", grid(6)},
          {"torus", torus(12, 9)},
          {"dirty", dirty()}};
}

inline std::vector<Animal> volumes() {
  return {{"one_tet", one_tet()},
          {"two_tets", two_tets()},
          {"tets_on_an_edge", tets_on_an_edge()},
          {"tets_on_a_vertex", tets_on_a_vertex()},
          {"hybrid", hybrid()},
          {"fan", fan()},
          {"glued", glued()}};
}

/// V - E + F over the vertices that faces use, from the faces alone.
inline int euler(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::vector<std::uint32_t> used;
  std::array<std::uint32_t, max_shape_vertices> buffer;
  for (const Face f : mesh.faces()) {
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 0; k < v.size(); ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % v.size()];
      sides.emplace_back(std::min(a, b), std::max(a, b));
      used.push_back(a);
    }
  }
  const auto distinct = [](auto& list) {
    std::sort(list.begin(), list.end());
    return static_cast<int>(std::unique(list.begin(), list.end()) - list.begin());
  };
  return distinct(used) - distinct(sides) + static_cast<int>(mesh.count(2));
}

/// Everything that the mesh is, as text: equal strings, equal meshes (ids, id stacks, connectivity,
/// positions, classes).
inline std::string fingerprint(const Mesh& mesh) {
  std::string s;
  const auto add = [&](auto x) { s += std::to_string(x) + ' '; };
  std::array<std::uint32_t, max_shape_vertices> buffer;
  for (int dim = 0; dim < 4; ++dim) {
    s += "| ";
    for (const std::uint32_t id : mesh.ids(dim).free_ids()) add(id);
    s += ": ";
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      if (!mesh.ids(dim).alive(id)) continue;
      add(id);
      for (const std::uint32_t v : mesh.vertices_of(EntityRef(dim, id), buffer)) add(v);
      add(mesh.classification(EntityRef(dim, id)).bits());
    }
  }
  for (const Vertex v : mesh.vertices())
    for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(mesh.position(v)[k]));
  return s;
}

}  // namespace aomd::zoo
