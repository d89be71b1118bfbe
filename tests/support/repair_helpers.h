#pragma once
// Repairing in tests, and what a repaired mesh must be.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/mesh/verify.h"
#include "core/repair/repair.h"
#include "tests/support/surface_facts.h"
#include "tests/support/zoo.h"

namespace aomd::test {

using zoo::Triangles;
using Names = std::vector<std::string>;

inline Names names(const std::vector<RepairItem>& items) {
  Names result;
  for (const RepairItem& item : items) result.push_back(item.name);
  return result;
}

/// Repairs, and expects that a second repair finds nothing more to do.
inline RepairReport mend(MeshData& data, const RepairOptions& options = {}) {
  const RepairReport report = repair(data, options);
  MeshData again = data;
  EXPECT_EQ(names(repair(again, options).done), Names());
  EXPECT_TRUE(again == data);
  return report;
}

inline Triangles triangles(const MeshData& data) {
  Triangles result;
  const auto& v = data.faces.vertices;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) result.push_back({v[i], v[i + 1], v[i + 2]});
  return result;
}

/// How many fans of faces there are beyond the first at each vertex, found by walking from face to
/// face.
inline std::size_t extra_fans(const MeshData& data) {
  const Triangles faces = triangles(data);
  std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 3>>> around;
  for (const auto& f : faces)
    for (const std::uint32_t v : f) around[v].push_back(f);
  const auto share_side = [](const auto& f, const auto& g) {  // at the vertex that both have
    return std::count_if(f.begin(), f.end(),
                         [&](auto v) { return std::find(g.begin(), g.end(), v) != g.end(); }) >= 2;
  };
  std::size_t fans = 0;
  for (auto& [v, left] : around)
    for (; !left.empty(); ++fans) {
      std::vector<std::array<std::uint32_t, 3>> fan{left.back()};
      left.pop_back();
      for (std::size_t i = 0; i < fan.size(); ++i) {
        const auto next = std::partition(left.begin(), left.end(),
                                         [&](auto& f) { return !share_side(fan[i], f); });
        const auto found = next - left.begin();
        fan.insert(fan.end(), next, left.end());
        left.resize(static_cast<std::size_t>(found));
      }
    }
  return fans - around.size();
}

inline void expect_manifold(const MeshData& data) {
  EXPECT_EQ(facts_of(data).nonmanifold, 0u);
  EXPECT_EQ(extra_fans(data), 0u);
  const Mesh mesh(data);
  EXPECT_TRUE(verify(mesh).empty());
}

inline double area(const MeshData& data) {
  double sum = 0;
  for (const auto& t : triangles(data))
    sum += glm::length(glm::cross(data.positions[t[1]] - data.positions[t[0]],
                                  data.positions[t[2]] - data.positions[t[0]])) /
           2;
  return sum;
}

}  // namespace aomd::test
