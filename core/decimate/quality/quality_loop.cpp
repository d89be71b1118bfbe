#include "core/decimate/quality/quality_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

// Neighbours are fetched together, so that the wait for memory is one and not six.
void prefetch(const void* place) { __builtin_prefetch(place); }

constexpr float inverse_typical =
    1e3f;  // of the distance, by the diagonal, whose third power is as large as its square

}  // namespace

// Where an end lies on a model edge or vertex only the rest of the model edge may follow it; the
// surface beside it gives way.
bool QualityLoop::may_collapse(Vertex v, Vertex w, double length2) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const int dim_v = at_v.model.dimension(), dim_w = at_w.model.dimension();
  if (dim_v == dim_w && (dim_v == 0 || at_v.model != at_w.model)) return false;
  const double reach = std::max(at_v.reach, at_w.reach);
  return length2 < reach * reach;
}

// What the collapse of an edge costs, and which end goes where; infinite where it is out of the
// question.
float QualityLoop::cost(Vertex v, Vertex w, Contraction& c) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  const glm::vec3 along(from - to);
  const float length2 = glm::dot(along, along);
  if (!may_collapse(v, w, double(length2))) return unlimited;
  const Freedom freedom = freedom_of(v, w);
  if (freedom == Freedom::None) return unlimited;
  LocalQuadric q = at_v.quadric.about(-along);  // all as seen from w
  q += at_w.quadric;
  glm::vec3 x(0.0f);
  c = {v, w, to};
  if (freedom == Freedom::OntoFirst) {
    c = {w, v, from};
    x = along;
  } else if (freedom == Freedom::Any) {
    constexpr float steady =
        1e-3f;  // of the quadric's trace: flat places leave the minimum open otherwise
    const glm::vec3 middle = 0.5f * along;
    if (!q.minimum(middle, steady * q.trace(), x) ||
        !(glm::dot(x - middle, x - middle) <= 4 * length2))
      x = middle;
    c.position = to + glm::dvec3(x);
  }
  // Squared distances become third powers, nearly: few large errors count more than many small
  // ones.
  const float area = at_v.area + at_w.area, squares = std::max(0.0f, q(x) * scale_);
  const float error =
      cubes_ && area > 0 ? squares * std::sqrt(squares / area) * inverse_typical : squares;
  return error + edge_weight_ * area * length2 * scale_;
}

// Whether the place is free, or one of the ends stays where it is: on a lower model entity, by the
// user's wish, or on the model, where no place between is as good as one on it.
QualityLoop::Freedom QualityLoop::freedom_of(Vertex v, Vertex w) const {
  const int dim_v = state_[v].model.dimension(), dim_w = state_[w].model.dimension();
  const bool v_stays = dim_v < dim_w || options_.kept(v),
             w_stays = dim_w < dim_v || options_.kept(w);
  if (v_stays && w_stays) return Freedom::None;
  if (v_stays) return Freedom::OntoFirst;
  if (w_stays) return Freedom::OntoSecond;
  if (!options_.model && places_) return Freedom::Any;
  return state_[v].area > state_[w].area ? Freedom::OntoFirst : Freedom::OntoSecond;
}

template <typename Visit>
void QualityLoop::look_around(Vertex v, Star& star, Visit&& visit) const {
  gather(mesh_, v, star);
  for (const StarFace& f : star) {
    prefetch(&state_[f.next]);
    prefetch(&mesh_.position(f.next));
  }
  for_neighbours(star, visit);
}

// All candidates of a vertex, cheapest first. An edge is a candidate of its end with the smaller
// id.
void QualityLoop::find_candidates(Vertex v) {
  look_around(v, star_, [&](Vertex w) {
    if (w < v) return;
    Candidate c;
    c.cost = cost(v, w, c.contraction);
    if (c.cost < unlimited) found_.push_back(c);
  });
  std::sort(found_.begin(), found_.end(),
            [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
}

// A candidate that was not there before, or of which nothing better is known.
void QualityLoop::offer(State& state, Vertex partner, float cost) {
  if (cost < state.cost) {
    state.second = state.cost;
    state.cost = cost;
    state.partner = partner;
  } else {
    state.second = std::min(state.second, cost);
  }
}

void QualityLoop::dequeue(Vertex v) {
  State& s = state_[v];
  s.partner = {};
  s.cost = s.second = unlimited;
  queue_.remove(v);
}

void QualityLoop::fill_queue() {
  queue_.reset(mesh_.capacity(0));
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 Star star;
                 each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                   const Vertex v(id);
                   if (crowded(mesh_, v)) return;
                   look_around(v, star, [&](Vertex w) {
                     if (w < v) return;
                     Contraction c;
                     offer(state_[v], w, cost(v, w, c));
                   });
                 });
               });
  for (const Vertex v : mesh_.vertices())
    if (state_[v].partner.valid()) queue_.put(v, state_[v].cost);
}

