#include "core/operators/region_collapse.h"

#include <algorithm>

#include "core/base/assertion.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/shared_edits.h"
#include "core/operators/collapse_checks.h"

namespace aomd {
namespace {

// Whether the balls of both ends can be looked at.
Verdict judge_surroundings(const Mesh& mesh, const EdgeEnds& ends) {
  for (const Vertex v : ends) {
    if (const Region other = first_other_shape(mesh, v); other.valid())
      return {Reason::Kept, other};
    if (in_crowd(mesh, v)) return {Reason::Topology, v};
  }
  return {};
}

// Model faces are gathered where the edge lies on one: strata that the vertex which goes is not
// part of do not change.
void gather_ends(const Mesh& mesh, const EdgeEnds& ends, bool on_faces, VolumeCollapsePlan& plan) {
  for (std::size_t i = 0; i < 2; ++i) {
    gather(mesh, ends[i], plan.balls[i]);
    plan.stars[i].clear();
    if (on_faces) gather_model_faces(mesh, ends[i], plan.stars[i]);
  }
}

bool on_model_face(ModelRef model) { return model.dimension() <= 2; }

// What one end stretches on its way, index i of the plan.
Verdict judge_end(const Mesh& mesh, const VolumeCollapsePlan& plan, std::size_t i,
                  const EndMove& move, const VolumeRules& rules) {
  const Verdict v = judge_faces(mesh, plan.stars[i], move, rules.faces);
  return v.accepted() ? judge_regions(mesh, plan.balls[i], move, rules) : v;
}

// The face entity on three vertices, where it may be one.
Face face_on(const Mesh& mesh, Vertex a, const EdgeEnds& side) {
  return mesh.find_face(std::array{a, side[0], side[1]});
}

std::uint32_t slot_of(const Mesh& mesh, Face f, Vertex v) {
  const auto t = mesh.triangle(f);
  return std::uint32_t{t[1] == v} + 2 * std::uint32_t{t[2] == v};
}

// The two vertices of a tetrahedron beside the edge from its centre to `other`.
EdgeEnds beside(const BallRegion& r, Vertex other) {
  const auto& o = r.others;
  return o[0] == other ? EdgeEnds{o[1], o[2]} : EdgeEnds{o[0], o[1] == other ? o[2] : o[1]};
}

bool contains(const std::vector<Face>& faces, Face f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

}  // namespace

bool RegionCollapser::at_edge(Vertex v) const {
  return std::any_of(ring_.begin(), ring_.end(),
                     [&](const EdgeEnds& e) { return e[0] == v || e[1] == v; });
}

bool RegionCollapser::at_edge(Vertex a, Vertex b) const {
  return std::any_of(ring_.begin(), ring_.end(), [&](const EdgeEnds& e) {
    return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a);
  });
}

// A tetrahedron that stretches: none of its corners, edges and sides away from the centre may lie
// around the kept vertex too, unless it stands beside the edge.
Verdict RegionCollapser::judge_sides(const BallRegion& r, const Ball& kept) const {
  std::array<bool, 3> shared{};
  for (std::size_t k = 0; k < 3; ++k) {
    shared[k] = marks_.has(r.others[k]);
    if (shared[k] && !at_edge(r.others[k])) return {Reason::Topology, r.others[k]};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex a = r.others[k], b = r.others[(k + 1) % 3], c = r.others[(k + 2) % 3];
    if (!shared[k] || !shared[(k + 1) % 3]) continue;
    const bool beside = at_edge(a, b);
    for (const BallRegion& other : kept)
      if (other.uses(a) && other.uses(b) && (!beside || other.uses(c)))
        return {Reason::Topology, other.region};
  }
  return {};
}

// The link condition among the tetrahedra: what is common to the links of both ends is the link of
// the edge.
Verdict RegionCollapser::judge_balls(const Mesh& mesh, const EdgeEnds& ends, const Balls& balls) {
  marks_.clear(mesh);
  for_corners(balls[1], [&](Vertex v) { marks_.set(v); });
  ring_.clear();
  for (const BallRegion& r : balls[0])
    if (r.uses(ends[1])) ring_.push_back(beside(r, ends[1]));
  if (ring_.empty()) return {Reason::Topology, ends[0]};
  for (const BallRegion& r : balls[0]) {
    if (r.uses(ends[1])) continue;
    if (const Verdict v = judge_sides(r, balls[1]); !v.accepted()) return v;
  }
  return {};
}

// In every stratum that the edge is part of (Dey, Edelsbrunner, Guha, Nekhayev 1999): among model
// edges, model faces, and tetrahedra. The vertex that goes lies on what the edge lies on, so that
// the other strata do not change.
Verdict RegionCollapser::judge_topology(const Mesh& mesh, EntityRef edge, const EdgeEnds& ends,
                                        ModelRef model, const VolumeCollapsePlan& plan) {
  if (model.dimension() <= 1)
    if (const Vertex third = closes_chain(mesh, ends, plan.stars[0]); third.valid())
      return {Reason::Topology, third};
  if (on_model_face(model))
    if (const Verdict v = link_.judge(mesh, edge, ends, plan.stars, marks_); !v.accepted())
      return v;
  return judge_balls(mesh, ends, plan.balls);
}

Verdict RegionCollapser::judge_either(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                                      const VolumeRules& rules, VolumeCollapsePlan& plan) {
  const EdgeEnds ends = mesh.edge_vertices(edge);
  const ModelRef model = mesh.classification(edge);
  Verdict furthest = judge_classes(mesh, ends, model, may_go);
  if (!may_go[0] && !may_go[1]) return furthest;
  if (const Verdict v = judge_surroundings(mesh, ends); !v.accepted()) return v;
  gather_ends(mesh, ends, on_model_face(model), plan);
  if (const Verdict v = judge_topology(mesh, edge, ends, model, plan); !v.accepted()) return v;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!may_go[i]) continue;
    const Contraction c{ends[i], ends[1 - i], mesh.position(ends[1 - i])};
    Verdict v;
    if (model.dimension() == 1)
      v = judge_curve(mesh, plan.stars[i], model, c, rules.faces.max_curve_turn);
    if (v.accepted()) v = judge_end(mesh, plan, i, {c.deleted, c.kept, c.position}, rules);
    if (v.accepted()) {
      plan.contraction = c;
      if (i == 1) std::swap(plan.balls[0], plan.balls[1]);
      if (i == 1) std::swap(plan.stars[0], plan.stars[1]);
      return v;
    }
    if (check_order(v.reason) >= check_order(furthest.reason)) furthest = v;
  }
  return furthest;
}

