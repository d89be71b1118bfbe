// The stages of the quality strategy for volumes: down until the target is reached or refused,
// improve, and down again as long as improvement has made something possible.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/decimate/volume/volume_quality_loop.h"
#include "core/mesh/geometry.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

// A weight that is given at regularity 0, 1/2 and 1, and follows powers between.
double between(double regularity, double at_0, double at_half, double at_1) {
  const double w = std::clamp(regularity, 0.0, 1.0);
  const double low = w < 0.5 ? at_0 : at_half, high = w < 0.5 ? at_half : at_1;
  return low * std::pow(high / low, w < 0.5 ? 2 * w : 2 * w - 1);
}

// Improvement takes tetrahedra too, most in its first round: by how much each descent but the last
// ends above the target.
constexpr std::array<double, 2> above{1.06, 1.007};

// A descent that takes less than this part of the tetrahedra was the last one, or with collapses
// that wait the last one without them.
constexpr double worth_another = 0.01, worth_waiting = 0.4;

}  // namespace

VolumeQualityLoop::VolumeQualityLoop(Mesh& mesh, const DecimationOptions& options)
    : Loop(mesh, options), improvement_(mesh, improving_, *this), alone_(mesh) {
  start(options);
}

void VolumeQualityLoop::restart(const DecimationOptions& options) {
  guards_.restart(mesh_, options);
  start(options);
}

void VolumeQualityLoop::start(const DecimationOptions& options) {
  options_ = options;
  options_.keep_volumes = options.keep_volumes && !options.model;
  target_ = options.target_faces;
  start_regions_ = mesh_.count(3);
  state_.assign(mesh_.capacity(0), {});
  debts_.reset(mesh_.capacity(0));
  if (options_.keep_volumes) limit_debts();
  stir_.assign(mesh_.capacity(0), 0);
  stir_now_ = stir_limit_ = 0;
  refusal_.assign(mesh_.complete(1) ? mesh_.capacity(1) : 0, Reason::None);
  find_unit();
  measure_vertices();
  set_rules();
  improvement_.set_threads(options_.threads);
  reach_of_payment_ = paid_at_once * std::max(1.0, stretch());
  descents_ = 0;
  waiting_ = false;
  begin_descent();
}

// How many times longer edges are to become.
double VolumeQualityLoop::stretch() const {
  if (target_ > 0) return std::cbrt(std::max(1.0, double(start_regions_) / target_));
  return options_.coarsest || options_.spacing ? 0 : options_.factor;
}

void VolumeQualityLoop::set_rules() {
  const double w = options_.regularity;
  floor_ = between(w, 0.285, 0.30, 0.40);
  surface_ = static_cast<float>(between(w, 7000, 55, 7));
  hold_ = between(w, 500000, 60, 7);
  const double fair = between(w, 1, 2, 2) * stretch() * stretch();
  patience_ = target_ > 0 ? static_cast<float>(fair) : unlimited;
  rules_.faces.max_turn = TurnLimit(options_.angle_deg);
  rules_.faces.topology = TopologyRule::Safe;
  rules_.faces.least_angle = LeastAngle(options_.min_angle_deg);
  rules_.least_shape = floor_;
  rules_.overshoot = 2 * stretch();
  rules_.size = &size_;
  improving_.removal.max_turn = TurnLimit(std::min(options_.angle_deg, 30.0));
  improving_.removal.least_angle = rules_.faces.least_angle;
  improving_.removal.goal = RemovalGoal::Sum;
  improving_.poor = 0.65;
  limit_dihedrals(options_.min_dihedral_deg);
}

void VolumeQualityLoop::limit_dihedrals(double deg) {
  rules_.least_dihedral = improving_.removal.least_dihedral = LeastAngle(deg);
  improvement_.set_rules(improving_);
}

