#include "core/decimate/quality/collapse_queue.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

// Neighbours are fetched together, so that the wait for memory is one and not six.
void prefetch(const void* place) { __builtin_prefetch(place); }

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

float CollapseQueue::cost(Vertex v, Vertex w, Contraction& c) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const glm::dvec3 from = mesh_.position(v), to = mesh_.position(w);
  const glm::vec3 along(from - to);
  const float length2 = glm::dot(along, along);
  if (!may_collapse(v, w, double(length2))) return unlimited;
  if (on_curves(v, w)) return cost_along_curve(v, w, c);
  const Freedom freedom = freedom_of(v, w);
  if (freedom == Freedom::None) return unlimited;
  EdgeView<float> edge{at_v.quadric.about(-along), along, length2, at_v.area + at_w.area};
  edge.quadric += at_w.quadric;  // all as seen from w
  if (!values_) return cost_at(rules_, edge, place(v, w, freedom, edge, c));
  const LocalQuadric beside = attributes_.together(v, w, along);
  EdgeView<float> both = edge;
  both.quadric += beside;
  const glm::vec3 x = place(v, w, freedom, both, c);
  return cost_at(rules_, edge, x) + cost_beside(rules_, beside, x);
}

// Which end goes where, and that place as seen from w.
glm::vec3 CollapseQueue::place(Vertex v, Vertex w, Freedom freedom, const EdgeView<float>& edge,
                               Contraction& c) const {
  const glm::dvec3 to = mesh_.position(w);
  if (freedom == Freedom::OntoFirst) {
    c = {w, v, mesh_.position(v)};
    return edge.along;
  }
  c = {v, w, to};
  if (freedom != Freedom::Any) return glm::vec3(0.0f);
  const glm::vec3 x = place_of_least(edge);
  c.position = to + glm::dvec3(x);
  return x;
}

// Whether a vertex may go anywhere on what it lies on.
bool CollapseQueue::roams(Vertex v) const {
  return state_[v].model.dimension() > 1 && rules_.places && !options_.model && !options_.kept(v);
}

EdgeView<Lanes> CollapseQueue::view_of_four(const State& at_v, const FourStates& others,
                                            const std::array<glm::vec3, Lanes::count>& along) {
  EdgeView<Lanes> edges;
  edges.along = {Lanes::each([&](std::size_t i) { return along[i].x; }),
                 Lanes::each([&](std::size_t i) { return along[i].y; }),
                 Lanes::each([&](std::size_t i) { return along[i].z; })};
  edges.length2 = glm::dot(edges.along, edges.along);
  edges.area = Lanes(at_v.area) + Lanes::each([&](std::size_t i) { return others[i]->area; });
  edges.quadric = QuadricOf<Lanes>(at_v.quadric).about(-edges.along);
  edges.quadric += QuadricOf<Lanes>::of_each(
      [&](std::size_t i) -> const LocalQuadric& { return others[i]->quadric; });
  return edges;
}

// As costs() would without them, and what they add.
Lanes CollapseQueue::costs_with_values(Vertex v, std::span<const Vertex> others,
                                       const EdgeView<Lanes>& edges) const {
  std::array<LocalQuadric, Lanes::count> each;
  for (std::size_t i = 0; i < others.size(); ++i)
    each[i] =
        attributes_.together(v, others[i], {edges.along.x[i], edges.along.y[i], edges.along.z[i]});
  const auto beside =
      QuadricOf<Lanes>::of_each([&](std::size_t i) -> const LocalQuadric& { return each[i]; });
  EdgeView<Lanes> both = edges;
  both.quadric += beside;
  const auto x = place_of_least(both);
  return cost_at(rules_, edges, x) + cost_beside(rules_, beside, x);
}

