#include "core/decimate/paper/paper_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/decimate/spacing/spacing.h"

namespace aomd {

PaperLoop::PaperLoop(Mesh& mesh, const DecimationOptions& options, int dimension)
    : Loop(mesh, options), dimension_(dimension) {}

void PaperLoop::start() {
  set_rules();
  reach_ = first_reach();
  average_length_ = average_lengths();
  forget();
  begin_sweep();
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
  forget();
  improved_ = 0;
  begin_sweep();
}

void PaperLoop::forget() {
  judged_.assign(edges().capacity(), 0);
  refusal_.assign(edges().capacity(), Reason::None);
  changed_.assign(mesh_.capacity(0), ++now_);
}

void PaperLoop::begin_sweep() {
  phase_ = Phase::Collapse;
  cursor_ = 0;
  open_sweep();
}

// A collapse removes what is shorter than half the spacing: edges then end up at about that length.
Verdict PaperLoop::judge(Vertex a, Vertex b) {
  Plan plan;
  return judge(between(a, b), {true, true}, plan);
}

Verdict PaperLoop::judge(Edge edge, std::array<bool, 2> may_go, Plan& plan) {
  const EdgeEnds ends = this->ends(edge);
  const double length = glm::length(mesh_.position(ends[0]) - mesh_.position(ends[1]));
  for (std::size_t i = 0; i < 2; ++i) may_go[i] = may_go[i] && 0.5 * spacing(ends[i]) > length;
  if (!may_go[0] && !may_go[1]) return {Reason::Spacing, edge, length};
  const std::size_t first = may_go[0] ? 0 : 1;
  for (std::size_t i = 0; i < 2; ++i) may_go[i] = may_go[i] && !options_.kept(ends[i]);
  if (!may_go[0] && !may_go[1]) return {Reason::Kept, ends[first]};
  return judge_collapse(edge, may_go, plan);
}

Verdict PaperLoop::judge(Edge edge, Vertex& deleted) {
  Plan plan;
  const Verdict verdict = judge(edge_of(edge), {true, true}, plan);
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

bool PaperLoop::try_collapse(Edge edge) {
  if (unchanged_since(edge)) {
    ++sweeps_.back().refused[static_cast<std::size_t>(refusal_[edge])];
    return false;
  }
  const Verdict verdict = judge(edge, {true, true}, plan_);
  if (!verdict.accepted()) {
    judged_[edge] = now_;
    refusal_[edge] = verdict.reason;
    ++sweeps_.back().refused[static_cast<std::size_t>(verdict.reason)];
    return false;
  }
  const EntityRef known_by = collapse(edge);
  ++now_;
  made(StepKind::Collapse, known_by, plan_.change);
  return true;
}

std::vector<CollapseOutlook> PaperLoop::outlook(Edge entity) {
  const Edge edge = edge_of(entity);
  const EdgeEnds ends = this->ends(edge);
  std::vector<CollapseOutlook> outlooks(2);
  Plan plan;
  for (std::size_t i = 0; i < 2; ++i) {
    CollapseOutlook& o = outlooks[i];
    o.contraction = {ends[i], ends[1 - i], mesh_.position(ends[1 - i])};
    o.verdict = judge(edge, {i == 0, i == 1}, plan);
    o.limits = limits(mesh_.classification(entity));
    o.length = glm::length(mesh_.position(ends[0]) - mesh_.position(ends[1]));
    o.longest = 0.5 * spacing(ends[i]);
  }
  return outlooks;
}

// Edges that a swap among tetrahedra has made were not judged yet.
bool PaperLoop::try_swap(Edge edge) {
  const EntityRef known_by = swap(edge);
  if (!known_by.valid()) return false;
  ++now_;
  judged_.resize(edges().capacity(), 0);
  refusal_.resize(edges().capacity(), Reason::None);
  made(StepKind::Swap, known_by, plan_.change);
  return true;
}

bool PaperLoop::try_smooth(Vertex v) {
  if (!smooth(v)) return false;
  ++now_;
  made(StepKind::Smooth, v, plan_.change);
  return true;
}

std::uint32_t PaperLoop::end_of_phase() const {
  return (phase_ == Phase::Smooth ? mesh_.ids(0) : edges()).capacity();
}

bool PaperLoop::at_target() const {
  return options_.target_faces > 0 && mesh_.count(dimension_) <= options_.target_faces;
}

bool PaperLoop::advance() {
  if (phase_ == Phase::Done) return false;
  if (cursor_ >= end_of_phase() || (phase_ == Phase::Collapse && at_target())) {
    next_phase();
    return false;
  }
  const std::uint32_t id = (phase_ == Phase::Smooth ? mesh_.ids(0) : edges()).next_alive(cursor_);
  cursor_ = id + 1;
  if (id >= end_of_phase()) return false;
  if (phase_ == Phase::Collapse) return try_collapse(Edge(id));
  return phase_ == Phase::Swap ? try_swap(Edge(id)) : try_smooth(Vertex(id));
}

void PaperLoop::next_phase() {
  cursor_ = 0;
  const bool improving = improved_ < options_.improve_passes;
  if (phase_ == Phase::Collapse && improving && options_.swap)
    phase_ = Phase::Swap;
  else if (phase_ != Phase::Smooth && improving && options_.smooth)
    phase_ = Phase::Smooth;
  else
    end_sweep();
}

void PaperLoop::end_sweep() {
  close_sweep();
  const SweepStatistics& sweep = sweeps_.back();
  ++improved_;
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

std::uint32_t PaperLoop::swap_pass() {
  std::uint32_t made = 0;
  for (const Edge e : EntityRange<1>(edges())) made += try_swap(e);
  return made;
}

std::uint32_t PaperLoop::smooth_pass() {
  std::uint32_t made = 0;
  for (const Vertex v : mesh_.vertices()) made += try_smooth(v);
  return made;
}

double PaperLoop::progress() const {
  if (done()) return 1;
  const double share = end_of_phase() ? double(cursor_) / end_of_phase() : 1;
  const double part = (static_cast<double>(phase_) + share) / 3;
  return 1 - std::pow(0.5, static_cast<double>(sweeps_.size()) - 1 + part);
}

}  // namespace aomd
