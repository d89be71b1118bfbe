#pragma once
// Words on the picture: what the mouse points at, and ids.

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// Draws over the scene, below the panels. At most a few dozen labels.
void scene_labels(Frame& frame, const Area& viewport);

/// How long what is measured is, at the middle of each line: also in a picture that is no window's.
void ruler_labels(const Frame& frame, const Area& viewport);

/// The box that is being dragged, in ImGui's coordinates.
void selection_box(const Frame& frame, ImVec2 from, ImVec2 to);

}  // namespace aomd::ui