void VolumeQualityLoop::find_unit() {
  Box box;
  for (const Region r : mesh_.regions())
    if (mesh_.shape(r) == Shape::Tetrahedron)
      for (const Vertex v : mesh_.tetrahedron(r)) box.add(mesh_.position(v));
  const glm::dvec3 sides = box.empty() ? glm::dvec3(0.0) : box.high - box.low;
  const double length = std::max({sides.x, sides.y, sides.z}) / std::cbrt(mesh_.count(3));
  unit_ = length > 0 ? std::ldexp(1.0, -std::ilogb(length)) : 1;
}

void VolumeQualityLoop::measure_vertices() {
  size_.assign(mesh_.capacity(0), 0.0);
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 each_alive(mesh_.ids(0), begin, end, [&](std::uint32_t id) {
                   state_[Vertex(id)].model = mesh_.classification(Vertex(id));
                 });
               });
  parallel_for(mesh_.capacity(0), options_.threads, vertices_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 Scratch scratch;
                 each_alive(mesh_.ids(0), begin, end,
                            [&](std::uint32_t id) { measure(Vertex(id), scratch); });
               });
  quadrics_of_model_edges();
}

// A collapse removes what is shorter than half the spacing: edges then end up at about that length.
void VolumeQualityLoop::measure(Vertex v, Scratch& scratch) {
  if (first_other_shape(mesh_, v).valid()) return;
  const std::span<const Vertex> around = neighbours_of(v, scratch);
  double sum = 0;
  for (const Vertex w : around) sum += glm::length(mesh_.position(v) - mesh_.position(w));
  size_[v] = around.empty() ? 0 : sum / double(around.size());
  State& s = state_[v];
  s.size = static_cast<float>(unit_ * size_[v]);
  const bool by_factor = !options_.spacing && !options_.coarsest && target_ == 0;
  const Column<Vertex, double>* given = options_.spacing.get();
  if (by_factor)
    s.reach = static_cast<float>(0.5 * unit_ * options_.factor * size_[v]);
  else if (given)
    s.reach = v.index < given->size() ? static_cast<float>(0.5 * unit_ * (*given)[v]) : 0.0f;
  else
    s.reach = unlimited;
  if (s.model.dimension() < 3) quadric_of_faces(v, scratch.star);
}

// Every model face is a plane to its three vertices, by its area (Garland, Heckbert 1997).
void VolumeQualityLoop::quadric_of_faces(Vertex v, Star& star) {
  const glm::dvec3 at = mesh_.position(v);
  gather_model_faces(mesh_, v, star);
  for (const StarFace& f : star) {
    const glm::dvec3 normal = area_normal(at, mesh_.position(f.next), mesh_.position(f.previous));
    const double length = glm::length(normal);
    if (length > 0)
      state_[v].quadric.add_plane(glm::vec3(normal / length), 0,
                                  static_cast<float>(unit_ * unit_ * length / 6));
  }
}

// A model edge is a plane at right angles to each face beside it, by the square of its length.
void VolumeQualityLoop::quadrics_of_model_edges() {
  for (const Edge e : mesh_.edges()) {
    if (mesh_.classification(e).dimension() > 1) continue;
    const auto [a, b] = mesh_.edge_vertices(e);
    const glm::dvec3 along = mesh_.position(b) - mesh_.position(a);
    gather_model_faces(mesh_, a, alone_.scratch.star);
    for (const StarFace& f : alone_.scratch.star) {
      if (!f.uses(b)) continue;
      const glm::dvec3 normal =
          area_normal(mesh_.position(a), mesh_.position(f.next), mesh_.position(f.previous));
      const glm::dvec3 across = glm::cross(along, normal);
      const double length = glm::length(across), square = glm::dot(along, along);
      if (!(length > 0)) continue;
      for (const Vertex v : {a, b})
        state_[v].quadric.add_plane(glm::vec3(across / length), 0,
                                    static_cast<float>(curve_weight * unit_ * unit_ * square));
    }
  }
}

