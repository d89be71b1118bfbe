// Passes of the quality strategy over tetrahedra and vertices: edges and faces are removed around
// poor tetrahedra, and vertices go where those around them are better.

#include <algorithm>
#include <cmath>

#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/id_pool.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/smooth.h"

namespace aomd {
namespace {

// A tetrahedron of this shape is good enough to be left to itself.
constexpr double fair = 0.65;

constexpr std::array<std::array<std::uint8_t, 2>, 6> edges_of_tet{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

double shape_of(const Mesh& mesh, const std::array<Vertex, 4>& t) {
  return tet_shape(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]),
                   mesh.position(t[3]));
}

double six_volumes_of(const Mesh& mesh, Vertex a, Vertex b, Vertex c, Vertex d) {
  return std::abs(six_volumes(mesh.position(a), mesh.position(b), mesh.position(c),
                              mesh.position(d)));
}

// How much volume the tetrahedra on one side of a model face gain, six times.
double gain_of(const Mesh& mesh, const EdgeRing& ring, const RingSide& side,
               const RingTriangles& triangles) {
  double gain = 0;
  for (std::uint32_t i = 0; i < side.region_count(); ++i)
    gain -= six_volumes_of(mesh, ring.a, ring.b, side.ring[i], side.after(i));
  for (std::uint32_t i = 0; i < triangles.count; ++i) {
    const RingTriangle& t = triangles.items[i];
    for (const Vertex end : {ring.a, ring.b})
      gain += six_volumes_of(mesh, end, side.ring[t[0]], side.ring[t[1]], side.ring[t[2]]);
  }
  return gain;
}

}  // namespace

bool VolumeQualityLoop::advance_swap() {
  const std::uint32_t id = mesh_.ids(3).next_alive(cursor_);
  if (id >= mesh_.capacity(3)) {
    end_phase();
    return false;
  }
  cursor_ = id + 1;
  return improve(Region(id));
}

// One edge or face of a poor tetrahedron, whichever helps first.
bool VolumeQualityLoop::improve(Region r) {
  const auto t = mesh_.tetrahedron(r);
  if (shape_of(mesh_, t) >= fair || !stirred(t)) return false;
  for (const auto& [i, k] : edges_of_tet)
    if (remove_edge(t[i], t[k])) return true;
  for (std::uint32_t slot = 0; slot < 4; ++slot)
    if (remove_face(r, slot)) return true;
  return false;
}

// Whatever an operation makes has a vertex of those that it stirs.
bool VolumeQualityLoop::stirred(const std::array<Vertex, 4>& t) const {
  return std::any_of(t.begin(), t.end(), [&](Vertex v) { return stir_[v] >= stir_limit_; });
}

void VolumeQualityLoop::stir(Vertex v) { stir_[v] = stir_now_; }

bool VolumeQualityLoop::remove_edge(Vertex a, Vertex b) {
  EdgeRemoval& plan = edge_removal_;
  if (options_.kept(a) && options_.kept(b)) return false;
  if (!aomd::judge(mesh_, a, b, removal_, plan).accepted()) return false;
  const EdgeRing& ring = plan.ring;
  if (ring.on_model_face()) {
    if (!keeps_close(ring)) return false;
    note_gains(plan);
  }
  stir(a);
  stir(b);
  aomd::apply(mesh_, plan);
  made(StepKind::Swap, a, plan_.change);
  return true;
}

// The other diagonal of two faces runs beside the first one by so much at most that the cost of
// the distance is that of a short edge.
bool VolumeQualityLoop::keeps_close(const EdgeRing& ring) const {
  const glm::dvec3 a = mesh_.position(ring.a), b = mesh_.position(ring.b),
                   c = mesh_.position(ring.apexes[0]), d = mesh_.position(ring.apexes[1]);
  const double area = glm::length(glm::cross(b - a, d - c));
  if (!(area > 0)) return false;
  const double apart = six_volumes(a, b, c, d) / area;
  const double size = double(state_[ring.a].size) * double(state_[ring.b].size);
  return double(surface_) * apart * apart / 8 <= size;
}

