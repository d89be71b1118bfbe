#pragma once
// Classes as no sane file has them.

#include <random>
#include <utility>

#include "core/mesh/mesh_data.h"

namespace aomd::test {

/// The surface with a class of few tags, or none, drawn for each vertex and face and for some of
/// the sides; triangles only. Dimensions are those that an entity may lie on.
inline MeshData with_random_classes(MeshData data, unsigned seed) {
  std::mt19937 random(seed);
  const unsigned share = random() % 5;  // of entities without a class, in quarters
  const auto draw = [&](int dim) {
    if (random() % 4 < share) return ModelRef();
    return ModelRef(dim + static_cast<int>(random() % static_cast<unsigned>(4 - dim)),
                    static_cast<std::int32_t>(random() % 3));
  };
  data.vertex_classes.clear();
  for (std::size_t v = 0; v < data.positions.size(); ++v) data.vertex_classes.push_back(draw(0));
  data.faces.classes.clear();
  for (std::size_t f = 0; f < data.faces.size(); ++f) data.faces.classes.push_back(draw(2));
  data.edges = {};
  for (std::size_t f = 0; f < data.faces.size(); f += 1 + random() % 3) {
    const std::uint32_t* corner = data.faces.vertices.data() + 3 * f;
    data.edges.add(Shape::Line, {corner[0], corner[1]}, draw(1));
  }
  return data;
}

}  // namespace aomd::test
