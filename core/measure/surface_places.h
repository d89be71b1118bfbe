#pragma once
// Places of two surfaces that correspond to each other, where arrays are compared.

#include <vector>

#include "core/fields/vertex_values.h"
#include "core/measure/field_comparison.h"

namespace aomd::measure {

/// The middle of every face of either surface, and every vertex.
class SurfacePlaces {
 public:
  SurfacePlaces(const MeshData& original, const MeshData& result, int threads);

  /// Adds up what two arrays on vertices, or on faces, differ by.
  void add_differences(const Attribute& before, const Attribute& after, DifferenceSums& sums) const;

 private:
  /// A place on one of the surfaces.
  struct Spot {
    std::uint32_t face = no_index;
    fields::VertexSource corners;
  };
  struct Place {
    Spot before, after;
    double area = 0;
  };
  /// Adds those of the faces and vertices of `own` that the other one has a place for.
  void add(const MeshData& own, const MeshData& other, bool own_is_original, int threads);
  static double value(const Attribute& array, const Spot& spot, std::size_t component);

  std::vector<Place> middles_, vertices_;
};

}  // namespace aomd::measure
