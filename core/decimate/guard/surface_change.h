#pragma once
// What an operation would do to the surface, as geometry: what a guard looks at before it is
// applied.
//
//   replaced                    created
//     +-----+                     +-----+
//    / \   / \                   / \   / \        .
//   +---d-k---+    d onto k     +---k*----+
//    \ /   \ /    ---------->    \ /   \ /
//     +-----+                     +-----+

#include <array>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"
#include "core/operators/collapse.h"
#include "core/operators/star.h"
#include "core/operators/swap.h"

namespace aomd {

/// A face as it would be afterwards; its corners in the face's order, starting anywhere.
struct NewFace {
  Face face;
  std::array<Vertex, 3> vertices;
  Triangle corners;
  ModelRef model;  ///< what the face lies on
};

/// A piece of a model edge as it would be afterwards.
struct NewPiece {
  ModelRef curve;
  Vertex at;  ///< its end that moves or takes over
  std::array<glm::dvec3, 2> ends;
  Edge edge;
};

/// One operation: the faces that would go or change, and what would take their place. Reused, it
/// allocates nothing once it has held its largest operation.
struct Change {
  std::vector<Face> replaced;
  std::vector<NewFace> created;  ///< each has the id of one that is replaced
  std::vector<NewPiece> pieces;  ///< model edges that change
  std::vector<Edge> old_pieces;  ///< what they were; of a volume also what goes
  /// Of a volume, what stays as it is around the vertex that is kept.
  std::vector<NewFace> beside;
  std::vector<NewPiece> pieces_beside;

  void clear() {
    replaced.clear(), created.clear(), pieces.clear(), old_pieces.clear();
    beside.clear(), pieces_beside.clear();
  }
};

/// The change that a contraction makes, from the faces around both its ends, as a CollapsePlan has
/// them. Where the kept end does not move, the faces that only it has are no part of it. O(faces
/// around both ends).
void describe(const Mesh& mesh, const Contraction& contraction, const Star& around_deleted,
              const Star& around_kept, Change& change);

/// The change that swapping the edge of a pair makes.
void describe(const Mesh& mesh, const EdgePair& pair, Change& change);

/// The change that moving a vertex makes, from the faces around it. O(faces around it).
void describe(const Mesh& mesh, Vertex v, const Star& around, const glm::dvec3& target,
              Change& change);

}  // namespace aomd
