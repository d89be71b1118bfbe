#pragma once
// What a decimation of tetrahedra must keep, counted from plain arrays by definition.

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/disjoint_sets.h"
#include "core/mesh/mesh_data.h"

namespace aomd::test {

/// Of one model entity's simplices: vertices - edges + faces - regions, and how many pieces they
/// form that touch in vertices.
struct Topology {
  long euler = 0, parts = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

struct VolumeOracle {
  std::map<ModelRef, Topology> topology;  ///< by model region, face and edge
  std::map<ModelRef, double> volume;      ///< by model region
  std::set<ModelRef> model_vertices;
  long unlisted = 0;  ///< sides of one region, or of two model regions, on no listed face
  long stray = 0;     ///< listed faces that are no such sides, or listed twice
  long crowded = 0;   ///< sides of more than two regions
  long folded = 0;    ///< sides that two regions see the same way round
  long repeated = 0;  ///< regions on the same vertices
  long inverted = 0;  ///< regions without a positive volume
};

namespace detail {

using Simplex = std::vector<std::uint32_t>;

inline Topology topology_of(const std::vector<Simplex>& simplices, std::size_t vertices) {
  std::set<Simplex> all;
  DisjointSets pieces(vertices);
  for (const Simplex& s : simplices) {
    for (std::size_t mask = 1; mask < (std::size_t{1} << s.size()); ++mask) {
      Simplex part;
      for (std::size_t k = 0; k < s.size(); ++k)
        if (mask >> k & 1) part.push_back(s[k]);
      std::sort(part.begin(), part.end());
      all.insert(part);
    }
    for (const std::uint32_t v : s) pieces.unite(v, s[0]);
  }
  Topology result;
  std::set<std::uint32_t> roots;
  for (const Simplex& s : all) {
    result.euler += s.size() % 2 == 1 ? 1 : -1;
    roots.insert(pieces.find(s[0]));
  }
  result.parts = static_cast<long>(roots.size());
  return result;
}

inline std::map<ModelRef, std::vector<Simplex>> by_class(const EntityList& list, std::size_t n) {
  std::map<ModelRef, std::vector<Simplex>> result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto* v = &list.vertices[n * i];
    result[list.classes.empty() ? ModelRef() : list.classes[i]].emplace_back(v, v + n);
  }
  return result;
}

inline Simplex sorted(Simplex s) {
  std::sort(s.begin(), s.end());
  return s;
}

// Whether an odd permutation sorts three vertices.
inline bool is_odd(const Simplex& s) { return (s[0] > s[1]) ^ (s[1] > s[2]) ^ (s[0] > s[2]); }

}  // namespace detail

inline VolumeOracle volume_oracle(const MeshData& data) {
  using detail::Simplex;
  VolumeOracle o;
  struct Use {
    bool odd;
    ModelRef model;
  };
  std::map<Simplex, std::vector<Use>> sides;
  std::set<Simplex> cells;
  const auto regions = detail::by_class(data.regions, 4);
  for (const auto& [model, tets] : regions) {
    o.topology[model] = detail::topology_of(tets, data.positions.size());
    for (const Simplex& t : tets) {
      const auto at = [&](std::size_t k) { return data.positions[t[k]]; };
      const double volume = glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6;
      o.volume[model] += volume;
      o.inverted += !(volume > 0);
      o.repeated += !cells.insert(detail::sorted(t)).second;
      for (const Simplex& s : {Simplex{t[0], t[2], t[1]}, Simplex{t[0], t[1], t[3]},
                               Simplex{t[1], t[2], t[3]}, Simplex{t[2], t[0], t[3]}})
        sides[detail::sorted(s)].push_back({detail::is_odd(s), model});
    }
  }
  std::set<Simplex> listed;
  for (const auto& [model, faces] : detail::by_class(data.faces, 3)) {
    o.topology[model] = detail::topology_of(faces, data.positions.size());
    for (const Simplex& f : faces) o.stray += !listed.insert(detail::sorted(f)).second;
  }
  for (const auto& [model, edges] : detail::by_class(data.edges, 2))
    o.topology[model] = detail::topology_of(edges, data.positions.size());
  for (const auto& [side, uses] : sides) {
    const bool skin = uses.size() == 1 || uses[0].model != uses[1].model;
    o.unlisted += skin && listed.erase(side) == 0;
    o.crowded += uses.size() > 2;
    o.folded += uses.size() == 2 && uses[0].odd == uses[1].odd;
  }
  o.stray += static_cast<long>(listed.size());
  for (const ModelRef on : data.vertex_classes)
    if (on.dimension() == 0) o.model_vertices.insert(on);
  return o;
}

/// Expects what no operation may change; volumes to a share of themselves.
inline void expect_kept(const VolumeOracle& before, const VolumeOracle& now, double share) {
  EXPECT_EQ(now.topology, before.topology);
  EXPECT_EQ(now.model_vertices, before.model_vertices);
  EXPECT_EQ(now.unlisted + now.stray + now.crowded + now.folded + now.repeated, 0)
      << "unlisted " << now.unlisted << " stray " << now.stray << " crowded " << now.crowded
      << " folded " << now.folded << " repeated " << now.repeated;
  EXPECT_LE(now.inverted, before.inverted);
  for (const auto& [model, volume] : before.volume)
    EXPECT_NEAR(now.volume.at(model), volume, share * volume) << "region " << model.tag();
}

}  // namespace aomd::test
