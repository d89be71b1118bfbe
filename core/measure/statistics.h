#pragma once
// Counts and quality of a mesh: what reports and panels show.

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

#pragma GCC visibility push(default)

namespace aomd::measure {

/// How many there are of what. A face that occurs twice counts twice, also at its edges.
struct Counts {
  std::size_t vertices = 0;
  std::size_t unused_vertices = 0;  ///< of those: used by no region, no face and no listed edge
  std::size_t edges = 0;  ///< pairs of vertices that are a side of something, or a listed edge
  std::size_t faces = 0;  ///< with regions: their sides, each once, and listed faces
  std::size_t regions = 0;
  std::size_t boundary_edges = 0;     ///< sides of one listed face
  std::size_t nonmanifold_edges = 0;  ///< sides of three or more listed faces
  std::size_t boundary_faces = 0;     ///< sides of one region
  std::size_t nonmanifold_faces = 0;  ///< sides of three or more regions
  std::size_t folded_faces = 0;       ///< sides of two regions that lie on one side of them
  std::size_t components = 0;  ///< sets of faces and regions connected through shared vertices
  std::int64_t euler = 0;      ///< used vertices - edges + faces - regions
  std::array<std::size_t, max_shapes> by_shape{};  ///< faces and regions, indexed by Shape
  std::array<std::size_t, 4>
      by_class{};  ///< entities of all kinds that lie on a model entity of dimension 0..3
};

/// Whether or not the mesh has edges and faces: they are counted from what they are sides of.
/// O(entities).
[[nodiscard]] Counts count_entities(const Mesh& mesh);

/// Smallest angles of the faces, each in degrees; a quad counts as its two triangles. Zero without
/// faces.
struct Quality {
  double min_angle_mean_deg = 0;  ///< mean over the faces of the smallest angle of each
  double min_angle_worst_deg = 0;
  double faces_below_10deg_pct = 0;  ///< faces with an angle below 10 degrees, percent
};

[[nodiscard]] Quality measure_quality(const Mesh& mesh);

}  // namespace aomd::measure

#pragma GCC visibility pop
