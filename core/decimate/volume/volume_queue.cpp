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
  queue_.remove(v, partition_.part_of(v));
}

// An edge is a candidate of its end with the smaller id.
void VolumeQualityLoop::fill_queue() {
  part_count_ = parts_now();
  partition_ = part_count_ > 1 ? Partition(mesh_, part_count_, 0, options_.threads) : Partition();
  queue_.reset(mesh_.capacity(0), part_count_);
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
    if (state_[v].partner.valid()) put(v, state_[v].cost);
  rounds_.begin(goal_, part_count_);
}

// All candidates of a vertex, cheapest first.
void VolumeQualityLoop::find_candidates(Vertex v, Hand& hand) {
  std::vector<Candidate>& found = hand.found;
  found.clear();
  look_around(v, hand.scratch, [&](Vertex w) {
    if (w < v) return;
    if (const float known = cost(v, w); known < unlimited) found.push_back({w, known});
  });
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.other < b.other);
  });
}

bool VolumeQualityLoop::advance_collapse() {
  if (part_count_ > 1) return advance_collapse_in_turn();
  const Vertex v = rounds_.next();
  waiting_ = v.valid() && state_[v].cost > patience_;
  if (!v.valid() || waiting_) {
    begin_improvement();
    return false;
  }
  alone_.within_part = false;
  return try_vertex(v, alone_);
}

// What costs too much for now leaves the queue, which is filled again for the next descent.
bool VolumeQualityLoop::advance_collapse_in_turn() {
  const Vertex v = rounds_.next();
  if (!v.valid()) {
    waiting_ = waiting_ && !reached();
    begin_improvement();
    return false;
  }
  alone_.within_part = rounds_.in_part();
  alone_.part = partition_.part_of(v);
  return try_vertex(v, alone_);
}

// One vertex: its cheapest candidate that is allowed, as long as nothing else in the queue is
// cheaper.
bool VolumeQualityLoop::try_vertex(Vertex v, Hand& hand) {
  if (state_[v].cost > patience_) {
    (hand.edits ? hand.waits : waiting_) = true;
    return false;
  }
  const Vertex partner = state_[v].partner;
  if (hand.within_part && (!is_inside(v) || (partner.valid() && must_wait(v, partner, hand)))) {
    rounds_.leave(hand.part, v);
    return false;
  }
  return (partner.valid() && collapse(v, partner, hand)) || try_others(v, hand);
}

// The cheapest candidate is not known any more, or not allowed.
bool VolumeQualityLoop::try_others(Vertex v, Hand& hand) {
  const float known = state_[v].cost;
  const Vertex refused = state_[v].partner;
  find_candidates(v, hand);
  dequeue(v);
  for (std::size_t i = 0; i < hand.found.size(); ++i) {
    const Candidate c = hand.found[i];
    if (c.other == refused) continue;
    if (c.cost > known && !queue_.is_next(c.cost, partition_.part_of(v))) {
      know(v, i, hand);
      put(v, c.cost);
      return false;
    }
    if (must_wait(v, c.other, hand)) {
      know(v, i, hand);
      rounds_.leave(hand.part, v);
      return false;
    }
    if (collapse(v, c.other, hand)) return true;
  }
  return false;
}

// By the i-th of all its candidates.
void VolumeQualityLoop::know(Vertex v, std::size_t i, const Hand& hand) {
  State& s = state_[v];
  s.partner = hand.found[i].other;
  s.cost = hand.found[i].cost;
  s.second = i + 1 < hand.found.size() ? hand.found[i + 1].cost : unlimited;
}

// A vertex that is gone is in no region; whether one is alive the mesh only knows when all parts
// are done, but what happens to another part's vertices is not to be looked at.
bool VolumeQualityLoop::is_there(Vertex partner, Vertex of) const {
  if (!partner.valid() || !mesh_.alive(partner)) return false;
  return partition_.part_of(partner) != partition_.part_of(of) || !mesh_.row<3>(partner).empty();
}

void VolumeQualityLoop::update(Vertex v, Vertex kept, float cost) {
  State& s = state_[v];
  if (!s.update(kept, cost, is_there(s.partner, v))) return;
  if (s.cost < unlimited)
    put(v, s.cost);
  else
    queue_.remove(v, partition_.part_of(v));
}

void VolumeQualityLoop::refresh_around(Vertex kept, Hand& hand) {
  dequeue(kept);
  look_around(kept, hand.scratch, [&](Vertex w) {
    const float known = cost(kept, w);
    if (kept < w) state_[kept].offer(w, known);
    update(w, kept, w < kept ? known : unlimited);
  });
  if (state_[kept].partner.valid()) put(kept, state_[kept].cost);
}

}  // namespace aomd
