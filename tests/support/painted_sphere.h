#pragma once
// A sphere with land and sea, painted by how high the land is.

#include <cmath>
#include <vector>

#include "core/mesh/mesh_data.h"
#include "core/samples/samples.h"

namespace aomd::test {

/// A colour of bytes: paint(height) gives its components at each vertex, which are rounded. Land is
/// where the height is above 0; it is smooth, and no axis is special to it.
template <typename Paint>
MeshData painted_sphere(int size, const char* name, int components, const Paint& paint) {
  MeshData mesh = make_sample("sphere", size);
  Attribute colour{name, 0, components, true, {}};
  colour.type = NumberType::UInt8;
  colour.meaning = Meaning::Colour;
  for (const glm::dvec3& p : mesh.positions) {
    const glm::dvec3 q = 3.0 * glm::normalize(p);
    const std::vector<double> paints =
        paint(std::sin(q.x + 1) + std::sin(q.y + 2) + std::sin(q.z + 0.5));
    for (const double x : paints) colour.values.push_back(std::round(x));
  }
  mesh.attributes = {colour};
  return mesh;
}

}  // namespace aomd::test