// What cost() says of up to four edges from one vertex: those whose ends may go anywhere are
// computed together, others one by one.
CollapseQueue::FourCosts CollapseQueue::costs(Vertex v, std::span<const Vertex> others) const {
  FourStates at;
  std::array<glm::vec3, Lanes::count> along;
  for (std::size_t i = 0; i < Lanes::count; ++i) {
    const Vertex w = others[std::min(i, others.size() - 1)];
    at[i] = &state_[w];
    along[i] = glm::vec3(mesh_.position(v) - mesh_.position(w));
  }
  const EdgeView<Lanes> edges = view_of_four(state_[v], at, along);
  const Lanes together =
      values_ ? costs_with_values(v, others, edges) : cost_at(rules_, edges, place_of_least(edges));
  const bool free = roams(v);
  FourCosts result;
  for (std::size_t i = 0; i < others.size(); ++i) {
    Contraction c;
    if (!free || at[i]->model != state_[v].model || options_.kept(others[i]))
      result[i] = cost(v, others[i], c);
    else
      result[i] = may_collapse(v, others[i], double(edges.length2[i])) ? together[i] : unlimited;
  }
  return result;
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
  const LocalQuadric beside = values_ ? attributes_.together(v, w, along) : LocalQuadric();
  c = freedom == Freedom::OntoFirst ? Contraction{w, v, from} : Contraction{v, w, to};
  Quadric all(q);
  if (values_) all += Quadric(beside);
  if (freedom == Freedom::Any) c.position = least_on_curve(place, all, from, to);
  const CurveError e = curves_.error(mesh_, place, c.position);
  const float area = at_v.area + at_w.area;
  const float strip = static_cast<float>(e.length * e.length / rules_.unit_area);
  const float squares = static_cast<float>(e.squares * e.length / rules_.unit_area);
  const glm::vec3 x(c.position - to);
  return price(rules_, q(x) + squares, area + strip) + cost_beside(rules_, beside, x) +
         rules_.edge_weight * area * glm::dot(along, along) * rules_.scale;
}

// Where the quadric, which is about `to`, and the error of the curve together are least: which
// piece of the curve a point is nearest to depends on the place, so twice.
glm::dvec3 CollapseQueue::least_on_curve(const CurvePlace& place, const Quadric& quadric,
                                         const glm::dvec3& from, const glm::dvec3& to) const {
  constexpr float steady = 1e-3f;  // of the quadric's trace: straight pieces leave it open else
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
  if (options_.seal_kept && (options_.kept(v) || options_.kept(w))) return Freedom::None;
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

// Calls visit(neighbour, cost) for the edges to the wanted neighbours.
template <typename Wanted, typename Visit>
void CollapseQueue::for_costs(Vertex v, Star& star, const Wanted& wanted, Visit&& visit) const {
  std::array<Vertex, Lanes::count> others;
  std::size_t count = 0;
  const auto finish = [&] {
    if (count == 0) return;
    const FourCosts found = costs(v, std::span(others).first(count));
    for (std::size_t i = 0; i < count; ++i) visit(others[i], found[i]);
    count = 0;
  };
  look_around(v, star, [&](Vertex w) {
    if (!wanted(w)) return;
    others[count++] = w;
    if (count == others.size()) finish();
  });
  finish();
}

// All candidates of a vertex, cheapest first. An edge is a candidate of its end with the smaller
// id.
void CollapseQueue::find_candidates(Vertex v, Turn& turn) const {
  look_around(v, turn.star, [&](Vertex w) {
    if (w < v) return;
    Candidate c;
    c.cost = cost(v, w, c.contraction);
    if (c.cost < unlimited) turn.found.push_back(c);
  });
  std::sort(turn.found.begin(), turn.found.end(),
            [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
}

// A candidate that was not there before, or of which nothing better is known.
void CollapseQueue::dequeue(Vertex v) {
  state_[v].forget();
  order_.remove(v, parts_.part_of(v));
}

void CollapseQueue::fill() {
  order_.reset(mesh_.capacity(0), parts_.count());
  levels_.assign(parts_.count(), 0);
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 Star star;
                 each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                   const Vertex v(id);
                   if (crowded(mesh_, v)) return;
                   const auto is_later = [v](Vertex w) { return v < w; };
                   for_costs(v, star, is_later,
                             [&](Vertex w, float its_cost) { state_[v].offer(w, its_cost); });
                 });
               });
  for (const Vertex v : mesh_.vertices())
    if (state_[v].partner.valid()) put(v, state_[v].cost);
}

void CollapseQueue::reset(const CostRules& rules) {
  rules_ = rules;
  state_.assign(mesh_.capacity(0), {});
}

void CollapseQueue::measure(bool by_points) {
  normal_.assign(mesh_.capacity(0), glm::vec3(0.0f));
  for (const Vertex v : mesh_.vertices()) {
    State fresh;
    fresh.reach = state_[v].reach;
    fresh.model = mesh_.classification(v);
    state_[v] = fresh;
  }
  if (by_points)
    quadrics_of_points();
  else
    quadrics_of_faces();
  if (values_) add_values(by_points);
  fill();
}

