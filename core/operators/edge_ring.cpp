#include "core/operators/edge_ring.h"

#include <algorithm>
#include <span>

#include "core/operators/ball.h"
#include "core/operators/swap.h"

namespace aomd {
namespace {

// A tetrahedron at the edge: (a, b, from, to) stands upright where it does.
struct Link {
  Vertex from, to;
  Region region;
};

struct Links {
  std::array<Link, std::size_t{2} * largest_ring> items;
  std::uint32_t count = 0;
  [[nodiscard]] std::span<const Link> all() const { return {items.data(), count}; }
  [[nodiscard]] const Link* from(Vertex v) const {
    const auto links = all();
    const auto at =
        std::find_if(links.begin(), links.end(), [&](const Link& link) { return link.from == v; });
    return at == links.end() ? nullptr : &*at;
  }
};

template <std::size_t N>
bool has_all(const Mesh& mesh, Region r, const std::array<Vertex, N>& wanted) {
  const Row<0> corners = mesh.row<0>(r);
  return std::all_of(wanted.begin(), wanted.end(), [&](Vertex v) {
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  });
}

bool all_tetrahedra(const Mesh& mesh) {
  const ShapeTemplate* all = mesh.uniform_shape(3);
  return all && all->vertex_count == 4;
}

// Whether a region that is known to be a tetrahedron has all of some vertices: the inner loop,
// which does not ask for the shape.
template <std::size_t N>
bool tetrahedron_has_all(const Mesh& mesh, Region r, const std::array<Vertex, N>& wanted) {
  const auto t = mesh.tetrahedron(r);
  std::uint32_t found = 0;
  for (const Vertex v : wanted) found += (t[0] == v) | (t[1] == v) | (t[2] == v) | (t[3] == v);
  return found == N;
}

template <std::size_t N>
bool share_a_region(const Mesh& mesh, const std::array<Vertex, N>& wanted) {
  const bool tetrahedra = all_tetrahedra(mesh);
  for (const Region r : fewer_regions(mesh, wanted[0], wanted[1]))
    if (tetrahedra ? tetrahedron_has_all(mesh, r, wanted) : has_all(mesh, r, wanted)) return true;
  return false;
}

// The two other vertices of a tetrahedron, in the order that stands upright behind (a, b).
Link link_of(const Mesh& mesh, Region r, Vertex a, Vertex b) {
  const auto t = mesh.tetrahedron(r);
  const auto slot = static_cast<std::size_t>(std::find(t.begin(), t.end(), a) - t.begin());
  const auto& from = seen_from[slot];
  const std::size_t k = t[from[0]] == b ? 0 : t[from[1]] == b ? 1 : 2;
  return {t[from[(k + 1) % 3]], t[from[(k + 2) % 3]], r};
}

bool gather(const Mesh& mesh, Vertex a, Vertex b, Links& links) {
  const bool tetrahedra = all_tetrahedra(mesh);
  const std::array ends{a, b};
  links.count = 0;
  for (const Region r : fewer_regions(mesh, a, b)) {
    if (!(tetrahedra ? tetrahedron_has_all(mesh, r, ends) : has_all(mesh, r, ends))) continue;
    if (!tetrahedra && mesh.shape(r) != Shape::Tetrahedron) return false;
    if (links.count == links.items.size()) return false;
    links.items[links.count++] = link_of(mesh, r, a, b);
  }
  return links.count > 0;
}

// The faces at the edge that lie on a model face: none, or the two of a pair.
Verdict find_faces(const Mesh& mesh, EdgeRing& ring) {
  for (const Face f : fewer_faces(mesh, ring.a, ring.b)) {
    const ModelRef on = mesh.classification(f);
    if (on.dimension() > 2) continue;
    const auto t = mesh.triangle(f);
    const auto at = std::find(t.begin(), t.end(), ring.a) - t.begin();
    if (at == 3 || std::find(t.begin(), t.end(), ring.b) == t.end()) continue;
    const auto slot = static_cast<std::size_t>(at);
    const bool forward = t[(slot + 1) % 3] == ring.b;
    Face& place = ring.faces[forward ? 0 : 1];
    if (place.valid()) return {Reason::Topology, f};
    place = f;
    ring.apexes[forward ? 0 : 1] = t[(slot + (forward ? 2 : 1)) % 3];
  }
  const auto [f, g] = ring.faces;
  if (f.valid() != g.valid()) return {Reason::Classification, f.valid() ? f : g};
  if (f.valid() && mesh.classification(f) != mesh.classification(g))
    return {Reason::Classification, f};
  return {};
}

// Follows the links from `first` on until `last` is reached. False where they end before, or are
// too many.
bool follow(const Links& links, Vertex first, Vertex last, RingSide& side) {
  side = {};
  side.closed = first == last;
  Vertex v = first;
  do {
    const Link* link = links.from(v);
    if (!link || side.count == largest_ring) return false;
    side.ring[side.count] = v;
    side.regions[side.count++] = link->region;
    v = link->to;
  } while (v != last);
  if (side.closed) return true;
  if (side.count == largest_ring) return false;
  side.ring[side.count++] = last;
  return true;
}

bool find_sides(const Links& links, EdgeRing& ring) {
  ring.side_count = 0;
  std::uint32_t used = 0;
  const auto add = [&](Vertex first, Vertex last) {
    RingSide& side = ring.sides[ring.side_count++];
    const bool follows = follow(links, first, last, side);
    used += follows ? side.region_count() : 0;
    return follows;
  };
  const auto& [c, d] = ring.apexes;
  if (!ring.on_model_face()) {
    const Vertex first = links.items[0].from;
    return add(first, first) && used == links.count;
  }
  if (links.from(c) && !add(c, d)) return false;
  if (links.from(d) && !add(d, c)) return false;
  return used == links.count;
}

// Whether each side of the ring lies within one model region.
Verdict judge_classes(const Mesh& mesh, const EdgeRing& ring) {
  for (std::uint32_t s = 0; s < ring.side_count; ++s) {
    const RingSide& side = ring.sides[s];
    for (std::uint32_t i = 1; i < side.region_count(); ++i)
      if (mesh.classification(side.regions[i]) != mesh.classification(side.regions[0]))
        return {Reason::Classification, side.regions[i]};
  }
  return {};
}

// Faces inside regions are sides of the ring, or hang on the edge from outside.
Verdict judge_other_faces(const Mesh& mesh, const EdgeRing& ring, const Links& links) {
  for (const Face f : fewer_faces(mesh, ring.a, ring.b)) {
    if (mesh.classification(f).dimension() <= 2) continue;
    const auto t = mesh.triangle(f);
    const auto on = [&](Vertex v) { return std::find(t.begin(), t.end(), v) != t.end(); };
    if (!on(ring.a) || !on(ring.b)) continue;
    const auto all = links.all();
    if (std::none_of(all.begin(), all.end(),
                     [&](const Link& link) { return on(link.from) || on(link.to); }))
      return {Reason::Topology, f};
  }
  return {};
}

Verdict judge_edge(const Mesh& mesh, Vertex a, Vertex b) {
  if (!may_end_model_edge(mesh, a) || !may_end_model_edge(mesh, b)) return {};
  const Edge edge = mesh.find_edge(a, b);
  if (on_model_edge(mesh, edge)) return {Reason::Classification, edge};
  return {};
}

}  // namespace

Verdict find_ring(const Mesh& mesh, Vertex a, Vertex b, EdgeRing& ring) {
  ring.a = std::min(a, b);
  ring.b = std::max(a, b);
  ring.faces = {};
  ring.side_count = 0;
  Links links;
  if (!gather(mesh, ring.a, ring.b, links)) return {Reason::Topology, ring.a};
  if (const Verdict v = judge_edge(mesh, ring.a, ring.b); !v.accepted()) return v;
  if (const Verdict v = find_faces(mesh, ring); !v.accepted()) return v;
  if (!find_sides(links, ring)) return {Reason::Topology, ring.a};
  if (const Verdict v = judge_classes(mesh, ring); !v.accepted()) return v;
  return judge_other_faces(mesh, ring, links);
}

bool joined_in_volume(const Mesh& mesh, Vertex a, Vertex b) {
  return share_a_region(mesh, std::array{a, b}) || joined(mesh, a, b);
}

bool joined_in_volume(const Mesh& mesh, Vertex a, Vertex b, Vertex c) {
  const std::array corners{a, b, c};
  return share_a_region(mesh, corners) || mesh.find_face(corners).valid();
}

}  // namespace aomd
