#pragma once
// What a volume mesh is, counted from its arrays alone: for tests of readers and generators.

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <glm/geometric.hpp>

#include "core/mesh/mesh_data.h"

namespace aomd::test {

struct VolumeFacts {
  long vertices = 0, edges = 0, faces = 0, regions = 0;  ///< distinct ones that regions use
  long euler = 0;                                        ///< V - E + F - R
  std::size_t unused = 0;                                ///< vertices that no region uses
  std::size_t boundary = 0;                              ///< sides of one region
  std::size_t between = 0;      ///< sides of two regions on different model regions
  std::size_t crowded = 0;      ///< sides of more than two regions
  std::size_t misoriented = 0;  ///< sides that two regions see the same way round
  std::size_t folded = 0;       ///< regions that a corner's edges turn inside out
  std::size_t listed_outward = 0,
              listed_inside = 0;  ///< listed faces that are sides, as one region sees them
  std::size_t listed_wrong = 0;   ///< other listed faces
  double volume = 0, least_volume = 1e300;
  std::map<int, double> volume_of;  ///< by the tag of the model region
};

using Cycle = std::vector<std::uint32_t>;

/// The vertices of one lower entity of a region.
inline Cycle corners_of(const std::uint32_t* v, const SubEntity& sub) {
  Cycle corners;
  for (int k = 0; k < shape_template(sub.shape).vertex_count; ++k)
    corners.push_back(v[sub.vertices[static_cast<std::size_t>(k)]]);
  return corners;
}

/// A cycle with its smallest vertex first, its direction kept.
inline Cycle turned(Cycle c) {
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

inline Cycle reversed(Cycle c) {
  std::reverse(c.begin(), c.end());
  return turned(c);
}

/// Six times the volume that sides span with a point; quads as the mean of their two cuts.
inline double volume_of_region(const MeshData& mesh, const std::uint32_t* v,
                               const ShapeTemplate& shape) {
  const glm::dvec3 o = mesh.positions[v[0]];
  double six = 0;
  for (int i = 0; i < shape.face_count; ++i) {
    const Cycle c = corners_of(v, shape.sub(2, i));
    const auto part = [&](std::size_t a, std::size_t b, std::size_t d) {
      const auto& p = mesh.positions;
      return glm::dot(p[c[a]] - o, glm::cross(p[c[b]] - o, p[c[d]] - o));
    };
    if (c.size() == 3) six += part(0, 1, 2);
    if (c.size() == 4) six += (part(0, 1, 2) + part(0, 2, 3) + part(0, 1, 3) + part(1, 2, 3)) / 2;
  }
  return six / 6;
}

/// dot(cross(v1 - v0, v2 - v0), top - v0) > 0, where `top` is the first vertex that is not on the
/// first side.
inline bool stands_upright(const MeshData& mesh, const std::uint32_t* v, Shape shape) {
  const std::size_t top = shape == Shape::Tetrahedron || shape == Shape::Prism ? 3 : 4;
  const auto& p = mesh.positions;
  return glm::dot(glm::cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]), p[v[top]] - p[v[0]]) > 0;
}

inline VolumeFacts volume_facts_of(const MeshData& mesh) {
  VolumeFacts facts;
  struct Uses {
    std::vector<Cycle> cycles;
    std::vector<ModelRef> models;
  };
  std::map<std::set<std::uint32_t>, Uses> sides;
  std::set<std::set<std::uint32_t>> edges;
  std::set<std::uint32_t> used;
  for (std::size_t r = 0, place = 0; r < mesh.regions.size(); ++r) {
    const Shape kind = mesh.regions.shapes[r];
    const ShapeTemplate& shape = shape_template(kind);
    const std::uint32_t* v = &mesh.regions.vertices[place];
    const ModelRef model = mesh.regions.classes.empty() ? ModelRef() : mesh.regions.classes[r];
    for (int k = 0; k < shape.vertex_count; ++k) used.insert(v[k]);
    for (int i = 0; i < shape.edge_count; ++i) {
      const Cycle c = corners_of(v, shape.sub(1, i));
      edges.insert({c.begin(), c.end()});
    }
    for (int i = 0; i < shape.face_count; ++i) {
      const Cycle c = corners_of(v, shape.sub(2, i));
      Uses& uses = sides[{c.begin(), c.end()}];
      uses.cycles.push_back(turned(c));
      uses.models.push_back(model);
    }
    const double volume = volume_of_region(mesh, v, shape);
    facts.volume += volume;
    facts.volume_of[model.tag()] += volume;
    facts.least_volume = std::min(facts.least_volume, volume);
    facts.folded += !stands_upright(mesh, v, kind);
    place += static_cast<std::size_t>(shape.vertex_count);
  }
  for (const auto& [key, uses] : sides) {
    const std::size_t n = uses.cycles.size();
    facts.boundary += n == 1;
    facts.crowded += n > 2;
    facts.between += n == 2 && uses.models[0] != uses.models[1];
    facts.misoriented += n == 2 && uses.cycles[0] != reversed(uses.cycles[1]);
  }
  for (std::size_t f = 0, place = 0; f < mesh.faces.size(); ++f) {
    const auto n = static_cast<std::size_t>(shape_template(mesh.faces.shapes[f]).vertex_count);
    const Cycle c(&mesh.faces.vertices[place], &mesh.faces.vertices[place] + n);
    const auto at = sides.find({c.begin(), c.end()});
    const bool seen = at != sides.end() && at->second.cycles[0] == turned(c);
    facts.listed_outward += seen && at->second.cycles.size() == 1;
    facts.listed_inside += seen && at->second.cycles.size() == 2;
    facts.listed_wrong += !seen;
    place += n;
  }
  facts.unused = mesh.positions.size() - used.size();
  facts.vertices = static_cast<long>(used.size());
  facts.edges = static_cast<long>(edges.size());
  facts.faces = static_cast<long>(sides.size());
  facts.regions = static_cast<long>(mesh.regions.size());
  facts.euler = facts.vertices - facts.edges + facts.faces - facts.regions;
  return facts;
}

}  // namespace aomd::test