// A mesh of slivers cannot reach its target without making some. Then only what the user asked for
// binds.
bool QualityLoop::relax() {
  const bool stuck = goals_[stage_] > 0 && mesh_.count(2) > goals_[stage_];
  if (!stuck || !rules_.least_around.binds()) return false;
  rules_.least_around = LeastAngle(0);
  fit_.least_angle = rules_.least_angle;
  for (const Vertex v : mesh_.vertices()) dequeue(v);
  fill_queue();
  return true;
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is
// cheaper.
bool QualityLoop::advance_collapse() {
  const std::uint32_t goal = goals_[stage_];
  const Vertex v = goal > 0 && mesh_.count(2) <= goal ? Vertex() : queue_.pop();
  if (!v.valid()) {
    if (!relax()) begin_improvement();
    return false;
  }
  if (const Vertex partner = state_[v].partner; partner.valid())
    if (Contraction c; cost(v, partner, c) < unlimited && collapse(c)) return true;
  return try_others(v);
}

// The cheapest candidate is not known any more, or not allowed.
bool QualityLoop::try_others(Vertex v) {
  const float known = state_[v].cost;
  found_.clear();
  if (!crowded(mesh_, v)) find_candidates(v);
  dequeue(v);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Contraction c = found_[i].contraction;
    const float present = found_[i].cost;
    if (present > known && !queue_.is_next(present)) {
      State& s = state_[v];
      s.partner = c.kept == v ? c.deleted : c.kept;
      s.cost = present;
      s.second = i + 1 < found_.size() ? found_[i + 1].cost : unlimited;
      queue_.put(v, present);
      return false;
    }
    if (collapse(c)) return true;
  }
  return false;
}

Verdict QualityLoop::judge(const Contraction& c, Plan& plan) {
  const CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser_.judge(mesh_, c, rules_, plan.collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, c, collapse.around_deleted(), collapse.around_kept());
}

bool QualityLoop::collapse(const Contraction& c) {
  const Verdict verdict = judge(c, plan_);
  if (!verdict.accepted()) {
    ++sweeps_.back().refused[static_cast<std::size_t>(verdict.reason)];
    if (mesh_.stored(0, 1))
      if (const Edge e = mesh_.find_edge(c.deleted, c.kept); e.valid() && e.index < refusal_.size())
        refusal_[e] = verdict.reason;
    return false;
  }
  dequeue(c.deleted);
  State& kept = state_[c.kept];
  const LocalQuadric stays = kept.quadric.about(glm::vec3(c.position - mesh_.position(c.kept)));
  kept.quadric = state_[c.deleted].quadric.about(glm::vec3(c.position - mesh_.position(c.deleted)));
  kept.quadric += stays;
  kept.area += state_[c.deleted].area;
  add_normal(c.kept, normal_[c.deleted]);
  original_.merged(c.deleted, c.kept);
  collapser_.apply(mesh_, plan_.collapse);
  refresh_around(c.kept);
  if (rules_.topology == TopologyRule::Paper) forget_lost_edges(plan_.collapse);
  made(StepKind::Collapse, c.kept, plan_.change);
  return true;
}

// Without the link condition a third vertex of the faces that went may have no face with the kept
// one any more: then their edge is no candidate.
void QualityLoop::forget_lost_edges(const CollapsePlan& made) {
  const Vertex kept = made.contraction.kept;
  gather(mesh_, kept, star_);
  for (const StarFace& f : made.around_deleted()) {
    if (!f.uses(kept)) continue;
    const Vertex third = f.third(kept);
    const auto uses_third = [third](const StarFace& g) { return g.uses(third); };
    if (std::none_of(star_.begin(), star_.end(), uses_third)) update(third, kept, unlimited);
  }
}

// The edge from `v` to the vertex that has taken another in has a new cost; others at `v` have not
// become cheaper.
void QualityLoop::update(Vertex v, Vertex kept, float cost) {
  State& s = state_[v];
  const bool known = s.partner.valid() && s.partner != kept && mesh_.alive(s.partner);
  if (known || cost < s.cost) {
    if (cost >= s.cost) {
      s.second = std::min(s.second, cost);
      return;
    }
    offer(s, kept, cost);
  } else if (cost <= s.second) {
    s.partner = kept;
    s.cost = cost;
  } else {
    s.partner = {};
    s.cost = s.second;
  }
  if (s.cost < unlimited)
    queue_.put(v, s.cost);
  else
    queue_.remove(v);
}

void QualityLoop::refresh_around(Vertex kept) {
  dequeue(kept);
  look_around(kept, star_, [&](Vertex w) {
    Contraction c;
    const float known = cost(kept, w, c);
    if (kept < w) offer(state_[kept], w, known);
    update(w, kept, w < kept ? known : unlimited);
  });
  if (state_[kept].partner.valid()) queue_.put(kept, state_[kept].cost);
}

}  // namespace aomd
