#pragma once
// Face removal: the face between two tetrahedra becomes an edge between their other vertices.
//
//        p                      p
//      / | \                  / | \         the face x y z goes, three tetrahedra stand around the
//    x---z---y      --->    x---|---y       edge p-q
//      \ | /                  \ | /
//        q                      q

#include <array>
#include <cstdint>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/edge_removal.h"
#include "core/operators/verdict.h"

namespace aomd {

/// A face removal that was judged: what the verdict says, and what making it needs. Both regions
/// keep their ids, a third is created.
struct FaceRemoval {
  Verdict verdict;
  std::array<Region, 2> regions;
  std::array<Vertex, 2> apexes;   ///< the vertices that are not on the face, by region
  std::array<Vertex, 3> corners;  ///< of the face: (apexes[0], corners) stands upright
  double before = 0, after = 0;   ///< by the goal: more is better
  std::uint64_t revision = 0;     ///< of the mesh that was judged
};

/// What removing the face of a tetrahedron would do that lies opposite to one of its vertices (by
/// its position there). Refusals in this order: Topology (no tetrahedron on the other side),
/// Classification (the face lies on a model face), Quality (by the goal the three would not be
/// better than the two, or not upright; number: the smallest dihedral angle of the worst one),
/// Shape (one of the three has a smaller dihedral angle than the rules allow, and than both of the
/// two), Topology (an edge between the apexes exists). What must be stored: as find_ring
/// (edge_ring.h). O(regions around an apex and a corner).
Verdict judge(const Mesh& mesh, Region region, std::uint32_t slot, const RemovalRules& rules,
              FaceRemoval& plan);

/// Makes what was accepted. The mesh must not have changed since. The face is destroyed where it is
/// an entity; the new edge and faces are made where their level is complete. One journal step.
void apply(Mesh& mesh, const FaceRemoval& plan);

}  // namespace aomd
