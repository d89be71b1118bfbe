#include "core/decimate/quality_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aomd {
namespace {

constexpr float unlimited = std::numeric_limits<float>::infinity();

}  // namespace

// Where an end lies on a model edge or vertex only the rest of the model edge may follow it; the surface
// beside it gives way.
std::optional<QualityLoop::Candidate> QualityLoop::candidate(Vertex v, Vertex w) const {
  const ModelRef on_v = mesh_.classification(v), on_w = mesh_.classification(w);
  const int dim_v = on_v.dimension(), dim_w = on_w.dimension();
  if (dim_v == 0 && dim_w == 0) return {};
  if (dim_v == dim_w && on_v != on_w) return {};
  if (!short_enough(v, w)) return {};
  const bool v_stays = options_.kept(v), w_stays = options_.kept(w);
  if (v_stays && w_stays) return {};
  Candidate c{{v, w, mesh_.position(w)}, 0};
  if (dim_w > dim_v || (v_stays && dim_v == dim_w)) c.contraction = {w, v, mesh_.position(v)};
  if (options_.kept(c.contraction.deleted)) return {};
  const State &at_v = state_[v], &at_w = state_[w];
  Quadric q = at_v.quadric;
  q += at_w.quadric;
  const glm::dvec3 along = mesh_.position(v) - mesh_.position(w);
  const double length2 = glm::dot(along, along);
  glm::dvec3& x = c.contraction.position;
  if (dim_v == dim_w && !v_stays && !w_stays &&
      options_.model) {  // on the model no place between is as good as one on it
    if (q(mesh_.position(v)) < q(x)) c.contraction = {w, v, mesh_.position(v)};
  } else if (dim_v == dim_w && !v_stays && !w_stays) {
    constexpr double steady = 1e-3;  // of the quadric's trace: flat places leave the minimum open otherwise
    const glm::dvec3 middle = 0.5 * (mesh_.position(v) + mesh_.position(w));
    if (!q.minimum(middle, steady * q.trace(), x) || glm::dot(x - middle, x - middle) > 4 * length2)
      x = middle;
  }
  const double area = double(at_v.area + at_w.area);
  c.cost = scale_ * (third_power(std::max(0.0, q(x)), area) + edge_weight_ * area * length2);
  return c;
}

// Squared distances become third powers, nearly: few large errors count more than many small ones.
double QualityLoop::third_power(double squares, double area) const {
  return area > 0 ? squares * std::sqrt(squares / area) / typical_ : squares;
}

bool QualityLoop::short_enough(Vertex v, Vertex w) const {
  const float reach = std::max(state_[v].reach, state_[w].reach);
  if (reach == std::numeric_limits<float>::infinity()) return true;
  return glm::length(mesh_.position(v) - mesh_.position(w)) < double(reach);
}

// Each neighbour once: as the next one around, or at the end of an open ring as the previous one.
template <typename Visit>
void QualityLoop::for_neighbours(Vertex v, Visit&& visit) {
  gather(mesh_, v, star_);
  const bool open = is_open(star_);
  for (const StarFace& f : star_) {
    visit(f.next);
    if (open &&
        std::none_of(star_.begin(), star_.end(), [&](const StarFace& g) { return g.next == f.previous; }))
      visit(f.previous);
  }
}

