#include "core/mesh/part.h"

#include <algorithm>
#include <set>

#include "core/mesh/derive.h"

namespace aomd {
namespace {

class Part {
 public:
  Part(const Mesh& mesh, std::span<const EntityRef> entities) : mesh_(mesh) {
    for (const EntityRef e : entities)
      if (e.dimension >= 2) taken_.insert(e);
  }

  MeshData run() {
    take_bounds();
    number_vertices();
    for (const EntityRef e : taken_) list(e);
    return std::move(data_);
  }

 private:
  void take_bounds() {
    const std::set<EntityRef> chosen = taken_;
    for (const EntityRef e : chosen)
      for (int level = 1; level < e.dimension; ++level) take_sides(e, level);
  }

  void take_sides(EntityRef e, int level) {
    if (!mesh_.complete(level) ||
        explain(mesh_, e.dimension, level).kind == AdjacencyPath::Kind::None)
      return;
    adjacent(mesh_, e, level, ids_);
    for (const std::uint32_t id : ids_)
      if (mesh_.classification({level, id}).dimension() == level) taken_.emplace(level, id);
  }

  void number_vertices() {
    for (const EntityRef e : taken_)
      for (const std::uint32_t v : mesh_.vertices_of(e, buffer_)) vertices_.push_back(v);
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const std::uint32_t v : vertices_) {
      data_.positions.push_back(mesh_.position(Vertex(v)));
      data_.vertex_classes.push_back(mesh_.classification(Vertex(v)));
    }
  }

  void list(EntityRef e) {
    EntityList& all = data_.list(e.dimension);
    all.shapes.push_back(mesh_.shape(e));
    all.classes.push_back(mesh_.classification(e));
    for (const std::uint32_t v : mesh_.vertices_of(e, buffer_))
      all.vertices.push_back(static_cast<std::uint32_t>(
          std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin()));
  }

  const Mesh& mesh_;
  MeshData data_;
  std::set<EntityRef> taken_;
  std::vector<std::uint32_t> vertices_, ids_;
  VertexBuffer buffer_{};
};

}  // namespace

MeshData part_of(const Mesh& mesh, std::span<const EntityRef> entities) {
  return Part(mesh, entities).run();
}

}  // namespace aomd
