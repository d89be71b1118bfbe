#pragma once
// How a document is looked at: nothing here changes a mesh.

#include <optional>
#include <set>
#include <string>

#include "core/mesh/model_ref.h"
#include "viewer/scene/camera.h"

namespace aomd::scene {

/// Spacing: the wanted length of edges; Verdict: why each edge would be refused now. Both on surfaces that
/// can be decimated.
enum class Coloring { Classification, Spacing, Verdict, None };
/// What a click takes: Automatic is the vertex or edge that is near, else the face, else the region.
enum class PickLevel { Automatic, Vertex, Edge, Face, Region };
enum class Theme { Light, Dark };
enum class Dialog { None, Open, Save, Screenshot, Shortcuts, About };

/// What the panel on the right shows: one of them at a time, side by side there is no room.
enum class Page { Decimation, Adjacency, Selection };

struct Panels {
  bool mesh = true;
  bool side = true;  ///< the one on the right
  bool timeline = true;
  Page page = Page::Decimation;
  friend bool operator==(const Panels&, const Panels&) = default;
};

struct View {
  Camera camera;
  double aspect = 1.5;     ///< width by height of the picture; whoever draws keeps it true
  double height_px = 600;  ///< of the picture, logical pixels; likewise
  Coloring coloring = Coloring::Classification;
  bool surface = true;
  bool edges = true;
  bool model_edges = true;
  bool model_vertices = true;
  bool interfaces = true;  ///< faces between two model regions, seen where something is hidden
  bool operation = true;   ///< what the last single step touched
  std::set<ModelRef> hidden;
  std::optional<ModelRef> highlighted;
  PickLevel pick_level = PickLevel::Automatic;
  bool preview = true;          ///< what collapsing the selected edge, or smoothing the vertex, would lead to
  std::size_t preview_way = 0;  ///< 0: the best way, else the one of this number
  bool labels = false;          ///< ids at what is selected and around the cursor
  Theme theme = Theme::Light;
  Panels panels;
  Dialog dialog = Dialog::None;
};

}  // namespace aomd::scene
