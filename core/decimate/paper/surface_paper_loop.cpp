#include "core/decimate/paper/surface_paper_loop.h"

#include <utility>

namespace aomd {
namespace {

bool has_wires(Mesh& mesh) {
  const Request faces = mesh.request(1, 2, PaperLoop::name);
  for (const Edge e : mesh.edges())
    if (mesh.row<2>(e).empty()) return true;
  return false;
}

}  // namespace

SurfacePaperLoop::SurfacePaperLoop(Mesh& mesh, const DecimationOptions& options)
    : PaperLoop(mesh, options, 2), collapser_(mesh) {
  if (options_.exchange) wires_ = has_wires(mesh_);
  start();
}

SurfacePaperLoop::~SurfacePaperLoop() {
  needs_.clear();
  if (built_hash_) mesh_.drop_hash(1);
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
  limits.min_angle_deg = options_.min_angle_deg;
  limits.distance = options_.max_distance;
  return limits;
}

Verdict SurfacePaperLoop::judge_collapse(Edge edge, std::array<bool, 2> may_go, Plan& plan) {
  hold(true);
  CollapsePlan& collapse = plan.collapse;
  const Verdict verdict = collapser_.judge(mesh_, edge, may_go, rules_, collapse);
  if (!verdict.accepted()) return verdict;
  return guards_.judge(mesh_, plan.change, collapse.contraction, collapse.around_deleted(),
                       collapse.around_kept());
}

void SurfacePaperLoop::collapse() {
  collapser_.apply(mesh_, plan_.collapse);
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
