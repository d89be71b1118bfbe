// Volume samples: boxes of every shape, a drilled box, a layered beam and a ball, all classified.

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/samples/build.h"
#include "core/samples/makers.h"
#include "core/samples/numeric.h"
#include "core/samples/volume_build.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

/// Vertices of a grid of cells, numbered along i first, then j, then k. Where `around`, the last j
/// is the first again.
class Grid {
 public:
  Grid(int ni, int nj, int nk, bool around = false)
      : cells_{ni, nj, nk}, rows_(around ? nj : nj + 1) {}

  void add_vertices(MeshData& mesh,
                    const std::function<glm::dvec3(int, int, int)>& position) const {
    for (int k = 0; k <= cells_[2]; ++k) {
      for (int j = 0; j < rows_; ++j) {
        for (int i = 0; i <= cells_[0]; ++i) add_vertex(mesh, position(i, j, k));
      }
    }
  }

  [[nodiscard]] Cell cell(int i, int j, int k) const {
    Cell corners{};
    for (int c = 0; c < 8; ++c)
      corners[static_cast<std::size_t>(c)] =
          at(i + (c & 1), (j + (c >> 1 & 1)) % rows_, k + (c >> 2));
    return corners;
  }

  /// Calls visit(i, j, k) for every cell.
  template <class Visit>
  void for_each_cell(Visit&& visit) const {
    for (int k = 0; k < cells_[2]; ++k) {
      for (int j = 0; j < cells_[1]; ++j) {
        for (int i = 0; i < cells_[0]; ++i) visit(i, j, k);
      }
    }
  }

 private:
  [[nodiscard]] Index at(int i, int j, int k) const {
    return static_cast<Index>((k * rows_ + j) * (cells_[0] + 1) + i);
  }

  std::array<int, 3> cells_;
  int rows_;
};

constexpr ModelRef solid(3, 1);

template <class AddCell>
MeshData make_cube(int n, AddCell&& add_cell) {
  MeshData mesh;
  const Grid grid(n, n, n);
  grid.add_vertices(
      mesh, [&](int i, int j, int k) { return glm::dvec3(i, j, k) / static_cast<double>(n); });
  grid.for_each_cell([&](int i, int j, int k) { add_cell(mesh, grid.cell(i, j, k), solid); });
  classify_below_regions(
      mesh, [](const glm::dvec3& p) { return side_of_box(p, glm::dvec3(0), glm::dvec3(1), 0); });
  return mesh;
}

/// A ball around the origin: each face of an icosahedron and the centre span a tetrahedron, cut
/// into n^3 (Freudenthal's subdivision, which matches across faces when corners are taken in one
/// order everywhere).
class Ball {
 public:
  explicit Ball(int n) : n_(n), surface_(make_sphere(1)) {}

  MeshData make() {
    for (std::size_t f = 0; f < surface_.faces.size(); ++f) {
      Corners c{surface_.faces.vertices[3 * f], surface_.faces.vertices[3 * f + 1],
                surface_.faces.vertices[3 * f + 2]};
      const Corners outward = c;
      std::sort(c.begin(), c.end());
      const auto at = static_cast<std::size_t>(std::find(outward.begin(), outward.end(), c[0]) -
                                               outward.begin());
      subdivide(c, outward[(at + 1) % 3] == c[1]);
    }
    classify_below_regions(mesh_, [](const glm::dvec3&) { return 1; });
    return std::move(mesh_);
  }

 private:
  using Corners = std::array<Index, 3>;
  using Lattice = std::array<int, 3>;

  /// Points n >= x >= y >= z >= 0: x layers from the centre, of which x - y, y - z and z go to the
  /// corners.
  [[nodiscard]] bool inside(const Lattice& p) const {
    return n_ >= p[0] && p[0] >= p[1] && p[1] >= p[2] && p[2] >= 0;
  }

  void subdivide(const Corners& c, bool even) {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    for (int x = 0; x < n_; ++x)
      for (int y = 0; y <= x; ++y)
        for (int z = 0; z <= y; ++z)
          for (int o = 0; o < 6; ++o) {
            std::array<Lattice, 4> p;
            p.fill({x, y, z});
            for (std::size_t step = 1; step < 4; ++step)
              for (std::size_t i = step; i < 4; ++i)
                ++p[i][static_cast<std::size_t>(orders[o][step - 1])];
            if (std::all_of(p.begin(), p.end(), [&](const Lattice& q) { return inside(q); }))
              add(c, p, even == (o < 3));
          }
  }

  void add(const Corners& c, const std::array<Lattice, 4>& p, bool upright) {
    std::array<Index, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) v[i] = vertex(c, p[i]);
    if (!upright) std::swap(v[1], v[2]);
    mesh_.regions.add(Shape::Tetrahedron, {v[0], v[1], v[2], v[3]}, solid);
  }

  Index vertex(const Corners& c, const Lattice& p) {
    const int weights[3] = {p[0] - p[1], p[1] - p[2], p[2]};
    std::array<int, 6> key{};  // corner and weight, those without weight left out
    glm::dvec3 direction(0);
    std::size_t used = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0) continue;
      key[used++] = static_cast<int>(c[i]) + 1;
      key[used++] = weights[i];
      direction += surface_.positions[c[i]] * static_cast<double>(weights[i]);
    }
    const auto [at, is_new] = vertices_.try_emplace(key, 0);
    if (is_new) {
      const double radius = static_cast<double>(p[0]) / n_;
      at->second = add_vertex(mesh_, used == 0 ? direction : glm::normalize(direction) * radius);
    }
    return at->second;
  }

  int n_;
  MeshData surface_, mesh_;
  std::map<std::array<int, 6>, Index> vertices_;
};

}  // namespace

