#pragma once
// Edge removal: the tetrahedra around an edge become others that do without it (paper, section 3;
// there V_swapOpEdges_ of a volume).
//
//        r2                          r2
//      / | \                       / | \          a and b lie below and above; each triangle
//    r3--e--r1        --->       r3  |  r1        of the ring becomes one tetrahedron with a
//      \ | /                       \ | /          and one with b
//        r0                          r0

#include <array>
#include <cstdint>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/edge_ring.h"
#include "core/operators/tet_edits.h"
#include "core/operators/verdict.h"

namespace aomd {

/// What edge and face removal are after, and what they have to respect.
struct RemovalRules {
  TurnLimit max_turn{10.0};      ///< how far the normals of a model face may turn
  LeastAngle least_angle{0};     ///< of a face on a model face, unless one of the two was smaller
  LeastAngle least_dihedral{0};  ///< between two faces of a new tetrahedron, unless one of those
                                 ///< that go had a smaller one
  RemovalGoal goal = RemovalGoal::Worst;
};

/// Positions in a ring, ascending.
using RingTriangle = std::array<std::uint8_t, 3>;

/// The triangles that a side's ring is cut into, two fewer than its vertices. Each is followed by
/// those behind its two other sides; the first one has the first and the last vertex.
struct RingTriangles {
  std::uint32_t count = 0;
  std::array<RingTriangle, largest_ring - 2> items;
};

/// An edge removal that was judged: what the verdict says, and what making it needs. Around an
/// inner edge n tetrahedra become 2 (n - 2), on each side of one on a model face n become 2 (n -
/// 1): every region of the ring keeps its id and all but one vertex, except the third of three,
/// which goes; others are created.
struct EdgeRemoval {
  Verdict verdict;
  EdgeRing ring;
  std::array<RingTriangles, 2> triangles;  ///< accepted or Quality: by side of the ring
  double before = 0, after = 0;            ///< by the goal: more is better
  std::uint64_t revision = 0;              ///< of the mesh that was judged
};

/// What removing the edge between two vertices would do: of all ways to cut the ring into
/// triangles, the best one by the goal (Klincsek 1980), accepted only where that is better than
/// what there is now, and upright. On a model face the edge becomes the other
/// diagonal of its two faces. Refusals in this order: as find_ring; Topology (an edge between those
/// faces' third vertices exists), Flat, Angle (a new normal further than `max_turn` from either old
/// one), Shape (a new face with a smaller angle than `least_angle` allows), Quality (number: the
/// smallest dihedral angle of the worst new tetrahedron), Shape (a new tetrahedron with a smaller
/// dihedral angle than `least_dihedral` allows; named is the first of the ring), Topology (an edge
/// or face inside the ring exists). What must be stored: as find_ring.
Verdict judge(const Mesh& mesh, Vertex a, Vertex b, const RemovalRules& rules, EdgeRemoval& plan);

/// Makes what was accepted. The mesh must not have changed since. Entities inside the ring that
/// vanish are destroyed, and made where their level is complete. One journal step.
void apply(Mesh& mesh, const EdgeRemoval& plan);

}  // namespace aomd
