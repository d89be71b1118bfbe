#pragma once
// Small meshes of tetrahedra with several materials: what collapses among them are tried on.

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/handle.h"
#include "core/mesh/mesh_data.h"

namespace aomd::zoo {

/// A cell of a grid and which of its six tetrahedra; the first three are those with x >= y.
struct Cell {
  int x, y, z, part;
};
/// The tag of the model region that a tetrahedron lies on; 0: there is none.
using Material = std::function<int(const Cell&)>;

/// A grid of cubes, each cut into the six tetrahedra around its diagonal (Kuhn). Vertices that no
/// tetrahedron uses are left out. With `bend` no four vertices of neighbouring cells are in a plane
/// by accident, but for those on the outside.
inline MeshData tet_grid(std::array<int, 3> n, const Material& material, double bend = 0) {
  const auto at = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * (n[1] + 1) + y) * (n[0] + 1) + x);
  };
  std::vector<glm::dvec3> places(at(n[0], n[1], n[2]) + 1);
  for (int z = 0; z <= n[2]; ++z)
    for (int y = 0; y <= n[1]; ++y)
      for (int x = 0; x <= n[0]; ++x) {
        const bool outside = x == 0 || y == 0 || z == 0 || x == n[0] || y == n[1] || z == n[2];
        const double s = outside ? 0 : bend * std::sin(3.0 * x + 5.0 * y + 7.0 * z);
        places[at(x, y, z)] = {x + s, y - 0.7 * s, z + 0.4 * s};
      }
  MeshData data;
  std::vector<std::uint32_t> numbers(places.size(), no_index);
  const auto number = [&](std::size_t place) {
    if (numbers[place] == no_index) {
      numbers[place] = static_cast<std::uint32_t>(data.positions.size());
      data.positions.push_back(places[place]);
    }
    return numbers[place];
  };
  constexpr int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {2, 0, 1}, {1, 0, 2}, {1, 2, 0}, {2, 1, 0}};
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x)
        for (int part = 0; part < 6; ++part) {
          const int tag = material({x, y, z, part});
          if (tag == 0) continue;
          std::array<int, 3> p{x, y, z};
          std::array<std::uint32_t, 4> v{number(at(x, y, z))};
          for (std::size_t k = 0; k < 3; ++k) {
            ++p[static_cast<std::size_t>(axes[part][k])];
            v[k + 1] = number(at(p[0], p[1], p[2]));
          }
          const bool even = part == 0 || part == 2 || part == 4;
          if (!even) std::swap(v[2], v[3]);
          data.regions.add(Shape::Tetrahedron, {v[0], v[1], v[2], v[3]}, ModelRef(3, tag));
        }
  return data;
}

struct TetAnimal {
  std::string name;
  MeshData data;
};

/// Every topology that a collapse could spoil, a few hundred tetrahedra each.
inline std::vector<TetAnimal> tets() {
  const auto in = [](int v, int low, int high) { return low <= v && v < high; };
  const auto inner = [=](const Cell& c) { return in(c.x, 1, 3) && in(c.y, 1, 3) && in(c.z, 1, 3); };
  return {{"box", tet_grid(
                      {3, 3, 3}, [](const Cell&) { return 1; }, 0.1)},
          {"on a face", tet_grid(
                            {4, 2, 2}, [](const Cell& c) { return c.x < 2 ? 1 : 2; }, 0.1)},
          {"on an edge", tet_grid({4, 4, 2}, [](const Cell& c) { return (c.x < 2) == (c.y < 2); })},
          {"on a vertex", tet_grid({4, 4, 4},
                                   [](const Cell& c) {
                                     const bool x = c.x < 2, y = c.y < 2, z = c.z < 2;
                                     return x == y && y == z;
                                   })},
          {"shell", tet_grid({4, 4, 4}, [=](const Cell& c) { return inner(c) ? 0 : 1; })},
          {"ball in a box", tet_grid(
                                {4, 4, 4}, [=](const Cell& c) { return inner(c) ? 2 : 1; }, 0.1)},
          {"three materials on a line",
           tet_grid(
               {4, 4, 3}, [](const Cell& c) { return c.y < 2   ? 1
                                                     : c.x < 2 ? 2
                                                               : 3; }, 0.1)},
          {"torus in a torus", tet_grid({5, 5, 3},
                                        [=](const Cell& c) {
                                          if (c.x == 2 && c.y == 2) return 0;
                                          return c.z == 1 && in(c.x, 1, 4) && in(c.y, 1, 4) ? 2 : 1;
                                        })},
          {"one cell thick", tet_grid(
                                 {4, 4, 3}, [](const Cell& c) { return c.z == 1 ? 2 : 1; }, 0.1)},
          {"tube of triangles",
           tet_grid(
               {3, 3, 4}, [](const Cell& c) { return c.x == 1 && c.y == 1 && c.part < 3 ? 2 : 1; },
               0.1)},
          {"touches in a point", tet_grid({4, 4, 4},
                                          [=](const Cell& c) {
                                            return in(c.x, 1, 3) && in(c.y, 1, 3) &&
                                                           (c.z < 1 ? c.x + c.y == 2 && c.part == 0
                                                                    : c.z < 3)
                                                       ? 2
                                                       : 1;
                                          })},
          {"two beside each other", tet_grid({4, 4, 3}, [=](const Cell& c) {
             return c.z == 1 && ((c.x == 1 && c.y == 1) || (c.x == 2 && c.y == 2)) ? 2 : 1;
           })}};
}

}  // namespace aomd::zoo
