#include "core/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/buckets.h"
#include "core/base/disjoint_sets.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/geometry.h"
#include "core/mesh/side_groups.h"

namespace aomd::measure {
namespace {

// Calls visit(its vertices) for every entity of a level.
template <typename Visit>
void each_by_vertices(const Mesh& mesh, int dim, Visit&& visit) {
  if (mesh.count(dim) == 0) return;
  const VertexRows rows(mesh, dim);
  rows.each([&](std::uint32_t id, const std::uint32_t* v) {
    visit(std::span(v, static_cast<std::size_t>(rows.shape(id).vertex_count)));
  });
}

struct EdgeEnd {
  std::uint32_t vertex, faces;
};

// Of surfaces: the sides of all faces and the listed edges, each filed under its lower vertex,
// which takes less time there than SideGroups and memory that is no concern.
Buckets<EdgeEnd> sides_of_surface(const Mesh& mesh) {
  return {mesh.capacity(0), [&](auto&& file) {
            const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t faces) {
              file(std::min(a, b), {std::max(a, b), faces});
            };
            each_by_vertices(mesh, 2, [&](std::span<const std::uint32_t> v) {
              for (std::size_t k = 0; k < v.size(); ++k)
                add(v[k], v[k + 1 < v.size() ? k + 1 : 0], 1);
            });
            each_by_vertices(mesh, 1,
                             [&](std::span<const std::uint32_t> v) { add(v[0], v[1], 0); });
          }};
}

// Edges are told apart by marks at their larger vertices.
void count_surface_edges(const Mesh& mesh, Counts& counts) {
  struct Seen {
    std::uint32_t low = no_index, faces = 0;
  };
  std::vector<Seen> seen(mesh.capacity(0));
  const Buckets<EdgeEnd> sides = sides_of_surface(mesh);
  for (std::uint32_t low = 0; low < sides.count(); ++low)
    for (const EdgeEnd& side : sides[low]) {
      Seen& edge = seen[side.vertex];
      if (edge.low != low) edge = {low, 0}, ++counts.edges;
      if (side.faces == 0) continue;
      ++edge.faces;
      counts.boundary_edges += edge.faces == 1;
      counts.boundary_edges -= edge.faces == 2;
      counts.nonmanifold_edges += edge.faces == 3;
    }
}

void count_edges(const Mesh& mesh, Counts& counts) {
  if (mesh.count(3) == 0) return count_surface_edges(mesh, counts);
  SideGroups<1>(mesh).each([&](std::span<const SideUse> uses) {
    const auto faces = std::count_if(uses.begin(), uses.end(),
                                     [](const SideUse& use) { return use.dimension == 2; });
    ++counts.edges;
    counts.boundary_edges += faces == 1;
    counts.nonmanifold_edges += faces > 2;
  });
}

// Sets of vertices that faces and regions connect.
class Components {
 public:
  explicit Components(const Mesh& mesh) : sets_(mesh.capacity(0)), used_(mesh.capacity(0), 0) {
    for (const int dim : {2, 3})
      each_by_vertices(mesh, dim, [&](std::span<const std::uint32_t> v) { connect(v); });
  }

  [[nodiscard]] std::size_t count() {
    std::size_t sets = 0;
    for (std::uint32_t v = 0; v < used_.size(); ++v) sets += used_[v] && sets_.find(v) == v;
    return sets;
  }
  [[nodiscard]] bool used(Vertex v) const { return used_[v.index] != 0; }

 private:
  void connect(std::span<const std::uint32_t> v) {
    used_[v[0]] = 1;
    for (const std::uint32_t u : v.subspan(1)) used_[u] = 1, sets_.unite(v[0], u);
  }

  DisjointSets sets_;
  std::vector<std::uint8_t> used_;
};

void count_vertices(const Mesh& mesh, Counts& counts) {
  Components components(mesh);
  counts.components = components.count();
  std::vector<std::uint8_t> on_edge(mesh.capacity(0), 0);
  for (const Edge e : mesh.edges())
    for (const Vertex v : mesh.edge_vertices(e)) on_edge[v.index] = 1;
  counts.vertices = mesh.count(0);
  for (const Vertex v : mesh.vertices())
    counts.unused_vertices += !components.used(v) && !on_edge[v.index];
}

void count_classes(const Mesh& mesh, Counts& counts) {
  for (int dim = 0; dim < 4; ++dim) {
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      if (!mesh.ids(dim).alive(id)) continue;
      const ModelRef model = mesh.classification(EntityRef(dim, id));
      if (model.valid()) ++counts.by_class[static_cast<std::size_t>(model.dimension())];
    }
  }
}

}  // namespace

Counts count_entities(const Mesh& mesh) {
  Counts counts;
  count_vertices(mesh, counts);
  count_edges(mesh, counts);
  counts.faces = mesh.count(2);
  counts.regions = mesh.count(3);
  if (counts.regions > 0) count_volume_faces(mesh, counts);
  counts.euler = static_cast<std::int64_t>(counts.vertices - counts.unused_vertices) -
                 static_cast<std::int64_t>(counts.edges) + static_cast<std::int64_t>(counts.faces) -
                 static_cast<std::int64_t>(counts.regions);
  for (const Region r : mesh.regions()) ++counts.by_shape[static_cast<std::size_t>(mesh.shape(r))];
  for (const Face f : mesh.faces()) ++counts.by_shape[static_cast<std::size_t>(mesh.shape(f))];
  count_classes(mesh, counts);
  return counts;
}

namespace {

double largest_coordinate(const glm::dvec3& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

// Fourth powers of lengths from 1e-70 to 1e+70 are numbers: other triangles are measured at size 1.
// Differences of quarters are never infinite.
double angle_at_any_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr double least = 1e-70, most = 1e70;
  const glm::dvec3 u = b / 4.0 - a / 4.0, v = c / 4.0 - a / 4.0;
  const double size = std::max(largest_coordinate(u), largest_coordinate(v));
  if (size == 0 || (size >= least && size <= most)) return smallest_angle_deg(a, b, c);
  return smallest_angle_deg(glm::dvec3(0.0), u / size, v / size);
}

}  // namespace

Quality measure_quality(const Mesh& mesh) {
  const Triangles triangles = triangles_of(mesh);
  if (triangles.corners.empty()) return {};
  double sum = 0, worst = 180;
  std::size_t below = 0;
  for (const auto& [a, b, c] : triangles.corners) {
    const double angle = angle_at_any_size(a, b, c);
    sum += angle;
    worst = std::min(worst, angle);
    below += angle < 10;
  }
  const auto n = static_cast<double>(triangles.corners.size());
  return {sum / n, worst, 100 * static_cast<double>(below) / n};
}

}  // namespace aomd::measure