Verdict RegionCollapser::judge_contraction(const Mesh& mesh, const Contraction& c,
                                           const VolumeRules& rules, VolumeCollapsePlan& plan) {
  if (const Verdict s = judge_surroundings(mesh, {c.deleted, c.kept}); !s.accepted()) return s;
  gather_ends(mesh, {c.deleted, c.kept}, on_model_face(mesh.classification(c.deleted)), plan);
  const ModelRef model = class_between(mesh, c.deleted, c.kept, plan.stars[0], plan.balls[0]);
  const bool moves = c.position != mesh.position(c.kept);
  if (const Verdict s = judge_classes(mesh, c, model, moves); !s.accepted()) return s;
  Verdict v = judge_topology(mesh, c.kept, {c.deleted, c.kept}, model, plan);
  const TurnLimit& turn = rules.faces.max_curve_turn;
  if (v.accepted() && model.dimension() == 1) v = judge_curve(mesh, plan.stars[0], model, c, turn);
  if (v.accepted() && moves && model.dimension() == 1)
    v = judge_rest_of_curve(mesh, plan.stars[1], model, c, turn);
  if (v.accepted()) v = judge_end(mesh, plan, 0, {c.deleted, c.kept, c.position}, rules);
  if (v.accepted() && moves) v = judge_end(mesh, plan, 1, {c.kept, c.deleted, c.position}, rules);
  return v;
}

Verdict RegionCollapser::judge(const Mesh& mesh, Edge edge, std::array<bool, 2> may_go,
                               const VolumeRules& rules, VolumeCollapsePlan& plan) {
  plan.edge = edge;
  plan.revision = mesh.revision();
  return plan.verdict = judge_either(mesh, edge, may_go, rules, plan);
}

Verdict RegionCollapser::judge(const Mesh& mesh, const Contraction& c, const VolumeRules& rules,
                               VolumeCollapsePlan& plan) {
  plan.edge = {};
  plan.contraction = c;
  plan.revision = mesh.revision();
  return plan.verdict = judge_contraction(mesh, c, rules, plan);
}

