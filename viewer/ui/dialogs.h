#pragma once
// The dialogs and messages that stand over everything else.

#include "viewer/ui/command_palette.h"
#include "viewer/ui/file_browser.h"
#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"
#include "viewer/ui/picture_choices.h"

namespace aomd::ui {

/// What the dialogs remember from frame to frame.
struct DialogState {
  FileBrowser meshes;
  FileBrowser pictures;
  PictureChoices picture;
  CommandPalette palette;
  scene::Dialog shown = scene::Dialog::None;  ///< in the last frame
};

/// The dialog that the session asks for, if any.
void draw_dialogs(Frame& frame, DialogState& state);

/// Loading and errors, at the top of the viewport.
void draw_messages(Frame& frame, const Area& viewport);

}  // namespace aomd::ui
