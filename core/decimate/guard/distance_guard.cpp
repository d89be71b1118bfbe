#include "core/decimate/guard/distance_guard.h"

#include <algorithm>
#include <limits>
#include <map>

namespace aomd {

namespace {

/// Triangles, and the vertices of each, for an envelope.
struct Soup {
  std::vector<Triangle> corners;
  std::vector<std::array<std::uint32_t, 3>> vertices;
};

// Of a volume by model face, quads as two triangles; of a surface all faces together.
std::map<ModelRef, Soup> surfaces_of(const Mesh& mesh, bool by_model_face) {
  std::map<ModelRef, Soup> surfaces;
  if (!by_model_face) surfaces[{}].corners.reserve(mesh.count(2));
  VertexBuffer buffer;
  const auto at = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
  for (const Face f : mesh.faces()) {
    const ModelRef model = mesh.classification(f);
    if (model.dimension() == 3) continue;
    Soup& soup = surfaces[by_model_face ? model : ModelRef()];
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 2; k < v.size(); ++k) {
      soup.corners.push_back({at(v[0]), at(v[k - 1]), at(v[k])});
      soup.vertices.push_back({v[0], v[k - 1], v[k]});
    }
  }
  return surfaces;
}

std::map<ModelRef, std::vector<Triangle>> curves_of(const Mesh& mesh) {
  std::map<ModelRef, std::vector<Triangle>> curves;
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() != 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    curves[mesh.classification(e)].push_back(
        {mesh.position(a), mesh.position(b), mesh.position(b)});
  }
  return curves;
}

}  // namespace

DistanceGuard::DistanceGuard(const Mesh& original, double distance)
    : distance_(distance), by_model_face_(original.count(3) > 0), hints_(original.capacity(0)) {
  for (const auto& [model, soup] : surfaces_of(original, by_model_face_))
    surfaces_.push_back({model, Envelope(soup.corners, distance, soup.vertices)});
  for (const auto& [model, segments] : curves_of(original))
    curves_.push_back({model, Envelope(segments, distance)});
}

DistanceGuard::Part* DistanceGuard::find(std::vector<Part>& parts, ModelRef model) {
  const auto part = std::lower_bound(parts.begin(), parts.end(), model,
                                     [](const Part& p, ModelRef m) { return p.model < m; });
  return part == parts.end() || part->model != model ? nullptr : &*part;
}

DistanceGuard::Part* DistanceGuard::surface_of(const NewFace& f) {
  return by_model_face_ ? find(surfaces_, f.model) : &surfaces_.front();
}

// What was near the vertex on another part says nothing.
std::uint32_t& DistanceGuard::hint(Vertex v, const Part& part) {
  if (v.index >= hints_.size()) hints_.resize(v.index + std::size_t{1}, {});
  Hint& hint = hints_[v];
  if (hint.part != &part) hint = {&part, no_index};
  return hint.triangle;
}

Verdict DistanceGuard::judge(const Change& change) {
  if (const Verdict v = judge_curves(change); !v.accepted()) return v;
  if (const Verdict v = judge_middles(change); !v.accepted()) return v;
  for (const NewFace& f : change.created) {
    Part* part = surface_of(f);
    const Envelope::Answer answer = part->near.contains(f.corners, hint(f.vertices[0], *part));
    if (!answer.inside) return {Reason::Distance, f.face, answer.distance};
  }
  return {};
}

// Most that is too far is so in the middle of a new face or edge: to look there first saves going
// over faces that are near.
Verdict DistanceGuard::judge_middles(const Change& change) {
  for (const NewFace& f : change.created) {
    Part* part = surface_of(f);
    if (!part) return {Reason::Distance, f.face, std::numeric_limits<double>::infinity()};
    const auto& [a, b, c] = f.corners;
    for (const glm::dvec3& p : {(a + b + c) / 3.0, 0.5 * (a + b)}) {
      const Envelope::Answer answer = part->near.contains(p, hint(f.vertices[0], *part));
      if (!answer.inside) return {Reason::Distance, f.face, answer.distance};
    }
  }
  return {};
}

Verdict DistanceGuard::judge_curves(const Change& change) {
  for (const NewPiece& piece : change.pieces) {
    Part* part = find(curves_, piece.curve);
    if (!part) return {Reason::Distance, piece.at, std::numeric_limits<double>::infinity()};
    std::uint32_t near = no_index;
    const Envelope::Answer answer =
        part->near.contains({piece.ends[0], piece.ends[1], piece.ends[1]}, near);
    if (!answer.inside) return {Reason::Distance, piece.at, answer.distance};
  }
  return {};
}

}  // namespace aomd
