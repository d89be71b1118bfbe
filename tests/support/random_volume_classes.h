#pragma once
// Volumes that list and classify what no sane file does.

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::test {

/// A volume of tetrahedra that lists some of the sides of its regions, each once, in any direction,
/// and classifies some of all on few tags. Dimensions are those that an entity may lie on.
inline MeshData with_random_classes_of_volumes(MeshData data, unsigned seed) {
  std::mt19937 random(seed);
  const unsigned share = random() % 5, rarity = 2 + random() % 40;
  const auto draw = [&](int dim) {
    if (random() % 4 < share) return ModelRef();
    return ModelRef(dim + static_cast<int>(random() % static_cast<unsigned>(4 - dim)),
                    static_cast<std::int32_t>(random() % 3));
  };
  data.vertex_classes.clear();
  for (std::size_t v = 0; v < data.positions.size(); ++v)
    data.vertex_classes.push_back(random() % rarity == 0 ? draw(0) : ModelRef());
  if (random() % 2 == 0)
    for (ModelRef& model : data.regions.classes) model = draw(3);
  std::vector<std::array<std::uint32_t, 3>> listed;
  for (std::size_t r = 0; r < data.regions.size(); ++r) {
    const std::uint32_t* v = data.regions.vertices.data() + 4 * r;
    const std::size_t k = random() % 4;
    std::array<std::uint32_t, 3> side{v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]};
    if (random() % 3 == 0)
      data.edges.add(Shape::Line, {v[k], v[(k + 1 + random() % 3) % 4]},
                     random() % rarity == 0 ? draw(1) : ModelRef());
    if (random() % 3 != 0) continue;
    std::array<std::uint32_t, 3> sorted = side;
    std::sort(sorted.begin(), sorted.end());
    if (std::find(listed.begin(), listed.end(), sorted) != listed.end()) continue;
    listed.push_back(sorted);
    if (random() % 2 == 0) std::swap(side[0], side[1]);
    data.faces.add(Shape::Triangle, {side[0], side[1], side[2]},
                   random() % rarity == 0 ? draw(2) : ModelRef());
  }
  return data;
}

}  // namespace aomd::test
