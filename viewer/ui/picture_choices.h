#pragma once
// What a picture is to have, besides a name: the lower part of the dialog that saves one.

#include <string>

#include "viewer/ui/frame.h"

namespace aomd::ui {

struct PictureChoices {
  static constexpr int rows = 2;  ///< of controls

  std::size_t size = 0;  ///< in the list: as the window, some usual ones, one's own
  std::string own_size = "2400x1600";
  bool panels = true;
  bool transparent = false;
  double scale = 1;
};

void picture_choices(Frame& frame, PictureChoices& choices);
/// As the command screenshot has it behind the name: " 1920x1080 no-ui scale 2".
[[nodiscard]] std::string picture_words(const PictureChoices& choices);
/// What is wrong with the size that was typed; empty where nothing is.
[[nodiscard]] std::string picture_problem(const PictureChoices& choices);

}  // namespace aomd::ui
