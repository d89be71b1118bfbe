#pragma once
// Names what is dirty in a surface, without changing it.

#include <string>
#include <vector>

#include "core/repair/repair.h"

namespace aomd {

/// What a surface may be asked to be.
enum class SurfaceProperty {
  Closed,         ///< every edge has two faces or more
  Welded,         ///< no two edges of one face lie on each other, or nearly so
  Distinct,       ///< no two faces on the same vertices
  Oriented,       ///< faces at an edge look to the same side
  Manifold,       ///< at most two faces at an edge, and one fan at a vertex
  Nondegenerate,  ///< every face has area
  Used,           ///< every vertex has a face or a listed edge
  Embedded,       ///< no two faces cut each other
};
constexpr int surface_property_count = 8;

/// "closed": one word in small letters, for scripts.
[[nodiscard]] const char* property_name(SurfaceProperty property);

/// What mends a kind of dirt.
enum class Remedy { None, Repair, Weld, DropUnused };

/// One kind of dirt in a surface.
struct SurfaceFinding {
  RepairItem dirt;  ///< its name, a sentence, how much there is and the first few
  SurfaceProperty breaks = SurfaceProperty::Closed;
  Remedy remedy = Remedy::None;
  double tolerance = 0;  ///< of a weld: 0 where equal positions are enough
};

/// What is dirty in a surface, kind by kind: border edges, borders that lie on each other, gaps,
/// repeated, opposite and turned faces, pieces that cannot be oriented, non-manifold edges,
/// bow-ties (vertices that join several fans of faces), faces without area and isolated vertices.
/// Where a surface cuts itself is told by measure::count_self_intersections alone.
///
/// Non-manifold edges are those of the file. Orientation, bow-ties and borders that could be welded
/// are told of the surface without its repeated faces, which would hide them; the edges of
/// "borders" are those that would get a second face. The tolerance for gaps is the largest
/// distance from a border vertex to another of another face in the fullest part of its histogram:
/// up to the first quarter of a decade without any, and less than a tenth of the median border
/// edge.
///
/// Nothing where there are regions. Throws std::invalid_argument where arrays contradict each
/// other. O(n log n): 0.1 s for 200,000 faces.
[[nodiscard]] std::vector<SurfaceFinding> survey(const MeshData& data);

}  // namespace aomd
