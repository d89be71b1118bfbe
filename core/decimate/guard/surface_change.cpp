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
                              {to, mesh.position(f.next), mesh.position(f.previous)}});
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

void describe(const Mesh& mesh, const Contraction& c, const Star& around_deleted,
              const Star& around_kept, Change& change) {
  change.clear();
  for (const StarFace& f : around_deleted)
    if (f.uses(c.kept)) change.replaced.push_back(f.face);
  stretch(mesh, around_deleted, c.kept, c.kept, c.position, change);
  stretch_curves(mesh, around_deleted, c.deleted, c.kept, c.kept, c.position, change);
  if (c.position == mesh.position(c.kept)) return;
  stretch(mesh, around_kept, c.deleted, c.kept, c.position, change);
  stretch_curves(mesh, around_kept, c.kept, c.deleted, c.kept, c.position, change);
}

void describe(const Mesh& mesh, const EdgePair& e, Change& change) {
  change.clear();
  change.replaced.assign({e.f, e.g});
  const auto create = [&](Face face, Vertex a, Vertex b, Vertex c) {
    change.created.push_back(
        {face, {a, b, c}, {mesh.position(a), mesh.position(b), mesh.position(c)}});
  };
  create(e.f, e.d, e.b, e.c);
  create(e.g, e.c, e.a, e.d);
}

void describe(const Mesh& mesh, Vertex v, const Star& around, const glm::dvec3& target,
              Change& change) {
  change.clear();
  stretch(mesh, around, {}, v, target, change);
  stretch_curves(mesh, around, v, {}, v, target, change);
}

}  // namespace aomd
