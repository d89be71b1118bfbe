#include "core/decimate/guard/distance_guard.h"

#include <algorithm>
#include <limits>
#include <map>

namespace aomd {

namespace {

// Of a volume the faces on its model, quads as two triangles.
Envelope envelope_of(const Mesh& mesh, double distance) {
  std::vector<Triangle> corners;
  std::vector<std::array<std::uint32_t, 3>> vertices;
  corners.reserve(mesh.count(2));
  vertices.reserve(mesh.count(2));
  VertexBuffer buffer;
  const auto at = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() == 3) continue;
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 2; k < v.size(); ++k) {
      corners.push_back({at(v[0]), at(v[k - 1]), at(v[k])});
      vertices.push_back({v[0], v[k - 1], v[k]});
    }
  }
  return Envelope(corners, distance, vertices);
}

}  // namespace

DistanceGuard::DistanceGuard(const Mesh& original, double distance)
    : surface_(envelope_of(original, distance)), hints_(original.capacity(0), no_index) {
  std::map<ModelRef, std::vector<Triangle>> pieces;
  for (const Edge e : original.edges()) {
    if (original.classification(e).dimension() != 1) continue;
    const auto [a, b] = original.edge_vertices(e);
    pieces[original.classification(e)].push_back(
        {original.position(a), original.position(b), original.position(b)});
  }
  for (const auto& [model, segments] : pieces)
    curves_.push_back({model, Envelope(segments, distance)});
}

std::uint32_t& DistanceGuard::hint(Vertex v) {
  if (v.index >= hints_.size()) hints_.resize(v.index + std::size_t{1}, no_index);
  return hints_[v];
}

Verdict DistanceGuard::judge(const Change& change) {
  if (const Verdict v = judge_curves(change); !v.accepted()) return v;
  for (const NewFace& f : change.created) {
    const Envelope::Answer answer = surface_.contains(f.corners, hint(f.vertices[0]));
    if (!answer.inside) return {Reason::Distance, f.face, answer.distance};
  }
  return {};
}

Verdict DistanceGuard::judge_curves(const Change& change) {
  for (const NewPiece& piece : change.pieces) {
    const auto curve = std::lower_bound(curves_.begin(), curves_.end(), piece.curve,
                                        [](const Curve& c, ModelRef m) { return c.model < m; });
    if (curve == curves_.end() || curve->model != piece.curve)
      return {Reason::Distance, piece.at, std::numeric_limits<double>::infinity()};
    std::uint32_t near = no_index;
    const Envelope::Answer answer =
        curve->pieces.contains({piece.ends[0], piece.ends[1], piece.ends[1]}, near);
    if (!answer.inside) return {Reason::Distance, piece.at, answer.distance};
  }
  return {};
}

}  // namespace aomd
