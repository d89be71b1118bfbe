#pragma once
// Places of two surfaces that correspond to each other, where arrays are compared.

#include <vector>

#include "core/fields/cells.h"
#include "core/fields/vertex_values.h"
#include "core/measure/field_comparison.h"

namespace aomd::measure {

/// The middle of every face of either surface, and every vertex. Both must outlive it.
class SurfacePlaces {
 public:
  SurfacePlaces(const MeshData& original, const MeshData& result, int threads);

  /// Adds up what two arrays on vertices, on faces or on the corners of faces differ by.
  void add_differences(const Attribute& before, const Attribute& after, bool on_corners,
                       DifferenceSums& sums) const;
  /// The same of directions: the angles between them, in degrees.
  void add_angles(const Attribute& before, const Attribute& after, bool on_corners,
                  DifferenceSums& sums) const;

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
  /// Calls use(values before, values after, area) at every place.
  template <typename Use>
  void for_values(const Attribute& before, const Attribute& after, bool on_corners,
                  Use&& use) const;
  static void fill(const Attribute& array, bool on_corners, const fields::Cells& cells,
                   const Spot& spot, std::vector<double>& values);

  fields::Cells before_, after_;
  std::vector<Place> middles_, vertices_;
};

}  // namespace aomd::measure
