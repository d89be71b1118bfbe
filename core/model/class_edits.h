#pragma once
// Edits of a classification by hand. Each returns what would change; core/model/class_rules judges
// and applies it.

#include <span>

#include "core/model/class_rules.h"

namespace aomd {

/// The smallest tag above all that the mesh and its model table use for model entities of a
/// dimension; ModelRef::max_tag + 1 where there is none left. O(entities), with class lists O(model
/// entities).
[[nodiscard]] std::int32_t free_tag(const Mesh& mesh, int dimension);

// All need T(0,1), and adjacency as judge_classes() does. `corner_angle_deg` is that of
// ClassifyOptions.

/// Edges that lie on no model edge become new model edges, chained between model vertices; the
/// others of `entities` that are edges stay. Their ends go along, or become new model vertices
/// where other than two edges on model edges meet, where two model edges do, or where the curve
/// turns by more than the corner angle. A model edge that a new model vertex cuts keeps its tag on
/// its longer part (by mesh edges), the rest gets a new one. Vertices become model vertices. A
/// closed curve leaves one model face on both of its sides: see split_face().
[[nodiscard]] ClassOverlay promote(const Mesh& mesh, std::span<const EntityRef> entities,
                                   double corner_angle_deg = 60);

/// Edges on model edges go onto the model face of their first face, which is valid where the others
/// lie on it too. Their ends go onto the face where no model edge is left, become model vertices
/// where a model edge now ends, and go onto a model edge that they no longer branch; where two
/// model edges are left, the model vertex between them stays. Model vertices go onto the model face
/// around them, or onto the model edge that they cut; of two model edges the smaller tag remains
/// for both.
[[nodiscard]] ClassOverlay demote(const Mesh& mesh, std::span<const EntityRef> entities,
                                  double corner_angle_deg = 60);

/// Puts entities onto a model entity. Faces take what lies between them along, and with `border`
/// the edges around them become model edges where they are none. Edges put onto a model edge take
/// their ends along as promote() does. All else stays, so that the rules decide.
[[nodiscard]] ClassOverlay assign(const Mesh& mesh, std::span<const EntityRef> entities,
                                  ModelRef model, bool border = false,
                                  double corner_angle_deg = 60);

/// The parts of a model face that model edges separate get tags of their own, with what lies
/// inside; the part with the most faces keeps the present one, among equals that with the smallest
/// id.
[[nodiscard]] ClassOverlay split_face(const Mesh& mesh, ModelRef face);

}  // namespace aomd
