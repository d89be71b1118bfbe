#include "core/decimate/quality/collapse_queue.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

// Neighbours are fetched together, so that the wait for memory is one and not six.
void prefetch(const void* place) { __builtin_prefetch(place); }

constexpr float inverse_typical =
    1e3f;  // of the distance, by the diagonal, whose third power is as large as its square
constexpr float steady =
    1e-3f;  // of the quadric's trace: flat places leave the minimum open otherwise

}  // namespace

// Where an end lies on a model edge or vertex only the rest of the model edge may follow it; the
// surface beside it gives way.
bool CollapseQueue::may_collapse(Vertex v, Vertex w, double length2) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const int dim_v = at_v.model.dimension(), dim_w = at_w.model.dimension();
  if (dim_v == dim_w && (dim_v == 0 || at_v.model != at_w.model)) return false;
  const double reach = std::max(at_v.reach, at_w.reach);
  return length2 < reach * reach;
}

// Squared distances become third powers, nearly: few large errors count more than many small ones.
float CollapseQueue::price(float squares, float area) const {
  const float scaled = std::max(0.0f, squares * rules_.scale);
  return rules_.cubes && area > 0 ? scaled * std::sqrt(scaled / area) * inverse_typical : scaled;
}

float CollapseQueue::cost(Vertex v, Vertex w, Contraction& c) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  const glm::vec3 along(from - to);
  const float length2 = glm::dot(along, along);
  if (!may_collapse(v, w, double(length2))) return unlimited;
  if (on_curves(v, w)) return cost_along_curve(v, w, c);
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
    const glm::vec3 middle = 0.5f * along;
    if (!q.minimum(middle, steady * q.trace(), x) ||
        !(glm::dot(x - middle, x - middle) <= 4 * length2))
      x = middle;
    c.position = to + glm::dvec3(x);
  }
  const float area = at_v.area + at_w.area;
  return price(q(x), area) + rules_.edge_weight * area * length2 * rules_.scale;
}

// A curve counts like a strip of surface as wide as the curve is long there: then an edge of it and
// an edge beside it go at the same error.
float CollapseQueue::cost_along_curve(Vertex v, Vertex w, Contraction& c) const {
  CurvePlace place;
  const Freedom freedom = freedom_of(v, w);
  if (freedom == Freedom::None || !curves_.between(v, w, place)) return unlimited;
  const State &at_v = state_[v], &at_w = state_[w];
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  const glm::vec3 along(from - to);
  LocalQuadric q = at_v.quadric.about(-along);  // all as seen from w
  q += at_w.quadric;
  c = freedom == Freedom::OntoFirst ? Contraction{w, v, from} : Contraction{v, w, to};
  if (freedom == Freedom::Any) c.position = least_on_curve(place, Quadric(q), from, to);
  const CurveError e = curves_.error(mesh_, place, c.position);
  const float area = at_v.area + at_w.area;
  const float strip = static_cast<float>(e.length * e.length / rules_.unit_area);
  const float squares = static_cast<float>(e.squares * e.length / rules_.unit_area);
  return price(q(glm::vec3(c.position - to)) + squares, area + strip) +
         rules_.edge_weight * area * glm::dot(along, along) * rules_.scale;
}

// Where the quadric, which is about `to`, and the error of the curve together are least: which
// piece of the curve a point is nearest to depends on the place, so twice.
glm::dvec3 CollapseQueue::least_on_curve(const CurvePlace& place, const Quadric& quadric,
                                         const glm::dvec3& from, const glm::dvec3& to) const {
  const glm::dvec3 middle = (from + to) / 2.0;
  const double length2 = glm::dot(from - to, from - to), length = curves_.length(place);
  glm::dvec3 x = middle;
  for (int i = 0; i < 2; ++i) {
    Quadric error = curves_.quadric(mesh_, place, x);
    error *= length / rules_.unit_area;
    error += quadric.about(x - to);
    glm::dvec3 step;
    if (!error.minimum(middle - x, double(steady) * error.trace(), step)) return middle;
    x += step;
    if (!(glm::dot(x - middle, x - middle) <= 4 * length2)) return middle;
  }
  return x;
}

// Whether the place is free, or one of the ends stays where it is: on a lower model entity, by the
// user's wish, or on the model, where no place between is as good as one on it.
CollapseQueue::Freedom CollapseQueue::freedom_of(Vertex v, Vertex w) const {
  const int dim_v = state_[v].model.dimension(), dim_w = state_[w].model.dimension();
  const bool along = dim_v <= 1 && dim_w <= 1;
  const bool v_stays = dim_v < dim_w || options_.kept(v) || (along && !curves_.inside(v)),
             w_stays = dim_w < dim_v || options_.kept(w) || (along && !curves_.inside(w));
  if (v_stays && w_stays) return Freedom::None;
  if (v_stays) return Freedom::OntoFirst;
  if (w_stays) return Freedom::OntoSecond;
  if (!options_.model && rules_.places) return Freedom::Any;
  return state_[v].area > state_[w].area ? Freedom::OntoFirst : Freedom::OntoSecond;
}

template <typename Visit>
void CollapseQueue::look_around(Vertex v, Star& star, Visit&& visit) const {
  gather(mesh_, v, star);
  for (const StarFace& f : star) {
    prefetch(&state_[f.next]);
    prefetch(&mesh_.position(f.next));
  }
  for_neighbours(star, visit);
}

