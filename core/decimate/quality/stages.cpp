// The stages of the quality strategy: down to a little above the target, improve, measure anew,
// down to the target, improve.

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/decimate/quality/quality_loop.h"
#include "core/decimate/spacing/spacing.h"
#include "core/mesh/geometry.h"

namespace aomd {
namespace {

// Two faces go with most collapses. Far above the target eight octaves of costs are worked off at
// once.
constexpr RoundRules surface_rounds{.dimension = 2, .most_each = 2, .buckets_far_off = 16};

// A weight that is given at regularity 0, 1/2 and 1, and follows powers between.
double between(double regularity, double at_0, double at_half, double at_1) {
  const double w = std::clamp(regularity, 0.0, 1.0);
  const double low = w < 0.5 ? at_0 : at_half, high = w < 0.5 ? at_half : at_1;
  return low * std::pow(high / low, w < 0.5 ? 2 * w : 2 * w - 1);
}

// What counts for those who want accuracy first: 1/2 for them, 0 for all others.
double accuracy(double regularity) { return std::max(0.0, 0.5 - std::max(0.0, regularity)); }

bool is_flat(const Mesh& mesh, Vertex v) {
  constexpr double flat = 1 - 1e-6;  // cosine: some 0.1 degrees
  glm::dvec3 sum(0.0);
  double areas = 0;
  for (const Face f : mesh.row<2>(v)) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 normal =
        area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    sum += normal;
    areas += glm::length(normal);
  }
  return glm::length(sum) >= flat * areas;
}

// About how many vertices lie where the surface bends: flat places end up with next to no faces,
// and have none of their points to offer elsewhere.
double bent_vertices(const Mesh& mesh) {
  constexpr std::uint32_t one_of = 16;
  std::uint32_t seen = 0, bent = 0;
  const IdPool& ids = mesh.ids(0);
  for (std::uint32_t id = ids.next_alive(0); id < ids.capacity();
       id = ids.next_alive(id + one_of)) {
    ++seen;
    bent += !is_flat(mesh, Vertex(id));
  }
  return seen > 0 ? double(mesh.count(0)) * bent / seen : 0;
}

// A vertex that is fitted to a handful of points follows their noise, and what lies between them
// not at all. More points take time: for those who want accuracy first.
Sampling sampling(const Mesh& mesh, const DecimationOptions& options) {
  constexpr double enough = 8;  // vertices of the original for each face of the result
  const bool by_factor = options.target_faces == 0 && !options.coarsest && !options.spacing;
  const double faces =
      by_factor ? mesh.count(2) / (options.factor * options.factor) : options.target_faces;
  const bool wanted = options.regularity < 0.5 && options.has(Idea::DensePoints);
  const bool too_few =
      wanted && (mesh.count(0) < enough * faces || bent_vertices(mesh) < enough * faces);
  return too_few ? Sampling::VerticesAndFaces : Sampling::Vertices;
}

}  // namespace

QualityLoop::QualityLoop(Mesh& mesh, DecimationOptions options)
    : Loop(mesh, options.without_original()),
      from_samples_(options.original != nullptr),
      original_(from_samples_
                    ? OriginalSurface(mesh, *std::exchange(options.original, nullptr))
                    : OriginalSurface(mesh, sampling(mesh, options), accuracy(options.regularity))),
      curves_(mesh),
      fitter_(mesh, original_, curves_),
      queue_(mesh, original_, curves_, options_, partition_),
      rounds_(mesh, queue_, surface_rounds),
      alone_(mesh) {
  if (options.values) {
    values_ = std::make_unique<AttributeFit>(mesh, original_, *options.values);
    queue_.count(values_->original());
    fitter_.count(*values_);
  }
  if (from_samples_) locate();
  start(options);
}

OriginalSamples QualityLoop::original() {
  locate();
  return original_.samples();
}

void QualityLoop::set_rules() {
  const double w = options_.regularity;
  const double usual_least_deg = between(w, 4, 12, 12);
  rules_.max_turn = TurnLimit(options_.angle_deg);
  rules_.topology = options_.topology;
  rules_.original_normals = options_.has(Idea::Facing) ? &queue_.normals() : nullptr;
  fit_.max_away = TurnLimit(options_.has(Idea::Facing) ? 60 : 179);
  fit_.far = options_.has(Idea::FarPoints) ? 0.1 : 0;
  fit_.stay_far = options_.has(Idea::FarPoints) ? 0.3 - 0.6 * accuracy(w) : 0;
  rules_.least_angle = LeastAngle(options_.min_angle_deg);
  rules_.least_around = LeastAngle(0);
  sliver_rules_ = away_rules_ = rules_;
  if (options_.target_faces > 0) away_rules_.original_normals = nullptr;
  rules_.least_around = LeastAngle(usual_least_deg);
  sliver_price_ = static_cast<float>(between(w, 1, 1e4, 1e4));
  away_price_ = static_cast<float>(between(w, 10, 1e4, 1e4));
  fit_.max_turn = TurnLimit(std::min(options_.angle_deg, 30.0));
  fit_.shape = between(w, 0.3, 1.5, 4);
  fit_.local = 2 * accuracy(w);
  fit_.pull = between(w, 1e-4, 0.022, 0.07);
  fit_.least_angle = LeastAngle(std::max(options_.min_angle_deg, usual_least_deg));
  fit_.model = options_.model;
}

