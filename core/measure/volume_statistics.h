#pragma once
// Counts and quality of the regions of a volume mesh.

#include <cstddef>
#include <vector>

#include "core/measure/histogram.h"
#include "core/measure/statistics.h"

namespace aomd::measure {

/// Faces between regions whether or not the mesh has them as entities: fills faces, boundary_faces,
/// nonmanifold_faces and folded_faces. O(sides log sides).
void count_volume_faces(const Mesh& mesh, Counts& counts);

/// Volume enclosed by a region's faces, in cubed units of length: negative where they look inward.
/// Quads count as the fan of triangles from their first vertex. O(1).
[[nodiscard]] double signed_volume(const Mesh& mesh, Region r);

/// Smallest angle between two faces of a region that share an edge, in degrees; 0 where no two of
/// them have any area. O(1).
[[nodiscard]] double smallest_dihedral_deg(const Mesh& mesh, Region r);

/// 6 sqrt(2) V / l^3 of a tetrahedron, where l is the root mean square of its six edges: 1 for the
/// regular one, 0 for a flat one, negative where its faces look inward (V. N. Parthasarathy,
/// C. M. Graichen, A. F. Hathaway, A comparison of tetrahedron quality measures, Finite Elements in
/// Analysis and Design 15, 1994). O(1).
[[nodiscard]] double tetrahedron_shape(const Mesh& mesh, Region r);

/// What a mesh has of one model region; those without a class are one, whose `model` is invalid.
struct RegionVolume {
  ModelRef model;
  std::size_t regions = 0;
  double volume = 0;
};

/// By ascending `model`. O(regions).
[[nodiscard]] std::vector<RegionVolume> region_volumes(const Mesh& mesh);

/// Smallest dihedral angles of the regions, each in degrees, whichever way its faces look.
struct VolumeQuality {
  std::vector<Sample> dihedrals;         ///< of each region, by ascending ids
  double min_dihedral_deg = 0;           ///< over all regions
  double p5_dihedral_deg = 0;            ///< a twentieth of the regions have a smaller one
  double mean_dihedral_deg = 0;          ///< mean over the regions of the smallest of each
  double regions_below_10deg_pct = 0;    ///< regions with an angle below 10 degrees, percent
  Region worst;                          ///< has the smallest of all; invalid without regions
  std::vector<Region> inverted;          ///< whose volume is zero or negative
  std::size_t tetrahedra = 0;            ///< what the next two are of
  double shape_min = 0, shape_mean = 0;  ///< tetrahedron_shape()
};

/// The same for any number of threads. O(regions).
[[nodiscard]] VolumeQuality measure_volume(const Mesh& mesh, int threads = 1);

}  // namespace aomd::measure
