#pragma once
// The list of lessons.

#include "viewer/ui/frame.h"

namespace aomd::ui {

/// What each is about, how long it takes, and which have been done.
void lessons_dialog(Frame& frame);

}  // namespace aomd::ui
