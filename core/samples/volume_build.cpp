#include "core/samples/volume_build.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/samples/build.h"

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

constexpr Index none = 0xffffffffu;

/// A side of a region: its vertices sorted, and where it stands.
struct Side {
  std::array<Index, 4> key{none, none, none, none};
  Index region = 0, place = 0;  ///< of the region's vertices in the list
  int side = 0;
};

std::vector<Side> sorted_sides(const MeshData& mesh) {
  std::vector<Side> sides;
  for (Index r = 0, place = 0; r < mesh.regions.size(); ++r) {
    const ShapeTemplate& shape = shape_template(mesh.regions.shapes[r]);
    for (int i = 0; i < shape.face_count; ++i) {
      Side side{{none, none, none, none}, r, place, i};
      const SubEntity& sub = shape.sub(2, i);
      for (int k = 0; k < shape_template(sub.shape).vertex_count; ++k) {
        const auto at = static_cast<std::size_t>(k);
        side.key[at] = mesh.regions.vertices[place + sub.vertices[at]];
      }
      std::sort(side.key.begin(), side.key.end());
      sides.push_back(side);
    }
    place += static_cast<Index>(shape.vertex_count);
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.key != b.key ? a.key < b.key : a.region < b.region;
  });
  return sides;
}

void add_side(MeshData& mesh, const Side& side, const FaceTag& tag_of) {
  const SubEntity& sub = shape_template(mesh.regions.shapes[side.region]).sub(2, side.side);
  std::array<Index, 4> v{};
  const std::size_t n = sub.shape == Shape::Quad ? 4 : 3;
  glm::dvec3 sum(0);
  for (std::size_t k = 0; k < n; ++k) {
    v[k] = mesh.regions.vertices[side.place + sub.vertices[k]];
    sum += mesh.positions[v[k]];
  }
  const ModelRef model(2, tag_of(sum / static_cast<double>(n)));
  if (n == 4)
    mesh.faces.add(Shape::Quad, {v[0], v[1], v[2], v[3]}, model);
  else
    mesh.faces.add(Shape::Triangle, {v[0], v[1], v[2]}, model);
}

}  // namespace

void add_hexahedron(MeshData& mesh, const Cell& c, ModelRef model) {
  mesh.regions.add(Shape::Hexahedron, {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]}, model);
}

void add_prisms(MeshData& mesh, const Cell& c, ModelRef model) {
  mesh.regions.add(Shape::Prism, {c[0], c[1], c[3], c[4], c[5], c[7]}, model);
  mesh.regions.add(Shape::Prism, {c[0], c[3], c[2], c[4], c[7], c[6]}, model);
}

void add_tetrahedra(MeshData& mesh, const Cell& c, ModelRef model) {
  // The corners around the diagonal, each with the next one.
  constexpr std::size_t pairs[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
  for (const auto& [a, b] : pairs)
    mesh.regions.add(Shape::Tetrahedron, {c[0], c[a], c[b], c[7]}, model);
}

void add_transition(MeshData& mesh, const Cell& c, Index centre, ModelRef model) {
  mesh.regions.add(Shape::Pyramid, {c[0], c[1], c[3], c[2], centre}, model);
  // Two triangles on each other side, seen from the centre.
  constexpr std::size_t triangles[10][3] = {{4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5}, {2, 3, 7},
                                            {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 7, 3}, {1, 5, 7}};
  for (const auto& t : triangles)
    mesh.regions.add(Shape::Tetrahedron, {c[t[0]], c[t[1]], c[t[2]], centre}, model);
}

std::int32_t side_of_box(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high,
                         std::int32_t inside) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] == low[axis]) return 2 * axis + 1;
    if (p[axis] == high[axis]) return 2 * axis + 2;
  }
  return inside;
}

void classify_below_regions(MeshData& mesh, const FaceTag& tag_of) {
  const std::vector<Side> sides = sorted_sides(mesh);
  std::vector<Side> outer;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    for (next = i + 1; next < sides.size() && sides[next].key == sides[i].key;) ++next;
    const auto& classes = mesh.regions.classes;
    if (next - i == 1 || classes[sides[i].region] != classes[sides[i + 1].region])
      outer.push_back(sides[i]);
  }
  std::sort(outer.begin(), outer.end(), [](const Side& a, const Side& b) {
    return a.region != b.region ? a.region < b.region : a.side < b.side;
  });
  for (const Side& side : outer) add_side(mesh, side, tag_of);
  classify_below_faces(mesh);
  for (std::size_t r = 0, place = 0; r < mesh.regions.size(); ++r) {
    for (int k = shape_template(mesh.regions.shapes[r]).vertex_count; k > 0; --k, ++place) {
      ModelRef& model = mesh.vertex_classes[mesh.regions.vertices[place]];
      if (!model.valid()) model = mesh.regions.classes[r];
    }
  }
}

}  // namespace aomd::sample
