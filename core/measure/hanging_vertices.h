#pragma once
// Where parts of a mesh touch without being joined.

#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::measure {

/// Where the sides of a volume are looked for.
enum class Skin {
  Derived,  ///< sides of one region
  Listed,   ///< faces on model faces, as classify() makes them: much cheaper
};

/// The vertices of the boundary that lie on a side of it, within a millionth of the side's
/// diameter, which they are no corner of: hanging nodes where a finer part meets a coarser one, and
/// bodies that touch. Of a volume vertices at one place count. Of a surface the vertices are those
/// on borders, the sides all faces; vertices at one place are left to welding. By ascending ids,
/// the same for any number of threads. O(n log n) of the boundary.
[[nodiscard]] std::vector<Vertex> hanging_vertices(const Mesh& mesh, int threads = 1,
                                                   Skin skin = Skin::Derived);

}  // namespace aomd::measure
