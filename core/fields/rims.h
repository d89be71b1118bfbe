#pragma once
// The curves on which a surface ends or does not go on smoothly.

#include <array>
#include <cstdint>
#include <vector>

#include "core/fields/cells.h"

namespace aomd::fields {

/// A side of a face that lies on a rim.
struct RimSide {
  std::array<std::uint32_t, 2> ends{};
  std::uint32_t face = 0;
};

/// The sides of faces along edges of other than two faces, and along listed edges on model edges,
/// in ascending order of their vertices, then of their faces. Expected O(n).
[[nodiscard]] std::vector<RimSide> rims_of(const Cells& faces);

}  // namespace aomd::fields
