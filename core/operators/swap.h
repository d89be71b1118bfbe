#pragma once
// Edge swap on surfaces: the other diagonal of two triangles (paper, section 3; there
// V_swapOpEdges_).
//
//        c                 c
//      / f \             / | \          .
//    a-------b   --->   a  |  b         .
//      \ g /             \ | /          .
//        d                 d

#include <array>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/verdict.h"

#pragma GCC visibility push(default)

namespace aomd {

class SharedEdits;

/// The two triangles at an edge, f = (a, b, c) and g = (b, a, d).
struct EdgePair {
  Face f, g;
  Vertex a, b, c, d;
};

/// Fills `pair` with the two triangles at the edge between two vertices. Refusals: Classification
/// (the edge lies on a model edge, or its faces differ), Topology (not exactly two faces,
/// oppositely oriented, or two faces on the same vertices; `pair` then has none). T(0,2) and T(2,0)
/// must be stored; edges need not be entities (see for_edges_at). O(faces around the
/// end that has fewer).
[[nodiscard]] Verdict find_pair(const Mesh& mesh, Vertex a, Vertex b, EdgePair& pair);

/// Whether an edge or a face joins two vertices already, or both are so crowded that telling would
/// take too long. T(0,2) and T(2,0) must be stored. O(faces around the one that has fewer).
[[nodiscard]] bool joined(const Mesh& mesh, Vertex a, Vertex b);

/// What swapping an edge would do. Accepted only where the smallest angle of the two triangles
/// grows. Refusals: Classification (the edge is on a model edge, or its faces differ), Topology
/// (not exactly two faces, oppositely oriented, or the other diagonal exists or would join two
/// crowded vertices), Flat, Angle (a new normal further than `max_turn` from either old one),
/// Quality. The mesh must store T(0,1), T(0,2) or T(1,2), T(2,0), and hold triangles only. `pair`
/// receives what was found.
[[nodiscard]] Verdict judge_swap(const Mesh& mesh, Edge edge, const TurnLimit& max_turn,
                                 EdgePair& pair);

/// The same for an edge that is known by its ends. T(0,2) and T(2,0) must be stored; edges need not
/// be entities (see for_edges_at).
[[nodiscard]] Verdict judge_swap(const Mesh& mesh, Vertex a, Vertex b, const TurnLimit& max_turn,
                                 EdgePair& pair);

/// Swaps: both faces keep their ids, and so does the edge where it is an entity. One journal step.
void apply_swap(Mesh& mesh, Edge edge, const EdgePair& pair);
void apply_swap(Mesh& mesh, const EdgePair& pair);
/// The same for one of several threads that edit a mesh at once: the edge must be no entity.
void apply_swap(SharedEdits& edits, const Mesh& mesh, const EdgePair& pair);

}  // namespace aomd

#pragma GCC visibility pop
