#pragma once
// Where curves of mesh edges branch, end and turn.

#include <array>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// The first two edges of curves at a vertex, and how many there are: 3 stands for more, too.
struct CurveEnds {
  std::array<Edge, 2> edges;
  std::size_t count = 0;
};

/// `on_curve(Edge)` says which edges are on curves. `edges` are those of a mesh that stores T(0,1),
/// or SomeEdges, with all that are on curves. O(row).
template <typename Edges, typename OnCurve>
[[nodiscard]] CurveEnds curve_at(const Edges& edges, Vertex v, const OnCurve& on_curve) {
  CurveEnds ends;
  for (const Edge e : edges.template row<1>(v)) {
    if (!on_curve(e)) continue;
    if (ends.count == 2) return {ends.edges, 3};
    ends.edges[ends.count++] = e;
  }
  return ends;
}

/// The vertex so many edges along a curve, or where it branches or ends before.
template <typename Edges, typename OnCurve>
[[nodiscard]] Vertex along_curve(const Edges& edges, Vertex v, Edge e, int away,
                                 const OnCurve& on_curve) {
  for (int i = 0;; ++i) {
    v = edges.other_end(e, v);
    const CurveEnds ends = curve_at(edges, v, on_curve);
    if (i + 1 >= away || ends.count != 2) return v;
    e = ends.edges[0] == e ? ends.edges[1] : ends.edges[0];
  }
}

/// True at a corner: the curve turns at the vertex, where `ends` counts two, and still does when
/// looked at from a few edges away, so that the jags of a scan's border cancel each other.
template <typename Edges, typename OnCurve>
[[nodiscard]] bool curve_turns(const Edges& edges, Vertex v, const CurveEnds& ends,
                               const TurnLimit& corner, const OnCurve& on_curve) {
  constexpr int edges_away = 3;
  for (const int away : {1, edges_away}) {
    const glm::dvec3 at = edges.position(v);
    const glm::dvec3 in = at - edges.position(along_curve(edges, v, ends.edges[0], away, on_curve));
    const glm::dvec3 out =
        edges.position(along_curve(edges, v, ends.edges[1], away, on_curve)) - at;
    if (corner.allows(in, out)) return false;
  }
  return true;
}

}  // namespace aomd
