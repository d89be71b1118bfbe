#pragma once
// The panels. Each draws the content of a window that the caller has begun.

#include <string>

#include "viewer/ui/frame.h"
#include "viewer/ui/layout.h"

namespace aomd::ui {

/// What the memory of entities is, wherever it is shown.
inline constexpr const char* entity_memory_help =
    "Entities, coordinates and classification. Ids of deleted entities and their places are kept, "
    "for undo "
    "and for what is made next: so it does not shrink while faces go, and the stacks of free ids "
    "grow. Id "
    "stacks, on the page T(I,J), count the alive and the free ones.";

/// File, counts and their change since loading, memory.
void mesh_panel(Frame& frame);
/// The titles of the mesh's panel and the lesson's while a lesson is open. True where the lesson's
/// is up.
[[nodiscard]] bool lesson_titles(Frame& frame);
/// The page of the lesson that is open: text, task, and the way on.
void lesson_panel(Frame& frame);
/// Model entities by dimension: rows toggle and highlight. Scrolls in what is left of the window.
void legend_panel(Frame& frame);

/// What a panel remembers while a value is being typed or dragged and not to be emitted yet.
struct DecimationDrafts {
  double feature_angle_deg = 20;
  bool editing_feature_angle = false;
  std::string spacing;         ///< as typed
  std::string spacing_source;  ///< the present one when that began
};
/// What decimation is told; a strategy shows the options that it has.
void decimation_options(Frame& frame, DecimationDrafts& drafts);
/// In the accent colour where some limit is set: opens what holds in each operation besides the
/// angle, with what it costs.
void limits_button(Frame& frame);
[[nodiscard]] float limits_button_width();
/// Options, operations, progress and refusals.
void decimation_panel(Frame& frame, DecimationDrafts& drafts);

/// T(I,J): what is stored, for whom, at what cost; cells store and free relations.
void adjacency_panel(Frame& frame);
/// Its sections below the table, each open or closed: hash sets, id stacks, and what strategies
/// cost.
void tensor_sections(Frame& frame);
/// The two ways to store adjacencies during decimation, measured.
void strategy_section(Frame& frame);
/// What is selected: what it is, what is adjacent to it, why it stays.
void inspector_panel(Frame& frame);
/// The titles of the pages, and the one that is up.

/// What histograms remember: a bar that is pointed at is bright until the mouse leaves it.
struct HistogramDrafts {
  bool pointing = false;
};
/// Angles, lengths and valences as loaded and now.
void histogram_panel(Frame& frame, HistogramDrafts& drafts);
/// The titles of the pages, and the one that is up.
void side_panel(Frame& frame, DecimationDrafts& drafts, HistogramDrafts& histograms);

/// What the colours of the surface say, where they are numbers. Draws nothing where they are not.
void field_legend(Frame& frame);
/// The plane that hides things, and how far cells are pulled apart, while one of them is on.
void clip_controls(Frame& frame);
/// What is seen where, over the scene, while the mesh as loaded is shown.
void picture_labels(const Frame& frame, const Area& viewport);

/// What lights up around the selected entity: the path in words, and the two looks. Over the scene.
void neighbour_legend(const Frame& frame, const Area& viewport);

/// The whole history as a strip to scrub through, with buttons.
void timeline_panel(Frame& frame);

/// What runs came to, a row each: a click leads back to one, another one puts it beside the present
/// mesh.
void runs_panel(Frame& frame);

/// One line about what happened last and what there is.
void status_bar(Frame& frame);

}  // namespace aomd::ui
