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
    : PaperLoop(mesh, options, 2), curves_(mesh, most_points) {
  tools_.push_back(std::make_unique<Tools>(mesh));
  if (options_.exchange)
    wires_ = has_wires(mesh_);
  else if (!mesh_.complete(1))
    edges_.emplace(mesh_, options.threads);
  start();
}

SurfacePaperLoop::~SurfacePaperLoop() {
  needs_.clear();
  if (built_hash_) mesh_.drop_hash(1);
}

const IdPool& SurfacePaperLoop::edges() const { return edges_ ? edges_->ids() : mesh_.ids(1); }

EdgeEnds SurfacePaperLoop::ends(Edge edge) const {
  return edges_ ? edges_->ends(edge) : mesh_.edge_vertices(edge);
}

Edge SurfacePaperLoop::between(Vertex a, Vertex b) const {
  return edges_ ? edges_->find(mesh_, a, b) : mesh_.find_edge(a, b);
}

Edge SurfacePaperLoop::edge_of(Edge entity) const {
  if (!edges_) return entity;
  const auto [a, b] = mesh_.edge_vertices(entity);
  return edges_->find(mesh_, a, b);
}

Column<Vertex, double> SurfacePaperLoop::average_lengths() const {
  return edges_ ? edges_->average_lengths(mesh_) : PaperLoop::average_lengths();
}

void SurfacePaperLoop::restart(const DecimationOptions& options) {
  curves_.locate_anywhere(mesh_);
  if (edges_) edges_.emplace(mesh_, options.threads);
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

Verdict SurfacePaperLoop::judge_collapse(Edge edge, std::array<bool, 2> may_go, const Hand& hand,
                                         Plan& plan) {
  hold(true);
  CollapsePlan& collapse = plan.collapse;
  Collapser& collapser = tools(hand).collapser;
  const auto judge = [&] {
    return edges_ ? collapser.judge(mesh_, edges_->ends(edge), may_go, rules_, collapse)
                  : collapser.judge(mesh_, edge, may_go, rules_, collapse);
  };
  Verdict verdict = judge();
  if (verdict.accepted()) verdict = judge_curve(collapse.contraction);
  if (!verdict.accepted() && collapse.verdict.accepted()) {  // the other end may be the better one
    may_go[ends(edge)[0] == collapse.contraction.deleted ? 0 : 1] = false;
    if (!may_go[0] && !may_go[1]) return verdict;
    if (!judge().accepted()) return verdict;
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

EntityRef SurfacePaperLoop::collapse(Edge edge, Hand& hand) {
  const CollapsePlan& plan = hand.plan.collapse;
  auto& [collapser, scratch] = tools(hand);
  if (edges_) edges_->collapse(mesh_, plan.contraction, plan.stars, rules_.topology, scratch);
  if (hand.edits) {
    collapser.apply(mesh_, *hand.edits, plan);
  } else {
    collapser.apply(mesh_, plan);
    if (edges_) edges_->settle(scratch);
    curves_.merged(mesh_, plan.contraction.deleted, plan.contraction.kept);
  }
  for (const StarFace& f : plan.around_deleted()) touch(f.next, hand), touch(f.previous, hand);
  return edges_ ? EntityRef(plan.contraction.kept) : EntityRef(edge);
}

Verdict SurfacePaperLoop::judge_swapping(Edge edge, Plan& plan) {
  hold(false);
  const EdgeEnds ends = this->ends(edge);
  const Verdict verdict = edges_ ? judge_swap(mesh_, ends[0], ends[1], rules_.max_turn, plan.pair)
                                 : judge_swap(mesh_, edge, rules_.max_turn, plan.pair);
  if (verdict.accepted() && keeps_face_of(plan.pair)) return {Reason::Kept, plan.pair.a};
  return verdict.accepted() ? guards_.judge(mesh_, plan.change, plan.pair) : verdict;
}

std::optional<SwapOutlook> SurfacePaperLoop::swap_outlook(Edge edge) {
  SwapOutlook o;
  Plan plan;
  o.verdict = judge_swapping(edge_of(edge), plan);
  o.pair = plan.pair;
  o.limits = limits({});
  return o;
}

Verdict SurfacePaperLoop::judge_average(Vertex v, const Hand& hand, glm::dvec3& target) {
  if (!edges_) return judge_smooth(mesh_, v, smooth_, target);
  const auto neighbours = edges_->neighbours(mesh_, v, tools(hand).edges);
  return judge_smooth(mesh_, v, neighbours, smooth_, target);
}

Verdict SurfacePaperLoop::judge_smoothing(Vertex v, const Hand& hand, Plan& plan) {
  if (options_.kept(v)) return {Reason::Kept, v};
  hold(false);
  const Verdict verdict = judge_average(v, hand, plan.move.target);
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
  o.verdict = judge_smoothing(v, alone(), plan);
  o.target = plan.move.target;
  o.limits = limits({});
  return o;
}

// A part has no room for rows of any length.
EntityRef SurfacePaperLoop::swap(Edge edge, Hand& hand) {
  if (!judge_swapping(edge, hand.plan).accepted()) return {};
  const EdgePair& pair = hand.plan.pair;
  if (hand.within_part && (crowded(mesh_, pair.c) || crowded(mesh_, pair.d))) {
    leave(edge, hand);
    return {};
  }
  if (edges_) edges_->swap(mesh_, pair);
  if (hand.edits)
    apply_swap(*hand.edits, mesh_, pair);
  else
    apply_swap(mesh_, edges_ ? Edge() : edge, pair);
  for (const Vertex v : {pair.a, pair.b, pair.c, pair.d}) touch(v, hand);
  return edges_ ? EntityRef(pair.f) : EntityRef(edge);
}

bool SurfacePaperLoop::smooth(Vertex v, Hand& hand) {
  const glm::dvec3& target = hand.plan.move.target;
  if (!judge_smoothing(v, hand, hand.plan).accepted()) return false;
  if (hand.edits)
    hand.edits->move(v, target);
  else
    apply_smooth(mesh_, v, target);
  touch(v, hand);
  if (edges_)
    for (const Vertex u : edges_->neighbours(mesh_, v, tools(hand).edges)) touch(u, hand);
  else
    for (const Edge e : mesh_.row<1>(v)) touch(mesh_.other_end(e, v), hand);
  return true;
}

bool SurfacePaperLoop::ready_for(std::size_t hands) {
  if (!edges_) return false;
  while (tools_.size() <= hands) tools_.push_back(std::make_unique<Tools>(mesh_));
  if (phase() == Phase::Swap) mesh_.build_hash(1);
  return true;
}

void SurfacePaperLoop::settle() {
  for (const auto& tools : tools_) edges_->settle(tools->edges);
}

}  // namespace aomd
