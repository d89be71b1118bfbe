// What operations on a volume owe to its regions: who takes debts on, and how they are paid.

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

double six_volumes_of(const Mesh& mesh, Vertex a, Vertex b, Vertex c, Vertex d) {
  return std::abs(
      six_volumes(mesh.position(a), mesh.position(b), mesh.position(c), mesh.position(d)));
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

// A region may come to owe a part of its volume.
void VolumeQualityLoop::limit_debts() {
  std::unordered_map<std::uint32_t, double> volumes;
  for (const Region r : mesh_.regions()) {
    if (mesh_.shape(r) != Shape::Tetrahedron) continue;
    const auto t = mesh_.tetrahedron(r);
    volumes[mesh_.classification(r).bits()] += six_volumes_of(mesh_, t[0], t[1], t[2], t[3]);
  }
  for (const auto& [region, volume] : volumes)
    debts_.limit(ModelRef::from_bits(region), most_owed * volume);
}

// `in` is a tetrahedron of the model region that would change.
Verdict VolumeQualityLoop::judge_debt(Region in, double change) const {
  const ModelRef region = mesh_.classification(in);
  if (debts_.bears(region, change)) return {};
  return {Reason::Volume, in, 100 * most_owed * debts_.in_limits(region, change)};
}

// The tetrahedra around one vertex; of an edge, those around either end.
Verdict VolumeQualityLoop::judge_debts(const glm::dvec3& x, const Scratch& scratch) const {
  for (const VolumeCondition& condition : scratch.balance.conditions()) {
    const double change = condition.change(x);
    if (debts_.bears(condition.region, change)) continue;
    for (const Ball& ball : scratch.balls)
      for (const BallRegion& r : ball)
        if (mesh_.classification(r.region) == condition.region) return judge_debt(r.region, change);
  }
  return {};
}

Verdict VolumeQualityLoop::judge_debts(const EdgeRemoval& plan) const {
  if (!options_.keep_volumes) return {};
  const EdgeRing& ring = plan.ring;
  for (std::uint32_t s = 0; s < ring.side_count; ++s) {
    const RingSide& side = ring.sides[s];
    const double gain = gain_of(mesh_, ring, side, plan.triangles[s]);
    if (const Verdict v = judge_debt(side.regions[0], gain); !v.accepted()) return v;
  }
  return {};
}

// What a region gains is owed by an end of the old edge that can pay.
void VolumeQualityLoop::note_gains(const EdgeRemoval& plan) {
  if (!options_.keep_volumes) return;
  const EdgeRing& ring = plan.ring;
  Vertex debtor = ring.a;
  for (const Vertex v : {ring.apexes[1], ring.apexes[0], ring.b, ring.a})
    if (state_[v].model.dimension() == 2) debtor = v;
  for (std::uint32_t s = 0; s < ring.side_count; ++s)
    debts_.add(debtor, mesh_.classification(ring.sides[s].regions[0]),
               gain_of(mesh_, ring, ring.sides[s], plan.triangles[s]));
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

// In the first passes debts spread over curved model faces, then they are paid: so that none makes
// a bump.
bool VolumeQualityLoop::settle(Vertex v) {
  constexpr int spreading = 8;  // passes
  const int dimension = state_[v].model.dimension();
  if (dimension == 0 || dimension == 3 || options_.kept(v) || !among_tets(v)) return false;
  Scratch& scratch = alone_.scratch;
  gather(mesh_, v, scratch.balls[0]);
  scratch.balance.begin(mesh_.position(v));
  FixedDirections fixed;
  glm::dvec3 x(0.0);
  if (!fix_ways(v, scratch, fixed, x) || !owes(v)) return false;
  if (settling_ <= spreading) {
    spread(v);
    return false;
  }
  begin_relaxation(v, scratch);
  const VertexRelaxation& relaxation = scratch.relaxation;
  const double least = std::min(floor_, relaxation.worst_shape(glm::dvec3(0.0)));
  if (x == glm::dvec3(0.0) || relaxation.worst_shape(x) < least || !relaxation.keeps_dihedrals(x) ||
      !keeps_faces(v, scratch.star, mesh_.position(v) + x)) {
    spread(v);
    return false;
  }
  return move(v, x, alone_);
}

bool VolumeQualityLoop::owes(Vertex v) const {
  constexpr double noise = 1e-9;  // of a size cubed
  const auto conditions = alone_.scratch.balance.conditions();
  const double least = noise * std::pow(size_of(v), 3);
  return std::any_of(conditions.begin(), conditions.end(),
                     [&](const VolumeCondition& c) { return std::abs(c.debt) > least; });
}

// Each neighbour inside the same model face takes an equal part.
void VolumeQualityLoop::spread(Vertex v) {
  const auto takes = [&](const StarFace& f) { return state_[f.next].model == state_[v].model; };
  const auto takers = std::count_if(alone_.scratch.star.begin(), alone_.scratch.star.end(), takes);
  for (const VolumeCondition& c : alone_.scratch.balance.conditions()) {
    const double part = c.debt / double(takers + 1);
    for (const StarFace& f : alone_.scratch.star)
      if (takes(f)) debts_.add(f.next, c.region, part);
    debts_.add(v, c.region, part - c.debt);
  }
}

}  // namespace aomd
