#pragma once
// The borders of the side panels: dragging one makes the panel wider or narrower.

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// Emits `panel-width` while a border is dragged, and the usual width on a double click.
void draw_splitters(Frame& frame, const Layout& layout);

}  // namespace aomd::ui