// What a region gains is owed by an end of the old edge that can pay.
void VolumeQualityLoop::note_gains(const EdgeRemoval& plan) {
  const EdgeRing& ring = plan.ring;
  Vertex debtor = ring.a;
  for (const Vertex v : {ring.apexes[1], ring.apexes[0], ring.b, ring.a})
    if (state_[v].model.dimension() == 2) debtor = v;
  for (std::uint32_t s = 0; s < ring.side_count; ++s)
    debts_.add(debtor, mesh_.classification(ring.sides[s].regions[0]),
               gain_of(mesh_, ring, ring.sides[s], plan.triangles[s]));
}

bool VolumeQualityLoop::remove_face(Region r, std::uint32_t slot) {
  FaceRemoval& plan = face_removal_;
  if (!aomd::judge(mesh_, r, slot, plan).accepted()) return false;
  for (const Vertex v : plan.apexes) stir(v);
  aomd::apply(mesh_, plan);
  made(StepKind::Swap, r, plan_.change);
  return true;
}

bool VolumeQualityLoop::advance_smooth() {
  const std::uint32_t id = mesh_.ids(0).next_alive(cursor_);
  if (id >= mesh_.capacity(0)) {
    end_phase();
    return false;
  }
  cursor_ = id + 1;
  return settling_ > 0 ? settle(Vertex(id)) : try_move(Vertex(id));
}

bool VolumeQualityLoop::try_move(Vertex v) {
  glm::dvec3 x;
  if (!options_.smooth || options_.kept(v) || !find_target(v, scratch_, x)) return false;
  move(v, x);
  return true;
}

// Goes by `x`; the conditions in the scratch are those at the vertex.
void VolumeQualityLoop::move(Vertex v, const glm::dvec3& x) {
  State& s = state_[v];
  if (s.model.dimension() < 3) {
    s.quadric = s.quadric.about(glm::vec3(x));
    debts_.settle(v, x, scratch_.balance.conditions());
  }
  apply_smooth(mesh_, v, mesh_.position(v) + x);
  stir(v);
  made(StepKind::Smooth, v, plan_.change);
}

// In the first passes debts spread over curved model faces, then they are paid: so that none makes
// a bump.
bool VolumeQualityLoop::settle(Vertex v) {
  constexpr int spreading = 8;  // passes
  const int dimension = state_[v].model.dimension();
  if (dimension == 0 || dimension == 3 || options_.kept(v)) return false;
  gather(mesh_, v, scratch_.balls[0]);
  scratch_.balance.begin(mesh_.position(v));
  Frame frame;
  glm::dvec3 x(0.0);
  if (!fix_ways(v, scratch_, frame, x) || !owes(v)) return false;
  if (settling_ <= spreading) {
    spread(v);
    return false;
  }
  relaxation_.begin(mesh_, v, scratch_.balls[0]);
  const double least = std::min(floor_, relaxation_.worst_shape(glm::dvec3(0.0)));
  if (x == glm::dvec3(0.0) || relaxation_.worst_shape(x) < least ||
      !keeps_faces(v, scratch_.star, mesh_.position(v) + x)) {
    spread(v);
    return false;
  }
  move(v, x);
  return true;
}

bool VolumeQualityLoop::owes(Vertex v) const {
  constexpr double noise = 1e-9;  // of a size cubed
  const auto conditions = scratch_.balance.conditions();
  const double least = noise * std::pow(double(state_[v].size), 3);
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const VolumeCondition& c) { return std::abs(c.debt) > least; });
}

// Each neighbour inside the same model face takes an equal part.
void VolumeQualityLoop::spread(Vertex v) {
  const auto takes = [&](const StarFace& f) { return state_[f.next].model == state_[v].model; };
  const auto takers = std::count_if(scratch_.star.begin(), scratch_.star.end(), takes);
  for (const VolumeCondition& c : scratch_.balance.conditions()) {
    const double part = c.debt / double(takers + 1);
    for (const StarFace& f : scratch_.star)
      if (takes(f)) debts_.add(f.next, c.region, part);
    debts_.add(v, c.region, part - c.debt);
  }
}

