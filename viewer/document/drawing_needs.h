#pragma once
// What must be stored of a surface that is drawn.

#include <array>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// T(2,0), T(0,1) and T(0,2), which drawing and counting need; decimation needs the same.
using DrawingNeeds = std::array<Request, 3>;

[[nodiscard]] inline DrawingNeeds request_for_drawing(Mesh& mesh) {
  return {mesh.request(2, 0, "drawing"), mesh.request(0, 1, "drawing"),
          mesh.request(0, 2, "drawing")};
}

}  // namespace aomd::scene
