#pragma once
// How a document is looked at: nothing here changes a mesh.

#include <optional>
#include <set>
#include <string>

#include "core/mesh/model_ref.h"
#include "viewer/scene/camera.h"

namespace aomd::scene {

enum class Coloring { Classification, None };
enum class Theme { Light, Dark };
enum class Dialog { None, Open, Save, Screenshot, Shortcuts, About };

struct Panels {
  bool mesh = true;
  bool decimation = true;
  bool timeline = true;
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
  bool operation = true;  ///< what the last single step touched
  std::set<ModelRef> hidden;
  std::optional<ModelRef> highlighted;
  Theme theme = Theme::Light;
  Panels panels;
  Dialog dialog = Dialog::None;
};

}  // namespace aomd::scene
