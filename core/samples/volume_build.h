#pragma once
// What the generators of volumes share.

#include <array>
#include <cstdint>
#include <functional>

#include "core/mesh/mesh_data.h"

namespace aomd::sample {

/// The corners of a cell of a grid: corner[i + 2 j + 4 k] is the one at (i, j, k), each 0 or 1. The
/// three directions form a right-handed frame.
using Cell = std::array<std::uint32_t, 8>;

/// Adds a cell as one hexahedron.
void add_hexahedron(MeshData& mesh, const Cell& cell, ModelRef model);
/// Adds a cell as two prisms along k, cut by the diagonal from corner 0 to corner 3.
void add_prisms(MeshData& mesh, const Cell& cell, ModelRef model);
/// Adds a cell as six tetrahedra around the diagonal from corner 0 to corner 7 (Kuhn, Freudenthal).
/// Every side is cut from its smallest corner to its largest, so that cells of one grid match.
void add_tetrahedra(MeshData& mesh, const Cell& cell, ModelRef model);
/// Adds a cell as a pyramid on its side k = 0 and ten tetrahedra, all with their tops at `centre`;
/// the other five sides are cut as add_tetrahedra() cuts them.
void add_transition(MeshData& mesh, const Cell& cell, std::uint32_t centre, ModelRef model);

/// Model faces 1 to 6 of the box between two corners, in the order -x, +x, -y, +y, -z, +z; `inside`
/// otherwise.
[[nodiscard]] std::int32_t side_of_box(const glm::dvec3& p, const glm::dvec3& low,
                                       const glm::dvec3& high, std::int32_t inside);

/// Names the model face on which a side with this centre lies.
using FaceTag = std::function<std::int32_t(const glm::dvec3& centre)>;

/// Lists the sides that bound a model region as faces on model faces: those of one region only,
/// looking outward, and those between two model regions, looking out of the first. Classifies what
/// lies below, and all other vertices on the model region around them. O(n log n).
void classify_below_regions(MeshData& mesh, const FaceTag& tag_of);

}  // namespace aomd::sample
