#include "core/measure/volume_curves.h"

#include <algorithm>
#include <tuple>

namespace aomd::measure {
namespace {

// A side of a face of the skin.
struct Side {
  std::array<Vertex, 2> ends;
  Interface on;
};

std::array<Vertex, 2> edge_between(std::uint32_t a, std::uint32_t b) {
  return {Vertex(std::min(a, b)), Vertex(std::max(a, b))};
}

std::vector<Side> sides_of(const VolumeComplex& complex, bool model_faces) {
  std::vector<Side> sides;
  for (const SkinFace& face : complex.skin) {
    if (!model_faces && !face.on.separates()) continue;
    const auto v = face.vertices.span();
    for (std::size_t k = 0; k < v.size(); ++k)
      sides.push_back({edge_between(v[k], v[(k + 1) % v.size()]), face.on.seen(model_faces)});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.ends, a.on) < std::tie(b.ends, b.on);
  });
  return sides;
}

void add_borders(const std::vector<Side>& sides, VolumeCurves& curves) {
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    for (next = i + 1; next < sides.size() && sides[next].ends == sides[i].ends;) ++next;
    if (next - i != 2 || !(sides[i].on == sides[i + 1].on)) curves.edges.push_back(sides[i].ends);
  }
}

void add_listed(const Mesh& mesh, VolumeCurves& curves) {
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() != 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    curves.edges.push_back(edge_between(a.index, b.index));
  }
  std::sort(curves.edges.begin(), curves.edges.end());
  curves.edges.erase(std::unique(curves.edges.begin(), curves.edges.end()), curves.edges.end());
}

std::vector<Vertex> ends_of(const Mesh& mesh, const VolumeCurves& curves) {
  std::vector<std::uint32_t> meet(mesh.capacity(0), 0);
  for (const auto& edge : curves.edges)
    for (const Vertex v : edge) ++meet[v.index];
  const std::vector<bool> used = used_by_regions(mesh);
  std::vector<Vertex> ends;
  for (const Vertex v : mesh.vertices()) {
    const std::uint32_t n = meet[v.index];
    const bool listed = mesh.classification(v).dimension() == 0;
    if (used[v.index] && (listed || (n != 0 && n != 2))) ends.push_back(v);
  }
  return ends;
}

}  // namespace

VolumeCurves curves_of(const Mesh& mesh, const VolumeComplex& complex,
                       const CurveOptions& options) {
  VolumeCurves curves;
  add_borders(sides_of(complex, options.faces), curves);
  if (options.edges) add_listed(mesh, curves);
  curves.ends = ends_of(mesh, curves);
  return curves;
}

}  // namespace aomd::measure
