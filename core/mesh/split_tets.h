#pragma once
// Regions of any shape cut into tetrahedra.

#include <array>
#include <cstddef>
#include <string>

#include "core/mesh/mesh_data.h"

namespace aomd {

/// What split_to_tets() made.
struct SplitToTets {
  MeshData mesh;
  std::array<std::size_t, max_shapes> cut{};     ///< entities cut into pieces, indexed by Shape
  std::array<std::size_t, max_shapes> pieces{};  ///< what those of each shape became
  std::size_t inverted = 0;  ///< pieces without positive volume: of regions that are not convex

  /// "8 hexahedra into 48 tetrahedra, 34 quads into 68 triangles"; empty where nothing was cut.
  [[nodiscard]] std::string text() const;
};

/// Cuts every region that is no tetrahedron, and every face with more than three vertices, without
/// new vertices. Each side is cut from its smallest vertex, so that neighbours and listed faces
/// agree, and a region becomes the tetrahedra between its smallest vertex and the triangles of the
/// sides that do not have it ("pulling"; J. Dompierre, P. Labbe, M.-G. Vallet, R. Camarero, How to
/// subdivide pyramids, prisms and hexahedra into tetrahedra, 8th Meshing Roundtable, 1999). Pieces
/// stand where the whole stood, with its class and its attributes. Regions that are listed inside
/// out are renumbered before. A mesh without regions stays as it is. O(size).
[[nodiscard]] SplitToTets split_to_tets(MeshData mesh);

}  // namespace aomd
