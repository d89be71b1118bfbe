#pragma once
// What the generators share.

#include <cstdint>
#include <span>

#include "core/mesh/mesh_data.h"

namespace aomd::sample {

/// Adds a vertex and returns its index.
std::uint32_t add_vertex(MeshData& mesh, const glm::dvec3& position);

/// Adds the quad a, b, c, d as two triangles on a model face (none where tag is 0), cut from a to
/// c, or from b to d when `other_diagonal`.
void add_quad(MeshData& mesh, const std::uint32_t (&quad)[4], std::int32_t tag,
              bool other_diagonal);

/// Adds the quad a, b, c, d as two triangles on a model face, cut along the shorter diagonal.
void add_quad(MeshData& mesh, const std::uint32_t (&quad)[4], std::int32_t tag);

/// Classifies edges and vertices from faces that lie on model faces. A mesh edge lies on a model
/// edge unless exactly two faces of one model face share it; a vertex is a model vertex where model
/// edges end or meet, and where `corners` names it. Faces may have any number of sides. Model edges
/// run from model vertex to model vertex, or are closed; they and the model vertices get tags
/// from 1. Lists the classified edges in mesh.edges. O(n log n).
void classify_below_faces(MeshData& mesh, std::span<const std::uint32_t> corners = {});

/// Renumbers vertices and faces so that neighbours in space are near in memory, as in scanned data.
/// O(n log n).
void order_in_space(MeshData& mesh);

}  // namespace aomd::sample
