#pragma once
// What a right click into the picture offers for what is selected there.

#include <optional>

#include <glm/vec2.hpp>

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// Where the menu is open at present.
struct PictureMenuState {
  std::optional<glm::dvec2> shown;
};

/// Shows the menu that the view asks for, over the picture of the present mesh. A click elsewhere,
/// Escape and what is chosen close it.
void picture_menu(Frame& frame, const Area& picture, PictureMenuState& state);

}  // namespace aomd::ui