CostRules QualityLoop::cost_rules() const {
  CostRules rules;
  const double diagonal = original_.diagonal(),
               points = static_cast<double>(original_.points().size());
  rules.edge_weight = static_cast<float>(between(options_.regularity, 2e-8, 3e-4, 5e-3));
  if (original_.area() > 0) rules.unit_area = original_.area() / points;
  if (diagonal > 0) rules.scale = static_cast<float>(1 / (diagonal * diagonal));
  rules.cubes = options_.has(Idea::ThirdPowers);
  rules.places = options_.has(Idea::Placement);
  return rules;
}

// A collapse removes what is shorter than half the spacing: edges then end up at about that length.
void QualityLoop::fill_spacing() {
  const bool by_factor = !options_.spacing && !options_.coarsest && options_.target_faces == 0;
  if (by_factor && average_length_.size() == 0)
    average_length_ = evaluate_spacing(mesh_, {SpacingByFactor{1}, {}});
  const double factor = by_factor ? options_.factor : 1;
  const Column<Vertex, double>* given = by_factor ? &average_length_ : options_.spacing.get();
  for (const Vertex v : mesh_.vertices()) {
    const bool known = given && v.index < given->size();
    const float half = known ? static_cast<float>(0.5 * factor * (*given)[v]) : 0.0f;
    queue_.set_reach(v, given ? half : CollapseQueue::unlimited);
  }
}

// Without a target the first stage goes as far as spacing and limits let it, and the second takes
// what improvement has made possible.
void QualityLoop::set_goals() {
  constexpr double above = 1.3;
  const std::uint32_t target = options_.target_faces;
  goals_ = {target};
  if (options_.has(Idea::SecondStage))
    goals_.insert(goals_.begin(),
                  static_cast<std::uint32_t>(std::min<double>(above * target, mesh_.count(2))));
  start_faces_ = mesh_.count(2);
}

void QualityLoop::restart(const DecimationOptions& options) {
  original_.locate_anywhere(mesh_, options.threads);
  curves_.locate_anywhere(mesh_);
  guards_.restart(mesh_, options);
  start(options);
}

void QualityLoop::start(const DecimationOptions& options) {
  options_ = options;
  set_rules();
  set_goals();
  queue_.reset(cost_rules());
  fill_spacing();
  stage_ = 0;
  part_count_ = options_.parts > 0
                    ? std::min<std::size_t>(std::size_t(options_.parts), Partition::most_parts)
                    : part_count(mesh_);
  begin_stage();
}

void QualityLoop::begin_stage() {
  partition_ = Partition(mesh_, part_count_, 0, options_.threads);
  queue_.measure(stage_ > 0 || from_samples_);
  rounds_.begin(goals_[stage_], part_count_);
  refusal_.assign(mesh_.capacity(1), Reason::None);
  round_ = 0;
  phase_ = Phase::Collapse;
  open_sweep();
}

void QualityLoop::begin_improvement() {
  locate();
  measure_energy();
  enter(options_.swap ? Phase::Swap : Phase::Smooth);
}

void QualityLoop::locate() {
  original_.locate(mesh_, options_.threads);
  curves_.locate(mesh_);
}

void QualityLoop::measure_energy() {
  if (values_) values_->locate();
  const double faces = std::max<double>(1, mesh_.count(2));
  const double least =
      1e-4 * std::sqrt(original_.area() / faces);  // flat meshes have shape to care for only
  fit_.face_energy = std::max(original_.error() / faces, least * least * original_.area() / faces);
  fit_.mean_square = fit_.face_energy * faces / original_.area();
}

void QualityLoop::enter(Phase phase) {
  cursor_ = 0;
  swaps_ = {};
  corner_ = 0;
  phase_ = phase;
  if (part_count_ > 1)
    turns_.begin(mesh_, phase == Phase::Swap ? 2 : 0, part_count_, options_.threads);
}

void QualityLoop::end_phase() {
  if (phase_ == Phase::Swap && options_.smooth)
    enter(Phase::Smooth);
  else
    end_round();
}

void QualityLoop::end_round() {
  if (++round_ == rounds() && last_stage()) {  // nobody asks for the points any more
    sweeps_.back().faces = mesh_.count(2);
    phase_ = Phase::Done;
    return;
  }
  locate();
  if (round_ < rounds()) {
    open_sweep();
    enter(options_.swap ? Phase::Swap : Phase::Smooth);
  } else {
    ++stage_;
    begin_stage();
  }
}

bool QualityLoop::advance() {
  switch (phase_) {
    case Phase::Collapse:
      return advance_collapse();
    case Phase::Swap:
      return advance_swap();
    case Phase::Smooth:
      return advance_smooth();
    case Phase::Done:
      break;
  }
  return false;
}

double QualityLoop::progress() const {
  if (done()) return 1;
  const double share = static_cast<double>(stage_) / static_cast<double>(goals_.size());
  if (phase_ != Phase::Collapse) return share + 0.5 * (0.8 + 0.2 * round_ / rounds());
  const double goal = goals_[stage_];
  const double part =
      start_faces_ > goal ? (start_faces_ - mesh_.count(2)) / (start_faces_ - goal) : 1;
  return share + 0.4 * std::clamp(part, 0.0, 1.0);
}

}  // namespace aomd
