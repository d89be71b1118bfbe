#pragma once
// The arrays of a surface that count in the cost of its collapses (docs/ATTRIBUTES.md).

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/handle.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Numbers on the vertices of a surface, in its units of length: where the result's differ by so
/// much from the original's, it counts like as much distance.
struct CountedValues {
  std::size_t components = 0;
  std::vector<float> numbers;  ///< `components` for each vertex; NaN where nothing counts
  /// By component: the result's are those that fit best on the faces around a vertex (colours),
  /// and not the original's at its place.
  std::vector<bool> fitted;

  [[nodiscard]] std::span<const float> at(Vertex v) const {
    return std::span(numbers).subspan(components * v.index, components);
  }
};

/// How much the arrays of one name count: at 1 a difference over the whole range of a component
/// counts like a distance of 0.1 % of the diagonal.
struct ArrayWeight {
  std::string name;
  double weight = 1;
};

/// Whether an array can count: those on vertices and on corners can, but for labels, which have no
/// differences.
[[nodiscard]] bool can_count(const Attribute& array, bool on_corners);
/// Colours, at weight 3, and texture coordinates, at weight 1.
[[nodiscard]] std::vector<ArrayWeight> usual_weights(const MeshData& mesh);
/// What these arrays of a mesh as plain arrays come to on its vertices in the database, which are
/// in the same order; null where none has a weight. A value on corners counts where those of a
/// vertex agree, and no number that is not finite does. O(size).
[[nodiscard]] std::shared_ptr<const CountedValues> counted_values(
    const MeshData& data, const Mesh& mesh, std::span<const ArrayWeight> weights);

}  // namespace aomd

#pragma GCC visibility pop
