#pragma once
// What must be stored of a mesh that is drawn.

#include <array>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// T(2,0), T(0,1) and T(0,2), which drawing and counting need; decimation needs the same.
using DrawingNeeds = std::array<Request, 3>;

[[nodiscard]] inline DrawingNeeds request_for_drawing(Mesh& mesh) {
  return {mesh.request(2, 0, "drawing"), mesh.request(0, 1, "drawing"),
          mesh.request(0, 2, "drawing")};
}

/// T(0,1), T(0,2) and T(0,3) of what is there: what following the changes of a volume takes.
[[nodiscard]] inline DrawingNeeds request_for_patches(Mesh& mesh) {
  return {mesh.request_listed(0, 1, "drawing"), mesh.request_listed(0, 2, "drawing"),
          mesh.request_listed(0, 3, "drawing")};
}

}  // namespace aomd::scene
