#include "core/operators/collapse.h"

#include "core/base/assertion.h"
#include "core/mesh/journal.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/shared_edits.h"
#include "core/operators/collapse_checks.h"

namespace aomd {

Collapser::Collapser(const Mesh& mesh) : marks_(mesh), edges_(mesh) {
  AOMD_CHECK(mesh.representation().down(2, 0).stride() == 3);
}

// Among the faces, and among model edges where the edge lies on one.
Verdict Collapser::judge_topology(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                                  ModelRef model, const StarPair& stars) {
  if (model.dimension() == 1)
    if (const Vertex third = closes_chain(mesh, ends, stars[0]); third.valid())
      return {Reason::Topology, third};
  return link_.judge(mesh, edge, ends, stars, marks_);
}

Verdict Collapser::judge_either(const Mesh& mesh, const EdgeEnds& ends, ModelRef model,
                                std::array<bool, 2> may_go, const CollapseRules& rules,
                                CollapsePlan& plan) {
  const EntityRef edge = plan.edge.valid() ? EntityRef(plan.edge) : EntityRef(ends[1]);
  Verdict furthest = judge_classes(mesh, ends, model, may_go);
  if (!may_go[0] && !may_go[1]) return furthest;
  for (const Vertex v : ends)
    if (crowded(mesh, v)) return {Reason::Topology, v};
  for (std::size_t i = 0; i < 2; ++i) gather(mesh, ends[i], plan.stars[i]);
  if (rules.topology == TopologyRule::Safe)
    if (const Verdict v = judge_topology(mesh, edge, ends, model, plan.stars); !v.accepted())
      return v;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!may_go[i]) continue;
    const Contraction c{ends[i], ends[1 - i], mesh.position(ends[1 - i])};
    Verdict v = judge_faces(mesh, plan.stars[i], {c.deleted, c.kept, c.position}, rules);
    if (v.accepted() && model.dimension() == 1 && rules.topology == TopologyRule::Safe)
      v = judge_curve(mesh, plan.stars[i], model, c, rules.max_curve_turn);
    if (v.accepted()) {
      plan.contraction = c;
      if (i == 1) std::swap(plan.stars[0], plan.stars[1]);
      return v;
    }
    if (v.reason >= furthest.reason) furthest = v;
  }
  return furthest;
}

Verdict Collapser::judge_contraction(const Mesh& mesh, const Contraction& c,
                                     const CollapseRules& rules, StarPair& stars) {
  for (const Vertex v : {c.deleted, c.kept})
    if (crowded(mesh, v)) return {Reason::Topology, v};
  gather(mesh, c.deleted, stars[0]);
  gather(mesh, c.kept, stars[1]);
  const ModelRef model = class_between(mesh, c.deleted, c.kept, stars[0]);
  const bool moves = c.position != mesh.position(c.kept);
  if (const Verdict s = judge_classes(mesh, c, model, moves); !s.accepted()) return s;
  if (rules.topology == TopologyRule::Safe)
    if (const Verdict v = judge_topology(mesh, c.kept, {c.deleted, c.kept}, model, stars);
        !v.accepted())
      return v;
  Verdict v = judge_faces(mesh, stars[0], {c.deleted, c.kept, c.position}, rules);
  if (v.accepted() && moves)
    v = judge_faces(mesh, stars[1], {c.kept, c.deleted, c.position}, rules);
  if (v.accepted() && model.dimension() == 1 && rules.topology == TopologyRule::Safe)
    v = judge_curve(mesh, stars[0], model, c, rules.max_curve_turn);
  if (v.accepted() && moves && model.dimension() == 1 && rules.topology == TopologyRule::Safe)
    v = judge_rest_of_curve(mesh, stars[1], model, c, rules.max_curve_turn);
  return v;
}

Verdict Collapser::judge(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                         const CollapseRules& rules, CollapsePlan& plan) {
  plan.edge = edge;
  plan.revision = mesh.revision();
  return plan.verdict = judge_either(mesh, mesh.edge_vertices(edge), mesh.classification(edge),
                                     may_go, rules, plan);
}

