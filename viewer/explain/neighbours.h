#pragma once
// The entities of another level around one entity: from a stored row of T(I,J), or on a path of
// stored rows.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/derive.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene {

/// What there is to show of T(I,J) at one entity of level I.
struct Neighbours {
  EntityRef of;
  int level = 0;  ///< J
  AdjacencyPath path;
  bool known = false;  ///< false: `words` says what is missing
  std::vector<EntityRef>
      entities;  ///< of level J: lower ones in template order, higher ones sorted
  std::vector<EntityRef>
      between;         ///< those that the path passes, nearest level first, each level sorted
  std::string words;   ///< "T(0,2) derived: 0 -> 1 -> 2 (union of rows)"
  std::string remedy;  ///< the command that makes it known; empty where it is, or none can

  [[nodiscard]] bool stored() const { return path.kind == AdjacencyPath::Kind::Stored; }
};

/// Through explain(); a living entity. Never builds a hash set: where only one would lead there it
/// says so. O(answer).
[[nodiscard]] Neighbours find_neighbours(const Mesh& mesh, EntityRef e, int level);

/// Which relations are stored and which hash sets are built, as bits: what find_neighbours depends
/// on besides the entities.
[[nodiscard]] std::uint32_t stored_bits(const Mesh& mesh);

/// Stored neighbours: solid. Derived ones: dashed and hollow. What lies between: thin and grey.
[[nodiscard]] OverlayStyle stored_style();
[[nodiscard]] OverlayStyle derived_style();
[[nodiscard]] OverlayStyle between_style();
/// The entity itself is drawn as selected ones are. O(neighbours).
void draw_neighbours(const Mesh& mesh, const Neighbours& neighbours, const glm::dvec3& origin,
                     Overlay& overlay);

}  // namespace aomd::scene