// Where the energy of the vertex is least, as far as one step tells; false where it stays.
bool VolumeQualityLoop::find_target(Vertex v, Scratch& scratch, glm::dvec3& x) {
  const State& s = state_[v];
  if (s.model.dimension() == 0 || mesh_.row<3>(v).empty()) return false;
  gather(mesh_, v, scratch.balls[0]);
  relaxation_.begin(mesh_, v, scratch.balls[0]);
  scratch.balance.begin(mesh_.position(v));
  if (s.model.dimension() == 3) return relaxation_.step(floor_, glm::dvec3(0.0), x);
  Frame frame;
  glm::dvec3 shift(0.0);
  if (!fix_ways(v, scratch, frame, shift)) return false;
  for (int i = 0; i < frame.taken(); ++i) relaxation_.close(frame.axis(i));
  if (const float area = s.quadric.trace(); area > 0)
    relaxation_.add_surface(s.quadric, double(surface_ / (area * s.size * s.size)));
  return relaxation_.step(floor_, shift, x) &&
         keeps_faces(v, scratch.star, mesh_.position(v) + x);
}

// Vertices stay on what is flat, and go so that the volumes on all sides stay; those on model edges
// also along them. `x` receives what pays their debts.
bool VolumeQualityLoop::fix_ways(Vertex v, Scratch& scratch, Frame& frame, glm::dvec3& x) {
  const int dimension = state_[v].model.dimension();
  gather_model_faces(mesh_, v, scratch.star);
  scratch.planes.clear();
  scratch.planes.add(mesh_, v, scratch.star);
  take_planes(scratch.planes, frame);
  scratch.balance.add(mesh_, v, scratch.balls[0]);
  if (frame.taken() < 3 - dimension) draw_debts(v, scratch);
  debts_.charge(v, scratch.balance.conditions());
  take_conditions(scratch.balance.conditions(), paid_at_once * double(state_[v].size),
                  3 - dimension, frame, x);
  if (dimension == 2) return frame.taken() == 1;
  glm::dvec3 along;
  if (!tangent(v, scratch.star, along)) return false;
  if (frame.taken() == 1) frame.take(glm::cross(along, frame.axis(0)));
  return frame.taken() == 2;
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

// What contractions onto model edges owe is paid by the curved model faces beside them: a vertex
// there can give from one of its regions to the other.
void VolumeQualityLoop::draw_debts(Vertex v, const Scratch& scratch) {
  const std::span<const VolumeCondition> sides = scratch.balance.conditions();
  if (sides.empty() || sides.size() > 2) return;
  const ModelRef a = sides[0].region, b = sides.back().region;
  for (const StarFace& f : scratch.star) {
    const Vertex u = f.next;
    if (state_[u].model.dimension() >= state_[v].model.dimension()) continue;
    const double at_a = debts_.of(u, a), at_b = debts_.of(u, b);
    const double part = a == b ? at_a : 0.5 * (at_a - at_b);
    debts_.add(u, a, -part);
    debts_.add(v, a, part);
    if (a == b) continue;
    debts_.add(u, b, part);
    debts_.add(v, b, -part);
  }
}

bool VolumeQualityLoop::keeps_faces(Vertex v, const Star& star, const glm::dvec3& to) const {
  const glm::dvec3 from = mesh_.position(v);
  return std::none_of(star.begin(), star.end(), [&](const StarFace& f) {
    const glm::dvec3 p = mesh_.position(f.next), q = mesh_.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    return is_flat(to, p, q, after) || !removal_.max_turn.allows(before, after);
  });
}

std::uint32_t VolumeQualityLoop::swap_pass() {
  std::uint32_t count = 0;
  stir_limit_ = 0;
  for (const Region r : mesh_.regions()) count += improve(r);
  return pass_done(count);
}

std::uint32_t VolumeQualityLoop::smooth_pass() {
  std::uint32_t count = 0;
  for (const Vertex v : mesh_.vertices()) count += try_move(v);
  return pass_done(count);
}

// Between two collapses the queue knows neither the new edges nor the new places.
std::uint32_t VolumeQualityLoop::pass_done(std::uint32_t made) {
  if (made > 0 && phase_ == Phase::Collapse) fill_queue();
  return made;
}

}  // namespace aomd
