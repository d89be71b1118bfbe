#pragma once
// Counts and quality of the regions of a volume mesh.

#include <vector>

#include "core/measure/statistics.h"

namespace aomd::measure {

/// Faces between regions whether or not the mesh has them as entities: fills faces, boundary_faces,
/// nonmanifold_faces and regions. O(sides log sides).
void count_volume_faces(const Mesh& mesh, Counts& counts);

/// Volume enclosed by a region's faces, in cubed units of length: negative where they look inward.
/// Quads count as the fan of triangles from their first vertex. O(1).
[[nodiscard]] double signed_volume(const Mesh& mesh, Region r);

/// Smallest angle between two faces of a region that share an edge, in degrees. O(1).
[[nodiscard]] double smallest_dihedral_deg(const Mesh& mesh, Region r);

struct VolumeQuality {
  double min_dihedral_deg = 0;   ///< over all regions
  Region worst;                  ///< that has it; invalid without regions
  std::vector<Region> inverted;  ///< whose volume is zero or negative
};

/// O(regions).
[[nodiscard]] VolumeQuality measure_volume(const Mesh& mesh);

}  // namespace aomd::measure