// All candidates at a vertex, cheapest first.
void QualityLoop::find_candidates(Vertex v) {
  found_.clear();
  for_neighbours(v, [&](Vertex w) {
    if (const auto c = candidate(v, w)) found_.push_back(*c);
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
  for (const Vertex v : mesh_.vertices())
    for_neighbours(v, [&](Vertex w) {
      if (w < v) return;
      const auto c = candidate(v, w);
      if (!c) return;
      offer(state_[v], w, static_cast<float>(c->cost));
      offer(state_[w], v, static_cast<float>(c->cost));
    });
  for (const Vertex v : mesh_.vertices())
    if (state_[v].partner.valid()) queue_.put(v, state_[v].cost);
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is cheaper.
bool QualityLoop::advance_collapse() {
  const std::uint32_t goal = goals_[stage_];
  const Vertex v = goal > 0 && mesh_.count(2) <= goal ? Vertex() : queue_.pop();
  if (!v.valid()) {
    begin_improvement();
    return false;
  }
  if (const Vertex partner = state_[v].partner; partner.valid())
    if (const auto c = candidate(v, partner); c && collapse(*c)) return true;
  return try_others(v);
}

// The cheapest candidate is not known any more, or not allowed.
bool QualityLoop::try_others(Vertex v) {
  const float known = state_[v].cost;
  find_candidates(v);
  dequeue(v);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Candidate c = found_[i];
    const float cost = static_cast<float>(c.cost);
    if (cost > known && !queue_.is_next(cost)) {
      State& s = state_[v];
      s.partner = c.contraction.kept == v ? c.contraction.deleted : c.contraction.kept;
      s.cost = cost;
      s.second = i + 1 < found_.size() ? static_cast<float>(found_[i + 1].cost) : unlimited;
      queue_.put(v, cost);
      return false;
    }
    if (collapse(c)) return true;
  }
  return false;
}

Verdict QualityLoop::judge(const Contraction& c) {
  Verdict verdict = collapser_.judge(mesh_, c, rules_);
  for (std::size_t end = 0; end < 2 && verdict.accepted(); ++end)
    verdict = judge_facing(collapser_.star(end), c);
  return verdict;
}

// Small turns add up; so every face is also held against what the original looked like around its corners.
Verdict QualityLoop::judge_facing(const Star& star, const Contraction& c) const {
  static const TurnLimit most(60);
  const glm::vec3 own = state_[c.deleted].normal + state_[c.kept].normal;
  for (const StarFace& f : star) {
    if (f.uses(c.kept) || f.uses(c.deleted)) continue;
    const glm::dvec3 original(own + state_[f.next].normal + state_[f.previous].normal);
    const glm::dvec3 now = area_normal(c.position, mesh_.position(f.next), mesh_.position(f.previous));
    if (!most.allows(original, now)) return {Reason::Angle, f.face, cosine_between(original, now)};
  }
  return {};
}

bool QualityLoop::collapse(const Candidate& candidate) {
  const Contraction& c = candidate.contraction;
  const Verdict verdict = judge(c);
  if (!verdict.accepted()) {
    ++sweeps_.back().refused[static_cast<std::size_t>(verdict.reason)];
    if (mesh_.stored(0, 1))
      if (const Edge e = mesh_.find_edge(c.deleted, c.kept); e.valid() && e.index < refusal_.size())
        refusal_[e] = verdict.reason;
    return false;
  }
  dequeue(c.deleted);
  state_[c.kept].quadric += state_[c.deleted].quadric;
  state_[c.kept].area += state_[c.deleted].area;
  state_[c.kept].normal += state_[c.deleted].normal;
  original_.merged(c.deleted, c.kept);
  collapser_.apply_accepted(mesh_, c);
  refresh_around(c.kept);
  made(StepKind::Collapse, c.kept);
  return true;
}

// The edge from `v` to the vertex that has taken another in has a new cost; others at `v` have not become
// cheaper.
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
  for_neighbours(kept, [&](Vertex w) {
    const auto c = candidate(kept, w);
    const float cost = c ? static_cast<float>(c->cost) : unlimited;
    if (c) offer(state_[kept], w, cost);
    update(w, kept, cost);
  });
  if (state_[kept].partner.valid()) queue_.put(kept, state_[kept].cost);
}

Verdict QualityLoop::judge(Edge edge, Vertex& deleted) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  if (!short_enough(a, b)) return {Reason::Spacing, edge, glm::length(mesh_.position(a) - mesh_.position(b))};
  if (options_.kept(a) && options_.kept(b)) return {Reason::Kept, a};
  const auto c = candidate(a, b);
  if (!c) return {Reason::Classification, mesh_.classification(a).dimension() == 0 ? a : b};
  deleted = c->contraction.deleted;
  return judge(c->contraction);
}

Reason QualityLoop::last_refusal(Edge e) const {
  return e.index < refusal_.size() ? refusal_[e] : Reason::None;
}

double QualityLoop::spacing(Vertex v) const {
  return v.index < state_.size() ? 2.0 * double(state_[v].reach) : 0;
}

}  // namespace aomd