// A collapse that costs more than what makes edges as long as they have to become on average is the
// model faces' loss. Improvement often lets cheaper ones through that were refused before.
void VolumeQualityLoop::lose_patience() {
  constexpr float dearer = 64;
  if (freed_ < worth_waiting * before_descent_) patience_ *= dearer;
}

void VolumeQualityLoop::begin_descent() {
  if (waiting_)
    lose_patience();
  else
    ++descents_;
  waiting_ = false;
  settling_ = 0;
  const auto turn = static_cast<std::size_t>(descents_ - 1);
  goal_ = static_cast<std::uint32_t>((turn < above.size() ? above[turn] : 1.0) * target_);
  round_ = 0;
  before_descent_ = mesh_.count(3);
  fill_queue();
  phase_ = Phase::Collapse;
  open_sweep();
}

void VolumeQualityLoop::begin_improvement() {
  freed_ = before_descent_ - mesh_.count(3);
  enter(options_.swap ? Phase::Swap : Phase::Smooth);
}

// A pass looks at what has changed since the one before it began.
void VolumeQualityLoop::enter(Phase phase) {
  cursor_ = 0;
  improvement_.begin_pass();
  if (phase == Phase::Swap) stir_limit_ = stir_now_++;
  phase_ = phase;
  part_count_ = parts_now();
  if (phase == Phase::Smooth && settling_ == 0 && part_count_ > 1)
    turns_.begin(mesh_, 0, part_count_, options_.threads);
}

bool VolumeQualityLoop::last_descent() const {
  if (waiting_) return false;
  return (descents_ > 1 && reached()) ||
         (descents_ > 1 && freed_ < worth_another * before_descent_);
}

void VolumeQualityLoop::end_phase() {
  if (settling_ > 0)
    end_settling();
  else if (phase_ == Phase::Swap && options_.smooth)
    enter(Phase::Smooth);
  else
    end_round();
}

void VolumeQualityLoop::end_round() {
  if (++round_ < rounds()) {
    open_sweep();
    enter(options_.swap ? Phase::Swap : Phase::Smooth);
  } else if (!last_descent() || relax() || (reached() && mesh_.count(3) > target_)) {
    begin_descent();
  } else {
    end_settling();
  }
}

// One round lets a descent go on; three are what a result is worth, unless all but a few of its
// tetrahedra have had them.
int VolumeQualityLoop::rounds() const {
  constexpr double few = 0.02;
  if (waiting_) return 1;
  if (reached() && descents_ > 2 && freed_ < few * before_descent_) return 1;
  return last_descent() || descents_ > 2 ? 3 : 1;
}

// A target that shape and length keep out of reach is worth poorer tetrahedra, to a point: shapes
// that low may hide angles that solvers do not bear.
bool VolumeQualityLoop::relax() {
  constexpr double poorest = 0.2, smallest_deg = 10;
  if (target_ == 0 || reached() || rules_.least_shape <= poorest) return false;
  rules_.least_shape = std::max(poorest, 0.7 * rules_.least_shape);
  rules_.overshoot *= 1.25;
  limit_dihedrals(std::max(options_.min_dihedral_deg, smallest_deg));
  return true;
}

// What regions are owed at the end is paid in a few passes.
void VolumeQualityLoop::end_settling() {
  constexpr int passes = 32;
  if (settling_ < passes && options_.keep_volumes && options_.smooth) {
    ++settling_;
    enter(Phase::Smooth);
    return;
  }
  close_sweep();
  phase_ = Phase::Done;
}

bool VolumeQualityLoop::advance() {
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

double VolumeQualityLoop::progress() const {
  if (done()) return 1;
  const double goal = target_, all = start_regions_;
  const double part = all > goal ? (all - mesh_.count(3)) / (all - goal) : 1;
  const double descended = 0.6 * std::clamp(part, 0.0, 1.0);
  return phase_ == Phase::Collapse ? descended : std::max(descended, 0.6 + 0.1 * round_);
}

}  // namespace aomd
