// How the quality strategy contracts an edge of a volume: where the kept vertex may go, and which
// of these places is taken.

#include <algorithm>
#include <cmath>

#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

double worst_of(const Mesh& mesh, const Ball& ball, Vertex other, const glm::dvec3& x, double worst,
                double enough) {
  for (const BallRegion& r : ball) {
    if (r.uses(other)) continue;
    worst = std::min(worst, tet_shape(x, mesh.position(r.others[0]), mesh.position(r.others[1]),
                                      mesh.position(r.others[2])));
    if (worst < enough) return worst;
  }
  return worst;
}

}  // namespace

// Whether the place is free, or one of the ends stays where it is: on a lower model entity, by the
// user's wish, or on the model, where no place between is as good as one on it.
VolumeQualityLoop::Freedom VolumeQualityLoop::freedom_of(Vertex v, Vertex w) const {
  const int dim_v = state_[v].model.dimension(), dim_w = state_[w].model.dimension();
  const bool v_stays = dim_v < dim_w || options_.kept(v),
             w_stays = dim_w < dim_v || options_.kept(w);
  if (v_stays && w_stays) return Freedom::None;
  if (v_stays) return Freedom::OntoFirst;
  if (w_stays) return Freedom::OntoSecond;
  if (dim_v == 3 || (!options_.model && options_.has(Idea::Placement))) return Freedom::Any;
  return state_[v].quadric.trace() > state_[w].quadric.trace() ? Freedom::OntoFirst
                                                               : Freedom::OntoSecond;
}

// The third power of the distance, summed over the area: few large errors count more than many
// small ones. By the size, to which the length of the edge is held too.
float VolumeQualityLoop::surface_cost(const LocalQuadric& quadric, const glm::vec3& x,
                                      float size2) const {
  const float squares = surface_ * std::max(0.0f, quadric(x)) / (size2 * size2);
  return squares * std::sqrt(squares);
}

// The smallest shape of the tetrahedra that a contraction stretches; as soon as it is below
// `enough`, something below it.
double VolumeQualityLoop::worst_shape(const Contraction& c, const Scratch& scratch,
                                      double enough) const {
  const bool first_goes = scratch.places.front().contraction.deleted == c.deleted;
  const Ball &gone = scratch.balls[first_goes ? 0 : 1], &stays = scratch.balls[first_goes ? 1 : 0];
  const double worst = worst_of(mesh_, gone, c.kept, c.position, 1, enough);
  return worst < enough ? worst : worst_of(mesh_, stays, c.deleted, c.position, worst, enough);
}

// Fills the places where an edge may be contracted to, the first of which deletes the first vertex.
void VolumeQualityLoop::find_places(Vertex v, Vertex w, Scratch& scratch) const {
  scratch.places.clear();
  scratch.balance.begin(mesh_.position(w));
  gather(mesh_, v, scratch.balls[0]);
  gather(mesh_, w, scratch.balls[1]);
  const bool on_model = state_[v].model.dimension() < 3 && state_[w].model.dimension() < 3;
  if (on_model)
    places_on_model(v, w, scratch);
  else
    places_inside(v, w, scratch);
}

void VolumeQualityLoop::places_inside(Vertex v, Vertex w, Scratch& scratch) const {
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  auto& places = scratch.places;
  switch (freedom_of(v, w)) {
    case Freedom::OntoFirst:
      places = {{{w, v, from}, 0}};
      return;
    case Freedom::OntoSecond:
      places = {{{v, w, to}, 0}};
      return;
    case Freedom::Any:
      places = {{{v, w, to}, 0}, {{v, w, 0.5 * (from + to)}, 0}, {{v, w, from}, 0}};
      keep_best_shape(scratch);
      return;
    case Freedom::None:
      return;
  }
}

void VolumeQualityLoop::keep_best_shape(Scratch& scratch) const {
  double best = -1;
  Place chosen = scratch.places.front();
  for (const Place& p : scratch.places)
    if (const double shape = worst_shape(p.contraction, scratch, best); shape > best) {
      best = shape;
      chosen = p;
    }
  scratch.places.assign(1, chosen);
}

void VolumeQualityLoop::places_on_model(Vertex v, Vertex w, Scratch& scratch) const {
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  const Freedom freedom = freedom_of(v, w);
  if (freedom == Freedom::None) return;
  if (options_.keep_volumes) scratch.balance.add(mesh_, v, scratch.balls[0], w, scratch.balls[1]);
  debts_.charge(v, scratch.balance.conditions());
  debts_.charge(w, scratch.balance.conditions());
  scratch.quadric = state_[v].quadric.about(in_units(to - from));
  scratch.quadric += state_[w].quadric;
  if (freedom == Freedom::OntoFirst)
    add_place({w, v, from}, scratch);
  else if (freedom == Freedom::OntoSecond)
    add_place({v, w, to}, scratch);
  else if (state_[v].model.dimension() == 1 && straight_curve(v, w, scratch.star))
    places_along(v, w, scratch);
  else
    places_between(v, w, scratch);
}

// With what it costs the surface; the quadric is seen from where the conditions are.
void VolumeQualityLoop::add_place(const Contraction& c, Scratch& scratch) const {
  const float size2 = state_[c.deleted].size * state_[c.kept].size;
  const glm::vec3 x = in_units(c.position - scratch.balance.origin());
  scratch.places.push_back({c, surface_cost(scratch.quadric, x, size2)});
}

// On a straight model edge: where the quadric is least along it, or the ends.
void VolumeQualityLoop::places_along(Vertex v, Vertex w, Scratch& scratch) const {
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w), along = from - to;
  const double length = glm::length(along);
  const PlacementLimits limits{0.5 * along, 0.5 * length, 0};
  add_place({v, w, to + least_on_line(of_positions(scratch.quadric), along / length, limits)},
            scratch);
  add_place({v, w, to}, scratch);
  add_place({w, v, from}, scratch);
}

