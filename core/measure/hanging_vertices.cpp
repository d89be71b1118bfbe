#include "core/measure/hanging_vertices.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/mesh/side_groups.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {
namespace {

constexpr double tolerance = 1e-6;  // of a side's diameter

double distance2(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

/// The sides as triangles, if there are any vertices that may lie on them.
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

  [[nodiscard]] std::vector<Triangle> take_triangles() { return std::move(triangles_); }
  [[nodiscard]] bool asked(Vertex v) const { return asked_[v.index] != 0; }
  /// The largest of all within which a vertex lies on a side.
  [[nodiscard]] double reach2() const { return reach2_; }

  /// The triangle, and its number in the order of `take_triangles`.
  [[nodiscard]] bool hangs_on(Vertex v, const Triangle& triangle, std::uint32_t number) const {
    const SideVertices& side = sides_[side_of_[number]];
    const auto corners = side.span();
    if (std::find(corners.begin(), corners.end(), v.index) != corners.end()) return false;
    const glm::dvec3& p = mesh_.position(v);
    const double reach2 = reach2_of(side);
    if (distance2(nearest_point(triangle, p), p) > reach2) return false;
    return mesh_.count(3) > 0 ||
           std::none_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
             return distance2(mesh_.position(Vertex(corner)), p) <= reach2;
           });
  }

 private:
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
    add(side);
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
    for (const Face f : mesh_.faces()) add(SideVertices(mesh_.vertices_of(f, buffer)));
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

  void add(const SideVertices& side) {
    for (std::uint32_t k = 1; k + 1 < side.count; ++k) {
      triangles_.push_back({corner(side, 0), corner(side, k), corner(side, k + 1)});
      side_of_.push_back(static_cast<std::uint32_t>(sides_.size()));
    }
    sides_.push_back(side);
    reach2_ = std::max(reach2_, reach2_of(side));
  }

  const Mesh& mesh_;
  std::vector<std::uint8_t> asked_;  ///< by vertex
  std::vector<SideVertices> sides_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> side_of_;  ///< by triangle
  double reach2_ = 0;
};

}  // namespace

std::vector<Vertex> hanging_vertices(const Mesh& mesh, int threads, Skin skin) {
  Boundary boundary(mesh, skin);
  std::vector<Vertex> asked, found;
  for (const Vertex v : mesh.vertices())
    if (boundary.asked(v)) asked.push_back(v);
  if (asked.empty()) return found;
  const TriangleTree tree(boundary.take_triangles(), threads);
  std::vector<std::uint8_t> hangs(asked.size(), 0);
  parallel_for(asked.size(), threads, 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      tree.within(mesh.position(asked[i]), boundary.reach2(), [&](std::uint32_t n) {
        if (hangs[i] == 0 && boundary.hangs_on(asked[i], tree.triangle(n), tree.source(n)))
          hangs[i] = 1;
      });
  });
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (hangs[i] != 0) found.push_back(asked[i]);
  return found;
}

}  // namespace aomd::measure
