#include "core/model/discrete_model.h"

#include <algorithm>
#include <map>

#include "core/mesh/geometry.h"

namespace aomd {
namespace {

using Boundaries = std::map<ModelRef, std::vector<ModelRef>>;

// A model entity is bounded by the lower ones that the sides of its own mesh entities lie on.
template <typename Range>
void add_sides(Boundaries& boundaries, const Mesh& mesh, ModelRef model, const Range& sides) {
  std::vector<ModelRef>& boundary = boundaries[model];
  for (const auto side : sides) {
    const ModelRef below = mesh.classification(side);
    if (below.dimension() == EntityRef(side).dimension && below.dimension() < model.dimension())
      boundary.push_back(below);
  }
}

std::vector<Model::Entry> entries_of(Mesh& mesh) {
  const std::array<Request, 2> needs{mesh.request(2, 0, "the faceted model"),
                                     mesh.request(2, 1, "the faceted model")};
  const Request regions = mesh.count(3) > 0 ? mesh.request(3, 2, "the faceted model") : Request();
  Boundaries boundaries;
  for (int dim = 0; dim <= 3; ++dim) {
    const IdPool& ids = mesh.ids(dim);
    for (std::uint32_t id = ids.next_alive(0); id < ids.capacity(); id = ids.next_alive(id + 1)) {
      const ModelRef model = mesh.classification(EntityRef(dim, id));
      if (model.dimension() != dim) continue;
      add_sides(boundaries, mesh, model, std::array<Vertex, 0>());
      if (dim == 1) add_sides(boundaries, mesh, model, mesh.edge_vertices(Edge(id)));
      if (dim == 2) add_sides(boundaries, mesh, model, mesh.row<1>(Face(id)));
      if (dim == 2) add_sides(boundaries, mesh, model, mesh.row<0>(Face(id)));
      if (dim == 3) add_sides(boundaries, mesh, model, mesh.row<2>(Region(id)));
    }
  }
  std::vector<Model::Entry> entries;
  for (auto& [model, boundary] : boundaries) {
    std::sort(boundary.begin(), boundary.end());
    boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
    entries.push_back({model, std::move(boundary)});
  }
  return entries;
}

}  // namespace

DiscreteModel::DiscreteModel(Mesh& mesh) : Model(entries_of(mesh)) {
  std::vector<std::vector<Triangle>> facets(size());
  const auto add = [&](EntityRef e, const Triangle& corners) {
    if (const ModelRef model = mesh.classification(e); model.dimension() == e.dimension)
      facets[index_of(model)].push_back(corners);
  };
  const Triangles all = triangles_of(mesh);
  for (std::size_t i = 0; i < all.faces.size(); ++i) add(all.faces[i], all.corners[i]);
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    add(e, {mesh.position(a), mesh.position(b), mesh.position(b)});
  }
  for (const Vertex v : mesh.vertices())
    add(v, {mesh.position(v), mesh.position(v), mesh.position(v)});
  for (const auto& list : facets) facets_.emplace_back(list);
}

ClosestPoint DiscreteModel::closest_on(std::size_t index, const glm::dvec3& point) const {
  return {facets_[index].nearest(point).point, {}};
}

glm::dvec3 DiscreteModel::normal_of(std::size_t index, const glm::dvec3& point) const {
  const TriangleTree& tree = facets_[index];
  const auto& [a, b, c] = tree.triangle(tree.nearest(point).triangle);
  const glm::dvec3 normal = area_normal(a, b, c);
  const double length = glm::length(normal);
  if (!(length > 0)) throw ModelError(name_of(entity(index)) + " has a facet without a normal");
  return normal / length;
}

}  // namespace aomd