// The sides (deleted, x, y) and (kept, x, y) of a tetrahedron that goes fall together. Where both
// are entities the one on the lower class stays, so that a model face keeps its direction: one at
// the deleted vertex changes places with its double, of which the regions beyond then take leave.
void RegionCollapser::merge_sides(const Mesh& mesh, const Contraction& c, const EdgeEnds& side,
                                  const Ball& kept) {
  const Face mine = face_on(mesh, c.deleted, side);
  const Face theirs = mine.valid() ? face_on(mesh, c.kept, side) : Face();
  if (!theirs.valid()) return;
  if (mesh.classification(mine).dimension() >= mesh.classification(theirs).dimension()) {
    doubles_.push_back(mine);
    return;
  }
  doubles_.push_back(theirs);
  rebindings_.push_back({theirs, slot_of(mesh, theirs, c.kept), c.kept, c.deleted});
  for (const BallRegion& r : kept)
    if (r.uses(side[0]) && r.uses(side[1]) && !r.uses(c.deleted))
      regions_.push_back({r.region, r.slot, c.kept, c.kept});
}

void RegionCollapser::find_faces(const Mesh& mesh, const Contraction& c, const Balls& balls) {
  at_edge_.clear();
  doubles_.clear();
  const Row<2> faces = mesh.row<2>(c.deleted);
  if (faces.empty()) return;
  for (const BallRegion& r : balls[0])
    if (r.uses(c.kept)) merge_sides(mesh, c, beside(r, c.kept), balls[1]);
  for (std::size_t i = faces.size(); i-- > 0;) {
    const auto t = mesh.triangle(faces[i]);
    if (t[0] == c.kept || t[1] == c.kept || t[2] == c.kept)
      at_edge_.push_back(faces[i]);
    else if (!contains(doubles_, faces[i]))
      rebindings_.push_back({faces[i], slot_of(mesh, faces[i], c.deleted), c.deleted, c.kept});
  }
}

void RegionCollapser::find_regions(const VolumeCollapsePlan& plan) {
  const Contraction& c = plan.contraction;
  const Ball& ball = plan.balls[0];
  for (auto r = ball.rbegin(); r != ball.rend(); ++r)
    if (!r->uses(c.kept)) regions_.push_back({r->region, r->slot, c.deleted, c.kept});
}

// Entities in descending order: rows are sorted, so that each leaves the deleted vertex's row at
// its end.
void RegionCollapser::find_edits(const Mesh& mesh, const VolumeCollapsePlan& plan) {
  const Contraction& c = plan.contraction;
  rebindings_.clear();
  regions_.clear();
  edges_.find(mesh, c, plan.stars, marks_, rebindings_);
  find_faces(mesh, c, plan.balls);
  find_regions(plan);
  rebindings_.insert(rebindings_.end(), regions_.begin(), regions_.end());
}

void RegionCollapser::apply(Mesh& mesh, const VolumeCollapsePlan& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const Contraction& c = plan.contraction;
  const JournalScope step(mesh, StepKind::Collapse,
                          plan.edge.valid() ? EntityRef(plan.edge) : EntityRef(c.kept));
  if (c.position != mesh.position(c.kept)) mesh.move(c.kept, c.position);
  find_edits(mesh, plan);
  for (const BallRegion& r : plan.balls[0])
    if (r.uses(c.kept)) mesh.destroy_unused(r.region);
  for (const Face f : at_edge_) mesh.destroy_unused(f);
  mesh.rebind(rebindings_);
  for (const Face f : doubles_) mesh.destroy_unused(f);
  edges_.merge(mesh);
  if (edges_.collapsed().valid()) mesh.destroy_unused(edges_.collapsed());
  mesh.destroy_unused(c.deleted);
}

void RegionCollapser::apply(const Mesh& mesh, SharedEdits& edits, const VolumeCollapsePlan& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const Contraction& c = plan.contraction;
  if (c.position != mesh.position(c.kept)) edits.move(c.kept, c.position);
  regions_.clear();
  find_regions(plan);
  for (const BallRegion& r : plan.balls[0])
    if (r.uses(c.kept)) edits.destroy_unused(r.region);
  edits.rebind(regions_);
  edits.destroy_unused(c.deleted);
}

}  // namespace aomd
