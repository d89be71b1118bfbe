#include "core/operators/collapse.h"

#include <algorithm>

#include "core/base/assertion.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/journal.h"
#include "core/mesh/journal_scope.h"

namespace aomd {
namespace {

// The cosine of the smallest angle of all faces around a vertex.
double smallest_angle_around(const Mesh& mesh, const Star& star, const glm::dvec3& centre) {
  double cosine = 0.5;
  for (const StarFace& f : star)
    cosine = std::max(
        cosine, smallest_angle_cosine(centre, mesh.position(f.next), mesh.position(f.previous)));
  return cosine;
}

}  // namespace

Collapser::Collapser(const Mesh& mesh)
    : mark_(mesh.capacity(0), 0), edge_to_kept_(mesh.capacity(0)) {
  AOMD_CHECK(mesh.representation().down(2, 0).stride() == 3);
}

void Collapser::next_stamp(const Mesh& mesh) {
  if (mark_.size() < mesh.capacity(0)) {
    mark_.resize(mesh.capacity(0), 0);
    edge_to_kept_.resize(mesh.capacity(0));
  }
  if (++stamp_ != 0) return;
  mark_.assign(mark_.size(), 0);
  stamp_ = 1;
}

void Collapser::mark_neighbours(Vertex kept, const Star& star) {
  for (const StarFace& f : star) mark_[f.next] = mark_[f.previous] = stamp_;
  mark_[kept] = stamp_;
}

// The third vertices of the faces at the edge. False where two of them are one: those faces enclose
// a pocket.
bool Collapser::gather_apexes(const Star& star, Vertex other_end) {
  apexes_.clear();
  for (const StarFace& f : star) {
    if (!f.uses(other_end)) continue;
    const Vertex apex = f.third(other_end);
    if (apex_bit(apex) != 0) return false;
    apexes_.push_back(apex);
  }
  return true;
}

// One bit for each apex; those past the 63rd share the last, which only makes a later check look
// closer.
std::uint64_t Collapser::apex_bit(Vertex v) const {
  for (std::size_t i = 0; i < apexes_.size(); ++i)
    if (apexes_[i] == v) return std::uint64_t{1} << std::min<std::size_t>(i, 63);
  return 0;
}

// The two other edges of a removed face fall together. If neither has a further face, the one that
// stays has none.
bool Collapser::leaves_bare_edge(const Ends& ends, const Stars& stars, Vertex apex) {
  for (std::size_t i = 0; i < 2; ++i)
    for (const StarFace& f : stars[i])
      if (f.uses(apex) && !f.uses(ends[1 - i])) return false;
  return true;
}

// Whether the faces that stay around both ends hang together beside the edge, from apex to apex:
// else they would meet in nothing but the kept vertex.
bool Collapser::stay_together(const Ends& ends, const Stars& stars) const {
  std::vector<Vertex> around;
  const auto for_staying = [&](auto&& visit) {
    for (std::size_t i = 0; i < 2; ++i)
      for (const StarFace& f : stars[i])
        if (!f.uses(ends[1 - i])) visit(f);
  };
  for_staying([&](const StarFace& f) { around.insert(around.end(), {f.next, f.previous}); });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  const auto place = [&](Vertex v) {
    return static_cast<std::uint32_t>(std::lower_bound(around.begin(), around.end(), v) -
                                      around.begin());
  };
  DisjointSets sheets(around.size());
  for_staying([&](const StarFace& f) { sheets.unite(place(f.next), place(f.previous)); });
  const auto ends_here = [&](Vertex apex) {  // no face is left beside the edge: judged elsewhere
    return !std::binary_search(around.begin(), around.end(), apex);
  };
  const auto first = std::find_if_not(apexes_.begin(), apexes_.end(), ends_here);
  return std::all_of(first, apexes_.end(), [&](Vertex apex) {
    return ends_here(apex) || sheets.find(place(apex)) == sheets.find(place(*first));
  });
}

// What the faces around the kept vertex need to form no more fans than before. Two apexes: the
// edge must not cut both fans in two, as it does between two points of the border.
bool Collapser::keeps_fans(const Ends& ends, const Stars& stars) const {
  if (apexes_.empty()) return stars[0].empty() || stars[1].empty();
  if (apexes_.size() == 2) return !is_open(stars[0]) || !is_open(stars[1]);
  return apexes_.size() == 1 || stay_together(ends, stars);
}

// The link condition, which is the same whichever end goes: the ends share no neighbour beyond the
// apexes of their faces, no two faces fall together, no pocket closes, no two fans meet in one
// vertex, and no edge loses its last face. A collapse then takes one vertex, k faces and k + 1
// edges: the Euler number stays.
Verdict Collapser::judge_topology(const Mesh& mesh, EntityRef edge, const Ends& ends,
                                  const Stars& stars) {
  next_stamp(mesh);
  mark_neighbours(ends[1], stars[1]);
  if (!gather_apexes(stars[0], ends[1])) return {Reason::Topology, edge};
  if (!keeps_fans(ends, stars)) return {Reason::Topology, edge};
  std::uint64_t has_further_face = 0;
  for (const StarFace& f : stars[0]) {
    const bool next = marked(f.next), previous = marked(f.previous);
    if (!(next | previous) || f.uses(ends[1])) continue;
    const std::uint64_t next_bit = next ? apex_bit(f.next) : 0,
                        previous_bit = previous ? apex_bit(f.previous) : 0;
    if (next && !next_bit) return {Reason::Topology, f.next};
    if (previous && !previous_bit) return {Reason::Topology, f.previous};
    has_further_face |= next_bit | previous_bit;
    if (!next || !previous) continue;
    for (const StarFace& g : stars[1])
      if (g.uses(f.next) && g.uses(f.previous)) return {Reason::Topology, g.face};
  }
  for (const Vertex apex : apexes_)
    if (!(has_further_face & apex_bit(apex)) && leaves_bare_edge(ends, stars, apex))
      return {Reason::Topology, apex};
  return {};
}

// The faces that stay when `moved` goes to `to`; those that also use `other` fall away.
Verdict Collapser::judge_geometry(const Mesh& mesh, const Star& star, const Move& move,
                                  const CollapseRules& rules) {
  const glm::dvec3 from = mesh.position(move.vertex), to = move.to;
  for (const StarFace& f : star) {
    if (f.uses(move.other)) continue;
    const glm::dvec3 p = mesh.position(f.next), q = mesh.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    if (is_flat(to, p, q, after)) return {Reason::Flat, f.face};
    if (!rules.max_turn.allows(before, after) && !is_flat(from, p, q, before))
      return {Reason::Angle, f.face, cosine_between(before, after)};
    if (rules.original_normals) {
      const Column<Vertex, glm::vec3>& normals = *rules.original_normals;
      const glm::dvec3 original(normals[move.vertex] + normals[move.other] + normals[f.next] +
                                normals[f.previous]);
      if (original != glm::dvec3(0.0) && !rules.max_away.allows(original, after))
        return {Reason::Angle, f.face, cosine_between(original, after)};
    }
    if (!rules.least_angle.binds() && !rules.least_around.binds()) continue;
    const double cosine = smallest_angle_cosine(to, p, q);
    if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }) ||
        !rules.least_around.allows(cosine, [&] { return smallest_angle_around(mesh, star, from); }))
      return {Reason::Shape, f.face, cosine};
  }
  return {};
}

