#pragma once
// Does a mesh fit a model; and classification of a mesh on a model that it lies on
// (docs/MODELS.md).

#include "core/mesh/mesh.h"
#include "core/model/model.h"

namespace aomd {

/// Throws ModelError where the mesh is classified on entities that the model lacks: how many, and
/// the first of them. O(mesh entities).
void check_entities(const Mesh& mesh, const Model& model);

/// Throws ModelError as check_entities() does, and where a vertex is further from the entity that
/// it lies on than 1 % of the model's diagonal: another model, or other units. O(mesh entities),
/// one closest point a vertex.
void check_against(const Mesh& mesh, const Model& model);

/// True where the mesh has a class on any entity.
[[nodiscard]] bool is_classified(const Mesh& mesh);

/// Classifies the vertices, edges and faces of a surface mesh on a model that it lies on, in this
/// order:
///  - a vertex on the nearest model vertex within the tolerance, else on the nearest model edge
///    within it;
///  - an edge on a model edge that both ends lie on or bound, where no other vertex of that model
///    edge is nearer to the middle of the piece between them;
///  - vertices on a model edge along which no edge lies are taken off it (a seam that the mesh
///    ignores);
///  - faces, flooded between those edges, on the model face that is bounded by all of these and
///    nearest to the vertices inside, or to the middles of the faces where there are none inside;
///  - what is left takes the class of its face.
/// Replaces what was classified before; vertices that nothing uses stay unclassified. `tolerance`
/// is a length; 0 takes 1e-6 of the model's diagonal. One step in the journal. About O(vertices)
/// closest points. Throws ModelError, naming the largest distance, where a vertex does not lie on
/// the model; where an edge with other than two faces lies on no model edge; and for meshes with
/// regions. The mesh is then unchanged.
void classify_on(Mesh& mesh, const Model& model, double tolerance = 0);

}  // namespace aomd
