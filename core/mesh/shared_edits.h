#pragma once
// Edits that several threads make on one surface, or inside the regions of one volume, at once,
// each on vertices of its own.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

namespace aomd {

/// What one part of a surface of triangles does to it while other parts do the same, or one of a
/// volume of tetrahedra inside its model regions. A part owns vertices; it may touch a face (of a
/// volume, a region) where it owns all corners, and must look at no vertex that another part owns.
/// No entity of other levels changes but vertices, none is created, and ids of what was destroyed
/// stay taken until settle().
class SharedEdits {
 public:
  /// Whether nothing has to follow such edits but T(2,0) and T(0,2), which are stored: no other
  /// relation of faces, no journal, no lists of model entities, no hash of faces. Of a volume the
  /// same with T(3,0), T(0,3) and regions; then levels 1 and 2 hold no more than what lies on model
  /// edges and faces.
  [[nodiscard]] static bool possible(const Mesh& mesh);
  /// One for each of `parts`. Whoever has used up its room needs another call, which leaves the
  /// rest as it is.
  static void begin(Mesh& mesh, std::size_t parts, std::vector<SharedEdits>& edits);
  /// Ends what all parts destroyed, part by part, so that the mesh is one again.
  static void settle(Mesh& mesh, std::vector<SharedEdits>& edits);

  /// Whether there is room for one more operation around vertices that are not crowded.
  [[nodiscard]] bool has_room() const { return rows().room(part_).left() >= enough_; }
  /// As the functions of Mesh. A vertex that is destroyed must be in no face any more.
  void destroy_unused(Face f) { destroy_unused(f.index, mesh_->triangle(f)); }
  void destroy_unused(Region r) { destroy_unused(r.index, mesh_->tetrahedron(r)); }
  void destroy_unused(Vertex v) { destroyed_[0].push_back(v.index); }
  void rebind(std::span<const Rebinding> items);
  void move(Vertex v, const glm::dvec3& position) { mesh_->positions_[v.index] = position; }

 private:
  SharedEdits(Mesh& mesh, std::size_t part)
      : mesh_(&mesh), part_(part), level_(level_of(mesh)), enough_(enough_on(level_)) {}
  [[nodiscard]] static int level_of(const Mesh& mesh) { return mesh.count(3) > 0 ? 3 : 2; }
  /// Places for the row of two crowds, with those that it leaves behind as it grows.
  [[nodiscard]] static std::uint32_t enough_on(int level) { return level == 3 ? 8192 : 2048; }
  [[nodiscard]] UpRows& rows() const { return mesh_->representation_.up(0, level_); }
  template <std::size_t N>
  void destroy_unused(std::uint32_t id, const std::array<Vertex, N>& corners);

  Mesh* mesh_;
  std::size_t part_;
  int level_;                                            ///< of the faces, or regions
  std::uint32_t enough_;                                 ///< places for one more operation
  std::array<std::vector<std::uint32_t>, 2> destroyed_;  ///< vertices, and those, in their order
};

}  // namespace aomd
