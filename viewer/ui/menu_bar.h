#pragma once
// The menus: names for commands.

#include "viewer/ui/frame.h"
#include "viewer/ui/recent_files.h"

namespace aomd::ui {

/// Inside a window with a menu bar.
void menu_bar(Frame& frame, const RecentFiles& recent);

}  // namespace aomd::ui
