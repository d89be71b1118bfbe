#include "core/measure/hanging_vertices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/box_tree.h"
#include "core/base/parallel.h"
#include "core/mesh/side_groups.h"
#include "core/model/tilted_box.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {
namespace {

constexpr double tolerance = 1e-6;  // of a side's diameter

double distance2(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

/// The sides, if there are any vertices that may lie on them.
class Boundary {
 public:
  Boundary(const Mesh& mesh, Skin skin) : mesh_(mesh), asked_(mesh.capacity(0), 0) {
    if (mesh.count(3) == 0)
      take_surface();
    else if (skin == Skin::Listed)
      take_listed();
    else
      take_derived();
  }

  [[nodiscard]] std::size_t size() const { return sides_.size(); }
  [[nodiscard]] std::vector<Vertex> asked() const {
    std::vector<Vertex> list;
    for (const Vertex v : mesh_.vertices())
      if (asked_[v.index] != 0) list.push_back(v);
    return list;
  }

  /// Calls visit(n) for the vertices of a tree, by its order, that hang on a side.
  template <typename Visit>
  void hanging_on(std::size_t side, const BoxTree& places, std::span<const Vertex> vertices,
                  const Visit& visit) const {
    const SideVertices& corners = sides_[side];
    const double reach2 = reach2_of(corners), reach = std::sqrt(reach2);
    std::array<glm::dvec3, 4> points;
    for (std::uint32_t k = 0; k < corners.count; ++k) points[k] = corner(corners, k);
    const Surroundings around(std::span<const glm::dvec3>(points).first(corners.count),
                              places.box(), reach);
    places.reached([&](std::uint32_t node) { return around.may_touch(places.node(node).box); },
                   [&](std::uint32_t n) {
                     if (hangs_on(vertices[places.source(n)], corners, reach2)) visit(n);
                   });
  }

 private:
  [[nodiscard]] bool hangs_on(Vertex v, const SideVertices& side, double reach2) const {
    const auto corners = side.span();
    if (std::find(corners.begin(), corners.end(), v.index) != corners.end()) return false;
    const glm::dvec3& p = mesh_.position(v);
    double least2 = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 1; k + 1 < side.count; ++k)
      least2 = std::min(least2, distance2(nearest_point(triangle(side, k), p), p));
    if (least2 > reach2) return false;
    return mesh_.count(3) > 0 ||
           std::none_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
             return distance2(mesh_.position(Vertex(corner)), p) <= reach2;
           });
  }

  [[nodiscard]] Triangle triangle(const SideVertices& side, std::uint32_t k) const {
    return {corner(side, 0), corner(side, k), corner(side, k + 1)};
  }

  void take_derived() {
    const SideGroups<2> groups(mesh_);
    groups.each([&](std::span<const SideUse> uses) {
      const auto of_region = [](const SideUse& use) { return use.dimension == 3; };
      if (std::count_if(uses.begin(), uses.end(), of_region) == 1)
        take_skin(groups.vertices(uses.back()));
    });
  }

  void take_listed() {
    VertexBuffer buffer;
    for (const Face f : mesh_.faces())
      if (mesh_.classification(f).dimension() == 2)
        take_skin(SideVertices(mesh_.vertices_of(f, buffer)));
  }

  void take_skin(const SideVertices& side) {
    for (const std::uint32_t v : side.span()) asked_[v] = 1;
    sides_.push_back(side);
  }

  void take_surface() {
    const SideGroups<1> groups(mesh_);
    bool closed = true;
    groups.each([&](std::span<const SideUse> uses) {
      const auto of_face = [](const SideUse& use) { return use.dimension == 2; };
      if (std::count_if(uses.begin(), uses.end(), of_face) != 1) return;
      const SideVertices edge = groups.vertices(uses.back());
      for (const std::uint32_t v : edge.span()) asked_[v] = 1;
      closed = false;
    });
    if (closed) return;
    VertexBuffer buffer;
    for (const Face f : mesh_.faces()) sides_.emplace_back(mesh_.vertices_of(f, buffer));
  }

  [[nodiscard]] glm::dvec3 corner(const SideVertices& side, std::uint32_t k) const {
    return mesh_.position(Vertex(side.ids[k]));
  }

  [[nodiscard]] double reach2_of(const SideVertices& side) const {
    double diameter2 = 0;
    for (std::uint32_t i = 0; i < side.count; ++i)
      for (std::uint32_t k = 0; k < i; ++k)
        diameter2 = std::max(diameter2, distance2(corner(side, i), corner(side, k)));
    return tolerance * tolerance * diameter2;
  }

  const Mesh& mesh_;
  std::vector<std::uint8_t> asked_;  ///< by vertex
  std::vector<SideVertices> sides_;
};

BoxTree tree_of(const Mesh& mesh, std::span<const Vertex> vertices, int threads) {
  std::vector<BoxTree::Item> items;
  items.reserve(vertices.size());
  for (const Vertex v : vertices)
    items.push_back({mesh.position(v), static_cast<std::uint32_t>(items.size())});
  BoxTree tree(items, threads);
  std::vector<Box> boxes(items.size());
  for (std::size_t n = 0; n < boxes.size(); ++n)
    boxes[n].add(mesh.position(vertices[items[n].source]));
  tree.fit(std::move(boxes));
  return tree;
}

}  // namespace

std::vector<Vertex> hanging_vertices(const Mesh& mesh, int threads, Skin skin) {
  const Boundary boundary(mesh, skin);
  const std::vector<Vertex> asked = boundary.asked();
  std::vector<Vertex> found;
  if (asked.empty()) return found;
  const BoxTree places = tree_of(mesh, asked, threads);
  std::vector<std::uint8_t> hangs(asked.size(), 0);
  parallel_for(boundary.size(), threads, 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t side = begin; side < end; ++side)
      boundary.hanging_on(side, places, asked, [&](std::uint32_t n) {
        std::atomic_ref(hangs[places.source(n)]).store(1, std::memory_order_relaxed);
      });
  });
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (hangs[i] != 0) found.push_back(asked[i]);
  return found;
}

}  // namespace aomd::measure
