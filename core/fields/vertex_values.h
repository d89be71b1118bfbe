#pragma once
// Values at the vertices of a result, from those at the vertices of its original.

#include <array>
#include <vector>

#include "core/fields/same_place.h"
#include "core/fields/tet_tree.h"

namespace aomd::fields {

/// What the value at a vertex is made of: corners of a tetrahedron of the original, or of a
/// triangle (the last of the four weighs nothing), by weight, or one vertex alone. corners[0] is
/// no_index where nothing is known.
struct VertexSource {
  std::array<std::uint32_t, 4> corners{no_index, no_index, no_index, no_index};
  Weights weights{1, 0, 0, 0};

  [[nodiscard]] static VertexSource only(std::uint32_t vertex) {
    return {{vertex, vertex, vertex, vertex}, {1, 0, 0, 0}};
  }
};

/// For each vertex of the result: the vertex of the original at its place; else the corners of the
/// tetrahedron of `tree` that holds it, or that is carried on least to reach it. Where parts touch
/// without being joined, those count on whose side the vertex's own regions lie.
[[nodiscard]] std::vector<VertexSource> vertex_sources(const Cells& original, const TetTree& tree,
                                                       const Cells& result,
                                                       const SameVertices& same, int threads);

/// A component of an array on vertices at such a place; NaN, or the label 0, where nothing is
/// known.
[[nodiscard]] double value_at(const Attribute& array, const VertexSource& source,
                              std::size_t component);

/// An array of the original's vertices at those of the result. Labels come from the corner of the
/// largest weight. What is no finite number has no say where the weights of the others add up to
/// more than a half, and else the result is no number either. Linear functions stay to rounding.
[[nodiscard]] Attribute at_vertices(const Attribute& array,
                                    const std::vector<VertexSource>& sources);

}  // namespace aomd::fields
