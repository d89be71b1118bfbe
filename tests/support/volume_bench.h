#pragma once
// A classified volume mesh for operators on tetrahedra: with what lies on model faces and edges as
// entities, or with everything; and small volumes to try them on.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/operators/ball.h"
#include "core/samples/samples.h"
#include "tests/support/volume_mesh.h"
#include "tests/support/zoo.h"

namespace aomd::test {

/// The shape of the worst tetrahedron; 1 where there is none.
inline double worst_shape(const Mesh& mesh) {
  double worst = 1;
  for (const Region r : mesh.regions()) worst = std::min(worst, tet_shape(mesh, r));
  return worst;
}

/// The angle at the edge p-q between the half planes through r and s, degrees: by what is left of r
/// and s across the edge, which shares nothing with the code that is tested.
inline double dihedral_at(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r,
                          const glm::dvec3& s) {
  const glm::dvec3 along = glm::normalize(q - p);
  const auto across = [&](const glm::dvec3& v) { return v - p - glm::dot(v - p, along) * along; };
  const glm::dvec3 u = across(r), v = across(s);
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * 180 / M_PI;
}

/// The smallest angle between two faces of a tetrahedron of the mesh, degrees; 180 where there is
/// none.
inline double smallest_dihedral(const Mesh& mesh) {
  double least = 180;
  for (const Region r : mesh.regions()) {
    if (mesh.shape(r) != Shape::Tetrahedron) continue;
    const auto t = mesh.tetrahedron(r);
    const auto at = [&](std::size_t i) { return mesh.position(t[i]); };
    for (const auto& [p, q, a, b] :
         {std::array{0, 1, 2, 3}, std::array{0, 2, 1, 3}, std::array{0, 3, 1, 2},
          std::array{1, 2, 0, 3}, std::array{1, 3, 0, 2}, std::array{2, 3, 0, 1}})
      least = std::min(least, dihedral_at(at(p), at(q), at(a), at(b)));
  }
  return least;
}

enum class Levels { Listed, Complete };
inline constexpr Levels both_levels[] = {Levels::Listed, Levels::Complete};
inline const char* name(Levels levels) {
  return levels == Levels::Listed ? "as listed" : "complete";
}

struct VolumeBench {
  VolumeBench(const MeshData& data, Levels levels, const ClassifyOptions& options = {})
      : mesh(data) {
    classify(mesh, options);
    if (levels == Levels::Complete) {
      set_all(mesh);
      return;
    }
    mesh.keep_model_faces_only();
    mesh.keep_model_edges_only();
    mesh.set(0, 3);
    for (const int level : {2, 1}) held.push_back(mesh.request_listed(0, level));
  }
  [[nodiscard]] std::string finding() const {
    const auto all = verify(mesh);
    return all.empty() ? "" : all[0].name + ": " + all[0].text;
  }
  Mesh mesh;
  std::vector<Request> held;
};

/// Smooth surfaces are one model face.
inline const ClassifyOptions smooth_skin{.feature_angle_deg = {}};

// Tetrahedra all around the edge 0-1, seen from 1; ring vertex i is 2 + i.
inline MeshData ring_around_an_edge(const std::vector<glm::dvec3>& ring, const glm::dvec3& below,
                                    const glm::dvec3& above) {
  MeshData data;
  data.positions = {below, above};
  data.positions.insert(data.positions.end(), ring.begin(), ring.end());
  const auto n = static_cast<std::uint32_t>(ring.size());
  for (std::uint32_t i = 0; i < n; ++i)
    data.regions.add(Shape::Tetrahedron, {0, 1, 2 + i, 2 + (i + 1) % n});
  return data;
}

// n ring vertices at random distances and heights.
inline MeshData random_ring(std::uint32_t n, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return low + (high - low) * double(random() % 100'000) / 1e5;
  };
  std::vector<glm::dvec3> ring;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (i + number(-0.3, 0.3)) / n, radius = number(0.7, 1.3);
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle), number(-0.2, 0.2));
  }
  return ring_around_an_edge(ring, {number(-0.1, 0.1), 0, -number(0.2, 2)},
                             {0, number(-0.1, 0.1), number(0.2, 2)});
}

// A sample of two materials, left and right, shaken inside and tangentially on flat sides.
inline MeshData shaken(const char* sample, int size, double amount, std::uint32_t seed) {
  MeshData data = make_sample(sample, size);
  data.model = {};
  std::mt19937 random(seed);
  for (std::size_t r = 0; r < data.regions.size(); ++r) {
    double x = 0;
    for (int k = 0; k < 4; ++k)
      x += data.positions[data.regions.vertices[4 * r + std::size_t(k)]].x;
    data.regions.classes[r] = ModelRef(3, x / 4 < data.positions[0].x + 0.51 ? 1 : 2);
  }
  data.faces = {}, data.edges = {}, data.vertex_classes = {};
  Mesh mesh(data);
  classify(mesh);
  for (const Vertex v : mesh.vertices())
    for (int k = 0; k < 3; ++k) {
      const double by = amount * (double(random() % 2001) / 1000 - 1);
      if (mesh.classification(v).dimension() == 3) data.positions[v.index][k] += by;
    }
  return data;
}

}  // namespace aomd::test