void CollapseQueue::refill() {
  for (const Vertex v : mesh_.vertices()) dequeue(v);
  fill();
}

Vertex CollapseQueue::pop(std::size_t part, std::uint32_t last) {
  const Vertex v = order_.pop(part, last);
  if (v.valid()) levels_[part] = std::max(levels_[part], state_[v].cost);
  return v;
}

void CollapseQueue::even_out_levels() {
  std::fill(levels_.begin(), levels_.end(), *std::max_element(levels_.begin(), levels_.end()));
}

void CollapseQueue::wait(Vertex v, float cost) {
  State& s = state_[v];
  s.cost = s.second = cost;
  put(v, cost);
}

bool CollapseQueue::cheapest(Vertex v, Candidate& c) const {
  const Vertex partner = state_[v].partner;
  if (!partner.valid()) return false;
  c.cost = cost(v, partner, c.contraction);
  return c.cost < unlimited;
}

void CollapseQueue::take_all(Vertex v, Turn& turn) {
  turn.known = state_[v].cost;
  turn.found.clear();
  if (!crowded(mesh_, v)) find_candidates(v, turn);
  dequeue(v);
}

void CollapseQueue::remember(Vertex v, std::size_t i, float bound, const Turn& turn) {
  const Contraction& c = turn.found[i].contraction;
  State& s = state_[v];
  s.partner = c.kept == v ? c.deleted : c.kept;
  s.cost = turn.found[i].cost;
  s.second = i + 1 < turn.found.size() ? std::min(bound, turn.found[i + 1].cost) : bound;
}

bool CollapseQueue::put_off(Vertex v, std::size_t i, float bound, const Turn& turn) {
  const float present = turn.found[i].cost;
  if (!(present > turn.known) || order_.is_next(present, parts_.part_of(v))) return false;
  remember(v, i, bound, turn);
  put(v, present);
  return true;
}

void CollapseQueue::merge(const Contraction& c) {
  dequeue(c.deleted);
  State& kept = state_[c.kept];
  const glm::vec3 from_kept(c.position - mesh_.position(c.kept)),
      from_deleted(c.position - mesh_.position(c.deleted));
  const LocalQuadric stays = kept.quadric.about(from_kept);
  kept.quadric = state_[c.deleted].quadric.about(from_deleted);
  kept.quadric += stays;
  if (values_) attributes_.merge(c.deleted, from_deleted, c.kept, from_kept);
  kept.area += state_[c.deleted].area;
  add_normal(c.kept, normal_[c.deleted]);
}

void CollapseQueue::forget_lost_edges(const CollapsePlan& made, Turn& turn) {
  const Vertex kept = made.contraction.kept;
  gather(mesh_, kept, turn.star);
  for (const StarFace& f : made.around_deleted()) {
    if (!f.uses(kept)) continue;
    const Vertex third = f.third(kept);
    const auto uses_third = [third](const StarFace& g) { return g.uses(third); };
    if (std::none_of(turn.star.begin(), turn.star.end(), uses_third))
      update(third, made.contraction, unlimited);
  }
}

// The partner that a vertex knows is one of its neighbours, so that only the last collapse can have
// ended it.
void CollapseQueue::update(Vertex v, Vertex other, const Contraction& made, float cost) {
  State& s = state_[v];
  if (!s.update(other, cost, s.partner.valid() && s.partner != made.deleted)) return;
  if (s.cost < unlimited)
    put(v, s.cost);
  else
    order_.remove(v, parts_.part_of(v));
}

void CollapseQueue::refresh_around(const Contraction& made, Turn& turn) {
  const Vertex kept = made.kept;
  dequeue(kept);
  const auto all = [](Vertex) { return true; };
  for_costs(kept, turn.star, all, [&](Vertex w, float known) {
    if (kept < w) state_[kept].offer(w, known);
    update(w, made, w < kept ? known : unlimited);
  });
  if (state_[kept].partner.valid()) put(kept, state_[kept].cost);
  if (curves_.inside(kept)) refresh_curve(made);
}

// What a collapse along a curve costs depends on where the vertices to either side are.
void CollapseQueue::refresh_curve(const Contraction& made) {
  for (const Vertex near : curves_.neighbours(made.kept)) {
    if (!curves_.inside(near)) continue;
    for (const Vertex far : curves_.neighbours(near)) {
      if (far == made.kept) continue;
      Contraction c;
      update(std::min(near, far), std::max(near, far), made, cost(near, far, c));
    }
  }
}

}  // namespace aomd
