#pragma once
// The arrays of a mesh go along with operations on it: what they come to is a function of the mesh
// before and the mesh after, whatever led from one to the other (docs/ATTRIBUTES.md).

#include <span>
#include <string>
#include <vector>

#include "core/fields/field.h"

namespace aomd::fields {

/// An array of a result, and what it was in the original.
struct CarriedField {
  std::string name;
  int dimension = 0, components = 1;
  FieldKind kind = FieldKind::Interpolated;
  FieldFacts before, after;
};

/// True where values can be carried along: both meshes are volumes, or both are surfaces.
[[nodiscard]] bool can_carry(const MeshData& original, const MeshData& result);

/// Appends to the attributes of `result`, made from `original` by operations, these arrays of the
/// original: on vertices by interpolation (at_vertices), on cells by what they cover (at_cells). An
/// array on entities of which one of the meshes has none is not carried. The same for any number of
/// threads. O(n log n); nothing is allocated where there are no arrays.
std::vector<CarriedField> carry(std::span<const Attribute* const> arrays, const MeshData& original,
                                MeshData& result, int threads);

/// The same list where nothing has moved.
[[nodiscard]] std::vector<CarriedField> unmoved(std::span<const Attribute* const> arrays,
                                                const MeshData& mesh);

}  // namespace aomd::fields
