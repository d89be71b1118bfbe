// Samples with model vertices, edges and faces, as from a solid modeller.

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/samples/build.h"
#include "core/samples/makers.h"
#include "core/samples/numeric.h"
#include "core/samples/plate.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

/// The vertices at these positions.
std::vector<Index> at_positions(const MeshData& mesh, std::span<const glm::dvec3> wanted) {
  std::vector<Index> found;
  for (const glm::dvec3& p : wanted) {
    const auto at = std::find(mesh.positions.begin(), mesh.positions.end(), p);
    if (at != mesh.positions.end())
      found.push_back(static_cast<Index>(at - mesh.positions.begin()));
  }
  return found;
}

/// A sheet-metal bracket: a plate with three holes, of thickness 1, bent by a right angle. In the
/// plate's own coordinates s runs along it, y across, t through it; t = 0 is the outer side of the
/// bend.
class Bracket {
 public:
  explicit Bracket(int n) : n_(n), plate_(make_plate(length, width, n, holes)) {}

  MeshData make() {
    sides();
    for (const auto& [a, b, c] : plate_.triangles) {
      const int part = part_of((plate_.points[a].x + plate_.points[b].x + plate_.points[c].x) / 3);
      mesh_.faces.add(Shape::Triangle, {column(a, 0), column(b, 0), column(c, 0)},
                      ModelRef(2, 1 + part));
      mesh_.faces.add(Shape::Triangle, {column(a, n_), column(c, n_), column(b, n_)},
                      ModelRef(2, 4 + part));
    }
    walls();
    classify_below_faces(mesh_);
    return std::move(mesh_);
  }

 private:
  static constexpr int length = 10, width = 4, bend_start = 4, bend_end = 6;
  static constexpr double thickness = 1, outer_radius = 2, unit_mm = 10;
  static constexpr Hole holes[] = {{2, 1, 0.5}, {2, 3, 0.5}, {8, 2, 0.65}};

  /// 0 before the bend, 1 in it, 2 after it.
  static int part_of(double s) { return s < bend_start ? 0 : s < bend_end ? 1 : 2; }

  static glm::dvec3 bent(double s, double y, double t) {
    const double radius = outer_radius - t;
    if (s <= bend_start) return unit_mm * glm::dvec3(bend_start - s, y, t);
    if (s >= bend_end) return unit_mm * glm::dvec3(-radius, y, outer_radius + s - bend_end);
    const glm::dvec2 turned = on_circle(0.25 * (s - bend_start) / (bend_end - bend_start));
    return unit_mm * glm::dvec3(-radius * turned.y, y, outer_radius - radius * turned.x);
  }

  /// Vertices on the two sides: those of t = 0 first, then those of t = thickness.
  void sides() {
    for (const double t : {0.0, thickness}) {
      for (const glm::dvec2& p : plate_.points) add_vertex(mesh_, bent(p.x, p.y, t));
    }
  }

  /// The vertex above plate point p after `layer` of n layers.
  Index column(Index p, int layer) {
    const auto points = static_cast<Index>(plate_.points.size());
    if (layer == 0) return p;
    if (layer == n_) return points + p;
    const auto [at, is_new] = inner_.try_emplace({p, layer}, 0);
    const glm::dvec2& q = plate_.points[p];
    if (is_new) at->second = add_vertex(mesh_, bent(q.x, q.y, thickness * layer / n_));
    return at->second;
  }

  /// The model face of the wall that stands on a border edge of the plate.
  [[nodiscard]] std::int32_t wall_tag(Index a, Index b) const {
    const glm::dvec2 &p = plate_.points[a], &q = plate_.points[b];
    if (plate_.hole_of[a] >= 0) return 11 + plate_.hole_of[a];
    if (p.y == 0 && q.y == 0) return 7;
    if (p.y == width && q.y == width) return 8;
    return p.x == 0 ? 9 : 10;
  }

  void walls() {
    std::map<std::pair<Index, Index>, int> sides_of;
    for (const auto& t : plate_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++sides_of[std::minmax(t[i], t[(i + 1) % 3])];
    }
    for (const auto& t : plate_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        if (sides_of[std::minmax(a, b)] == 1) wall(a, b);
      }
    }
  }

  void wall(Index a, Index b) {
    for (int k = 0; k < n_; ++k) {
      add_quad(mesh_, {column(b, k), column(a, k), column(a, k + 1), column(b, k + 1)},
               wall_tag(a, b));
    }
  }

  int n_;
  Plate plate_;
  MeshData mesh_;
  std::map<std::pair<Index, int>, Index> inner_;
};

/// Vertices of a round disk: rings of 6, 12, 18, ... points around a centre.
class Disk {
 public:
  Disk(MeshData& mesh, int rings, double z)
      : mesh_(mesh), rings_(rings), first_(add_vertex(mesh, {0, 0, z})) {
    for (int ring = 1; ring <= rings; ++ring) {
      for (int i = 0; i < 6 * ring; ++i) {
        const glm::dvec2 p =
            on_circle(static_cast<double>(i) / (6 * ring)) * (static_cast<double>(ring) / rings);
        add_vertex(mesh, {p.x, p.y, z});
      }
    }
  }

