#pragma once
// Model entities, and the classification edited by hand.

#include "viewer/ui/frame.h"

namespace aomd::ui {

/// What is highlighted: counts, neighbours, size, the mesh entities on it. Draws nothing where
/// nothing is.
void model_entity_section(Frame& frame);
/// What puts the selection onto other model entities. Draws nothing for volumes and quads.
void class_edits(Frame& frame);
/// The menu of the last item, which stands for a model entity.
void model_entity_menu(Frame& frame, ModelRef ref);

}  // namespace aomd::ui
