#include "core/decimate/guard/surface_change.h"

namespace aomd {
namespace {

// The faces of a star as they are when `hub` stands at `to` in its middle, but for those that use
// `gone`.
void stretch(const Mesh& mesh, const Star& star, Vertex gone, Vertex hub, const glm::dvec3& to,
             Change& change) {
  for (const StarFace& f : star) {
    if (f.uses(gone)) continue;
    change.replaced.push_back(f.face);
    change.created.push_back({f.face,
                              {hub, f.next, f.previous},
                              {to, mesh.position(f.next), mesh.position(f.previous)},
                              mesh.classification(f.face)});
  }
}

void stretch_curves(const Mesh& mesh, const Star& star, Vertex from, Vertex gone, Vertex hub,
                    const glm::dvec3& to, Change& change) {
  if (mesh.classification(from).dimension() > 1) return;
  for_edges_at(mesh, from, star, [&](Edge e, Vertex far) {
    if (const ModelRef curve = mesh.classification(e); far != gone && curve.dimension() == 1)
      change.pieces.push_back({curve, hub, {to, mesh.position(far)}});
  });
}

}  // namespace

void describe(const Mesh& mesh, const Contraction& contraction, const Star& around_deleted,
              const Star& around_kept, Change& change) {
  change.clear();
  for (const StarFace& f : around_deleted)
    if (f.uses(contraction.kept)) change.replaced.push_back(f.face);
  stretch(mesh, around_deleted, contraction.kept, contraction.kept, contraction.position, change);
  stretch_curves(mesh, around_deleted, contraction.deleted, contraction.kept, contraction.kept,
                 contraction.position, change);
  if (contraction.position == mesh.position(contraction.kept)) return;
  stretch(mesh, around_kept, contraction.deleted, contraction.kept, contraction.position, change);
  stretch_curves(mesh, around_kept, contraction.kept, contraction.deleted, contraction.kept,
                 contraction.position, change);
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
  stretch(mesh, around, {}, v, target, change);
  stretch_curves(mesh, around, v, {}, v, target, change);
}

}  // namespace aomd
