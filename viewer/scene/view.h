#pragma once
// How a document is looked at: nothing here changes a mesh.

#include <optional>
#include <set>
#include <string>

#include "core/mesh/model_ref.h"
#include "viewer/scene/camera.h"

namespace aomd::scene {

/// Spacing: the wanted length of edges, on surfaces that can be decimated.
enum class Coloring { Classification, Spacing, None };
enum class Theme { Light, Dark };
enum class Dialog { None, Open, Save, Screenshot, Shortcuts, About, Palette, Unsaved, Recovery };

/// What the panel on the right shows: one of them at a time, side by side there is no room.
enum class Page { Decimation, Adjacency };

struct Panels {
  bool mesh = true;
  bool side = true;  ///< the one on the right
  bool timeline = true;
  Page page = Page::Decimation;
  float mesh_ems = 0;  ///< widths in units of the font's size; 0: the usual ones
  float side_ems = 0;
  friend bool operator==(const Panels&, const Panels&) = default;
};

struct View {
  Camera camera;
  double aspect = 1.5;  ///< width by height of the picture; whoever draws keeps it true
  Coloring coloring = Coloring::Classification;
  bool surface = true;
  bool edges = true;
  bool model_edges = true;
  bool model_vertices = true;
  bool interfaces = true;  ///< faces between two model regions, seen where something is hidden
  bool operation = true;   ///< what the last single step touched
  std::set<ModelRef> hidden;
  std::optional<ModelRef> highlighted;
  Theme theme = Theme::Light;
  Panels panels;
  Dialog dialog = Dialog::None;
  std::string palette_text;  ///< what stands in the palette when it opens
};

}  // namespace aomd::scene
