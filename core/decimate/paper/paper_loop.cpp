#include "core/decimate/paper/paper_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/decimate/spacing/spacing.h"

namespace aomd {
namespace {

// Of surfaces in parts: the paper's own models have fewer, and go as printed.
constexpr std::uint32_t fewest_faces = 250'000;
// Of edges to collapses of a sweep, where the next one is worth sharing out.
constexpr std::uint64_t fewest_share = 64;
constexpr std::size_t fewest_edges_each = 64;  // in a part

}  // namespace

PaperLoop::PaperLoop(Mesh& mesh, const DecimationOptions& options, int dimension)
    : Loop(mesh, options), dimension_(dimension) {}

void PaperLoop::start() {
  set_rules();
  reach_ = first_reach();
  average_length_ = average_lengths();
  begin();
}

void PaperLoop::begin() {
  part_count_ = parts();
  forget();
  begin_sweep();
}

std::size_t PaperLoop::parts() const {
  if (dimension_ == 3) return 1;
  if (options_.parts > 0)
    return std::min(static_cast<std::size_t>(options_.parts), Partition::most_parts);
  return mesh_.count(2) < fewest_faces ? 1 : part_count(mesh_);
}

Column<Vertex, double> PaperLoop::average_lengths() const {
  return evaluate_spacing(mesh_, {SpacingByFactor{1}, {}});
}

// Towards a target twice the factor that would lead there if the angle refused nothing: started
// lower it grows in many sweeps, each of which leaves what no longer fits together.
double PaperLoop::first_reach() const {
  if (!aims()) return options_.factor;
  const double ratio = double(mesh_.count(dimension_)) / options_.target_faces;
  return std::max(1.5, 2 * (dimension_ == 2 ? std::sqrt(ratio) : std::cbrt(ratio)));
}

double PaperLoop::spacing(Vertex v) const {
  if (options_.spacing) return v.index < options_.spacing->size() ? (*options_.spacing)[v] : 0;
  if (options_.coarsest) return std::numeric_limits<double>::infinity();
  return v.index < average_length_.size() ? average_length_[v] * reach_ : 0;
}

void PaperLoop::restart(const DecimationOptions& options) {
  options_ = options;
  guards_.restart(mesh_, options);
  set_rules();
  reach_ = first_reach();
  improved_ = 0;
  begin();
}

void PaperLoop::forget() {
  judged_.assign(edges().capacity(), 0);
  refusal_.assign(edges().capacity(), Reason::None);
  changed_.assign(mesh_.capacity(0), ++alone_.now);
  many_ = true;
}

void PaperLoop::begin_sweep() {
  enter(Phase::Collapse);
  open_sweep();
}

// What is left of a large surface may be too small to be worth cutting. A sweep that finds next to
// nothing changed since the last one is too short to be shared out, and so is one over few edges.
void PaperLoop::enter(Phase phase) {
  phase_ = phase;
  cursor_ = 0;
  const bool is_large = options_.parts > 0 || mesh_.count(2) >= fewest_faces;
  in_parts_ = part_count_ > 1 && is_large && edges().size() >= fewest_edges_each * part_count_ &&
              (phase != Phase::Collapse || many_);
  if (in_parts_) begin_turns();
}

void PaperLoop::begin_turns() {
  if (phase_ == Phase::Smooth) return turns_.begin(mesh_, 0, part_count_, options_.threads);
  const auto corners = [this](std::uint32_t id) { return this->ends(Edge(id)); };
  const bool ends_at_target = phase_ == Phase::Collapse && options_.target_faces > 0;
  const std::uint64_t above =
      std::max(mesh_.count(2), options_.target_faces) - options_.target_faces;
  turns_.begin(mesh_, edges(), corners, part_count_, options_.threads,
               ends_at_target ? above : PassTurns::unlimited);
}

// A collapse removes what is shorter than half the spacing: edges then end up at about that length.
Verdict PaperLoop::judge(Vertex a, Vertex b) {
  Plan plan;
  return judge(between(a, b), {true, true}, alone_, plan);
}

Verdict PaperLoop::judge(Edge edge, std::array<bool, 2> may_go, const Hand& hand, Plan& plan) {
  const EdgeEnds ends = this->ends(edge);
  const double length = glm::length(mesh_.position(ends[0]) - mesh_.position(ends[1]));
  for (std::size_t i = 0; i < 2; ++i) may_go[i] = may_go[i] && 0.5 * spacing(ends[i]) > length;
  if (!may_go[0] && !may_go[1]) return {Reason::Spacing, edge, length};
  const std::size_t first = may_go[0] ? 0 : 1;
  for (std::size_t i = 0; i < 2; ++i) may_go[i] = may_go[i] && !options_.kept(ends[i]);
  if (!may_go[0] && !may_go[1]) return {Reason::Kept, ends[first]};
  return judge_collapse(edge, may_go, hand, plan);
}

Verdict PaperLoop::judge(Edge edge, Vertex& deleted) {
  Plan plan;
  const Verdict verdict = judge(edge_of(edge), {true, true}, alone_, plan);
  deleted = plan.collapse.contraction.deleted;
  return verdict;
}

Reason PaperLoop::last_refusal(Edge e) const {
  const Edge edge = edge_of(e);
  return edge.index < refusal_.size() ? refusal_[edge] : Reason::None;
}

bool PaperLoop::unchanged_since(Edge e) const {
  const auto [a, b] = ends(e);
  return std::max(changed_[a], changed_[b]) <= judged_[e];
}

// Model edges and their ends are for who works alone: more than the faces around them changes.
bool PaperLoop::must_wait(Edge edge) const {
  const auto [a, b] = ends(edge);
  return mesh_.classification(a).dimension() != 2 || mesh_.classification(b).dimension() != 2;
}

bool PaperLoop::try_collapse(Edge edge, Hand& hand) {
  if (unchanged_since(edge)) {
    refused(refusal_[edge], hand);
    return false;
  }
  if (hand.within_part && must_wait(edge)) {
    leave(edge, hand);
    return false;
  }
  const Verdict verdict = judge(edge, {true, true}, hand, hand.plan);
  if (!verdict.accepted()) {
    judged_[edge] = hand.now;
    refusal_[edge] = verdict.reason;
    refused(verdict.reason, hand);
    return false;
  }
  const EntityRef known_by = collapse(edge, hand);
  if (hand.within_part) turns_.took(hand.part, hand.plan.collapse.faces_gone());
  made_by(hand, StepKind::Collapse, known_by);
  return true;
}

void PaperLoop::refused(Reason reason, Hand& hand) {
  SweepStatistics& sweep = hand.edits ? hand.made : sweeps_.back();
  ++sweep.refused[static_cast<std::size_t>(reason)];
}

void PaperLoop::made_by(Hand& hand, StepKind kind, EntityRef entity) {
  ++hand.now;
  if (hand.edits)
    hand.made.count(kind);
  else
    made(kind, entity, hand.plan.change);
}

std::vector<CollapseOutlook> PaperLoop::outlook(Edge entity) {
  const Edge edge = edge_of(entity);
  const EdgeEnds ends = this->ends(edge);
  std::vector<CollapseOutlook> outlooks(2);
  Plan plan;
  for (std::size_t i = 0; i < 2; ++i) {
    CollapseOutlook& o = outlooks[i];
    o.contraction = {ends[i], ends[1 - i], mesh_.position(ends[1 - i])};
    o.verdict = judge(edge, {i == 0, i == 1}, alone_, plan);
    o.limits = limits(mesh_.classification(entity));
    o.length = glm::length(mesh_.position(ends[0]) - mesh_.position(ends[1]));
    o.longest = 0.5 * spacing(ends[i]);
  }
  return outlooks;
}

// Edges that a swap among tetrahedra has made were not judged yet.
bool PaperLoop::try_swap(Edge edge, Hand& hand) {
  const EntityRef known_by = swap(edge, hand);
  if (!known_by.valid()) return false;
  if (!hand.edits) {
    judged_.resize(edges().capacity(), 0);
    refusal_.resize(edges().capacity(), Reason::None);
  }
  made_by(hand, StepKind::Swap, known_by);
  return true;
}

bool PaperLoop::try_smooth(Vertex v, Hand& hand) {
  if (!smooth(v, hand)) return false;
  made_by(hand, StepKind::Smooth, v);
  return true;
}

std::uint32_t PaperLoop::end_of_phase() const {
  return (phase_ == Phase::Smooth ? mesh_.ids(0) : edges()).capacity();
}

bool PaperLoop::at_target() const {
  return options_.target_faces > 0 && mesh_.count(dimension_) <= options_.target_faces;
}

std::uint32_t PaperLoop::next() {
  if (in_parts_) return turns_.next(mesh_, options_.threads);
  const IdPool& ids = phase_ == Phase::Smooth ? mesh_.ids(0) : edges();
  const std::uint32_t id = ids.next_alive(cursor_);
  cursor_ = id + 1;
  return id < ids.capacity() ? id : no_index;
}

// A part has its share of the faces that are to go, whatever the others have done.
bool PaperLoop::advance() {
  if (phase_ == Phase::Done) return false;
  const std::uint32_t id = next();
  alone_.within_part = in_parts_ && turns_.in_part();
  alone_.part = turns_.part();
  const bool stops = phase_ == Phase::Collapse && !alone_.within_part && at_target();
  if (id != no_index && !stops) return try_one(id, alone_);
  next_phase();
  return false;
}

bool PaperLoop::try_one(std::uint32_t id, Hand& hand) {
  if (phase_ == Phase::Smooth) return try_smooth(Vertex(id), hand);
  if (in_parts_ && has_gone(Edge(id))) return false;
  return phase_ == Phase::Swap ? try_swap(Edge(id), hand) : try_collapse(Edge(id), hand);
}

void PaperLoop::next_phase() {
  const bool improving = improved_ < options_.improve_passes;
  if (phase_ == Phase::Collapse && improving && options_.swap)
    enter(Phase::Swap);
  else if (phase_ != Phase::Smooth && improving && options_.smooth)
    enter(Phase::Smooth);
  else
    end_sweep();
}

bool PaperLoop::advance_parts(const std::function<bool()>& cancelled) {
  if (done() || !in_parts_ || !turns_.in_part() ||
      !surface_parts_may_share(mesh_, options_, guards_) ||
      !ready_for(std::min(std::size_t(options_.threads), part_count_)))
    return false;
  const PartsAtOnce<Hand>::Work work{part_count_, turns_.part(), options_.threads, cancelled};
  at_once_.need_hands(work, [&] { return std::make_unique<Hand>(at_once_.hands().size() + 1); });
  const bool all_done = at_once_.run(
      mesh_, work, sweeps_.back(), [&] { agree_on_now(); },
      [&](Hand& hand) { return advance_part(hand); });
  agree_on_now();
  settle();
  if (all_done) turns_.end_parts();
  return true;
}

// Parts may come to other hands.
void PaperLoop::agree_on_now() {
  for (const auto& hand : at_once_.hands()) alone_.now = std::max(alone_.now, hand->now);
  for (const auto& hand : at_once_.hands()) hand->now = alone_.now;
}

bool PaperLoop::advance_part(Hand& hand) {
  const std::uint32_t id = turns_.next_of(hand.part);
  if (id != no_index) try_one(id, hand);
  return id != no_index;
}

void PaperLoop::end_sweep() {
  close_sweep();
  const SweepStatistics& sweep = sweeps_.back();
  ++improved_;
  many_ = fewest_share * sweep.collapses >= edges().size();
  if (at_target() || (sweep.collapses == 0 && !grow()))
    phase_ = Phase::Done;
  else
    begin_sweep();
}

// Towards a target the spacing grows whenever nothing shorter is left to collapse, as long as that
// can let an edge go. While sweeps are still improved it grows by one step at a time, because
// swaps and smoothing change lengths.
bool PaperLoop::grow() {
  constexpr double growth = 1.2;
  const double needed = aims() ? needed_reach() : std::numeric_limits<double>::infinity();
  if (std::isinf(needed)) return false;
  do reach_ *= growth;
  while (reach_ < needed && improved_ >= options_.improve_passes);
  forget();
  return true;
}

// The least reach at which an edge that the spacing holds back could go. Infinite where none ever
// could: between vertices without a length around them at the start, or of infinite length.
double PaperLoop::needed_reach() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge e : EntityRange<1>(edges())) {
    if (refusal_[e] != Reason::Spacing) continue;
    const auto [a, b] = ends(e);
    const double length = glm::length(mesh_.position(a) - mesh_.position(b));
    const double needed = 2 * length * reach_ / std::max(spacing(a), spacing(b));
    if (needed < least) least = needed;
  }
  return least;
}

// Turns were dealt out before.
std::uint32_t PaperLoop::swap_pass() {
  std::uint32_t made = 0;
  alone_.within_part = false;
  for (const Edge e : EntityRange<1>(edges())) made += try_swap(e, alone_);
  if (in_parts_) turns_.give_up_parts();
  return made;
}

std::uint32_t PaperLoop::smooth_pass() {
  std::uint32_t made = 0;
  alone_.within_part = false;
  for (const Vertex v : mesh_.vertices()) made += try_smooth(v, alone_);
  if (in_parts_) turns_.give_up_parts();
  return made;
}

double PaperLoop::progress() const {
  if (done()) return 1;
  const double share = in_parts_        ? turns_.progress()
                       : end_of_phase() ? double(cursor_) / end_of_phase()
                                        : 1;
  const double part = (static_cast<double>(phase_) + share) / 3;
  return 1 - std::pow(0.5, static_cast<double>(sweeps_.size()) - 1 + part);
}

}  // namespace aomd
