#pragma once
// How strongly a surface bends at its vertices.

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// The larger principal curvature at each vertex, without sign, in 1 / unit of length; for a vertex
/// on a model edge that of the edge where it is larger. 0 where no face is.
///
/// Over each face the normals of its vertices vary linearly; the mean of that derivative over the
/// star of a vertex is the tensor whose larger eigenvalue counts (Rusinkiewicz, "Estimating
/// curvatures and their derivatives on triangle meshes", 2004, as a sum over faces). Averaging
/// tensors over the stars around, `smoothing` times, keeps the noise of a scanner out; 2 reaches
/// three rings. On a sphere the error is of second order in edge / radius. Surfaces are cut along
/// model edges first, so that the angle between two model faces is no curvature; an unclassified
/// mesh has no model edges, and bends at its creases. Faces are expected to agree about their
/// sides. In a volume only faces on model faces count. O(faces).
[[nodiscard]] Column<Vertex, double> vertex_curvatures(const Mesh& mesh, int smoothing = 2);

}  // namespace aomd
