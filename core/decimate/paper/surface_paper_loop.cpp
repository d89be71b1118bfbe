#include "core/decimate/paper/surface_paper_loop.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace aomd {
namespace {

// Of a model edge in all collapses and moves together: the bunny keeps its counts, a disc its
// shape.
constexpr double most_turn_deg = 60;
// Half of them tell the height of an arc to a hundredth; a rim of 100,000 edges costs no more.
constexpr std::uint32_t most_points = 64;

bool has_wires(Mesh& mesh) {
  const Request faces = mesh.request(1, 2, PaperLoop::name);
  for (const Edge e : mesh.edges())
    if (mesh.row<2>(e).empty()) return true;
  return false;
}

}  // namespace

SurfacePaperLoop::SurfacePaperLoop(Mesh& mesh, const DecimationOptions& options)
    : PaperLoop(mesh, options, 2), collapser_(mesh), curves_(mesh, most_points) {
  if (options_.exchange) wires_ = has_wires(mesh_);
  start();
}

SurfacePaperLoop::~SurfacePaperLoop() {
  needs_.clear();
  if (built_hash_) mesh_.drop_hash(1);
}

void SurfacePaperLoop::restart(const DecimationOptions& options) {
  curves_.locate_anywhere(mesh_);
  PaperLoop::restart(options);
}

/// What collapses read, or swaps and smoothing; what the others need goes first.
void SurfacePaperLoop::hold(bool collapses) {
  if (!options_.exchange || collapsing_ == collapses) return;
  collapsing_ = collapses;
  needs_.clear();
  if (std::exchange(built_hash_, false)) mesh_.drop_hash(1);
  if (collapses) {
    needs_.push_back(mesh_.request(0, 2, name));
    if (wires_) needs_.push_back(mesh_.request(0, 1, name));
    built_hash_ = !mesh_.stored(0, 1) && !mesh_.hash(1).built();
    if (built_hash_) mesh_.build_hash(1);
  } else {
    needs_.push_back(mesh_.request(0, 1, name));
    needs_.push_back(mesh_.request(1, 2, name));
  }
}

void SurfacePaperLoop::set_rules() {
  rules_.max_turn = smooth_.max_turn = TurnLimit(options_.angle_deg);
  rules_.topology = options_.topology;
  rules_.least_angle = smooth_.least_angle = LeastAngle(options_.min_angle_deg);
  smooth_.model = options_.model;
}

Limits SurfacePaperLoop::limits(ModelRef edge) const {
  Limits limits;
  limits.turn_deg = options_.angle_deg;
  if (edge.dimension() == 1 && options_.topology == TopologyRule::Safe)
    limits.curve_deg = rules_.max_curve_turn.angle_deg();
  limits.curve_sum_deg = most_turn_deg;
  limits.min_angle_deg = options_.min_angle_deg;
  limits.distance = options_.max_distance;
  return limits;
}

Verdict SurfacePaperLoop::judge_collapse(Edge edge, std::array<bool, 2> may_go, Plan& plan) {
  hold(true);
  CollapsePlan& collapse = plan.collapse;
  Verdict verdict = collapser_.judge(mesh_, edge, may_go, rules_, collapse);
  if (verdict.accepted()) verdict = judge_curve(collapse.contraction);
  if (!verdict.accepted() && collapse.verdict.accepted()) {  // the other end may be the better one
    may_go[mesh_.edge_vertices(edge)[0] == collapse.contraction.deleted ? 0 : 1] = false;
    if (!may_go[0] && !may_go[1]) return verdict;
    if (!collapser_.judge(mesh_, edge, may_go, rules_, collapse).accepted()) return verdict;
    verdict = judge_curve(collapse.contraction);
  }
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, collapse.contraction, collapse.around_deleted(),
                       collapse.around_kept());
}

// The operator limits what one collapse turns of a model edge; many in a row would eat a border.
Verdict SurfacePaperLoop::judge_curve(const Contraction& c) const {
  CurvePlace place;
  if (rules_.topology != TopologyRule::Safe || !curves_.between(c.deleted, c.kept, place))
    return {};
  double cosine = 1;
  if (turns_too_far(place, c.position, cosine)) return {Reason::Angle, c.kept, cosine};
  return {};
}

bool SurfacePaperLoop::turns_too_far(const CurvePlace& place, const glm::dvec3& x,
                                     double& cosine) const {
  cosine = curves_.turn_cosine(mesh_, place, x);
  const double limit = std::cos(most_turn_deg * std::numbers::pi / 180);
  return cosine < limit;
}

void SurfacePaperLoop::collapse() {
  collapser_.apply(mesh_, plan_.collapse);
  curves_.merged(mesh_, plan_.collapse.contraction.deleted, plan_.collapse.contraction.kept);
  for (const StarFace& f : plan_.collapse.around_deleted()) touch(f.next), touch(f.previous);
}

Verdict SurfacePaperLoop::judge_swapping(Edge edge, Plan& plan) {
  hold(false);
  const Verdict verdict = judge_swap(mesh_, edge, rules_.max_turn, plan.pair);
  if (verdict.accepted() && keeps_face_of(plan.pair)) return {Reason::Kept, plan.pair.a};
  return verdict.accepted() ? guards_.judge(mesh_, plan.change, plan.pair) : verdict;
}

std::optional<SwapOutlook> SurfacePaperLoop::swap_outlook(Edge edge) {
  SwapOutlook o;
  Plan plan;
  o.verdict = judge_swapping(edge, plan);
  o.pair = plan.pair;
  o.limits = limits({});
  return o;
}

Verdict SurfacePaperLoop::judge_smoothing(Vertex v, Plan& plan) {
  if (options_.kept(v)) return {Reason::Kept, v};
  hold(false);
  const Verdict verdict = judge_smooth(mesh_, v, smooth_, plan.move.target);
  if (double cosine = 1; verdict.accepted() && curves_.inside(v) &&
                         rules_.topology == TopologyRule::Safe &&
                         turns_too_far(curves_.around(v), plan.move.target, cosine))
    return {Reason::Angle, v, cosine};
  if (!verdict.accepted() || !guards_.any()) return verdict;
  std::vector<std::uint32_t> derived;
  gather(mesh_, v, faces_around(mesh_, v, derived), plan.move.star);
  return guards_.judge(mesh_, plan.change, v, plan.move.star, plan.move.target);
}

std::optional<MoveOutlook> SurfacePaperLoop::move_outlook(Vertex v) {
  MoveOutlook o;
  Plan plan;
  plan.move.target = mesh_.position(v);
  o.vertex = v;
  o.verdict = judge_smoothing(v, plan);
  o.target = plan.move.target;
  o.limits = limits({});
  return o;
}

bool SurfacePaperLoop::swap(Edge edge) {
  if (!judge_swapping(edge, plan_).accepted()) return false;
  const EdgePair& pair = plan_.pair;
  apply_swap(mesh_, edge, pair);
  for (const Vertex v : {pair.a, pair.b, pair.c, pair.d}) touch(v);
  return true;
}

bool SurfacePaperLoop::smooth(Vertex v) {
  if (!judge_smoothing(v, plan_).accepted()) return false;
  apply_smooth(mesh_, v, plan_.move.target);
  for (const Edge e : mesh_.row<1>(v))
    for (const Vertex u : mesh_.edge_vertices(e)) touch(u);
  return true;
}

}  // namespace aomd