// Where the quadric is least under the conditions; then next to the middle and the ends, which may
// be better for the shape.
void VolumeQualityLoop::places_between(Vertex v, Vertex w, Scratch& scratch) const {
  const glm::dvec3 to = mesh_.position(w), along = mesh_.position(v) - to;
  const double length = glm::length(along);
  const PlacementLimits limits{0.5 * along, 0.5 * length, paid_at_once * length};
  const auto conditions = scratch.balance.conditions();
  find_planes(v, w, scratch);
  const glm::dvec3 best =
      least_under(of_positions(scratch.quadric), scratch.planes, conditions, limits);
  const glm::dvec3 away = best - limits.middle;
  if (glm::dot(away, away) <= 4 * length * length) add_place({v, w, to + best}, scratch);
  for (const double share : {0.5, 0.0, 1.0})
    add_place({v, w, to + nearest_under(scratch.planes, conditions, limits, share * along)},
              scratch);
}

void VolumeQualityLoop::find_planes(Vertex v, Vertex w, Scratch& scratch) const {
  scratch.planes.clear();
  for (const Vertex end : {v, w}) {
    gather_model_faces(mesh_, end, scratch.star);
    scratch.planes.add(mesh_, end, scratch.star);
  }
}

// Whether the model edge runs straight from the vertex before these two to the one after them.
bool VolumeQualityLoop::straight_curve(Vertex v, Vertex w, Star& star) const {
  constexpr double straight = 1e-10;  // of the squared sine
  const ModelRef model = state_[v].model;
  const glm::dvec3 along = mesh_.position(w) - mesh_.position(v);
  bool all = true;
  for (const Vertex end : {v, w}) {
    gather_model_faces(mesh_, end, star);
    for_edges_at(mesh_, end, star, [&](Edge e, Vertex far) {
      if (mesh_.classification(e) != model) return;
      const glm::dvec3 next = mesh_.position(far) - mesh_.position(end),
                       across = glm::cross(along, next);
      all = all &&
            glm::dot(across, across) <= straight * glm::dot(along, along) * glm::dot(next, next);
    });
  }
  return all;
}

// Another place is worth it as long as nothing else in the queue costs less.
float VolumeQualityLoop::worst_cost(float best) { return 2 * best + 0.25f; }

Verdict VolumeQualityLoop::judge(Vertex v, Vertex w, Scratch& scratch, Plan& plan,
                                 RegionCollapser& collapser) {
  find_places(v, w, scratch);
  Verdict furthest{Reason::Classification, v};
  const float most = scratch.places.empty() ? 0 : worst_cost(scratch.places.front().cost);
  for (const Place& p : scratch.places) {
    if (p.cost > most) continue;
    Verdict verdict = collapser.judge(mesh_, p.contraction, rules_, plan.collapse);
    if (verdict.accepted())
      verdict = judge_debts(p.contraction.position - scratch.balance.origin(), scratch);
    if (verdict.accepted())
      verdict = guards_.judge(mesh_, plan.change, p.contraction, plan.collapse.around_deleted(),
                              plan.collapse.around_kept());
    if (verdict.accepted()) return verdict;
    if (check_order(verdict.reason) >= check_order(furthest.reason)) furthest = verdict;
  }
  return furthest;
}

void VolumeQualityLoop::note_refusal(Vertex v, Vertex w, const Verdict& verdict, Hand& hand) {
  SweepStatistics& sweep = hand.edits ? hand.made : sweeps_.back();
  ++sweep.refused[static_cast<std::size_t>(verdict.reason)];
  if (!mesh_.complete(1)) return;
  if (const Edge e = mesh_.find_edge(v, w); e.valid() && e.index < refusal_.size())
    refusal_[e] = verdict.reason;
}

bool VolumeQualityLoop::collapse(Vertex v, Vertex w, Hand& hand) {
  Plan& plan = hand.plan;
  const Verdict verdict = judge(v, w, hand.scratch, plan, hand.collapser);
  if (!verdict.accepted()) {
    note_refusal(v, w, verdict, hand);
    return false;
  }
  const Contraction c = plan.collapse.contraction;
  take_over(c, mesh_.position(w), hand.scratch);
  if (hand.edits)
    hand.collapser.apply(mesh_, *hand.edits, plan.collapse);
  else
    hand.collapser.apply(mesh_, plan.collapse);
  refresh_around(c.kept, hand);
  stir(c.kept);
  count(c, hand);
  return true;
}

void VolumeQualityLoop::count(const Contraction& c, Hand& hand) {
  if (hand.within_part) {
    rounds_.took(hand.part, hand.plan.collapse.regions_gone());
  } else {
    partition_.joined(mesh_, c.kept);
  }
  if (hand.edits)
    ++hand.made.collapses;
  else
    Loop::made(StepKind::Collapse, c.kept, hand.plan.change);
}

// What the vertex that goes stood for becomes the kept one's.
void VolumeQualityLoop::take_over(const Contraction& c, const glm::dvec3& origin,
                                  const Scratch& scratch) {
  dequeue(c.deleted);
  State &kept = state_[c.kept], &gone = state_[c.deleted];
  if (gone.model.dimension() < 3) {
    const LocalQuadric stays = kept.quadric.about(in_units(c.position - mesh_.position(c.kept)));
    kept.quadric = gone.quadric.about(in_units(c.position - mesh_.position(c.deleted)));
    kept.quadric += stays;
    debts_.hand_over(c.deleted, c.kept);
    debts_.settle(c.kept, c.position - origin, scratch.balance.conditions());
  }
  kept.size = 0.5f * (kept.size + gone.size);
}

}  // namespace aomd
