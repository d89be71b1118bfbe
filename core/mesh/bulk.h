#pragma once
// The vertices of a whole level as plain rows, and loops over them without a decision for each
// entity.

#include <cstdint>

#include "core/mesh/mesh.h"
#include "core/mesh/side_index.h"

namespace aomd {

/// The vertices of all entities of level 1 to 3: T(dim,0) itself where it is stored, else a copy
/// made from what is. Valid until the next edit.
class VertexRows {
 public:
  VertexRows(const Mesh& mesh, int dim);

  [[nodiscard]] std::uint32_t stride() const { return stride_; }
  [[nodiscard]] const std::uint32_t* row(std::uint32_t id) const {
    return data_ + std::size_t{id} * stride_;
  }
  /// The shape of all entities, or none where they differ.
  [[nodiscard]] const ShapeTemplate* uniform() const { return uniform_; }
  [[nodiscard]] const ShapeTemplate& shape(std::uint32_t id) const {
    return uniform_ ? *uniform_ : shape_template(mesh_.shape(EntityRef(dim_, id)));
  }
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::uint32_t id) const {
    return {row(id), static_cast<std::size_t>(shape(id).vertex_count)};
  }

  /// Calls visit(id, its vertices) for every entity, in ascending order.
  template <typename Visit>
  void each(Visit&& visit) const {
    const IdPool& ids = mesh_.ids(dim_);
    const std::uint32_t* v = data_;
    const std::size_t stride = stride_;
    const std::uint32_t n = ids.capacity();
    if (ids.free_ids().empty())
      for (std::uint32_t id = 0; id < n; ++id, v += stride) visit(id, v);
    else
      for (std::uint32_t id = ids.next_alive(0); id < n; id = ids.next_alive(id + 1))
        visit(id, v + id * stride);
  }

 private:
  const Mesh& mesh_;
  int dim_;
  DownRows made_;
  const std::uint32_t* data_ = nullptr;
  std::uint32_t stride_ = 0;
  const ShapeTemplate* uniform_ = nullptr;
};

/// All edges, or all faces.
[[nodiscard]] SideIndex<EdgeKey> index_edges(const Mesh& mesh, const VertexRows& edges);
[[nodiscard]] SideIndex<FaceKey> index_faces(const Mesh& mesh, const VertexRows& faces);

/// True when two lists hold the same vertices.
[[nodiscard]] bool same_set(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

/// Upward rows from downward ones: count, prefix sum, fill. O(entries).
void build_upward(const Mesh& mesh, int i, int j, UpRows& result);

/// T(i,j), i > j > 0, with use directions where j is the level below: every side found by its
/// vertices. O(entities of both levels).
void build_sides(const Mesh& mesh, int i, int j, DownRows& result);

/// Entities that a level lacks to be complete, in the order of their ids to be.
struct MissingEntities {
  std::vector<std::uint32_t> vertices;
  std::vector<Shape> shapes;
  std::vector<ModelRef> classes;
};

/// Edges in ascending order of their smaller vertex, then of the first entity that uses them (faces
/// before regions), whose direction and classification they take. Fills in what T(2,1) will be then
/// where it is asked for, at a fraction of what build_sides() takes. O(sides).
[[nodiscard]] MissingEntities missing_edges(const Mesh& mesh, DownRows* sides_of_faces = nullptr);
/// Faces in the order of the regions, outward from the first region that has them, with its
/// classification. O(sides).
[[nodiscard]] MissingEntities missing_faces(const Mesh& mesh);

}  // namespace aomd
