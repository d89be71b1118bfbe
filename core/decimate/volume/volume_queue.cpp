// Which edge of a volume is next: the cheapest candidate of each vertex, by what it costs the model
// faces and by its length for the place.

#include <algorithm>

#include "core/base/parallel.h"
#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

void gather_neighbours(const Ball& ball, std::vector<Vertex>& neighbours) {
  neighbours.clear();
  for_corners(ball, [&](Vertex w) {
    if (std::find(neighbours.begin(), neighbours.end(), w) == neighbours.end())
      neighbours.push_back(w);
  });
}

bool uses(const Star& star, Vertex w) {
  return std::any_of(star.begin(), star.end(), [w](const StarFace& f) { return f.uses(w); });
}

}  // namespace

std::span<const Vertex> VolumeQualityLoop::neighbours_of(Vertex v, Scratch& scratch) const {
  gather(mesh_, v, scratch.balls[0]);
  gather_neighbours(scratch.balls[0], scratch.neighbours);
  return scratch.neighbours;
}

// Two vertices on model faces are joined by an edge that lies on one only where a face joins them:
// through a region nothing goes from one to the other.
template <typename Visit>
void VolumeQualityLoop::look_around(Vertex v, Scratch& scratch, Visit&& visit) const {
  if (!among_tets(v) || in_crowd(mesh_, v)) return;
  const std::span<const Vertex> around = neighbours_of(v, scratch);
  const bool inside = state_[v].model.dimension() == 3;
  if (!inside) gather_model_faces(mesh_, v, scratch.star);
  for (const Vertex w : around)
    if (inside || state_[w].model.dimension() == 3 || uses(scratch.star, w)) visit(w);
}

// Where an end lies on a lower model entity than the other it stays, and takes the other in.
bool VolumeQualityLoop::may_collapse(Vertex v, Vertex w, float length2) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const int dim_v = at_v.model.dimension(), dim_w = at_w.model.dimension();
  if (dim_v == dim_w && (dim_v == 0 || at_v.model != at_w.model)) return false;
  const float reach = std::max(at_v.reach, at_w.reach);
  return length2 < reach * reach;
}

// The squared length of the edge and the squared distance to the planes that its ends stand for,
// both by the squared size there: so one number says how far model faces may lag behind regions.
float VolumeQualityLoop::cost(Vertex v, Vertex w) const {
  const State &at_v = state_[v], &at_w = state_[w];
  const glm::vec3 along = in_units(mesh_.position(v) - mesh_.position(w));
  const float length2 = glm::dot(along, along);
  if (!may_collapse(v, w, length2)) return unlimited;
  const Freedom freedom = freedom_of(v, w);
  if (freedom == Freedom::None) return unlimited;
  const float size = at_v.size * at_w.size;
  if (!(size > 0)) return unlimited;
  const float shape = length2 / size;
  if (at_v.model.dimension() == 3 || at_w.model.dimension() == 3) return shape;
  LocalQuadric q = at_v.quadric.about(-along);  // all as seen from w
  q += at_w.quadric;
  glm::vec3 x = freedom == Freedom::OntoFirst ? along : glm::vec3(0.0f);
  if (freedom == Freedom::Any &&
      (!q.minimum(0.5f * along, 1e-3f * q.trace(), x) || glm::dot(x, x) > 4 * length2))
    x = 0.5f * along;
  return surface_cost(q, x, size) + shape;
}

void VolumeQualityLoop::dequeue(Vertex v) {
  state_[v].forget();
  queue_.remove(v);
}

// An edge is a candidate of its end with the smaller id.
void VolumeQualityLoop::fill_queue() {
  queue_.reset(mesh_.capacity(0));
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 Scratch scratch;
                 each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                   const Vertex v(id);
                   State& s = state_[v];
                   s.forget();
                   look_around(v, scratch, [&](Vertex w) {
                     if (v < w) s.offer(w, cost(v, w));
                   });
                 });
               });
  for (const Vertex v : mesh_.vertices())
    if (state_[v].partner.valid()) queue_.put(v, state_[v].cost);
}

// All candidates of a vertex, cheapest first.
void VolumeQualityLoop::find_candidates(Vertex v) {
  found_.clear();
  look_around(v, scratch_, [&](Vertex w) {
    if (w < v) return;
    if (const float known = cost(v, w); known < unlimited) found_.push_back({w, known});
  });
  std::sort(found_.begin(), found_.end(), [](const Candidate& a, const Candidate& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.other < b.other);
  });
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is
// cheaper.
bool VolumeQualityLoop::advance_collapse() {
  const Vertex v = reached() ? Vertex() : queue_.pop();
  waiting_ = v.valid() && state_[v].cost > patience_;
  if (!v.valid() || waiting_) {
    begin_improvement();
    return false;
  }
  if (const Vertex partner = state_[v].partner; partner.valid() && collapse(v, partner))
    return true;
  return try_others(v);
}

// The cheapest candidate is not known any more, or not allowed.
bool VolumeQualityLoop::try_others(Vertex v) {
  const float known = state_[v].cost;
  const Vertex refused = state_[v].partner;
  find_candidates(v);
  dequeue(v);
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Candidate c = found_[i];
    if (c.other == refused) continue;
    if (c.cost > known && !queue_.is_next(c.cost)) {
      State& s = state_[v];
      s.partner = c.other;
      s.cost = c.cost;
      s.second = i + 1 < found_.size() ? found_[i + 1].cost : unlimited;
      queue_.put(v, c.cost);
      return false;
    }
    if (collapse(v, c.other)) return true;
  }
  return false;
}

void VolumeQualityLoop::update(Vertex v, Vertex kept, float cost) {
  State& s = state_[v];
  if (!s.update(kept, cost, s.partner.valid() && mesh_.alive(s.partner))) return;
  if (s.cost < unlimited)
    queue_.put(v, s.cost);
  else
    queue_.remove(v);
}

void VolumeQualityLoop::refresh_around(Vertex kept) {
  dequeue(kept);
  look_around(kept, scratch_, [&](Vertex w) {
    const float known = cost(kept, w);
    if (kept < w) state_[kept].offer(w, known);
    update(w, kept, w < kept ? known : unlimited);
  });
  if (state_[kept].partner.valid()) queue_.put(kept, state_[kept].cost);
}

}  // namespace aomd
