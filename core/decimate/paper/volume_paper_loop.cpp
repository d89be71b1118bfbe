#include "core/decimate/paper/volume_paper_loop.h"

namespace aomd {
namespace {

// The printed loop forbids flat tetrahedra only. What is all but flat is of no more use to a
// solver: without a floor the worst dihedral angles of a result are far below a degree, with this
// one 6.7 or more, for 1 to 6 % of the input's tetrahedra that stay (docs/VOLUMES.md).
constexpr double least_shape = 0.15;

}  // namespace

VolumePaperLoop::VolumePaperLoop(Mesh& mesh, const DecimationOptions& options)
    : PaperLoop(mesh, options, 3), collapser_(mesh), mover_(mesh) {
  start();
}

void VolumePaperLoop::set_rules() {
  rules_.faces.max_turn = removal_.max_turn = moves_.max_turn = TurnLimit(options_.angle_deg);
  rules_.faces.least_angle = removal_.least_angle = moves_.least_angle =
      LeastAngle(options_.min_angle_deg);
  rules_.least_dihedral = removal_.least_dihedral = moves_.least_dihedral =
      LeastAngle(options_.min_dihedral_deg);
  rules_.least_shape = least_shape;
  moves_.model = options_.model;
}

Limits VolumePaperLoop::limits(ModelRef edge) const {
  Limits limits;
  limits.turn_deg = options_.angle_deg;
  if (edge.dimension() == 1) limits.curve_deg = rules_.faces.max_curve_turn.angle_deg();
  limits.min_angle_deg = options_.min_angle_deg;
  limits.min_dihedral_deg = options_.min_dihedral_deg;
  limits.distance = options_.max_distance;
  limits.regions = true;
  return limits;
}

Verdict VolumePaperLoop::judge_collapse(Edge edge, std::array<bool, 2> may_go, const Hand& /*hand*/,
                                        Plan& plan) {
  const CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser_.judge(mesh_, edge, may_go, rules_, plan.collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, collapse.contraction, collapse.around_deleted(),
                       collapse.around_kept());
}

EntityRef VolumePaperLoop::collapse(Edge edge, Hand& hand) {
  collapser_.apply(mesh_, hand.plan.collapse);
  for_corners(hand.plan.collapse.balls[0], [&](Vertex v) { touch(v, hand); });
  return edge;
}

Verdict VolumePaperLoop::judge_removing(Edge edge, Plan& plan) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  if (options_.kept(a) && options_.kept(b)) return {Reason::Kept, a};
  plan.change.clear();
  const Verdict verdict = aomd::judge(mesh_, a, b, removal_, plan.removal);
  const EdgeRing& ring = plan.removal.ring;
  if (!verdict.accepted() || !ring.on_model_face()) return verdict;
  plan.pair = {ring.faces[0], ring.faces[1], ring.a, ring.b, ring.apexes[0], ring.apexes[1]};
  if (keeps_face_of(plan.pair)) return {Reason::Kept, plan.pair.a};
  return guards_.judge(mesh_, plan.change, plan.pair);
}

EntityRef VolumePaperLoop::swap(Edge edge, Hand& hand) {
  if (!judge_removing(edge, hand.plan).accepted()) return {};
  aomd::apply(mesh_, hand.plan.removal);
  const EdgeRing& ring = hand.plan.removal.ring;
  for (std::uint32_t s = 0; s < ring.side_count; ++s)
    for (std::uint32_t i = 0; i < ring.sides[s].count; ++i) touch(ring.sides[s].ring[i], hand);
  touch(ring.a, hand);
  touch(ring.b, hand);
  return edge;
}

Verdict VolumePaperLoop::judge_moving(Vertex v, Plan& plan) {
  if (options_.kept(v)) return {Reason::Kept, v};
  RegionMove& move = plan.region_move;
  const Verdict verdict = mover_.judge(mesh_, v, moves_, move);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, v, move.star, move.target);
}

bool VolumePaperLoop::smooth(Vertex v, Hand& hand) {
  if (!judge_moving(v, hand.plan).accepted()) return false;
  RegionMover::apply(mesh_, hand.plan.region_move);
  for_corners(hand.plan.region_move.ball, [&](Vertex far) { touch(far, hand); });
  touch(v, hand);
  return true;
}

std::optional<SwapOutlook> VolumePaperLoop::swap_outlook(Edge edge) {
  SwapOutlook o;
  Plan plan;
  o.verdict = judge_removing(edge, plan);
  o.pair.a = mesh_.edge_vertices(edge)[0];
  o.pair.b = mesh_.edge_vertices(edge)[1];
  o.limits = limits({});
  return o;
}

std::optional<MoveOutlook> VolumePaperLoop::move_outlook(Vertex v) {
  MoveOutlook o;
  Plan plan;
  o.vertex = v;
  o.verdict = judge_moving(v, plan);
  o.target = o.verdict.accepted() ? plan.region_move.target : mesh_.position(v);
  o.limits = limits({});
  return o;
}

}  // namespace aomd
