#pragma once
// A floor below the mesh: a grid, and a soft shadow as of a high sky.

#include "viewer/base/up_axis.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// Where it lies, in world coordinates along the up axis.
[[nodiscard]] double ground_height(const Box& bounds, UpAxis up);
/// Fills `ground` for the surface of `drawable`, and says in which box it lies. Squares are 1, 2 or
/// 5 times a power of ten wide, about an eighth of the mesh. O(corners), but as if there were no
/// more than many thousands.
[[nodiscard]] Box draw_ground(const Drawable& drawable, UpAxis up, Overlay& ground);

}  // namespace aomd::scene