// All candidates of a vertex, cheapest first. An edge is a candidate of its end with the smaller
// id.
void CollapseQueue::find_candidates(Vertex v) {
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
void CollapseQueue::dequeue(Vertex v) {
  state_[v].forget();
  order_.remove(v);
}

void CollapseQueue::fill() {
  order_.reset(mesh_.capacity(0));
  level_ = 0;
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 Star star;
                 each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                   const Vertex v(id);
                   if (crowded(mesh_, v)) return;
                   look_around(v, star, [&](Vertex w) {
                     if (w < v) return;
                     Contraction c;
                     state_[v].offer(w, cost(v, w, c));
                   });
                 });
               });
  for (const Vertex v : mesh_.vertices())
    if (state_[v].partner.valid()) order_.put(v, state_[v].cost);
}

void CollapseQueue::reset(const CostRules& rules) {
  rules_ = rules;
  state_.assign(mesh_.capacity(0), {});
}

void CollapseQueue::measure(bool by_points) {
  normal_.assign(mesh_.capacity(0), glm::vec3(0.0f));
  const auto measure = [&](std::uint32_t id) {
    const Vertex v(id);
    State fresh;
    fresh.reach = state_[v].reach;
    fresh.model = mesh_.classification(v);
    state_[v] = fresh;
    if (!by_points) quadric_of_faces(v);
  };
  parallel_for(
      mesh_.capacity(0), options_.threads, vertices_a_piece,
      [&](std::size_t begin, std::size_t end) { each_alive(mesh_.ids(0), begin, end, measure); });
  if (by_points) quadrics_of_points();
  fill();
}

void CollapseQueue::refill() {
  for (const Vertex v : mesh_.vertices()) dequeue(v);
  fill();
}

Vertex CollapseQueue::pop() {
  const Vertex v = order_.pop();
  if (v.valid()) level_ = std::max(level_, state_[v].cost);
  return v;
}

void CollapseQueue::wait(Vertex v, float cost) {
  State& s = state_[v];
  s.cost = s.second = cost;
  order_.put(v, cost);
}

bool CollapseQueue::cheapest(Vertex v, Candidate& c) const {
  const Vertex partner = state_[v].partner;
  if (!partner.valid()) return false;
  c.cost = cost(v, partner, c.contraction);
  return c.cost < unlimited;
}

const std::vector<CollapseQueue::Candidate>& CollapseQueue::take_all(Vertex v) {
  known_ = state_[v].cost;
  found_.clear();
  if (!crowded(mesh_, v)) find_candidates(v);
  dequeue(v);
  return found_;
}

bool CollapseQueue::put_off(Vertex v, std::size_t i, float bound) {
  const auto& [c, present] = found_[i];
  if (!(present > known_) || order_.is_next(present)) return false;
  State& s = state_[v];
  s.partner = c.kept == v ? c.deleted : c.kept;
  s.cost = present;
  s.second = i + 1 < found_.size() ? std::min(bound, found_[i + 1].cost) : bound;
  order_.put(v, present);
  return true;
}

void CollapseQueue::merge(const Contraction& c) {
  dequeue(c.deleted);
  State& kept = state_[c.kept];
  const LocalQuadric stays = kept.quadric.about(glm::vec3(c.position - mesh_.position(c.kept)));
  kept.quadric = state_[c.deleted].quadric.about(glm::vec3(c.position - mesh_.position(c.deleted)));
  kept.quadric += stays;
  kept.area += state_[c.deleted].area;
  add_normal(c.kept, normal_[c.deleted]);
}

void CollapseQueue::forget_lost_edges(const CollapsePlan& made) {
  const Vertex kept = made.contraction.kept;
  gather(mesh_, kept, star_);
  for (const StarFace& f : made.around_deleted()) {
    if (!f.uses(kept)) continue;
    const Vertex third = f.third(kept);
    const auto uses_third = [third](const StarFace& g) { return g.uses(third); };
    if (std::none_of(star_.begin(), star_.end(), uses_third)) update(third, kept, unlimited);
  }
}

void CollapseQueue::update(Vertex v, Vertex kept, float cost) {
  State& s = state_[v];
  if (!s.update(kept, cost, s.partner.valid() && mesh_.alive(s.partner))) return;
  if (s.cost < unlimited)
    order_.put(v, s.cost);
  else
    order_.remove(v);
}

void CollapseQueue::refresh_around(Vertex kept) {
  dequeue(kept);
  look_around(kept, star_, [&](Vertex w) {
    Contraction c;
    const float known = cost(kept, w, c);
    if (kept < w) state_[kept].offer(w, known);
    update(w, kept, w < kept ? known : unlimited);
  });
  if (state_[kept].partner.valid()) order_.put(kept, state_[kept].cost);
  if (curves_.inside(kept)) refresh_curve(kept);
}

// What a collapse along a curve costs depends on where the vertices to either side are.
void CollapseQueue::refresh_curve(Vertex kept) {
  for (const Vertex near : curves_.neighbours(kept)) {
    if (!curves_.inside(near)) continue;
    for (const Vertex far : curves_.neighbours(near)) {
      if (far == kept) continue;
      Contraction c;
      update(std::min(near, far), std::max(near, far), cost(near, far, c));
    }
  }
}

}  // namespace aomd
