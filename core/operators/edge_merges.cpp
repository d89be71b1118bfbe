#include "core/operators/edge_merges.h"

namespace aomd {

// By edges, not by faces as in judging: an edge without faces must find its twin too.
void EdgeMerges::mark_edges(const Mesh& mesh, Vertex kept, const Star& star, VertexMarks& marks) {
  marks.clear(mesh);
  if (edge_to_kept_.size() < mesh.capacity(0)) edge_to_kept_.resize(mesh.capacity(0));
  for_edges_at(mesh, kept, star, [&](Edge e, Vertex far) {
    marks.set(far);
    edge_to_kept_[far] = e;
  });
}

void EdgeMerges::find(const Mesh& mesh, const Contraction& c, const std::array<Star, 2>& stars,
                      VertexMarks& marks, std::vector<Rebinding>& rebindings) {
  mark_edges(mesh, c.kept, stars[1], marks);
  merges_.clear();
  collapsed_ = {};
  for_edges_at(mesh, c.deleted, stars[0], [&](Edge e, Vertex far) {
    if (far == c.kept)
      collapsed_ = e;
    else if (marks.has(far))
      merges_.push_back({e, edge_to_kept_[far]});
    else
      rebindings.push_back({e, mesh.edge_vertices(e)[0] == c.deleted ? 0u : 1u, c.deleted, c.kept});
  });
}

void EdgeMerges::merge(Mesh& mesh) const {
  for (const Merge& m : merges_) {
    const ModelRef gone = mesh.classification(m.gone);
    if (gone.dimension() < mesh.classification(m.survivor).dimension())
      mesh.set_classification(m.survivor, gone);
    mesh.destroy_unused(m.gone);
  }
}

}  // namespace aomd
