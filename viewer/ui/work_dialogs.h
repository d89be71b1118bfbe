#pragma once
// The dialogs about work that could be lost, and about pictures that are being exported.

#include "viewer/ui/frame.h"

namespace aomd::ui {

/// Save, discard or cancel, before a line that would lose unsaved work.
void unsaved_dialog(Frame& frame);
/// The work that dead programs have left: restore or discard each.
void recovery_dialog(Frame& frame);
/// How far an export is, and a button that stops it. Stands over everything while there is one.
void draw_series_progress(Frame& frame);

}  // namespace aomd::ui
