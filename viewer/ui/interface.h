#pragma once
// All of the interface: one call a frame.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/ui/dialogs.h"
#include "viewer/ui/layout.h"
#include "viewer/ui/menu_bar.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/picture_menu.h"
#include "viewer/ui/recent_files.h"
#include "viewer/ui/theme.h"

namespace aomd::ui {

/// Between ImGui::NewFrame and ImGui::Render. Reads the session, emits lines, and never changes
/// anything else.
class Interface {
 public:
  RecentFiles recent;
  bool bars = true;         ///< false for --no-ui: nothing is drawn
  bool interactive = true;  ///< false without a window

  /// Draws everything; what is left for the scene is layout().viewport.
  [[nodiscard]] std::vector<std::string> draw(const scene::Session& session, const Fonts& fonts);
  /// Of a picture without anything else: what tells sizes and colours.
  void draw_scales(const scene::Session& session, const Fonts& fonts);
  /// The line that a chord means now; empty where it means nothing or goes into a field.
  [[nodiscard]] static std::string line_for_chord(const scene::Session& session,
                                                  std::string_view chord);
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// What the palette has run, newest first: kept between sessions.
  [[nodiscard]] std::vector<std::string>& recent_commands() { return dialogs_.palette.recent; }
  void remember_folder(const std::filesystem::path& folder) { dialogs_.meshes.set_folder(folder); }

 private:
  void scales(const Frame& frame) const;
  void draw_panels(Frame& frame);
  void handle_mouse(Frame& frame);
  void handle_click(Frame& frame);
  void handle_right_click(Frame& frame);
  void handle_hover(Frame& frame);
  /// Where the mouse is on the picture of the present mesh, from -1 to 1.
  [[nodiscard]] std::string place_words(ImVec2 mouse) const;

  Layout layout_;
  Area present_;  ///< the picture of the present mesh, in the layout's viewport
  DialogState dialogs_;
  DecimationDrafts drafts_;
  HistogramDrafts histogram_drafts_;
  bool dragging_ = false;  ///< a drag that began on the scene
  bool moved_ = false;     ///< and has left the place where it began: no click
  bool again_ =
      false;  ///< the second press of a double click: it has moved the picture below the mouse
  bool boxing_ = false;  ///< a drag with Ctrl
  ImVec2 began_;
  bool right_still_ = false;  ///< the right button is down on the picture, where it was pressed
  ImVec2 right_began_;
  PictureMenuState picture_menu_;
  MenuBarState menu_bar_;
  ImVec2 hovered_at_{-1, -1};
  scene::Camera hovered_from_;       ///< what lies under the mouse there also depends on these
  std::uint64_t hovered_after_ = 0;  ///< commands
};

[[nodiscard]] inline ThemeKind theme_kind(scene::Theme theme) {
  return theme == scene::Theme::Dark ? ThemeKind::Dark : ThemeKind::Light;
}

}  // namespace aomd::ui
