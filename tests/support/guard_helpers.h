#pragma once
// Surfaces before and after a change, for the tests of guards.

#include <algorithm>
#include <optional>

#include "core/decimate/guard/surface_change.h"
#include "core/model/classify.h"
#include "tests/support/zoo.h"

namespace aomd::test {

/// Borders are model edges, and where an angle is given what is sharper.
inline Mesh prepared(const MeshData& data, std::optional<double> feature_angle_deg = {}) {
  Mesh mesh(data);
  ClassifyOptions options;
  options.feature_angle_deg = feature_angle_deg;
  classify(mesh, options);
  for (const auto& [i, j] : {std::pair{2, 0}, {0, 1}, {0, 2}}) mesh.set(i, j);
  return mesh;
}

/// With vertices of its own.
inline void add(MeshData& data, const Triangle& t) {
  const auto n = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(), t.begin(), t.end());
  data.faces.add(Shape::Triangle, {n, n + 1, n + 2});
}

inline MeshData created_by(const Change& change) {
  MeshData data;
  for (const NewFace& f : change.created) add(data, f.corners);
  return data;
}

/// The surface as it is after a change, vertices not shared: what the changed mesh is to be
/// measured by.
inline MeshData after(const Mesh& mesh, const Change& change) {
  MeshData data = created_by(change);
  for (const Face f : mesh.faces()) {
    if (std::find(change.replaced.begin(), change.replaced.end(), f) != change.replaced.end())
      continue;
    const auto t = mesh.triangle(f);
    add(data, {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
  }
  return data;
}

/// Two surfaces of triangles as one.
inline MeshData both(MeshData a, const MeshData& b) {
  const auto n = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t f = 0; f < b.faces.size(); ++f) {
    const std::uint32_t* v = &b.faces.vertices[3 * f];
    a.faces.add(Shape::Triangle, {v[0] + n, v[1] + n, v[2] + n});
  }
  return a;
}

}  // namespace aomd::test