MeshData make_tet_box(int cells) { return make_cube(cells, add_tetrahedra); }

MeshData make_hex_box(int cells) { return make_cube(cells, add_hexahedron); }

MeshData make_mixed(int cells) {
  constexpr ModelRef lower(3, 1), upper(3, 2);
  MeshData mesh;
  const Grid grid(cells, cells, 2 * cells);
  const auto position = [&](double i, double j, double k) {
    return glm::dvec3(i, j, k) / static_cast<double>(cells);
  };
  grid.add_vertices(mesh, position);
  grid.for_each_cell([&](int i, int j, int k) {
    const Cell cell = grid.cell(i, j, k);
    const bool prisms_below = i == cells - 1;
    if (k < cells) {
      (prisms_below ? add_prisms : add_hexahedron)(mesh, cell, lower);
    } else if (k > cells || prisms_below) {
      add_tetrahedra(mesh, cell, upper);
    } else {
      add_transition(mesh, cell, add_vertex(mesh, position(i + 0.5, j + 0.5, k + 0.5)), upper);
    }
  });
  // Model faces: 1 to 5 around the lower block, 6 to 9 the sides and 10 the top of the upper, 11
  // between them.
  classify_below_regions(mesh, [](const glm::dvec3& p) {
    if (p.z < 1) return side_of_box(p, glm::dvec3(0), glm::dvec3(1), 0);
    if (p.z == 1) return 11;
    return p.z == 2 ? 10 : 5 + side_of_box(p, {0, 0, 1}, {1, 1, 2}, 0);
  });
  return mesh;
}

MeshData make_tet_drilled(int cells) {
  constexpr double radius = 0.5;
  const int around = 4 * cells, rings = std::max(1, cells / 2), layers = std::max(1, cells / 2);
  // Points on the square of side 2, counter-clockwise from its corner (1, -1).
  const auto on_square = [&](int j) {
    const double t = -1 + 2.0 * (j % cells) / cells;
    const glm::dvec2 sides[4] = {{1, t}, {-t, 1}, {-1, -t}, {t, -1}};
    return sides[j / cells];
  };
  MeshData mesh;
  const Grid grid(rings, around, layers, true);
  grid.add_vertices(mesh, [&](int i, int j, int k) {
    const glm::dvec2 end = on_square(j), start = radius * glm::normalize(end);
    const glm::dvec2 p = i == rings ? end : glm::mix(start, end, static_cast<double>(i) / rings);
    return glm::dvec3(p.x, p.y, static_cast<double>(k) / layers);
  });
  grid.for_each_cell([&](int i, int j, int k) { add_tetrahedra(mesh, grid.cell(i, j, k), solid); });
  classify_below_regions(mesh, [](const glm::dvec3& p) {
    return side_of_box(p, {-1, -1, 0}, {1, 1, 1}, 7);
  });
  return mesh;
}

// Three layers, of 1, 2 and 1 cells, one on the other; the temperature falls along the beam and
// towards its upper side, and what bends it pulls above the middle and presses below.
MeshData make_layered_beam(int n) {
  constexpr int length = 10, width = 2, height = 4;
  constexpr ModelRef layers[height] = {{3, 1}, {3, 2}, {3, 2}, {3, 3}};
  MeshData mesh;
  const Grid grid(length * n, width * n, height * n);
  grid.add_vertices(
      mesh, [&](int i, int j, int k) { return glm::dvec3(i, j, k) / static_cast<double>(n); });
  grid.for_each_cell(
      [&](int i, int j, int k) { add_tetrahedra(mesh, grid.cell(i, j, k), layers[k / n]); });
  Attribute temperature{"temperature", 0, 1, false, {}}, stress{"stress", 3, 1, false, {}};
  for (const glm::dvec3& p : mesh.positions) temperature.values.push_back(400 - 8 * p.x - 5 * p.z);
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    glm::dvec3 sum(0);
    for (std::size_t k = 0; k < 4; ++k) sum += mesh.positions[mesh.regions.vertices[4 * r + k]];
    stress.values.push_back((length - sum.x / 4) * (sum.z / 4 - 0.5 * height));
  }
  mesh.attributes = {temperature, stress};
  // Model faces: 1 below, 2 and 3 between the layers, 4 above, then the four sides of each layer.
  constexpr double planes[] = {0, 1, 3, height};
  classify_below_regions(mesh, [&](const glm::dvec3& p) {
    const auto next = std::lower_bound(std::begin(planes), std::end(planes), p.z);
    const auto at = static_cast<std::int32_t>(next - std::begin(planes));
    return *next == p.z ? at + 1 : 4 * at + side_of_box(p, {0, 0, -1}, {length, width, 9}, 0);
  });
  return mesh;
}

MeshData make_tet_ball(int layers) { return Ball(layers).make(); }

}  // namespace aomd::sample
