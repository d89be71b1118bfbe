#pragma once
// Edits that several threads make on one surface at once, each on vertices of its own.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

namespace aomd {

/// What one part of a surface of triangles does to it while other parts do the same. A part owns
/// vertices; it may touch a face where it owns all three corners, and must look at no vertex that
/// another part owns. No entity of level 1 changes, none is created, and ids of what was destroyed
/// stay taken until settle().
class SharedEdits {
 public:
  /// Whether nothing has to follow such edits but T(2,0) and T(0,2), which are stored: no other
  /// relation of faces, no journal, no lists of model entities, no hash of faces.
  [[nodiscard]] static bool possible(const Mesh& mesh);
  /// One for each of `parts`. Whoever has used up its room needs another call, which leaves the
  /// rest as it is.
  static void begin(Mesh& mesh, std::size_t parts, std::vector<SharedEdits>& edits);
  /// Ends what all parts destroyed, part by part, so that the mesh is one again.
  static void settle(Mesh& mesh, std::vector<SharedEdits>& edits);

  /// Whether there is room for one more operation around vertices that are not crowded.
  [[nodiscard]] bool has_room() const { return rows().room(part_).left() >= enough; }
  /// As the functions of Mesh. A vertex that is destroyed must be in no face any more.
  void destroy_unused(Face f);
  void destroy_unused(Vertex v) { destroyed_[0].push_back(v.index); }
  void rebind(std::span<const Rebinding> items);
  void move(Vertex v, const glm::dvec3& position) { mesh_->positions_[v.index] = position; }

 private:
  static constexpr std::uint32_t enough = 2048;  ///< places for the row of two crowds
  SharedEdits(Mesh& mesh, std::size_t part) : mesh_(&mesh), part_(part) {}
  [[nodiscard]] UpRows& rows() const { return mesh_->representation_.up(0, 2); }

  Mesh* mesh_;
  std::size_t part_;
  std::array<std::vector<std::uint32_t>, 2> destroyed_;  ///< vertices, and faces, in their order
};

}  // namespace aomd