  /// Point i of a ring, counted around and around.
  [[nodiscard]] Index at(int ring, int i) const {
    return ring == 0 ? first_
                     : first_ + static_cast<Index>(1 + 3 * ring * (ring - 1) + i % (6 * ring));
  }

  void add_faces(std::int32_t tag, bool downward) {
    for (int ring = 1; ring <= rings_; ++ring) {
      for (int sector = 0; sector < 6; ++sector) {
        for (int i = 0; i < ring; ++i) {
          const int outer = sector * ring + i, inner = sector * (ring - 1) + i;
          add(at(ring, outer), at(ring, outer + 1), at(ring - 1, inner), tag, downward);
          if (i + 1 < ring)
            add(at(ring - 1, inner), at(ring, outer + 1), at(ring - 1, inner + 1), tag, downward);
        }
      }
    }
  }

 private:
  void add(Index a, Index b, Index c, std::int32_t tag, bool downward) {
    if (downward) std::swap(b, c);
    mesh_.faces.add(Shape::Triangle, {a, b, c}, ModelRef(2, tag));
  }

  MeshData& mesh_;
  int rings_;
  Index first_;
};

}  // namespace

MeshData make_bracket(int cells) { return Bracket(cells).make(); }

MeshData make_plane_hole(int cells) {
  constexpr Hole hole[] = {{2, 2, 0.6}};
  const Plate plate = make_plate(4, 4, std::max(1, cells / 4), hole);
  MeshData mesh;
  for (const glm::dvec2& p : plate.points) add_vertex(mesh, {p.x, p.y, 0});
  for (const auto& [a, b, c] : plate.triangles)
    mesh.faces.add(Shape::Triangle, {a, b, c}, ModelRef(2, 1));
  constexpr std::array<glm::dvec3, 4> corners{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  classify_below_faces(mesh, at_positions(mesh, corners));
  return mesh;
}

MeshData make_box(int cells) {
  MeshData mesh;
  std::map<std::array<int, 3>, Index> lattice;
  const auto at = [&](const std::array<int, 3>& p) {
    const auto [slot, is_new] = lattice.try_emplace(p, 0);
    if (is_new)
      slot->second = add_vertex(mesh, glm::dvec3(p[0], p[1], p[2]) / static_cast<double>(cells));
    return slot->second;
  };
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool far = side % 2 == 1;
    const auto corner = [&](int i, int j) {
      std::array<int, 3> p{};
      p[axis] = far ? cells : 0;
      p[far ? u : v] = i;  // the near sides are seen from behind
      p[far ? v : u] = j;
      return at(p);
    };
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const Index quad[4] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                               corner(i, j + 1)};
        add_quad(mesh, quad, static_cast<std::int32_t>(side) + 1, (i + j) % 2 == 1);
      }
    }
  }
  classify_below_faces(mesh);
  return mesh;
}

MeshData make_cylinder(int rings) {
  constexpr double height = 2;
  const int around = 6 * rings, layers = 2 * rings;
  MeshData mesh;
  Disk bottom(mesh, rings, 0), top(mesh, rings, height);
  bottom.add_faces(2, true);
  top.add_faces(3, false);
  std::vector<Index> row(static_cast<std::size_t>(around)), next(row.size());
  for (int i = 0; i < around; ++i) row[static_cast<std::size_t>(i)] = bottom.at(rings, i);
  for (int k = 1; k <= layers; ++k, row.swap(next)) {
    for (int i = 0; i < around; ++i) {
      const glm::dvec2 p = on_circle(static_cast<double>(i) / around);
      next[static_cast<std::size_t>(i)] =
          k == layers ? top.at(rings, i) : add_vertex(mesh, {p.x, p.y, height * k / layers});
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t j = (i + 1) % row.size();
      add_quad(mesh, {row[i], row[j], next[j], next[i]}, 1);
    }
  }
  classify_below_faces(mesh);
  return mesh;
}

MeshData make_nonmanifold(int cells) {
  MeshData mesh;
  std::vector<Index> corners;
  for (int k = 0; k <= cells; ++k) add_vertex(mesh, {0, 0, static_cast<double>(k) / cells});
  for (int sheet = 0; sheet < 3; ++sheet) {
    const glm::dvec2 direction = on_circle(sheet / 3.0);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (int i = 1; i <= cells; ++i) {
      const glm::dvec2 p = direction * (static_cast<double>(i) / cells);
      for (int k = 0; k <= cells; ++k) add_vertex(mesh, {p.x, p.y, static_cast<double>(k) / cells});
    }
    const auto at = [&](int i, int k) {
      return i == 0 ? static_cast<Index>(k) : first + static_cast<Index>((i - 1) * (cells + 1) + k);
    };
    for (int i = 0; i < cells; ++i) {
      for (int k = 0; k < cells; ++k) {
        add_quad(mesh, {at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)}, sheet + 1,
                 (i + k) % 2 == 1);
      }
    }
    corners.insert(corners.end(), {at(cells, 0), at(cells, cells)});
  }
  classify_below_faces(mesh, corners);
  return mesh;
}

}  // namespace aomd::sample
