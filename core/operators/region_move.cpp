#include "core/operators/region_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/assertion.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/tet_edits.h"

namespace aomd {
namespace {

// The sine of what counts as straight: coordinates may have been stored in single precision.
constexpr double straight = 1e-5;

bool is_across(const glm::dvec3& normal, const glm::dvec3& axis) {
  return std::abs(glm::dot(normal, axis)) <= straight * glm::length(normal);
}

// The sum of the area normals of one model face around the vertex: moving it by d changes the
// volume on either side by dot(d, sum) / 6.
glm::dvec3 swept_normal(const Mesh& mesh, const RegionMove& plan, ModelRef model) {
  const glm::dvec3 at = mesh.position(plan.vertex);
  glm::dvec3 sum(0.0);
  for (const StarFace& f : plan.star)
    if (mesh.classification(f.face) == model)
      sum += area_normal(at, mesh.position(f.next), mesh.position(f.previous));
  return sum;
}

Verdict judge_faces(const Mesh& mesh, const RegionMove& plan, const glm::dvec3& to,
                    const MoveRules& rules) {
  const glm::dvec3 from = mesh.position(plan.vertex);
  for (const StarFace& f : plan.star) {
    const glm::dvec3 p = mesh.position(f.next), q = mesh.position(f.previous);
    const glm::dvec3 before = area_normal(from, p, q), after = area_normal(to, p, q);
    if (is_flat(to, p, q, after)) return {Reason::Flat, f.face};
    if (!rules.max_turn.allows(before, after) && !is_flat(from, p, q, before))
      return {Reason::Angle, f.face, cosine_between(before, after)};
    if (!rules.least_angle.binds()) continue;
    const double cosine = smallest_angle_cosine(to, p, q);
    if (!rules.least_angle.allows(cosine, [&] { return smallest_angle_cosine(from, p, q); }))
      return {Reason::Shape, f.face, cosine};
  }
  return {};
}

// The point of the convex hull of some slopes that is nearest to none at all: every one of them
// rises along it (Gilbert's iteration).
glm::dvec3 nearest_to_zero(const std::vector<glm::dvec3>& slopes) {
  glm::dvec3 x = slopes[0];
  for (int round = 0; round < 16; ++round) {
    const auto least = std::min_element(
        slopes.begin(), slopes.end(),
        [&](const auto& a, const auto& b) { return glm::dot(a, x) < glm::dot(b, x); });
    const glm::dvec3 back = x - *least;
    const double gain = glm::dot(x, back), length2 = glm::dot(back, back);
    if (!(gain > 1e-6 * glm::dot(x, x)) || !(length2 > 0)) break;
    x -= std::min(1.0, gain / length2) * back;
  }
  return x;
}

}  // namespace

glm::dvec3 RegionMover::Freedom::part_of(const glm::dvec3& way) const {
  const glm::dvec3 along = glm::dot(axis, way) * axis;
  return dimension == 3 ? way : dimension == 2 ? way - along : along;
}

double RegionMover::Cell::shape(const glm::dvec3& at) const { return tet_shape(at, a, b, c); }

double RegionMover::Cell::dihedral_cosine(const glm::dvec3& at) const {
  return smallest_dihedral_cosine(at, a, b, c);
}

// Of sqrt(2) six_volumes / m^(3/2), where m is the mean of the squared edges.
glm::dvec3 RegionMover::Cell::slope(const glm::dvec3& at) const {
  const double m = squared_edges(at, a, b, c) / 6;
  const glm::dvec3 of_volume = -glm::cross(b - a, c - a), of_m = (3.0 * at - a - b - c) / 3.0;
  return std::numbers::sqrt2 / (m * std::sqrt(m)) *
         (of_volume - 1.5 * six_volumes(at, a, b, c) / m * of_m);
}

void RegionMover::average_inside(const Mesh& mesh, const Ball& ball) {
  if (mark_.size() < mesh.capacity(0)) mark_.resize(mesh.capacity(0), 0);
  if (++stamp_ == 0) {
    mark_.assign(mark_.size(), 0);
    stamp_ = 1;
  }
  glm::dvec3 sum(0.0);
  std::uint32_t count = 0;
  for_corners(ball, [&](Vertex v) {
    if (mark_[v] == stamp_) return;
    mark_[v] = stamp_;
    sum += mesh.position(v);
    ++count;
  });
  freedom_ = {};
  average_ = sum / double(count);
}

// On a model face: across the sum of the normals around, which keeps the volume on each side.
Verdict RegionMover::find_way_across(const Mesh& mesh, const RegionMove& plan) {
  const Vertex v = plan.vertex;
  if (plan.star.empty() || !is_ring(plan.star)) return {Reason::Classification, v};
  const glm::dvec3 normal = swept_normal(mesh, plan, mesh.classification(v));
  const double length = glm::length(normal);
  if (!(length > 0)) return {Reason::Flat, plan.star[0].face};
  freedom_ = {2, normal / length};
  glm::dvec3 sum(0.0);
  for (const StarFace& f : plan.star) sum += mesh.position(f.next);
  average_ = sum / double(plan.star.size());
  return {};
}

// On a model edge: along it, where that leaves it and the model faces around as they are, or a
// model says where they are.
Verdict RegionMover::find_way_along(const Mesh& mesh, const MoveRules& rules,
                                    const RegionMove& plan) {
  const Vertex v = plan.vertex;
  std::array<Edge, 2> pieces;
  std::array<glm::dvec3, 2> ends;
  std::size_t count = 0;
  for_edges_at(mesh, v, plan.star, [&](Edge e, Vertex far) {
    if (mesh.classification(e) != mesh.classification(v)) return;
    if (count < 2) {
      pieces[count] = e;
      ends[count] = mesh.position(far);
    }
    ++count;
  });
  if (count != 2) return {Reason::Classification, v};
  const glm::dvec3 at = mesh.position(v), chord = ends[1] - ends[0];
  const double length = glm::length(chord);
  const glm::dvec3 axis = length > 0 ? chord / length : chord;
  freedom_ = {1, axis};
  average_ = 0.5 * (ends[0] + ends[1]);
  if (rules.model) return {};
  const double bend = glm::length(glm::cross(axis, at - ends[0]));
  const bool between = glm::dot(at - ends[0], ends[1] - at) > 0;
  if (!between || bend > straight * length)
    return {Reason::Angle, pieces[0], cosine_between(at - ends[0], ends[1] - at)};
  for (const StarFace& f : plan.star)
    if (const glm::dvec3 n = swept_normal(mesh, plan, mesh.classification(f.face));
        !is_across(n, axis))
      return {Reason::Angle, f.face, cosine_between(n, n - glm::dot(n, axis) * axis)};
  return {};
}

Verdict RegionMover::find_freedom(const Mesh& mesh, const MoveRules& rules,
                                  const RegionMove& plan) {
  const int dimension = mesh.classification(plan.vertex).dimension();
  if (plan.ball.empty() || dimension == 0 || dimension > 3)
    return {Reason::Classification, plan.vertex};
  if (dimension == 1) return find_way_along(mesh, rules, plan);
  if (dimension == 2) return find_way_across(mesh, plan);
  average_inside(mesh, plan.ball);
  return {};
}

void RegionMover::find_cells(const Mesh& mesh, const Ball& ball) {
  cells_.clear();
  for (const BallRegion& r : ball)
    cells_.push_back(
        {mesh.position(r.others[0]), mesh.position(r.others[1]), mesh.position(r.others[2])});
}

RegionMover::Shapes RegionMover::shapes(const glm::dvec3& at) const {
  Shapes shapes;
  for (const Cell& cell : cells_) {
    const double shape = cell.shape(at);
    shapes.worst = std::min(shapes.worst, shape);
    shapes.sum += shape;
  }
  return shapes;
}

Verdict RegionMover::judge_cells(const RegionMove& plan, const glm::dvec3& from,
                                 const glm::dvec3& to, const LeastAngle& least) const {
  std::optional<double> around;  // the worst cosine where it is, once it is asked for
  const auto before = [&] {
    if (around) return *around;
    around = -1;
    for (const Cell& cell : cells_) around = std::max(*around, cell.dihedral_cosine(from));
    return *around;
  };
  for (std::size_t i = 0; i < cells_.size() && least.binds(); ++i) {
    const double now = cells_[i].dihedral_cosine(to);
    if (!least.allows(now, before)) return {Reason::Shape, plan.ball[i].region, now};
  }
  return {};
}

// The way in which the worst cells, and those that are nearly as bad, all get better; none where
// their slopes cancel: what rounding leaves of them then points anywhere.
glm::dvec3 RegionMover::uphill(const glm::dvec3& at, double worst, double nearly) {
  constexpr double cancelled = 1e-6;
  slopes_.clear();
  double steepest = 0;
  for (const Cell& cell : cells_) {
    if (cell.shape(at) > worst + nearly) continue;
    slopes_.push_back(freedom_.part_of(cell.slope(at)));
    steepest = std::max(steepest, glm::length(slopes_.back()));
  }
  const glm::dvec3 way = nearest_to_zero(slopes_);
  return glm::length(way) > cancelled * steepest ? freedom_.part_of(way) : glm::dvec3(0.0);
}

double RegionMover::longest_step(const glm::dvec3& at) const {
  double sum = 0;
  for (const Cell& cell : cells_) sum += glm::length(cell.a - at);
  return 0.5 * sum / double(cells_.size());
}

bool RegionMover::go(const Mesh& mesh, const MoveRules& rules, RegionMove& plan, glm::dvec3 to) {
  const ModelRef on = mesh.classification(plan.vertex);
  if (rules.model && on.dimension() < 3) to = rules.model->snap(on, to);
  const Shapes there = shapes(to);
  if (!is_better_shape(plan.after, there.worst)) return false;
  if (plan.before >= rules.poor && there.sum < sum_before_) return false;
  Verdict v = judge_faces(mesh, plan, to, rules);
  if (v.accepted()) v = judge_cells(plan, mesh.position(plan.vertex), to, rules.least_dihedral);
  if (!v.accepted()) {
    refusal_ = v;
    return false;
  }
  plan.target = to;
  plan.after = there.worst;
  return true;
}

// A line search each time: half the step until the worst has grown. Where that gains little, fewer
// cells have a say in the way.
void RegionMover::climb(const Mesh& mesh, const MoveRules& rules, RegionMove& plan) {
  constexpr int rounds = 12;
  constexpr double least_gain = 1e-3, least_nearly = 1e-3, shortest = 1e-3;
  double nearly = 0.05;
  for (int round = 0; round < rounds && plan.after < rules.poor; ++round) {
    const double before = plan.after;
    const glm::dvec3 from = plan.target, way = uphill(from, before, nearly);
    const double length = glm::length(way), longest = longest_step(from);
    double step = length > 0 ? longest : 0;
    while (step > shortest * longest && !go(mesh, rules, plan, from + step / length * way))
      step /= 2;
    if (plan.after >= before + least_gain) continue;
    nearly /= 4;
    if (nearly < least_nearly) return;
  }
}

Verdict RegionMover::judge_plan(const Mesh& mesh, const MoveRules& rules, RegionMove& plan) {
  const Vertex v = plan.vertex;
  if (const Region other = first_other_shape(mesh, v); other.valid()) return {Reason::Kept, other};
  gather(mesh, v, plan.ball);
  gather_model_faces(mesh, v, plan.star);
  if (const Verdict verdict = find_freedom(mesh, rules, plan); !verdict.accepted()) return verdict;
  find_cells(mesh, plan.ball);
  const glm::dvec3 from = plan.target, way = freedom_.part_of(average_ - from);
  const Shapes here = shapes(from);
  plan.before = plan.after = here.worst;
  sum_before_ = here.sum;
  refusal_ = {};
  for (double part = 1; part > 0.2; part /= 2)
    if (go(mesh, rules, plan, from + part * way)) break;
  climb(mesh, rules, plan);
  if (plan.after > plan.before) return {};
  if (!refusal_.accepted()) return refusal_;
  const auto worst =
      std::min_element(cells_.begin(), cells_.end(),
                       [&](const Cell& a, const Cell& b) { return a.shape(from) < b.shape(from); });
  return {Reason::Quality, plan.ball[static_cast<std::size_t>(worst - cells_.begin())].region,
          worst->dihedral_cosine(from)};
}

Verdict RegionMover::judge(const Mesh& mesh, Vertex v, const MoveRules& rules, RegionMove& plan) {
  plan.vertex = v;
  plan.target = mesh.position(v);
  plan.revision = mesh.revision();
  return plan.verdict = judge_plan(mesh, rules, plan);
}

void RegionMover::apply(Mesh& mesh, const RegionMove& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const JournalScope step(mesh, StepKind::Smooth, plan.vertex);
  mesh.move(plan.vertex, plan.target);
}

}  // namespace aomd
