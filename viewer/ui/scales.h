#pragma once
// What tells sizes and colours in a picture.

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// The scale of the colours at the right edge, with title, unit and numbers; nothing where colours
/// are no numbers, or there is no room. Over the scene, below the panels.
void color_scale(const Frame& frame, const Area& picture);

/// A bar of a round length in the middle of the lower edge: without perspective, where it holds at
/// every depth.
void length_scale(const Frame& frame, const Area& picture);
/// Where it stands, in the font of the picture; empty where there is none.
[[nodiscard]] Area length_scale_area(const Frame& frame, const Area& picture);

}  // namespace aomd::ui
