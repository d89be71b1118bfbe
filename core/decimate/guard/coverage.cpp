#include "core/decimate/guard/coverage.h"

namespace aomd {
namespace {

// Those on model faces; a quad is two of one id.
std::vector<ModelCell> faces_of(const Mesh& mesh) {
  std::vector<ModelCell> cells;
  cells.reserve(mesh.count(2));
  VertexBuffer buffer;
  const auto at = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
  for (const Face f : mesh.faces()) {
    const ModelRef model = mesh.classification(f);
    if (model.dimension() == 3) continue;
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 2; k < v.size(); ++k)
      cells.push_back({f.index, model, {at(v[0]), at(v[k - 1]), at(v[k])}});
  }
  return cells;
}

std::vector<ModelCell> edges_of(const Mesh& mesh) {
  std::vector<ModelCell> cells;
  for (const Edge e : mesh.edges()) {
    const ModelRef model = mesh.classification(e);
    if (model.dimension() != 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    cells.push_back({e.index, model, {mesh.position(a), mesh.position(b), mesh.position(b)}});
  }
  return cells;
}

}  // namespace

Coverage::Coverage(const Mesh& original, double distance)
    : on_faces_(faces_of(original), distance), on_edges_(edges_of(original), distance) {}

void Coverage::restart(const Mesh& mesh) {
  on_faces_.attach(faces_of(mesh));
  on_edges_.attach(edges_of(mesh));
}

void Coverage::gather(const Change& change) {
  faces_.clear(), edges_.clear(), old_faces_.clear(), old_edges_.clear();
  for (const Face f : change.replaced) old_faces_.push_back(f.index);
  for (const Edge e : change.old_pieces) old_edges_.push_back(e.index);
  for (const auto* list : {&change.created, &change.beside})
    for (const NewFace& f : *list) faces_.push_back({f.face.index, f.model, f.corners});
  for (const auto* list : {&change.pieces, &change.pieces_beside})
    for (const NewPiece& p : *list)
      edges_.push_back({p.edge.index, p.curve, {p.ends[0], p.ends[1], p.ends[1]}});
}

Verdict Coverage::judge(const Change& change) {
  gather(change);
  if (const double far = on_edges_.uncovered(old_edges_, edges_); far > 0)
    return {Reason::Distance, change.pieces[0].at, far};
  if (const double far = on_faces_.uncovered(old_faces_, faces_); far > 0)
    return {Reason::Distance, change.created[0].face, far};
  return {};
}

void Coverage::applied(const Change& change) {
  gather(change);
  on_edges_.hand_over(old_edges_, edges_);
  on_faces_.hand_over(old_faces_, faces_);
}

}  // namespace aomd
