#pragma once
// In which direction a face uses its edges (paper, figure 3).

#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// Beside each edge of a face an arrow in the edge's own direction: blue where the face uses it so,
/// red where it goes the other way. T(2,1) must be stored.
void draw_use_arrows(const Mesh& mesh, Face face, const glm::dvec3& origin, Overlay& overlay);

}  // namespace aomd::scene
