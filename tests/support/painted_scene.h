#pragma once
// Pictures that tests judge: a body with faces and edges on a background, drawn without a GPU, and
// what may happen to it.

#include "core/io/png.h"

namespace aomd::test {

/// What is drawn. The same values give the same picture.
struct PaintedScene {
  int width = 240;
  int height = 160;
  bool dark = false;
  int rows = 8;           ///< of faces, from pole to pole; twice as many go around
  double edge_px = 1.2;   ///< how wide edges are drawn
  double turned_deg = 0;  ///< about the vertical
  double shifted_px = 0;  ///< by how much a driver places things otherwise
  int moved_edge = -1;    ///< the edge that is drawn elsewhere; -1: none
  double moved_px = 0;    ///< and by how much, upward; 1000 and more: it is gone
  int selected_face = -1;
  bool axes = true;  ///< three lines in the lower left corner
  int brighter = 0;  ///< added to all channels of faces
};

[[nodiscard]] io::Image paint(const PaintedScene& scene);

}  // namespace aomd::test
