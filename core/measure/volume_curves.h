#pragma once
// Where the surfaces of a volume mesh meet: its model edges and model vertices, as the skin shows
// them.

#include <array>
#include <vector>

#include "core/measure/volume_complex.h"

namespace aomd::measure {

/// Which of a mesh's own words count beside what the regions tell; two meshes can be compared by
/// what both have.
struct CurveOptions {
  bool faces = true;  ///< model faces on which faces are listed
  bool edges = true;  ///< edges listed on model edges
};

struct VolumeCurves {
  std::vector<std::array<Vertex, 2>> edges;  ///< ascending, each once
  std::vector<Vertex> ends;                  ///< model vertices, ascending
};

/// An edge of the skin lies on a curve unless exactly two faces of one interface share it, or where
/// it is listed on a model edge. A model vertex is where other than two of those edges meet, or
/// what is classified so; vertices that no region uses are none. O(skin log skin).
[[nodiscard]] VolumeCurves curves_of(const Mesh& mesh, const VolumeComplex& complex,
                                     const CurveOptions& options = {});

}  // namespace aomd::measure