Verdict Collapser::judge(const Mesh& mesh, const EdgeEnds& ends, std::array<bool, 2> may_go,
                         const CollapseRules& rules, CollapsePlan& plan) {
  plan.edge = {};
  plan.revision = mesh.revision();
  return plan.verdict = judge_either(mesh, ends, class_between(mesh, ends), may_go, rules, plan);
}

Verdict Collapser::judge(const Mesh& mesh, Edge edge, Vertex deleted, const CollapseRules& rules,
                         CollapsePlan& plan) {
  const bool first = mesh.edge_vertices(edge)[0] == deleted;
  return judge(mesh, edge, {first, !first}, rules, plan);
}

Verdict Collapser::judge(const Mesh& mesh, const Contraction& c, const CollapseRules& rules,
                         CollapsePlan& plan) {
  plan.edge = {};
  plan.contraction = c;
  plan.revision = mesh.revision();
  return plan.verdict = judge_contraction(mesh, c, rules, plan.stars);
}

// Entities in descending order: rows are sorted, so that each leaves the deleted vertex's row at
// its end.
void Collapser::find_edits(const Mesh& mesh, const Contraction& c, const StarPair& stars) {
  rebindings_.clear();
  edges_.find(mesh, c, stars, marks_, rebindings_);
  bare_.clear();
  for (auto f = stars[0].rbegin(); f != stars[0].rend(); ++f) {
    if (!f->uses(c.kept)) {
      rebindings_.push_back({f->face, f->slot, c.deleted, c.kept});
      continue;
    }
    if (const Vertex apex = f->third(c.kept); leaves_bare_edge({c.deleted, c.kept}, stars, apex))
      bare_.push_back(apex);
  }
}

// Without the link condition an edge may lose its last face; then it goes too.
void Collapser::destroy_bare_edges(Mesh& mesh, Vertex kept) {
  for (const Vertex apex : bare_)
    if (const Edge e = mesh.find_edge(kept, apex); e.valid()) mesh.destroy_unused(e);
}

void Collapser::apply(Mesh& mesh, Edge edge, Vertex deleted) {
  const Vertex kept = mesh.other_end(edge, deleted);
  StarPair stars;
  gather(mesh, deleted, stars[0]);
  gather(mesh, kept, stars[1]);
  const JournalScope step(mesh, StepKind::Collapse, edge);
  make(mesh, {deleted, kept, mesh.position(kept)}, stars);
}

void Collapser::apply(Mesh& mesh, const CollapsePlan& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const Contraction& c = plan.contraction;
  const JournalScope step(mesh, StepKind::Collapse,
                          plan.edge.valid() ? EntityRef(plan.edge) : EntityRef(c.kept));
  if (c.position != mesh.position(c.kept)) mesh.move(c.kept, c.position);
  make(mesh, c, plan.stars);
}

void Collapser::apply(const Mesh& mesh, SharedEdits& edits, const CollapsePlan& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const Contraction& c = plan.contraction;
  if (c.position != mesh.position(c.kept)) edits.move(c.kept, c.position);
  find_edits(mesh, c, plan.stars);
  for (const StarFace& f : plan.stars[0])
    if (f.uses(c.kept)) edits.destroy_unused(f.face);
  edits.rebind(rebindings_);
  edits.destroy_unused(c.deleted);
}

void Collapser::make(Mesh& mesh, const Contraction& c, const StarPair& stars) {
  find_edits(mesh, c, stars);
  for (const StarFace& f : stars[0])
    if (f.uses(c.kept)) mesh.destroy_unused(f.face);
  mesh.rebind(rebindings_);
  edges_.merge(mesh);
  destroy_bare_edges(mesh, c.kept);
  if (edges_.collapsed().valid()) mesh.destroy_unused(edges_.collapsed());
  mesh.destroy_unused(c.deleted);
}

}  // namespace aomd
