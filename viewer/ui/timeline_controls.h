#pragma once
// What belongs to the timeline besides the strip of operations: how fast it plays, and where else
// one can go.

#include <string>

#include "viewer/ui/frame.h"

namespace aomd::ui {

/// Bookmarks, branches and the speed of playing, at the right end of the present line.
void timeline_controls(Frame& frame);

/// Flags at bookmarks above the strip, and below it a line for each branch that leaves the present
/// one there.
void draw_places(const Frame& frame, ImVec2 from, ImVec2 to);
/// What the mouse points at of them; empty: nothing.
[[nodiscard]] std::string place_tooltip(const Frame& frame, ImVec2 from, ImVec2 to);

}  // namespace aomd::ui
