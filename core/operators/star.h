#pragma once
// The faces around a vertex, and the model edges there, as the operators look at them.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/mesh/derive.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A triangle around a vertex, seen from it.
struct StarFace {
  Face face;
  std::uint32_t slot = 0;  ///< where the vertex stands in the face
  Vertex next, previous;   ///< the other two, in the face's order
  [[nodiscard]] bool uses(Vertex v) const { return next == v || previous == v; }
  [[nodiscard]] Vertex third(Vertex v) const { return next == v ? previous : next; }
};
using Star = std::vector<StarFace>;

/// Fills `star` with these faces around `v`. T(2,0) must be stored, all faces be triangles.
inline void gather(const Mesh& mesh, Vertex v, const Row<2>& faces, Star& star) {
  static constexpr std::array<std::uint8_t, 3> next{1, 2, 0}, previous{2, 0, 1};
  const DownRows& corners = mesh.representation().down(2, 0);
  star.resize(faces.size());
  StarFace* to = star.data();
  for (const Face f : faces) {
    const std::uint32_t* const t = corners.row(f.index);
    const std::uint32_t slot = std::uint32_t{t[1] == v.index} + 2 * std::uint32_t{t[2] == v.index};
    *to++ = {f, slot, Vertex(t[next[slot]]), Vertex(t[previous[slot]])};
  }
}

/// The faces around a vertex, in ascending order. T(0,2) and T(2,0) must be stored. O(faces around
/// v).
inline void gather(const Mesh& mesh, Vertex v, Star& star) {
  gather(mesh, v, mesh.row<2>(v), star);
}

/// More faces around a vertex than this are a crowd. What looks at all of them for each edge there
/// takes the square of their number, so that a crowded vertex takes part in no collapse until
/// enough of its neighbours have gone into each other: a fan of any number of faces then takes time
/// proportional to it.
inline constexpr std::size_t largest_star = 512;

/// Whether a vertex has more than `largest_star` faces, or edges where T(0,2) is not stored.
[[nodiscard]] inline bool crowded(const Mesh& mesh, Vertex v) {
  return (mesh.stored(0, 2) ? mesh.row<2>(v).size() : mesh.row<1>(v).size()) > largest_star;
}

/// The faces around that end of an edge that has fewer. T(0,2) must be stored.
[[nodiscard]] inline Row<2> fewer_faces(const Mesh& mesh, Vertex a, Vertex b) {
  const Row<2> at_a = mesh.row<2>(a), at_b = mesh.row<2>(b);
  return at_b.size() < at_a.size() ? at_b : at_a;
}

/// The faces around a vertex, in ascending order: the row of T(0,2) where it is stored, else
/// derived (T(0,1) and T(1,2) stored, say) into `derived`.
[[nodiscard]] inline Row<2> faces_around(const Mesh& mesh, Vertex v,
                                         std::vector<std::uint32_t>& derived) {
  if (mesh.stored(0, 2)) return mesh.row<2>(v);
  adjacent(mesh, v, 2, derived);
  return Row<2>(derived);
}

/// Spreads ids over 64 bits, so that sums and xors of several tell sets of vertices apart.
[[nodiscard]] inline std::uint64_t spread(Vertex v) {
  const std::uint64_t x = (v.index + 1) * 0x9E3779B97F4A7C15u;
  return (x ^ (x >> 29)) * 0xBF58476D1CE4E5B9u;
}

/// True where the faces around a vertex do not close: in a closed ring every neighbour occurs
/// twice.
[[nodiscard]] inline bool is_open(const Star& star) {
  std::uint64_t odd = 0;
  for (const StarFace& f : star) odd ^= spread(f.next) ^ spread(f.previous);
  return odd != 0;
}

/// True where every neighbour follows a face as often as it precedes one: a closed ring of one
/// orientation.
[[nodiscard]] inline bool is_ring(const Star& star) {
  std::uint64_t sum = 0;
  for (const StarFace& f : star) sum += spread(f.next) - spread(f.previous);
  return sum == 0;
}

