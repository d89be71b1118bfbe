// CGAL's Tetrahedral_remeshing (Faraj, Thiery, Boubekeur 2016). That package is GPL, so this
// program is too, once passed on; it exists to be measured, is built on request only, never
// installed, and nothing else of the project includes or links it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_3/tet_soup_to_c3t3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/property_map.h>
#include <CGAL/tetrahedral_remeshing.h>
#include <CGAL/version.h>

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/box.h"
#include "tools/bench/peers/volume_peer.h"

namespace aomd::peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<Kernel>;
using Vertex = Triangulation::Vertex_handle;
using Edges = std::set<std::pair<Vertex, Vertex>>;

/// The size at the nearest vertex of the original: a factor times the mean length of its edges.
/// Vertices lie in the cells of a grid, about two in each.
class Sizes {
 public:
  Sizes(const TetMesh& mesh, double factor) : mesh_(mesh) {
    std::vector<double> sum(mesh.positions.size(), 0), count(mesh.positions.size(), 0);
    for (const auto& t : mesh.tets)
      for (const std::uint32_t v : t)
        for (const std::uint32_t w : t)
          if (v != w) sum[v] += glm::length(mesh.positions[v] - mesh.positions[w]), ++count[v];
    for (std::size_t v = 0; v < sum.size(); ++v) size_.push_back(factor * sum[v] / count[v]);
    Box box;
    for (const glm::dvec3& p : mesh.positions) box.add(p);
    low_ = box.low;
    const glm::dvec3 sides = box.high - box.low;
    cell_ = std::cbrt(2 * sides.x * sides.y * sides.z / double(mesh.positions.size()));
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      cells_[at(mesh.positions[v])].push_back(v);
  }

  double operator()(const Kernel::Point_3& point) const {
    const glm::dvec3 p(point.x(), point.y(), point.z());
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int ring = 0; least > (ring - 1) * cell_ && ring < 1000; ++ring)
      look(p, ring, best, least);
    return size_[best];
  }

 private:
  using Cell = std::array<int, 3>;
  [[nodiscard]] Cell at(const glm::dvec3& p) const {
    const glm::dvec3 q = (p - low_) / cell_;
    return {int(std::floor(q.x)), int(std::floor(q.y)), int(std::floor(q.z))};
  }
  void look(const glm::dvec3& p, int ring, std::uint32_t& best, double& least) const {
    const Cell centre = at(p);
    for (int i = -ring; i <= ring; ++i)
      for (int j = -ring; j <= ring; ++j)
        for (int k = -ring; k <= ring; ++k) {
          if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != ring) continue;
          const auto found = cells_.find({centre[0] + i, centre[1] + j, centre[2] + k});
          if (found == cells_.end()) continue;
          for (const std::uint32_t v : found->second)
            if (const double d = glm::length(p - mesh_.positions[v]); d < least)
              least = d, best = v;
        }
  }

  const TetMesh& mesh_;
  std::vector<double> size_;  ///< by vertex
  glm::dvec3 low_{0};
  double cell_ = 1;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

std::pair<Vertex, Vertex> ordered(Vertex a, Vertex b) {
  return a < b ? std::pair(a, b) : std::pair(b, a);
}

void build(const TetMesh& mesh, Triangulation& triangulation, Edges& curves) {
  std::vector<Triangulation::Point> points;
  for (const glm::dvec3& p : mesh.positions) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::array<int, 5>> cells;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tets[i];
    cells.push_back({int(a), int(b), int(c), int(d), mesh.regions[i]});
  }
  std::vector<Vertex> vertices;
  if (!CGAL::build_triangulation<Triangulation, false>(triangulation, points, cells, {}, vertices))
    throw std::runtime_error("CGAL takes this for no triangulation");
  for (const auto& [a, b] : mesh.curves)
    curves.insert(ordered(vertices[a + 1], vertices[b + 1]));  // the first one is infinite
}

TetMesh read_back(const Triangulation& triangulation) {
  TetMesh result;
  std::map<Vertex, std::uint32_t> number;
  for (const auto cell : triangulation.finite_cell_handles()) {
    if (cell->subdomain_index() == 0) continue;
    auto corner = result.tets.emplace_back().begin();
    for (int k = 0; k < 4; ++k) {
      const Vertex v = cell->vertex(k);
      const auto [entry, first] = number.emplace(v, static_cast<std::uint32_t>(number.size()));
      if (first) result.positions.emplace_back(v->point().x(), v->point().y(), v->point().z());
      *corner++ = entry->second;
    }
    result.regions.push_back(cell->subdomain_index());
  }
  return result;
}

}  // namespace

std::string library() { return "CGAL " CGAL_VERSION_STR; }
std::string wants() { return "factor"; }

// Five iterations give the best angles; with smooth_constrained_edges regions lose volume.
TetMesh remesh(const TetMesh& mesh, double amount) {
  Triangulation triangulation;
  Edges curves;
  build(mesh, triangulation, curves);
  CGAL::tetrahedral_isotropic_remeshing(
      triangulation, Sizes(mesh, amount),
      CGAL::parameters::number_of_iterations(5).edge_is_constrained_map(
          CGAL::Boolean_property_map<Edges>(curves)));
  return read_back(triangulation);
}

}  // namespace aomd::peers
