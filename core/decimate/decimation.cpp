#include "core/decimate/decimation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/mesh/check.h"
#include "core/operators/smooth.h"

namespace aomd {

const char* phase_name(Phase phase) {
  constexpr const char* names[] = {"collapse", "swap", "smooth", "done"};
  return names[static_cast<std::size_t>(phase)];
}

const char* decimation_obstacle(const Mesh& mesh) {
  if (mesh.count(3) > 0) return "Decimating volumes is not part of this version.";
  for (const Face f : mesh.faces())
    if (mesh.shape(f) != Shape::Triangle)
      return "Only triangles can be decimated, and there are quads: .ply is read as triangles.";
  return nullptr;
}

namespace {

Mesh& decimable(Mesh& mesh) {
  if (const char* obstacle = decimation_obstacle(mesh)) throw std::invalid_argument(obstacle);
  return mesh;
}

}  // namespace

Decimation::Decimation(Mesh& mesh, const DecimationOptions& options)
    : mesh_(decimable(mesh)),
      options_(options),
      limit_(options.angle_deg),
      needs_{mesh.request(2, 0), mesh.request(0, 1), mesh.request(0, 2)},
      collapser_(mesh),
      changed_(mesh.capacity(0), 1),
      judged_(mesh.capacity(1), 0),
      refusal_(mesh.capacity(1), Reason::None) {
  fill_spacing();
  begin_sweep();
}

void Decimation::fill_spacing() {
  average_length_.assign(mesh_.capacity(0), 0.0);
  for (const Edge e : mesh_.edges()) {
    const auto [a, b] = mesh_.edge_vertices(e);
    const double length = glm::length(mesh_.position(a) - mesh_.position(b));
    average_length_[a] += length;
    average_length_[b] += length;
  }
  for (const Vertex v : mesh_.vertices())
    if (const std::size_t degree = mesh_.row<1>(v).size()) average_length_[v] /= static_cast<double>(degree);
}

double Decimation::spacing(Vertex v) const {
  return options_.coarsest ? std::numeric_limits<double>::infinity() : average_length_[v] * options_.factor;
}

void Decimation::set_options(const DecimationOptions& options) {
  if (options == options_) return;
  options_ = options;
  limit_ = TurnLimit(options.angle_deg);
  invalidate();
}

void Decimation::invalidate() {
  average_length_.resize(mesh_.capacity(0), 0.0);
  judged_.assign(mesh_.capacity(1), 0);
  refusal_.assign(mesh_.capacity(1), Reason::None);
  changed_.assign(mesh_.capacity(0), ++now_);
  improved_ = 0;
  begin_sweep();
}

void Decimation::begin_sweep() {
  phase_ = Phase::Collapse;
  cursor_ = 0;
  const bool unused = !sweeps_.empty() && sweeps_.back() == SweepStatistics{};
  if (!unused && !sweeps_.empty()) sweeps_.back().faces = mesh_.count(2);
  if (!unused) sweeps_.emplace_back();
}

// A collapse removes what is shorter than half the wanted length: edges then end up at about that length.
Verdict Decimation::judge(Edge edge, Vertex& deleted) {
  const auto ends = mesh_.edge_vertices(edge);
  const double length = glm::length(mesh_.position(ends[0]) - mesh_.position(ends[1]));
  const std::array<bool, 2> short_for{0.5 * spacing(ends[0]) > length, 0.5 * spacing(ends[1]) > length};
  if (!short_for[0] && !short_for[1]) return {Reason::Spacing, edge, length};
  return collapser_.judge_either(mesh_, edge, short_for, rules(), deleted);
}

bool Decimation::unchanged_since(Edge e) const {
  const auto [a, b] = mesh_.edge_vertices(e);
  return std::max(changed_[a], changed_[b]) <= judged_[e];
}

bool Decimation::try_collapse(Edge edge) {
  SweepStatistics& sweep = sweeps_.back();
  if (unchanged_since(edge)) {
    ++sweep.refused[static_cast<std::size_t>(refusal_[edge])];
    return false;
  }
  Vertex deleted;
  const Verdict verdict = judge(edge, deleted);
  if (!verdict.accepted()) {
    judged_[edge] = now_;
    refusal_[edge] = verdict.reason;
    ++sweep.refused[static_cast<std::size_t>(verdict.reason)];
    return false;
  }
  ++now_;
  collapser_.apply_accepted(mesh_, edge, deleted);
  for (const Collapser::StarFace& f : collapser_.star()) touch(f.next), touch(f.previous);
  ++sweep.collapses;
  last_ = {StepKind::Collapse, edge};
  return true;
}

bool Decimation::try_swap(Edge edge) {
  EdgePair pair;
  if (!judge_swap(mesh_, edge, limit_, pair).accepted()) return false;
  ++now_;
  apply_swap(mesh_, edge, pair);
  for (const Vertex v : {pair.a, pair.b, pair.c, pair.d}) touch(v);
  ++sweeps_.back().swaps;
  last_ = {StepKind::Swap, edge};
  return true;
}

bool Decimation::try_smooth(Vertex v) {
  glm::dvec3 target;
  if (!judge_smooth(mesh_, v, {limit_, options_.model}, target).accepted()) return false;
  ++now_;
  apply_smooth(mesh_, v, target);
  for (const Edge e : mesh_.row<1>(v))
    for (const Vertex u : mesh_.edge_vertices(e)) touch(u);
  ++sweeps_.back().smooths;
  last_ = {StepKind::Smooth, v};
  return true;
}

std::uint32_t Decimation::end_of_phase() const { return mesh_.capacity(phase_ == Phase::Smooth ? 0 : 1); }

bool Decimation::advance() {
  if (phase_ == Phase::Done) return false;
  if (cursor_ >= end_of_phase()) {
    next_phase();
    return false;
  }
  const std::uint32_t id = mesh_.ids(phase_ == Phase::Smooth ? 0 : 1).next_alive(cursor_);
  cursor_ = id + 1;
  if (id >= end_of_phase()) return false;
  switch (phase_) {
    case Phase::Collapse:
      return try_collapse(Edge(id));
    case Phase::Swap:
      return try_swap(Edge(id));
    case Phase::Smooth:
      return try_smooth(Vertex(id));
    case Phase::Done:
      break;
  }
  return false;
}

void Decimation::next_phase() {
  cursor_ = 0;
  const bool improving = improved_ < options_.improve_passes;
  if (phase_ == Phase::Collapse && improving && options_.swap)
    phase_ = Phase::Swap;
  else if (phase_ != Phase::Smooth && improving && options_.smooth)
    phase_ = Phase::Smooth;
  else
    end_sweep();
}

void Decimation::end_sweep() {
  SweepStatistics& sweep = sweeps_.back();
  sweep.faces = mesh_.count(2);
  ++improved_;
  if (sweep.collapses == 0)
    phase_ = Phase::Done;
  else
    begin_sweep();
}

std::optional<Operation> Decimation::step() {
  while (!done())
    if (advance()) return last_;
  return {};
}

std::uint32_t Decimation::sweep() {
  if (done()) begin_sweep();
  while (phase_ == Phase::Swap || phase_ == Phase::Smooth) advance();
  if (done()) return 0;
  std::uint32_t collapses = 0;
  while (phase_ == Phase::Collapse && cursor_ < end_of_phase()) collapses += advance();
  advance();
  return collapses;
}

std::uint32_t Decimation::swap_pass() {
  std::uint32_t made = 0;
  for (const Edge e : mesh_.edges()) made += try_swap(e);
  return made;
}

std::uint32_t Decimation::smooth_pass() {
  std::uint32_t made = 0;
  for (const Vertex v : mesh_.vertices()) made += try_smooth(v);
  return made;
}

Decimation::Stop Decimation::run(std::optional<std::chrono::microseconds> budget,
                                 const std::function<bool()>& cancelled) {
  constexpr int candidates_between_checks = 64;
  const auto start = std::chrono::steady_clock::now();
  while (!done()) {
    for (int i = 0; i < candidates_between_checks; ++i) advance();
    if (cancelled && cancelled()) return Stop::Cancelled;
    if (budget && std::chrono::steady_clock::now() - start >= *budget)
      return done() ? Stop::Done : Stop::Budget;
  }
  return Stop::Done;
}

double Decimation::progress() const {
  if (done()) return 1;
  const double share = end_of_phase() ? double(cursor_) / end_of_phase() : 1;
  const double part = (static_cast<double>(phase_) + share) / 3;
  return 1 - std::pow(0.5, static_cast<double>(sweeps_.size()) - 1 + part);
}

}  // namespace aomd
