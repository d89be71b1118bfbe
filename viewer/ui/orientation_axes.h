#pragma once
// Where x, y and z point, in a corner of the picture.

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// The six ends of the axes, the nearest in front; a click looks from there. Draws nothing where
/// the view says so, without a mesh, or where the picture is too small.
void orientation_axes(Frame& frame, const Area& viewport);

}  // namespace aomd::ui
