#pragma once
// What a triangle mesh is, counted from its arrays alone: for tests of readers and generators.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/mesh/mesh_data.h"
#include "core/samples/samples.h"

namespace aomd::test {

/// The samples that are surfaces (2) or volumes (3).
inline std::vector<SampleInfo> samples_of(int dimension) {
  std::vector<SampleInfo> list;
  for (const SampleInfo& info : aomd::samples())
    if (info.dimension == dimension) list.push_back(info);
  return list;
}

struct SurfaceFacts {
  std::size_t edges = 0, boundary = 0, nonmanifold = 0;
  std::size_t misoriented = 0;  ///< edges that two faces run along in the same direction
  std::size_t unused = 0;
  long euler = 0;            ///< V - E + F without unused vertices
  double volume = 0;         ///< signed: positive where normals look outward
  double worst_angle = 180;  ///< the smallest angle of a face, degrees
  double least_area = 1e300;
};

inline SurfaceFacts facts_of(const MeshData& mesh) {
  SurfaceFacts facts;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
  std::vector<char> used(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t* v = &mesh.faces.vertices[3 * f];
    const glm::dvec3 p[3] = {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
    facts.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
    facts.least_area =
        std::min(facts.least_area, glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = v[i], b = v[(i + 1) % 3];
      used[a] = 1;
      auto& [forward, backward] = uses[std::minmax(a, b)];
      ++(a < b ? forward : backward);
      const glm::dvec3 to_next = p[(i + 1) % 3] - p[i], to_last = p[(i + 2) % 3] - p[i];
      const double angle =
          std::atan2(glm::length(glm::cross(to_next, to_last)), glm::dot(to_next, to_last));
      facts.worst_angle = std::min(facts.worst_angle, angle * 180 / 3.14159265358979);
    }
  }
  for (const auto& [edge, count] : uses) {
    const int all = count.first + count.second;
    facts.boundary += all == 1;
    facts.nonmanifold += all > 2;
    facts.misoriented += all == 2 && count.first != 1;
  }
  facts.edges = uses.size();
  facts.unused = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  facts.euler = static_cast<long>(mesh.positions.size() - facts.unused + mesh.faces.size()) -
                static_cast<long>(facts.edges);
  return facts;
}

/// The model entities of one dimension that a list of classes names.
inline std::set<std::int32_t> tags_of(const std::vector<ModelRef>& classes, int dimension) {
  std::set<std::int32_t> tags;
  for (const ModelRef m : classes) {
    if (m.valid() && m.dimension() == dimension) tags.insert(m.tag());
  }
  return tags;
}

inline bool same_entities(const EntityList& a, const EntityList& b) {
  return a.shapes == b.shapes && a.vertices == b.vertices && a.classes == b.classes;
}

inline bool same_mesh(const MeshData& a, const MeshData& b) {
  return a.positions == b.positions && a.vertex_classes == b.vertex_classes &&
         same_entities(a.edges, b.edges) && same_entities(a.faces, b.faces);
}

}  // namespace aomd::test
