// Passes of the quality strategy over tetrahedra and vertices: edges and faces are removed around
// poor tetrahedra, and vertices go where those around them are better.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/id_pool.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/smooth.h"

namespace aomd {
namespace {

// At right angles to `n`; of no length in particular.
glm::dvec3 across(const glm::dvec3& n) {
  return glm::cross(n, std::abs(n.x) < std::abs(n.y) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
}

}  // namespace

bool VolumeQualityLoop::advance_swap() {
  bool made = false;
  if (!improvement_.next_swap(made)) end_phase();
  return made;
}

// Whatever an operation makes has a vertex of those that it stirs.
bool VolumeQualityLoop::looks_at(Region poor) {
  const auto t = mesh_.tetrahedron(poor);
  return std::any_of(t.begin(), t.end(), [&](Vertex v) { return stir_[v] >= stir_limit_; });
}

// What the strategy holds against a removal that the operator has accepted.
Verdict VolumeQualityLoop::judge_removal(const EdgeRemoval& plan, Change& change) {
  const EdgeRing& ring = plan.ring;
  change.clear();
  if (options_.kept(ring.a) && options_.kept(ring.b)) return {Reason::Kept, ring.a};
  if (!ring.on_model_face()) return {};
  const EdgePair pair{ring.faces[0], ring.faces[1], ring.a, ring.b, ring.apexes[0], ring.apexes[1]};
  if (!keeps_close(ring)) return {Reason::Distance, ring.a, diagonals_apart(ring)};
  if (const Verdict v = judge_debts(plan); !v.accepted()) return v;
  if (keeps_face_of(pair)) return {Reason::Kept, ring.a};
  return guards_.judge(mesh_, change, pair);
}

// The last one that is allowed is the one that is made.
bool VolumeQualityLoop::allows(const EdgeRemoval& plan) {
  if (!judge_removal(plan, plan_.change).accepted()) return false;
  std::swap(allowed_, plan_.change);
  return true;
}

bool VolumeQualityLoop::allows(const FaceRemoval&) {
  allowed_.clear();
  return true;
}

void VolumeQualityLoop::made(const EdgeRemoval& plan) {
  const EdgeRing& ring = plan.ring;
  if (ring.on_model_face()) note_gains(plan);
  stir(ring.a);
  stir(ring.b);
  Loop::made(StepKind::Swap, ring.a, allowed_);
}

void VolumeQualityLoop::made(const FaceRemoval& plan) {
  for (const Vertex v : plan.apexes) stir(v);
  Loop::made(StepKind::Swap, plan.regions[0], allowed_);
}

// How far the other diagonal of two faces runs beside the first one; infinite where both have one
// direction.
double VolumeQualityLoop::diagonals_apart(const EdgeRing& ring) const {
  const glm::dvec3 a = mesh_.position(ring.a), b = mesh_.position(ring.b),
                   c = mesh_.position(ring.apexes[0]), d = mesh_.position(ring.apexes[1]);
  const double area = glm::length(glm::cross(b - a, d - c));
  return area > 0 ? std::abs(six_volumes(a, b, c, d)) / area
                  : std::numeric_limits<double>::infinity();
}

// By so much at most that the cost of the distance is that of a short edge.
bool VolumeQualityLoop::keeps_close(const EdgeRing& ring) const {
  const double apart = diagonals_apart(ring);
  const double size2 = size_of(ring.a) * size_of(ring.b);
  return double(surface_) * apart * apart / 8 <= size2;
}

bool VolumeQualityLoop::advance_smooth() {
  const bool in_turn = settling_ == 0 && part_count_ > 1;
  const std::uint32_t id =
      in_turn ? turns_.next(mesh_, options_.threads) : mesh_.ids(0).next_alive(cursor_);
  if (id >= mesh_.capacity(0)) {
    end_phase();
    return false;
  }
  cursor_ = id + 1;
  alone_.within_part = in_turn && turns_.in_part();
  alone_.part = turns_.part();
  return settling_ > 0 ? settle(Vertex(id)) : smooth_in_turn(Vertex(id), alone_);
}

// Only inside a region does a move change nothing but what lies around the vertex: on the model
// volumes are owed, and what they come to in all is asked for.
bool VolumeQualityLoop::smooth_in_turn(Vertex v, Hand& hand) {
  if (!hand.within_part || state_[v].model.dimension() == 3) return try_move(v, hand);
  turns_.leave(hand.part, v.index);
  return false;
}

bool VolumeQualityLoop::try_move(Vertex v, Hand& hand) {
  glm::dvec3 x;
  if (!options_.smooth || options_.kept(v) || !find_target(v, hand.scratch, x)) return false;
  return move(v, x, hand);
}

// Whether a vertex may go by `x`; the conditions and the model faces in the scratch are those at
// it.
Verdict VolumeQualityLoop::judge_move(Vertex v, const glm::dvec3& x, const Scratch& scratch,
                                      Change& change) {
  change.clear();
  if (state_[v].model.dimension() == 3) return {};
  if (const Verdict debts = judge_debts(x, scratch); !debts.accepted()) return debts;
  return guards_.judge(mesh_, change, v, scratch.star, mesh_.position(v) + x);
}

bool VolumeQualityLoop::move(Vertex v, const glm::dvec3& x, Hand& hand) {
  State& s = state_[v];
  if (!judge_move(v, x, hand.scratch, hand.plan.change).accepted()) return false;
  if (s.model.dimension() < 3) {
    s.quadric = s.quadric.about(in_units(x));
    debts_.settle(v, x, hand.scratch.balance.conditions());
  }
  stir(v);
  if (hand.edits) {
    hand.edits->move(v, mesh_.position(v) + x);
    ++hand.made.smooths;
    return true;
  }
  apply_smooth(mesh_, v, mesh_.position(v) + x);
  Loop::made(StepKind::Smooth, v, hand.plan.change);
  return true;
}

void VolumeQualityLoop::begin_relaxation(Vertex v, Scratch& scratch) const {
  scratch.relaxation.begin(mesh_, v, scratch.balls[0]);
  scratch.relaxation.limit_dihedrals(rules_.least_dihedral);
}

// Where the energy of the vertex is least, as far as one step tells; false where it stays.
bool VolumeQualityLoop::find_target(Vertex v, Scratch& scratch, glm::dvec3& x) {
  const State& s = state_[v];
  if (s.model.dimension() == 0 || !among_tets(v)) return false;
  gather(mesh_, v, scratch.balls[0]);
  VertexRelaxation& relaxation = scratch.relaxation;
  begin_relaxation(v, scratch);
  scratch.balance.begin(mesh_.position(v));
  if (s.model.dimension() == 3) return relaxation.step(floor_, glm::dvec3(0.0), x);
  FixedDirections fixed;
  glm::dvec3 shift(0.0);
  if (!fix_ways(v, scratch, fixed, shift)) return false;
  for (int i = 0; i < fixed.taken(); ++i) relaxation.close(fixed.axis(i));
  if (const float area = s.quadric.trace(); area > 0)
    relaxation.add_surface(of_positions(s.quadric), hold_ / (area * s.size * s.size));
  return relaxation.step(floor_, shift, x) && (!options_.model || end_on_model(v, relaxation, x)) &&
         keeps_faces(v, scratch.star, mesh_.position(v) + x);
}

// Ends the way on the model; false where a tetrahedron there is poorer than the floor, or has a
// smaller dihedral angle than the limit, and than all are now.
bool VolumeQualityLoop::end_on_model(Vertex v, const VertexRelaxation& relaxation, glm::dvec3& x) {
  const glm::dvec3 from = mesh_.position(v);
  x = options_.model->snap(state_[v].model, from + x) - from;
  const double least = std::min(floor_, relaxation.worst_shape(glm::dvec3(0.0)));
  return x != glm::dvec3(0.0) && relaxation.worst_shape(x) >= least &&
         relaxation.keeps_dihedrals(x);
}

// Vertices stay on what is flat, and go so that the volumes on all sides stay; those on model edges
// also along them. `x` receives what pays their debts.
bool VolumeQualityLoop::fix_ways(Vertex v, Scratch& scratch, FixedDirections& fixed,
                                 glm::dvec3& x) {
  const int dimension = state_[v].model.dimension();
  gather_model_faces(mesh_, v, scratch.star);
  scratch.planes.clear();
  scratch.planes.add(mesh_, v, scratch.star);
  take_planes(scratch.planes, fixed);
  if (options_.keep_volumes) scratch.balance.add(mesh_, v, scratch.balls[0]);
  if (fixed.taken() < 3 - dimension) draw_debts(v, scratch);
  debts_.charge(v, scratch.balance.conditions());
  take_conditions(scratch.balance.conditions(), reach_of_payment_ * size_of(v), 3 - dimension,
                  fixed, x);
  if (dimension == 2) return fixed.taken() == 1 || (!options_.keep_volumes && fixed.taken() == 0);
  glm::dvec3 along;
  if (!tangent(v, scratch.star, along)) return false;
  if (!options_.keep_volumes && fixed.taken() == 0) fixed.take(across(along));
  if (fixed.taken() == 1) fixed.take(glm::cross(along, fixed.axis(0)));
  return fixed.taken() == 2;
}

// From the vertex before it on its model edge to the one after it.
bool VolumeQualityLoop::tangent(Vertex v, const Star& star, glm::dvec3& along) const {
  std::array<glm::dvec3, 2> ways;
  std::size_t count = 0;
  for_edges_at(mesh_, v, star, [&](Edge e, Vertex far) {
    if (mesh_.classification(e) != state_[v].model) return;
    if (count < 2) ways[count] = mesh_.position(far) - mesh_.position(v);
    ++count;
  });
  along = ways[0] - ways[1];
  return count == 2 && glm::dot(ways[0], ways[1]) < 0;
}

bool VolumeQualityLoop::keeps_faces(Vertex v, const Star& star, const glm::dvec3& to) const {
  const glm::dvec3 from = mesh_.position(v);
  return std::none_of(star.begin(), star.end(), [&](const StarFace& f) {
    const glm::dvec3 p = mesh_.position(f.next), q = mesh_.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    const auto angle_before = [&] { return smallest_angle_cosine(from, p, q); };
    return is_flat(to, p, q, after) || !improving_.removal.max_turn.allows(before, after) ||
           (rules_.faces.least_angle.binds() &&
            !rules_.faces.least_angle.allows(smallest_angle_cosine(to, p, q), angle_before));
  });
}

std::uint32_t VolumeQualityLoop::swap_pass() {
  stir_limit_ = 0;
  return pass_done(improvement_.swap_pass());
}

std::uint32_t VolumeQualityLoop::smooth_pass() {
  std::uint32_t count = 0;
  for (const Vertex v : mesh_.vertices()) count += try_move(v, alone_);
  return pass_done(count);
}

// Between two collapses the queue knows neither the new edges nor the new places, and the parts of
// a pass were cut before there were new edges.
std::uint32_t VolumeQualityLoop::pass_done(std::uint32_t made) {
  turns_.give_up_parts();
  if (made > 0 && phase_ == Phase::Collapse) fill_queue();
  return made;
}

}  // namespace aomd
