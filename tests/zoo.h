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
  return make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

// Two closed pyramids base to base.
inline MeshData octahedron() {
  return make({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

// Three triangles on one edge 0-1: a book with three pages.
inline MeshData book() {
  return make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 1, 0.5}, {-1, -1, 0.5}},
              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
}

// Two triangles that share one vertex only, and a vertex that nothing uses.
inline MeshData bow_tie() {
  return make({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}, {9, 9, 9}}, {{0, 2, 1}, {0, 3, 4}});
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
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m, r = 1 + 0.05 * std::sin(3 * u + 5 * v);
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
  for (int dim = 0; dim < 3; ++dim) {
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
