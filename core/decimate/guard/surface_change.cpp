#include "core/decimate/guard/surface_change.h"

namespace aomd {
namespace {

// The faces of a star as they are when `hub` stands at `to` in its middle, but for those that use
// `gone`.
void stretch(const Mesh& mesh, const Star& star, Vertex gone, Vertex hub, const glm::dvec3& to,
             std::vector<NewFace>& faces) {
  for (const StarFace& f : star)
    if (!f.uses(gone))
      faces.push_back({f.face,
                       {hub, f.next, f.previous},
                       {to, mesh.position(f.next), mesh.position(f.previous)},
                       mesh.classification(f.face)});
}

void stretch_curves(const Mesh& mesh, const Star& star, Vertex from, Vertex gone, Vertex hub,
                    const glm::dvec3& to, std::vector<NewPiece>& pieces) {
  if (mesh.classification(from).dimension() > 1) return;
  for_edges_at(mesh, from, star, [&](Edge e, Vertex far) {
    if (const ModelRef curve = mesh.classification(e); far != gone && curve.dimension() == 1)
      pieces.push_back({curve, hub, {to, mesh.position(far)}, e});
  });
}

void replace(const Mesh& mesh, const Star& star, Vertex from, Vertex gone, Vertex hub,
             const glm::dvec3& to, Change& change) {
  stretch(mesh, star, gone, hub, to, change.created);
  stretch_curves(mesh, star, from, gone, hub, to, change.pieces);
}

void note_replaced(Change& change) {
  for (const NewFace& f : change.created) change.replaced.push_back(f.face);
  for (const NewPiece& p : change.pieces) change.old_pieces.push_back(p.edge);
}

void note_edge_between(const Mesh& mesh, Vertex v, Vertex w, const Star& around_v, Change& change) {
  if (mesh.classification(v).dimension() > 1) return;
  for_edges_at(mesh, v, around_v, [&](Edge e, Vertex far) {
    if (far == w && mesh.classification(e).dimension() == 1) change.old_pieces.push_back(e);
  });
}

}  // namespace

void describe(const Mesh& mesh, const Contraction& contraction, const Star& around_deleted,
              const Star& around_kept, Change& change) {
  const auto& [deleted, kept, position] = contraction;
  change.clear();
  for (const StarFace& f : around_deleted)
    if (f.uses(kept)) change.replaced.push_back(f.face);
  replace(mesh, around_deleted, deleted, kept, kept, position, change);
  if (position != mesh.position(kept))
    replace(mesh, around_kept, kept, deleted, kept, position, change);
  note_replaced(change);
  if (mesh.count(3) == 0) return;
  note_edge_between(mesh, deleted, kept, around_deleted, change);
  if (position != mesh.position(kept)) return;
  stretch(mesh, around_kept, deleted, kept, position, change.beside);
  stretch_curves(mesh, around_kept, kept, deleted, kept, position, change.pieces_beside);
}

void describe(const Mesh& mesh, const EdgePair& pair, Change& change) {
  change.clear();
  change.replaced.assign({pair.f, pair.g});
  const auto create = [&](Face face, Vertex a, Vertex b, Vertex c) {
    change.created.push_back({face,
                              {a, b, c},
                              {mesh.position(a), mesh.position(b), mesh.position(c)},
                              mesh.classification(face)});
  };
  create(pair.f, pair.d, pair.b, pair.c);
  create(pair.g, pair.c, pair.a, pair.d);
}

void describe(const Mesh& mesh, Vertex v, const Star& around, const glm::dvec3& target,
              Change& change) {
  change.clear();
  replace(mesh, around, v, {}, v, target, change);
  note_replaced(change);
}

}  // namespace aomd