// The curve u - deleted - kept becomes u - kept: neither of its two old directions may turn too
// far.
Verdict Collapser::judge_curve(const Mesh& mesh, const Star& star, ModelRef model,
                               const Contraction& c, const TurnLimit& limit) {
  Verdict verdict;
  const glm::dvec3 from = mesh.position(c.deleted);
  for_edges_at(mesh, c.deleted, star, [&](Edge e, Vertex far) {
    if (far == c.kept || mesh.classification(e) != model || !verdict.accepted()) return;
    const glm::dvec3 start = mesh.position(far), now = c.position - start;
    for (const glm::dvec3& old : {from - start, c.position - from})
      if (!limit.allows(old, now)) verdict = {Reason::Angle, e, cosine_between(old, now)};
  });
  return verdict;
}

// The rest of the curve beyond the kept vertex, where that moves.
Verdict Collapser::judge_rest_of_curve(const Mesh& mesh, const Star& star, ModelRef model,
                                       const Contraction& c, const TurnLimit& limit) {
  Verdict verdict;
  for_edges_at(mesh, c.kept, star, [&](Edge e, Vertex far) {
    if (far == c.deleted || mesh.classification(e) != model || !verdict.accepted()) return;
    const glm::dvec3 end = mesh.position(far), old = end - mesh.position(c.kept),
                     now = end - c.position;
    if (!limit.allows(old, now)) verdict = {Reason::Angle, e, cosine_between(old, now)};
  });
  return verdict;
}

