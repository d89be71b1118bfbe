#pragma once
// How a document is looked at: nothing here changes a mesh.

#include <array>
#include <optional>
#include <set>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/mesh/model_ref.h"
#include "viewer/base/box.h"
#include "viewer/drawing/camera.h"
#include "viewer/drawing/palette.h"
#include "viewer/drawing/play_speed.h"

namespace aomd::scene {

/// What a click takes: Automatic is the vertex or edge that is near, else the face, else the
/// region.
enum class PickLevel { Automatic, Vertex, Edge, Face, Region };
/// What is drawn of what an operation on the selected edge would lead to: a collapse to the end
/// that is better off, or to either, or the swap.
enum class PreviewedWay { Best, First, Second, Swap };
/// What the surface's colours mean. From Spacing to Curvature they are numbers: see scalar_field.h.
/// Verdict: why each edge would be refused now. Texture: the pictures and colours of the file's
/// materials.
enum class Coloring {
  Classification,
  Spacing,
  Quality,
  Distance,
  Curvature,
  Verdict,
  Texture,
  None
};
[[nodiscard]] constexpr bool is_field(Coloring coloring) {
  return coloring >= Coloring::Spacing && coloring <= Coloring::Curvature;
}
inline constexpr std::size_t field_count = 4;

/// What somebody wants of a scale of colours instead of what suits its numbers.
struct ScaleChoice {
  enum class Range { Automatic, Fixed, Percentile };
  Range range = Range::Automatic;
  double low = 0, high = 1;  ///< of a fixed range
  double percentile = 98;  ///< so many percent of the values lie below the end, and above the start
  int steps = 0;           ///< colours; 0: without a step
  std::optional<ColorMap> map;
  std::optional<bool> logarithmic;
  friend bool operator==(const ScaleChoice&, const ScaleChoice&) = default;
};

enum class HistogramKind { Angle, Length, Valence };
enum class Theme { Light, Dark };

/// How much larger text and controls may be made than they are at first.
inline constexpr double least_text_scale = 0.5, largest_text_scale = 3;
/// How much larger everything is while somebody presents.
inline constexpr double presentation_scale = 1.4;
enum class Dialog {
  None,
  Open,
  Save,
  Screenshot,
  Shortcuts,
  About,
  Palette,
  Unsaved,
  Recovery,
  Lessons
};

/// What the panel on the right shows: one of them at a time, side by side there is no room.
enum class Page { Decimation, Adjacency, Histograms, Selection };

/// How many faces are drawn of a surface that has very many. Automatic: all of them, but fewer
/// while the camera moves and drawing all takes long.
enum class Detail { Automatic, Full, Coarse };

/// Which sides of the last single step are pointed at.
struct StepSides {
  bool before = true;
  bool after = true;
  friend bool operator==(const StepSides&, const StepSides&) = default;
};

struct Panels {
  bool mesh = true;
  bool side = true;  ///< the one on the right
  bool timeline = true;
  bool runs = false;  ///< the table of kept states, below the picture
  bool menus = true;  ///< the menu bar, and the line at the bottom
  Page page = Page::Decimation;
  float mesh_ems = 0;  ///< widths in units of the font's size; 0: the usual ones
  float side_ems = 0;
  friend bool operator==(const Panels&, const Panels&) = default;
};

/// Surfaces are cut so far inside of the plane, in parts of the box's diagonal, and sections lie
/// twice as far: a face that lies in the plane is gone, and a section is not cut by its own plane.
inline constexpr double clip_hair = 1e-5;

/// A plane across an axis, behind which nothing is shown.
struct Clip {
  int axis = 0;           ///< 0..2
  double position = 0.5;  ///< 0..1 through the box of the mesh as loaded
  bool cells = false;     ///< whole faces and regions, by their centres; else cut through, volumes
                          ///< with a section
  bool flip = false;      ///< shows what lies beyond instead of what lies before

