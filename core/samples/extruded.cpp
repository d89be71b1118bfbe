// Volume samples drawn in a plane and extruded: an L-shaped bracket with a hole.

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/handle.h"
#include "core/mesh/split_tets.h"
#include "core/samples/build.h"
#include "core/samples/makers.h"
#include "core/samples/plate.h"
#include "core/samples/volume_build.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

constexpr int length = 5, width = 2, thickness = 1, height = 4;
constexpr Hole hole{3, 1, 0.5};

/// Model faces of the bracket: 1 to 6 as for a box, then 7 the base's upper side, 8 the upright's
/// inner side, 9 the bore.
std::int32_t side_of_bracket(const glm::dvec3& p) {
  if (p.z == thickness) return 7;
  if (p.x == thickness) return 8;
  return side_of_box(p, glm::dvec3(0), {length, width, height}, 9);
}

/// Layers of prisms over the triangles of the plate, up to a height that depends on the triangle.
class Extrusion {
 public:
  Extrusion(const Plate& plate, int n) : plate_(plate), n_(n) {
    for (int layer = 0; layer <= height * n; ++layer)
      for (const glm::dvec2& p : plate.points)
        vertices_.push_back(layer <= thickness * n || p.x <= thickness
                                ? add_vertex(mesh_, {p.x, p.y, static_cast<double>(layer) / n})
                                : no_index);
  }

  MeshData make() {
    for (int layer = 0; layer < height * n_; ++layer)
      for (const auto& [a, b, c] : plate_.triangles) {
        const std::array<Index, 6> v = {at(layer, a),     at(layer, b),     at(layer, c),
                                        at(layer + 1, a), at(layer + 1, b), at(layer + 1, c)};
        if (v[3] == no_index || v[4] == no_index || v[5] == no_index) continue;
        mesh_.regions.add(Shape::Prism, {v[0], v[1], v[2], v[3], v[4], v[5]}, ModelRef(3, 1));
      }
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] Index at(int layer, Index point) const {
    return vertices_[static_cast<std::size_t>(layer) * plate_.points.size() + point];
  }

  const Plate& plate_;
  int n_;
  MeshData mesh_;
  std::vector<Index> vertices_;  ///< layer by layer, one a point of the plate
};

}  // namespace

MeshData make_tet_bracket(int n) {
  const Plate plate = make_plate(length, width, n, std::array{hole});
  MeshData mesh = split_to_tets(Extrusion(plate, n).make()).mesh;
  classify_below_regions(mesh, side_of_bracket);
  return mesh;
}

}  // namespace aomd::sample
