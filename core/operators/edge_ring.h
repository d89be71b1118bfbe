#pragma once
// The tetrahedra around an edge, in order, as the operators that remove edges look at them.
//
//          v2                        d
//        / | \                     / | \          .
//      v3--e--v1                 v1--e            one side of an edge on a model face c-e-d,
//        \ | /                     \ | \          and the other
//          v0                        c

#include <array>
#include <cstdint>

#include "core/mesh/mesh.h"
#include "core/operators/verdict.h"

namespace aomd {

/// As many vertices as a ring may have: beyond nine, what pays is rare and costs the third power.
inline constexpr std::uint32_t largest_ring = 9;

/// Tetrahedra that follow each other around an edge from a to b, counterclockwise seen from b:
/// (a, b, ring[i], ring[i + 1]) stands upright where regions[i] does.
struct RingSide {
  bool closed = false;      ///< the last region ends at the first vertex
  std::uint32_t count = 0;  ///< of vertices
  std::array<Vertex, largest_ring> ring;
  std::array<Region, largest_ring> regions;

  [[nodiscard]] std::uint32_t region_count() const { return closed ? count : count - 1; }
  [[nodiscard]] Vertex after(std::uint32_t i) const { return ring[i + 1 == count ? 0 : i + 1]; }
};

/// All that is around the edge between two vertices, a the smaller one: a closed side inside a
/// region; one or two open ones, between the same two vertices, where the edge lies on a model
/// face.
struct EdgeRing {
  Vertex a, b;
  std::uint32_t side_count = 0;
  std::array<RingSide, 2> sides;
  /// The two faces of the model face, the first with a before b; invalid inside a region.
  std::array<Face, 2> faces;
  std::array<Vertex, 2> apexes;  ///< their third vertices

  [[nodiscard]] bool on_model_face() const { return faces[0].valid(); }
};

/// Fills `ring` with what is around the edge between two vertices. Refusals: Classification (the
/// edge lies on a model edge, or what is around it does not lie on one model region or face),
/// Topology (no tetrahedra or others than these, more than largest_ring on a side, none that close
/// the ring, or a face that is no side of them). T(0,3), T(3,0), T(0,2) and T(2,0) must be stored,
/// levels 1 and 2 complete or with what lies on model edges and faces (Mesh::request_listed).
/// O(regions and faces around the end that has fewer).
[[nodiscard]] Verdict find_ring(const Mesh& mesh, Vertex a, Vertex b, EdgeRing& ring);

/// The regions around that end of an edge that has fewer. T(0,3) must be stored.
[[nodiscard]] inline Row<3> fewer_regions(const Mesh& mesh, Vertex a, Vertex b) {
  const Row<3> at_a = mesh.row<3>(a), at_b = mesh.row<3>(b);
  return at_b.size() < at_a.size() ? at_b : at_a;
}

/// Whether an edge, a face or a region joins two vertices already. As find_ring.
[[nodiscard]] bool joined_in_volume(const Mesh& mesh, Vertex a, Vertex b);

/// Whether a face or a region has these three vertices already. As find_ring.
[[nodiscard]] bool joined_in_volume(const Mesh& mesh, Vertex a, Vertex b, Vertex c);

}  // namespace aomd
