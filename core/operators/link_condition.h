#pragma once
// When a collapse keeps the topology of the faces around an edge.

#include <vector>

#include "core/operators/collapse_rules.h"
#include "core/operators/star.h"
#include "core/operators/verdict.h"
#include "core/operators/vertex_marks.h"

#pragma GCC visibility push(default)

namespace aomd {

using StarPair = std::array<Star, 2>;

/// The two other edges of a face at the edge between the ends, at `apex`, fall together: whether
/// the one that stays would have no face any more.
[[nodiscard]] bool leaves_bare_edge(const EdgeEnds& ends, const StarPair& stars, Vertex apex);

/// The link condition among model edges: the third vertex of a chain of three of them that the edge
/// between two vertices, itself on one, is part of, and which a collapse would close; what it goes
/// around would vanish. Invalid where there is none. O(edges at the ends).
[[nodiscard]] Vertex closes_chain(const Mesh& mesh, const EdgeEnds& ends, const Star& around_first);

/// The link condition for faces, which is the same whichever end goes: the ends share no neighbour
/// beyond the apexes of their faces, no two faces fall together, no pocket closes, no two fans meet
/// in one vertex, and no edge loses its last face. A collapse then takes one vertex, k faces and
/// k + 1 edges: the Euler number stays. Edges of any number of faces are legal. Holds scratch, so
/// that judging allocates nothing.
class LinkCondition {
 public:
  /// Refuses with Topology and the entity that decided; with `edge` where that is the edge itself.
  /// O(faces around both ends).
  [[nodiscard]] Verdict judge(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                              const StarPair& stars, VertexMarks& marks);

 private:
  [[nodiscard]] bool gather_apexes(const Star& star, Vertex other_end);
  [[nodiscard]] std::uint64_t apex_bit(Vertex v) const;
  [[nodiscard]] bool stay_together(const EdgeEnds& ends, const StarPair& stars) const;
  [[nodiscard]] bool keeps_fans(const EdgeEnds& ends, const StarPair& stars) const;

  std::vector<Vertex> apexes_;  ///< third vertices of the edge's faces
};

}  // namespace aomd

#pragma GCC visibility pop
