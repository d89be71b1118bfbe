#pragma once
// What a coarser mesh still knows of the surface that it stands for.

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/handle.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A point of a surface, and where a mesh that stands for it is nearest.
struct OriginalSample {
  glm::dvec3 position{0.0};
  glm::vec3 normal{0.0f};  ///< of the surface there, of length 1, or 0
  float weight = 0;        ///< the area it stands for
  Face face;               ///< of the mesh, as far as is known
};
using OriginalSamples = std::vector<OriginalSample>;

}  // namespace aomd

#pragma GCC visibility pop
