#include "core/decimate/guard/distance_guard.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/base/assertion.h"

namespace aomd {

namespace {

Envelope envelope_of(const Mesh& mesh, double distance) {
  const Triangles all = triangles_of(mesh);
  AOMD_CHECK(all.faces.size() == mesh.count(2));  // quads would be two
  std::vector<std::array<std::uint32_t, 3>> vertices;
  vertices.reserve(all.faces.size());
  VertexBuffer buffer;
  for (const Face f : all.faces) {
    const auto v = mesh.vertices_of(f, buffer);
    vertices.push_back({v[0], v[1], v[2]});
  }
  return Envelope(all.corners, distance, vertices);
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
