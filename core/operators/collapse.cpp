#include "core/operators/collapse.h"

#include <algorithm>

#include "core/mesh/check.h"
#include "core/mesh/journal.h"
#include "core/mesh/journal_scope.h"

namespace aomd {
namespace {

Vertex other_end(const Mesh& mesh, Edge edge, Vertex v) {
  const auto [a, b] = mesh.edge_vertices(edge);
  AOMD_DEBUG_CHECK(a == v || b == v);
  return a == v ? b : a;
}

bool uses(const std::array<Vertex, 3>& triangle, Vertex v) {
  return triangle[0] == v || triangle[1] == v || triangle[2] == v;
}

}  // namespace

Collapser::Collapser(const Mesh& mesh) : mark_(mesh.capacity(0), 0), edge_to_kept_(mesh.capacity(0)) {}

void Collapser::gather(const Mesh& mesh, Vertex deleted, Vertex kept) {
  removed_.clear();
  stretched_.clear();
  for (const Face f : mesh.row<2>(deleted)) {
    const auto t = mesh.triangle(f);
    const std::uint32_t slot = t[0] == deleted ? 0 : t[1] == deleted ? 1 : 2;
    const Vertex next = t[slot == 2 ? 0 : slot + 1], previous = t[slot == 0 ? 2 : slot - 1];
    (next == kept || previous == kept ? removed_ : stretched_).push_back({f, slot, next, previous});
  }
}

void Collapser::mark_neighbours(const Mesh& mesh, Vertex kept) {
  if (mark_.size() < mesh.capacity(0)) {
    mark_.resize(mesh.capacity(0), 0);
    edge_to_kept_.resize(mesh.capacity(0));
  }
  if (++stamp_ == 0) {
    mark_.assign(mark_.size(), 0);
    stamp_ = 1;
  }
  for (const Edge e : mesh.row<1>(kept)) {
    const Vertex v = other_end(mesh, e, kept);
    mark_[v] = stamp_;
    edge_to_kept_[v] = e;
  }
}

bool Collapser::is_apex(Vertex v) const {
  return std::any_of(removed_.begin(), removed_.end(),
                     [v](const StarFace& f) { return f.next == v || f.previous == v; });
}

// The removed face's two other edges fall together. If neither had another face, the one that stays has none.
bool Collapser::leaves_bare_edge(const Mesh& mesh, const StarFace& face, Vertex deleted, Vertex kept) const {
  const Vertex apex = face.next == kept ? face.previous : face.next;
  const auto has_apex = [&](const StarFace& f) { return f.next == apex || f.previous == apex; };
  if (std::any_of(stretched_.begin(), stretched_.end(), has_apex)) return false;
  for (const Face f : mesh.row<2>(kept)) {
    const auto t = mesh.triangle(f);
    if (uses(t, apex) && !uses(t, deleted)) return false;
  }
  return true;
}

Verdict Collapser::judge_topology(const Mesh& mesh, Vertex deleted, Vertex kept) const {
  const auto pinched = [&](Vertex v) { return v != kept && marked(v) && !is_apex(v); };
  for (const StarFace& f : stretched_) {
    if (pinched(f.next)) return {Reason::Topology, 0, f.next};
    if (pinched(f.previous)) return {Reason::Topology, 0, f.previous};
    if (!marked(f.next) || !marked(f.previous)) continue;
    for (const Face g :
         mesh.row<2>(kept)) {  // both ends apexes: the stretched face may fall onto a face of `kept`
      const auto t = mesh.triangle(g);
      if (uses(t, f.next) && uses(t, f.previous)) return {Reason::Topology, 0, g};
    }
  }
  for (const StarFace& f : removed_)
    if (leaves_bare_edge(mesh, f, deleted, kept)) return {Reason::Topology, 0, f.face};
  return {};
}

Verdict Collapser::judge_geometry(const Mesh& mesh, Vertex deleted, Vertex kept,
                                  const TurnLimit& limit) const {
  const glm::dvec3 from = mesh.position(deleted), to = mesh.position(kept);
  for (const StarFace& f : stretched_) {
    const glm::dvec3 p = mesh.position(f.next), q = mesh.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    if (is_flat(to, p, q, after)) return {Reason::Flat, 0, f.face};
    if (limit.allows(before, after) || is_flat(from, p, q, before)) continue;
    return {Reason::Angle, angle_between_deg(before, after), f.face};
  }
  return {};
}

Verdict Collapser::judge(const Mesh& mesh, Edge edge, Vertex deleted, const CollapseRules& rules) {
  const ModelRef model = mesh.classification(deleted);
  if (model.dimension() == 0 || model != mesh.classification(edge))
    return {Reason::Classification, 0, deleted};
  const Vertex kept = other_end(mesh, edge, deleted);
  gather(mesh, deleted, kept);
  if (rules.topology == TopologyRule::Safe) {
    mark_neighbours(mesh, kept);
    if (const Verdict v = judge_topology(mesh, deleted, kept); !v.accepted()) return v;
  }
  return judge_geometry(mesh, deleted, kept, rules.max_turn);
}

void Collapser::plan_edges(const Mesh& mesh, Edge edge, Vertex deleted, Vertex kept) {
  merges_.clear();
  rebindings_.clear();
  for (const Edge e : mesh.row<1>(deleted)) {
    if (e == edge) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    const Vertex far = a == deleted ? b : a;
    if (marked(far))
      merges_.push_back({e, edge_to_kept_[far]});
    else
      rebindings_.push_back({e, a == deleted ? 0u : 1u, deleted, kept});
  }
}

// Without the link condition an edge may lose its last face; then it goes too.
void Collapser::destroy_if_bare(Mesh& mesh, Vertex apex, Vertex kept) {
  for (const Face f : mesh.row<2>(kept))
    if (uses(mesh.triangle(f), apex)) return;
  if (marked(apex)) mesh.destroy(edge_to_kept_[apex]);
  mark_[apex] = 0;
}

void Collapser::apply(Mesh& mesh, Edge edge, Vertex deleted) {
  const JournalScope step(mesh, StepKind::Collapse, edge);
  const Vertex kept = other_end(mesh, edge, deleted);
  gather(mesh, deleted, kept);
  mark_neighbours(mesh, kept);
  plan_edges(mesh, edge, deleted, kept);
  for (const StarFace& f : removed_) mesh.destroy(f.face);
  for (const StarFace& f : stretched_) rebindings_.push_back({f.face, f.slot, deleted, kept});
  mesh.rebind(rebindings_);
  for (const Merge& m : merges_) {
    const ModelRef gone = mesh.classification(m.gone);
    if (gone.dimension() < mesh.classification(m.survivor).dimension())
      mesh.set_classification(m.survivor, gone);
    mesh.destroy(m.gone);
  }
  for (const StarFace& f : removed_) destroy_if_bare(mesh, f.next == kept ? f.previous : f.next, kept);
  mesh.destroy(edge);
  mesh.destroy(deleted);
}

}  // namespace aomd