  /// Keeps points p with dot(xyz, p) + w >= 0. Moved by `inward` parts of the box's diagonal into
  /// what is kept.
  [[nodiscard]] glm::dvec4 plane(const Box& box, double inward = 0) const {
    glm::dvec4 result(0);
    const double sign = flip ? 1 : -1;
    result[axis] = sign;
    result.w = -sign * (box.low[axis] + position * (box.high[axis] - box.low[axis])) -
               inward * box.diagonal();
    return result;
  }
  friend bool operator==(const Clip&, const Clip&) = default;
};

/// A bar of a histogram that is pointed at: the entities whose value lies in it are bright.
struct MarkedBar {
  HistogramKind kind = HistogramKind::Angle;
  double value = 0;  ///< in the bar
  friend bool operator==(const MarkedBar&, const MarkedBar&) = default;
};

/// Which sections of the page on T(I,J) are open.
struct TensorSections {
  bool hash_sets = false, ids = false, strategies = false;
};

/// What of a view belongs to the mesh that is shown: another mesh begins without any of it.
struct MeshView {
  std::optional<Clip> clip;
  double shrink = 0;  ///< how far faces and regions are pulled towards their centres, 0..0.9
  std::set<ModelRef> hidden;
  std::optional<ModelRef> highlighted;
  std::optional<MarkedBar> marked;
  std::optional<glm::dvec2>
      menu;  ///< where a menu for what is selected is open in the picture, -1..1
};

struct View : MeshView {
  Camera camera;
  double aspect = 1.5;     ///< width by height of the picture; whoever draws keeps it true
  double height_px = 600;  ///< of the picture, logical pixels; likewise
  Coloring coloring = Coloring::Classification;
  std::array<ScaleChoice, field_count> scales;  ///< see scale_choice()
  bool scale = true;                            ///< the scale of the colours, in the picture
  bool length_scale = true;  ///< how long things are, in the picture without perspective
  bool surface = true;
  bool light = true;         ///< shades colours, so that shape shows
  bool hidden_lines = true;  ///< without the surface: also edges that it would hide
  bool edges = true;
  bool model_edges = true;
  bool model_vertices = true;
  bool interfaces = true;  ///< faces between two model regions, seen where something is hidden
  bool axes = true;        ///< where x, y and z point, in a corner
  bool occlusion = false;  ///< folds and cavities are darker
  bool ground = false;     ///< a grid below the mesh, with its shadow
  Detail detail = Detail::Automatic;
  /// Where the light was fixed over the shoulder of this camera; none: it follows the camera.
  std::optional<Camera> light_from;
  bool operation = true;  ///< what the last single step touched
  StepSides step_sides;
  PlaySpeed play_speed;
  bool original = false;        ///< the reference as glass over the present mesh
  bool side_by_side = false;    ///< the reference on the left, the present mesh on the right
  bool interior_edges = false;  ///< of a volume, through a surface of glass
  PickLevel pick_level = PickLevel::Automatic;
  bool preview = true;  ///< what an operation on the selected edge or vertex would lead to, or a
                        ///< collapse of the edge that the mouse points at
  PreviewedWay previewed = PreviewedWay::Best;
  bool labels = false;             ///< ids at what is selected and around the cursor
  bool labels_everywhere = false;  ///< also at all else, as far as there is room
  std::optional<int> neighbours;   ///< the level whose entities around the selected one light up
  TensorSections sections;
  std::string bar_menu;  ///< which menu of the menu bar is open: "File"; empty: none by a command
  Theme theme = Theme::Light;
  double text_scale = 1;  ///< of text and controls, beside that of the screen
  Panels panels;
  std::optional<Panels> presenting;  ///< large text, no menus: the panels from before
  Dialog dialog = Dialog::None;
  std::string palette_text;  ///< what stands in the palette when it opens

  /// That of what the colours mean; null where they are no numbers.
  [[nodiscard]] const ScaleChoice* scale_choice() const {
    return is_field(coloring) ? &scales[static_cast<std::size_t>(coloring) - 1] : nullptr;
  }
};

}  // namespace aomd::scene