Verdict Collapser::judge_either(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                                const CollapseRules& rules, CollapsePlan& plan) {
  const auto ends = mesh.edge_vertices(edge);
  const ModelRef model = mesh.classification(edge);
  Verdict furthest;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!may_go[i]) continue;
    const ModelRef own = mesh.classification(ends[i]);
    may_go[i] = own == model && own.dimension() != 0;
    if (!may_go[i] && furthest.accepted()) furthest = {Reason::Classification, ends[i]};
  }
  if (!may_go[0] && !may_go[1]) return furthest;
  for (const Vertex v : ends)
    if (crowded(mesh, v)) return {Reason::Topology, v};
  for (std::size_t i = 0; i < 2; ++i) gather(mesh, ends[i], plan.stars[i]);
  if (rules.topology == TopologyRule::Safe)
    if (const Verdict v = judge_topology(mesh, edge, ends, plan.stars); !v.accepted()) return v;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!may_go[i]) continue;
    const Contraction c{ends[i], ends[1 - i], mesh.position(ends[1 - i])};
    Verdict v = judge_geometry(mesh, plan.stars[i], {c.deleted, c.kept, c.position}, rules);
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
                                     const CollapseRules& rules, Stars& stars) {
  for (const Vertex v : {c.deleted, c.kept})
    if (crowded(mesh, v)) return {Reason::Topology, v};
  gather(mesh, c.deleted, stars[0]);
  gather(mesh, c.kept, stars[1]);
  const ModelRef model = class_between(mesh, c.deleted, c.kept, stars[0]);
  const bool moves = c.position != mesh.position(c.kept);
  for (const Vertex v : {c.deleted, c.kept})
    if (const ModelRef own = mesh.classification(v);
        (v == c.deleted || moves) && (own != model || own.dimension() == 0))
      return {Reason::Classification, v};
  if (rules.topology == TopologyRule::Safe)
    if (const Verdict v = judge_topology(mesh, c.kept, {c.deleted, c.kept}, stars); !v.accepted())
      return v;
  Verdict v = judge_geometry(mesh, stars[0], {c.deleted, c.kept, c.position}, rules);
  if (v.accepted() && moves)
    v = judge_geometry(mesh, stars[1], {c.kept, c.deleted, c.position}, rules);
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
  return plan.verdict = judge_either(mesh, edge, may_go, rules, plan);
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

// Marks the vertices at the other ends of the edges at `kept`. Judging goes by faces; here an edge
// without faces must find its twin too.
void Collapser::mark_edges(const Mesh& mesh, Vertex kept, const Star& star) {
  next_stamp(mesh);
  for_edges_at(mesh, kept, star, [&](Edge e, Vertex far) {
    mark_[far] = stamp_;
    edge_to_kept_[far] = e;
  });
}

// Entities in descending order: rows are sorted, so that each leaves the deleted vertex's row at
// its end.
void Collapser::find_edits(const Mesh& mesh, const Contraction& c, const Stars& stars) {
  merges_.clear();
  rebindings_.clear();
  collapsed_ = {};
  for_edges_at(mesh, c.deleted, stars[0], [&](Edge e, Vertex far) {
    if (far == c.kept)
      collapsed_ = e;
    else if (marked(far))
      merges_.push_back({e, edge_to_kept_[far]});
    else
      rebindings_.push_back(
          {e, mesh.edge_vertices(e)[0] == c.deleted ? 0u : 1u, c.deleted, c.kept});
  });
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

void Collapser::merge_edges(Mesh& mesh) {
  for (const Merge& m : merges_) {
    const ModelRef gone = mesh.classification(m.gone);
    if (gone.dimension() < mesh.classification(m.survivor).dimension())
      mesh.set_classification(m.survivor, gone);
    mesh.destroy_unused(m.gone);
  }
}

// Without the link condition an edge may lose its last face; then it goes too.
void Collapser::destroy_bare_edges(Mesh& mesh, Vertex kept) {
  for (const Vertex apex : bare_)
    if (const Edge e = mesh.find_edge(kept, apex); e.valid()) mesh.destroy_unused(e);
}

void Collapser::apply(Mesh& mesh, Edge edge, Vertex deleted) {
  const Vertex kept = mesh.other_end(edge, deleted);
  Stars stars;
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

void Collapser::make(Mesh& mesh, const Contraction& c, const Stars& stars) {
  mark_edges(mesh, c.kept, stars[1]);
  find_edits(mesh, c, stars);
  for (const StarFace& f : stars[0])
    if (f.uses(c.kept)) mesh.destroy_unused(f.face);
  mesh.rebind(rebindings_);
  merge_edges(mesh);
  destroy_bare_edges(mesh, c.kept);
  if (collapsed_.valid()) mesh.destroy_unused(collapsed_);
  mesh.destroy_unused(c.deleted);
}

}  // namespace aomd
