#pragma once
// What arrays of a mesh differ by from those of its original, at the same places.

#include <cstddef>
#include <string>
#include <vector>

#include "core/fields/field.h"
#include "core/mesh/mesh_data.h"

namespace aomd::measure {

/// An array that both meshes have: one name, on vertices, on cells (of surfaces faces, of volumes
/// regions) or on the corners of faces, as many components.
struct FieldDifference {
  std::string name;
  int dimension = 0, components = 1;
  bool corners = false;         ///< on those of faces
  bool label = false;           ///< whole numbers in both
  bool directions = false;      ///< normals in both: angles are told too
  double range = 0;             ///< of the original: the largest over its components
  double rms = 0, largest = 0;  ///< lengths of the difference; 0 for labels
  double differing = 0;         ///< the share of the volume or area where they are not the same
  double rms_deg = 0, largest_deg = 0;  ///< of directions: the angle between them
  std::size_t missing = 0;              ///< places where one has no number
  fields::FieldFacts before, after;

  /// In percent of the range; infinite where that is 0 and the difference is not.
  [[nodiscard]] double percent(double difference) const {
    return difference > 0 ? 100 * difference / range : 0;
  }
};

/// Adds up what an array differs by over a mesh.
class DifferenceSums {
 public:
  /// At a place that stands for so much volume or area; 0 counts for the largest difference alone.
  void add(double squares, double weight);
  void write(FieldDifference& difference) const;

 private:
  fields::Sum squares_, differing_, whole_;
  double largest_ = 0;
  std::size_t missing_ = 0;
};

/// Arrays of volumes are compared in the middle of every tetrahedron of either mesh, weighted by
/// its volume, and those on vertices at all vertices too, which count for the largest difference
/// alone. Other regions are cut into tetrahedra. Those of surfaces are compared in the middle of
/// every face of either mesh and at the vertices (on corners not there), with the nearest place of
/// the other on the same side. The same for any number of threads. O(n log n).
[[nodiscard]] std::vector<FieldDifference> compare_fields(const MeshData& original,
                                                          const MeshData& result, int threads = 1);

}  // namespace aomd::measure
