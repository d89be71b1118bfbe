#pragma once
// Values of the edges, faces and regions of a result, from those of its original.

#include <span>
#include <vector>

#include "core/fields/cell_parts.h"

namespace aomd::fields {

/// The entities of one dimension in both meshes, as far as values are concerned.
struct CellPairing {
  const Cells& original;
  const Cells& result;
  std::span<const std::uint32_t> same;  ///< for each of the result the one of the original, if any
  const CellParts& parts;               ///< of those that are not the same
};

/// Arrays of the original's cells on those of the result. Cells that are the same keep their value.
/// Of whole numbers the others get that of the largest part they cover, of real ones the mean of
/// what they cover; then on each class all of these are scaled by one number, so that the integral
/// over the class is what it was, to rounding. What is one number on all of a class stays that
/// number, and where numbers are missing on a class its integral is not kept. Cells that cover what
/// has no number to more than a half get none.
[[nodiscard]] std::vector<Attribute> at_cells(std::span<const Attribute* const> arrays,
                                              const CellPairing& cells, int threads);

}  // namespace aomd::fields
