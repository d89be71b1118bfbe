#pragma once
// A surface with few triangles that looks like one with many: what is drawn while the camera moves.

#include <cstddef>
#include <span>
#include <vector>

#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// Of face slots as Drawable::corners has them. The surface is laid over a grid whose cells are so
/// large that about `wanted_faces` are left: what lies in a cell becomes one point, and a face
/// stays where its corners lie in three. No edges are drawn on it. Where the two sides of something
/// thin fall together, or it folds over, it has no back. O(corners), about as long as drawing them
/// takes.
[[nodiscard]] std::vector<Corner> coarse_corners(std::span<const Corner> corners,
                                                 std::size_t wanted_faces);

}  // namespace aomd::scene
