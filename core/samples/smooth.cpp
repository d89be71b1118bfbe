// Smooth and scan-like samples, without classification.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/samples/build.h"
#include "core/samples/makers.h"
#include "core/samples/numeric.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

/// An icosahedron whose edges are cut into n, all points moved out to the unit sphere.
class Geodesic {
 public:
  explicit Geodesic(int n) : n_(n) {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    for (const auto& c : corners) {
      // Coordinates 0, 1 and golden ratio, coded as 0, 1 and 2.
      glm::dvec3 p(0);
      for (int i = 0; i < 3; ++i)
        p[i] = (c[i] < 0 ? -1 : 1) * (std::abs(c[i]) == 2 ? golden : std::abs(c[i]));
      add_vertex(mesh_, glm::normalize(p));
    }
  }

  MeshData make() {
    edges_.assign(std::size(corners) * std::size(corners), {});
    for (const auto& face : faces) subdivide(face);
    return std::move(mesh_);
  }

 private:
  static constexpr int corners[12][3] = {{-1, 2, 0}, {1, 2, 0}, {-1, -2, 0}, {1, -2, 0},
                                         {0, -1, 2}, {0, 1, 2}, {0, -1, -2}, {0, 1, -2},
                                         {2, 0, -1}, {2, 0, 1}, {-2, 0, -1}, {-2, 0, 1}};
  static constexpr Index faces[20][3] = {
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

  static glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, int i, int n) {
    return (a * static_cast<double>(n - i) + b * static_cast<double>(i)) / static_cast<double>(n);
  }

  /// The n + 1 points from corner a to corner b; made once for both faces at the edge.
  std::vector<Index> along(Index a, Index b) {
    std::vector<Index>& points =
        edges_[static_cast<std::size_t>(std::min(a, b) * 12 + std::max(a, b))];
    if (points.empty()) {
      const Index low = std::min(a, b), high = std::max(a, b);
      points.push_back(low);
      for (int i = 1; i < n_; ++i) {
        points.push_back(add_vertex(
            mesh_, glm::normalize(between(mesh_.positions[low], mesh_.positions[high], i, n_))));
      }
      points.push_back(high);
    }
    return a < b ? points : std::vector<Index>(points.rbegin(), points.rend());
  }

  /// Row j of a face runs from its edge 0-2 to its edge 1-2 and has n - j + 1 points.
  void subdivide(const Index (&f)[3]) {
    const std::vector<Index> left = along(f[0], f[2]), right = along(f[1], f[2]),
                             base = along(f[0], f[1]);
    std::vector<Index> row = base, next;
    for (int j = 1; j <= n_; ++j, row.swap(next)) {
      const auto k = static_cast<std::size_t>(j);
      const int cells = n_ - j;
      next.assign(1, left[k]);
      const glm::dvec3 start = between(mesh_.positions[f[0]], mesh_.positions[f[2]], j, n_);
      const glm::dvec3 end = between(mesh_.positions[f[1]], mesh_.positions[f[2]], j, n_);
      for (int i = 1; i < cells; ++i)
        next.push_back(add_vertex(mesh_, glm::normalize(between(start, end, i, cells))));
      if (cells > 0) next.push_back(right[k]);
      for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        mesh_.faces.add(Shape::Triangle, {row[i], row[i + 1], next[i]});
        if (i + 1 < next.size())
          mesh_.faces.add(Shape::Triangle, {row[i + 1], next[i + 1], next[i]});
      }
    }
  }

  int n_;
  MeshData mesh_;
  std::vector<std::vector<Index>> edges_;
};

double to_power(double x, int n) {
  double result = 1;
  for (; n > 0; n /= 2, x *= x) {
    if (n % 2 == 1) result *= x;
  }
  return result;
}

/// A bump on the surface of the creature that make_scan() makes.
struct Lobe {
  glm::dvec3 direction;
  double height;
  int sharpness;
};

/// Distance of the creature's surface from its centre: since it is a function of the direction, the
/// surface cannot cross itself.
double creature(const glm::dvec3& d) {
  static const std::array<Lobe, 9> lobes{{{{0.80, 0.00, 0.62}, 0.62, 16},  // head
                                          {{0.40, 0.34, 0.95}, 0.62, 60},  // ears
                                          {{0.40, -0.34, 0.95}, 0.62, 60},
                                          {{1.00, 0.00, 0.42}, 0.16, 70},   // nose
                                          {{-1.00, 0.00, 0.05}, 0.26, 40},  // tail
                                          {{0.62, 0.48, -0.70}, 0.34, 26},  // feet
                                          {{0.62, -0.48, -0.70}, 0.34, 26},
                                          {{-0.55, 0.62, -0.62}, 0.40, 18},
                                          {{-0.55, -0.62, -0.62}, 0.40, 18}}};
  const glm::dvec3 scaled(d.x / 1.05, d.y / 0.72, d.z / 0.80);
  double r = 1 / glm::length(scaled);
  for (const Lobe& lobe : lobes)
    r += lobe.height *
         to_power((1 + glm::dot(d, glm::normalize(lobe.direction))) / 2, lobe.sharpness);
  return r + 0.035 * noise(3.0 * d + glm::dvec3(11, 7, 5)) + 0.012 * noise(9.0 * d) +
         0.005 * noise(21.0 * d);
}

/// On the grid of a scanner's resolution, which also makes every coordinate exactly a 32-bit float.
glm::dvec3 measured(const glm::dvec3& p) {
  constexpr double steps = 4096;
  return glm::floor(p * steps + 0.5) / steps;
}

/// Adds a grid of (nu x nv) cells between vertices that `at(i, j)` names.
template <class At>
void add_grid(MeshData& mesh, int nu, int nv, At&& at) {
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i)
      add_quad(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, 0);
  }
}

}  // namespace

MeshData make_sphere(int frequency) { return Geodesic(frequency).make(); }

MeshData make_scan(int faces) {
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(faces / 20.0))));
  MeshData mesh = make_sphere(n);
  const double error = 0.05 / n;  // what a scanner adds: a twentieth of an edge or so
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3 d = mesh.positions[v];
    mesh.positions[v] = measured(50.0 * (creature(d) + error * hashed(v)) * d);
  }
  order_in_space(mesh);
  return mesh;
}

MeshData make_torus(int cells) {
  const int around = cells, across = std::max(3, 2 * cells / 5);
  constexpr double big = 1, small = 0.4;
  MeshData mesh;
  for (int j = 0; j < across; ++j) {
    const glm::dvec2 s = on_circle(static_cast<double>(j) / across);
    for (int i = 0; i < around; ++i) {
      const glm::dvec2 c = on_circle(static_cast<double>(i) / around);
      add_vertex(mesh, {(big + small * s.x) * c.x, (big + small * s.x) * c.y, small * s.y});
    }
  }
  add_grid(mesh, around, across,
           [&](int i, int j) { return static_cast<Index>((j % across) * around + i % around); });
  return mesh;
}

MeshData make_terrain(int cells) {
  MeshData mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = 10.0 * i / cells, y = 10.0 * j / cells;
      double height = 0, scale = 0.9;
      for (double frequency = 0.35; frequency < 6; frequency *= 2.1, scale *= 0.42) {
        height += scale * noise({frequency * x, frequency * y, 0.5 + frequency});
      }
      add_vertex(mesh, {x, y, height});
    }
  }
  add_grid(mesh, cells, cells,
           [&](int i, int j) { return static_cast<Index>(j * (cells + 1) + i); });
  return mesh;
}

}  // namespace aomd::sample
