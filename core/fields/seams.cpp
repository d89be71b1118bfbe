#include "core/fields/seams.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/disjoint_sets.h"
#include "core/mesh/handle.h"

namespace aomd::fields {
namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

Charts::Charts(const Cells& faces, const Attribute& corners)
    : faces_(faces), beyond_(faces.mesh().faces.vertices.size(), no_index) {
  const std::vector<Side> sides = sorted_sides();
  const auto first_corner = [](const Side& s, bool along) { return along ? s.from : s.to; };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
    if (end - i != 2) continue;
    const Side &a = sides[i], &b = sides[i + 1];
    if (jumps(corners, a, b)) {
      seams_.push_back(a.ends);
      continue;
    }
    const auto runs_along = [&](const Side& s) {
      const auto v = faces.vertices(s.face);
      const std::size_t k = s.from - faces.first_corner(s.face);
      return v[(k + 1) % v.size()] == s.ends[1];
    };
    beyond_[first_corner(a, runs_along(a))] = b.face;
    beyond_[first_corner(b, runs_along(b))] = a.face;
  }
}

std::vector<Charts::Side> Charts::sorted_sides() const {
  std::vector<Side> sides;
  sides.reserve(beyond_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const auto v = faces_.vertices(f);
    const std::size_t first = faces_.first_corner(f);
    for (std::size_t k = 0; k < v.size(); ++k) {
      const std::size_t l = (k + 1) % v.size(), a = first + k, b = first + l;
      sides.push_back(v[k] < v[l] ? Side{{v[k], v[l]}, f, a, b} : Side{{v[l], v[k]}, f, b, a});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.ends, a.from) < std::tie(b.ends, b.from);
  });
  return sides;
}

bool Charts::jumps(const Attribute& corners, const Side& a, const Side& b) {
  const auto n = static_cast<std::size_t>(corners.components);
  const auto differ = [&](std::size_t c, std::size_t d) {
    for (std::size_t k = 0; k < n; ++k)
      if (!same(corners.values[n * c + k], corners.values[n * d + k])) return true;
    return false;
  };
  return differ(a.from, b.from) || differ(a.to, b.to);
}

std::vector<std::uint32_t> Charts::numbers() const {
  DisjointSets sets(faces_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    for (std::size_t k = 0; k < faces_.vertices(f).size(); ++k)
      if (const std::uint32_t next = beyond_[faces_.first_corner(f) + k]; next != no_index)
        sets.unite(f, next);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) numbers.push_back(sets.find(f));
  return numbers;
}

std::vector<double> corner_measures(const MeshData& mesh) {
  const Cells faces(mesh, 2);
  std::vector<double> measures;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const std::size_t n = faces.vertices(f).size();
    measures.insert(measures.end(), n, faces.measure(f) / static_cast<double>(n));
  }
  return measures;
}

std::vector<NamedSeams> named_seams(const MeshData& mesh) {
  std::vector<NamedSeams> seams;
  if (mesh.corners.empty()) return seams;
  const Cells faces(mesh, 2);
  for (const Attribute& a : mesh.corners)
    if (a.meaning != Meaning::Normal) seams.push_back({a.name, Charts(faces, a).seams()});
  return seams;
}

std::vector<std::array<std::uint32_t, 2>> all_edges(const std::vector<NamedSeams>& seams) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const NamedSeams& each : seams)
    edges.insert(edges.end(), each.edges.begin(), each.edges.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::array<std::uint32_t, 2>> seams_of(const MeshData& mesh) {
  return all_edges(named_seams(mesh));
}

}  // namespace aomd::fields
