#pragma once
// What stood where an operation was made, read back from its records.

#include <array>
#include <map>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"

namespace aomd::scene {

struct StepBefore {
  std::vector<std::array<Vertex, 3>> faces;  ///< that the step destroyed or changed, as they were
  std::map<Vertex, glm::dvec3> moved;        ///< where vertices were that it destroyed or moved

  [[nodiscard]] glm::dvec3 position(const Mesh& mesh, Vertex v) const {
    const auto found = moved.find(v);
    return found == moved.end() ? mesh.position(v) : found->second;
  }
};

/// Of the last step that is applied to a mesh of triangles, which must store T(0,2) and T(2,0).
/// O(its records).
[[nodiscard]] StepBefore step_before(const Mesh& mesh, const Journal& journal, std::size_t step);

}  // namespace aomd::scene