/// Calls visit(neighbour) once for each vertex that shares a face: as the next one around, or where
/// the faces do not form rings of one orientation, as the previous one.
template <typename Visit>
void for_neighbours(const Star& star, Visit&& visit) {
  const bool ring = is_ring(star);
  for (std::size_t i = 0; i < star.size(); ++i) {
    bool seen = false;  // around a vertex where several sheets meet
    for (std::size_t k = 0; k < i && !ring && !seen; ++k) seen = star[k].next == star[i].next;
    if (!seen) visit(star[i].next);
    if (ring) continue;
    seen = false;
    for (std::size_t k = 0; k < star.size() && !seen; ++k)
      seen = star[k].next == star[i].previous || (k < i && star[k].previous == star[i].previous);
    if (!seen) visit(star[i].previous);
  }
}

/// False only where no entity of level 1 can end at a vertex: it lies inside a model face or
/// region.
[[nodiscard]] inline bool may_end_model_edge(const Mesh& mesh, Vertex v) {
  const ModelRef on = mesh.classification(v);
  return !on.valid() || on.dimension() <= 1;
}

/// Whether an edge is an entity and lies on a model edge.
[[nodiscard]] inline bool on_model_edge(const Mesh& mesh, Edge e) {
  return e.valid() && mesh.classification(e).dimension() <= 1;
}

/// What the edge between two vertices lies on, from the faces around the first. Only model edges
/// may be entities; every other edge lies on the face around it. Invalid where no face joins them.
[[nodiscard]] inline ModelRef class_between(const Mesh& mesh, Vertex a, Vertex b,
                                            const Star& around_a) {
  for (const Vertex v : {a, b})
    if (!may_end_model_edge(mesh, v)) return mesh.classification(v);
  if (const Edge e = mesh.find_edge(a, b); e.valid()) return mesh.classification(e);
  for (const StarFace& f : around_a)
    if (f.uses(b)) return mesh.classification(f.face);
  return {};
}

/// The same where the faces around neither end are gathered yet.
[[nodiscard]] inline ModelRef class_between(const Mesh& mesh, const std::array<Vertex, 2>& ends) {
  for (const Vertex v : ends)
    if (!may_end_model_edge(mesh, v)) return mesh.classification(v);
  const auto& [a, b] = ends;
  if (const Edge e = mesh.find_edge(a, b); e.valid()) return mesh.classification(e);
  for (const Face f : fewer_faces(mesh, a, b)) {
    const auto t = mesh.triangle(f);
    const auto has = [&t](Vertex v) { return t[0] == v || t[1] == v || t[2] == v; };
    if (has(a) && has(b)) return mesh.classification(f);
  }
  return {};
}

/// Calls visit(edge, far end) for every edge entity at `v`: from T(0,1) where it is stored; else
/// every edge must be a side of a face, and they are found by existence queries along the faces
/// around `v`. Where the mesh lists model edges only, just between vertices that may end one; where
/// it holds them all, in the order in which T(0,1) gives them, the last one first.
template <typename Visit>
void for_edges_at(const Mesh& mesh, Vertex v, const Star& star, Visit&& visit) {
  if (mesh.stored(0, 1)) {
    const Row<1> edges = mesh.row<1>(v);
    for (std::size_t i = edges.size(); i-- > 0;) visit(edges[i], mesh.other_end(edges[i], v));
    return;
  }
  const bool all = mesh.complete(1);
  if (mesh.count(1) == 0 || (!all && !may_end_model_edge(mesh, v))) return;
  std::vector<std::pair<Edge, Vertex>> found;
  for (std::size_t i = 0; i < star.size(); ++i) {
    for (const Vertex far : {star[i].next, star[i].previous}) {
      if (!all && !may_end_model_edge(mesh, far)) continue;
      bool seen = far == star[i].previous && far == star[i].next;
      for (std::size_t k = 0; k < i && !seen; ++k) seen = star[k].uses(far);
      if (seen) continue;
      const Edge e = mesh.find_edge(v, far);
      if (e.valid() && all) found.emplace_back(e, far);
      if (e.valid() && !all) visit(e, far);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return b.first < a.first; });
  for (const auto& [edge, far] : found) visit(edge, far);
}

}  // namespace aomd

#pragma GCC visibility pop
