#pragma once
// What a classified mesh of tetrahedra is to its model, counted from plain arrays: an oracle for
// operators that must keep it.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/tet_geometry.h"

namespace aomd::test {

using Corners = std::vector<std::uint32_t>;  ///< of a simplex, ascending

/// A set of simplices with all their sides.
class Complex {
 public:
  void add(Corners simplex) {
    std::sort(simplex.begin(), simplex.end());
    tops_.push_back(simplex);
    for (unsigned some = 1; some < 1u << simplex.size(); ++some) {
      Corners side;
      for (std::size_t k = 0; k < simplex.size(); ++k)
        if (some >> k & 1u) side.push_back(simplex[k]);
      all_.insert(side);
    }
  }

  [[nodiscard]] int euler() const {
    int sum = 0;
    for (const Corners& s : all_) sum += s.size() % 2 == 1 ? 1 : -1;
    return sum;
  }

  /// Parts that hang together by sides of `common` vertices.
  [[nodiscard]] int parts(std::size_t common) const {
    std::vector<std::size_t> root(tops_.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](std::size_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    std::map<Corners, std::size_t> first;
    for (std::size_t i = 0; i < tops_.size(); ++i)
      for (unsigned some = 1; some < 1u << tops_[i].size(); ++some) {
        Corners side;
        for (std::size_t k = 0; k < tops_[i].size(); ++k)
          if (some >> k & 1u) side.push_back(tops_[i][k]);
        if (side.size() == common) root[find(i)] = find(first.try_emplace(side, i).first->second);
      }
    int n = 0;
    for (std::size_t i = 0; i < root.size(); ++i) n += root[i] == i;
    return n;
  }

  /// Vertices around which it falls into several parts, each counted so often less one.
  [[nodiscard]] int pinches() const {
    std::map<std::uint32_t, Complex> links;
    for (const Corners& top : tops_)
      for (const std::uint32_t v : top) {
        Corners rest;
        for (const std::uint32_t w : top)
          if (w != v) rest.push_back(w);
        if (!rest.empty()) links[v].add(rest);
      }
    int n = 0;
    for (const auto& [v, link] : links) n += link.parts(1) - 1;
    return n;
  }

 private:
  std::vector<Corners> tops_;
  std::set<Corners> all_;
};

inline std::string facts_of(const Complex& c, std::size_t corners) {
  std::string text = " Euler " + std::to_string(c.euler());
  for (std::size_t common = corners - 1; common > 0; --common)
    text += " parts " + std::to_string(c.parts(common));
  return text + '\n';
}

/// One line for each model entity, pair of regions that meet, and union of those of one dimension:
/// Euler number, and parts that hang together by faces, edges and vertices.
inline std::string strata_of(const Mesh& mesh) {
  std::map<std::string, std::pair<Complex, std::size_t>> strata;
  const auto add = [&](const std::string& name, const Corners& simplex) {
    auto& [complex, corners] = strata[name];
    complex.add(simplex);
    corners = simplex.size();
  };
  std::map<Corners, std::multiset<int>> sides;
  std::map<std::pair<int, std::uint32_t>, int> used;
  VertexBuffer buffer;
  for (const Region r : mesh.regions()) {
    const auto v = mesh.vertices_of(r, buffer);
    Corners c(v.begin(), v.end());
    std::sort(c.begin(), c.end());
    const int tag = mesh.classification(r).tag();
    add("region " + std::to_string(tag), c);
    add("all", c);
    for (std::size_t k = 0; k < 4; ++k) {
      Corners side = c;
      side.erase(side.begin() + static_cast<std::ptrdiff_t>(k));
      sides[side].insert(tag);
    }
  }
  for (const auto& [side, tags] : sides) {
    if (tags.size() == 2 && *tags.begin() == *tags.rbegin()) continue;
    std::string name = "between";
    for (const int tag : tags) name += ' ' + std::to_string(tag);
    add(name, side);
    add("all faces", side);
  }
  std::string text;
  for (int dim = 1; dim < 3; ++dim)
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      const EntityRef e(dim, id);
      if (!mesh.alive(e) || mesh.classification(e).dimension() > dim) continue;
      const auto v = mesh.vertices_of(e, buffer);
      const std::string name = (dim == 1 ? "model edge " : "model face ");
      add(name + std::to_string(mesh.classification(e).tag()), {v.begin(), v.end()});
      add(name + "of any tag", {v.begin(), v.end()});
    }
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 0)
      text += "model vertex " + std::to_string(v.index) + '\n';
  for (const auto& [name, stratum] : strata) text += name + facts_of(stratum.first, stratum.second);
  for (const auto& [name, stratum] : strata)
    if (name.starts_with("region"))
      text += name + " pinches " + std::to_string(stratum.first.pinches()) + '\n';
  return text;
}

/// The first thing that is wrong with tetrahedra: upside down, repeated, more than two on a side,
/// or a side between materials that is on no model face; empty where all is right.
inline std::string wrong_with_tets(const Mesh& mesh) {
  std::set<Corners> known;
  std::map<Corners, std::vector<int>> sides;
  for (const Region r : mesh.regions()) {
    const auto t = mesh.tetrahedron(r);
    Corners c;
    for (const Vertex v : t) c.push_back(v.index);
    std::sort(c.begin(), c.end());
    const std::string name = "region " + std::to_string(r.index);
    if (!is_upright(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]),
                    mesh.position(t[3])))
      return name + " is inside out";
    if (!known.insert(c).second) return name + " is repeated";
    for (std::size_t k = 0; k < 4; ++k) {
      Corners side = c;
      side.erase(side.begin() + static_cast<std::ptrdiff_t>(k));
      sides[side].push_back(mesh.classification(r).tag());
      if (sides[side].size() > 2) return name + " is the third on a side";
    }
  }
  std::set<Corners> on_model;
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() > 2) continue;
    Corners c;
    for (const Vertex v : mesh.triangle(f)) c.push_back(v.index);
    std::sort(c.begin(), c.end());
    const std::string name = "face " + std::to_string(f.index);
    if (!on_model.insert(c).second) return name + " is repeated";
    if (!sides.contains(c)) return name + " is a side of nothing";
  }
  for (const auto& [side, tags] : sides)
    if ((tags.size() == 1 || tags[0] != tags[1]) && !on_model.contains(side))
      return "a side of a model region is on no model face";
  return "";
}

}  // namespace aomd::test
