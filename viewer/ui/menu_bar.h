#pragma once
// The menus: names for commands.

#include <string>

#include "viewer/ui/frame.h"
#include "viewer/ui/recent_files.h"

namespace aomd::ui {

/// The menu that a command has opened.
struct MenuBarState {
  std::string shown;
};

/// Inside a window with a menu bar. Opens the menu that the view asks for.
void menu_bar(Frame& frame, const RecentFiles& recent, MenuBarState& state);

}  // namespace aomd::ui
