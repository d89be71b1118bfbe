#pragma once
// How much of the sky each vertex of a surface sees: what makes folds and cavities darker.

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// A copy of what it depends on, so that it can be worked out in a thread of its own.
struct OpennessSource {
  std::vector<glm::vec3> positions;  ///< by vertex id
  std::vector<glm::vec3> normals;    ///< likewise; zero: no vertex, or without faces
  std::vector<float> lengths;        ///< of the edges around it, on average
  std::vector<Corner> occluders;     ///< face slots
  std::vector<std::array<std::uint32_t, 3>> faces = {};  ///< by vertex ids
};
/// Of a drawing of `mesh`, whose corners are relative to `origin`. O(size).
[[nodiscard]] OpennessSource openness_source(const Mesh& mesh, std::span<const Corner> corners,
                                             const glm::dvec3& origin);

/// By vertex id: 255 sees all, 0 nothing. The surface is looked at from many sides, with its depth
/// in a picture as wide as itself: a vertex sees those sides that see it. Where edges are longer
/// than 6 % of the whole there is less of it, for between vertices nothing is known. Folds that are
/// too small for these pictures are darker by their hollows(). Empty where it was stopped.
[[nodiscard]] std::vector<std::uint8_t> openness(const OpennessSource& source,
                                                 const std::stop_token& stop);

}  // namespace aomd::scene
