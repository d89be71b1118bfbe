// The guards of a decimation: what they promise, after random operations that nothing else holds
// back.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <random>

#include <glm/geometric.hpp>

#include "core/decimate/guard/coverage.h"
#include "core/decimate/guard/distance_guard.h"
#include "core/decimate/guard/intersection_guard.h"
#include "core/io/io.h"
#include "core/measure/distance.h"
#include "core/measure/intersections.h"
#include "core/operators/smooth.h"
#include "tests/support/guard_helpers.h"

namespace aomd::test::guard_random_test {
namespace {

using measure::self_intersections;

// Random operations on a mesh, as the operators allow them with all their own limits off.
class RandomOperations {
 public:
  RandomOperations(Mesh& mesh, unsigned seed) : mesh_(mesh), collapser_(mesh), random_(seed) {}

  /// Proposes one: false where the operators refuse. `apply` makes it.
  bool propose(Change& change) {
    if (mesh_.count(2) == 0) return false;
    kind_ = pick(3);
    const auto t = mesh_.triangle(any_face());
    const Vertex a = t[pick(3)], b = t[0] == a ? t[1] : t[0];
    if (kind_ == 0) return contraction(a, b, change);
    if (kind_ == 1) return swap(a, b, change);
    if (mesh_.classification(a).dimension() < 1) return false;
    gather(mesh_, a, star_);
    contraction_ = {{}, a, jittered(mesh_.position(a), length(a, b))};
    describe(mesh_, a, star_, contraction_.position, change);
    return true;
  }

  void apply() {
    if (kind_ == 0)
      collapser_.apply(mesh_, plan_);
    else if (kind_ == 1)
      apply_swap(mesh_, pair_);
    else
      apply_smooth(mesh_, contraction_.kept, contraction_.position);
  }

 private:
  std::size_t pick(std::size_t n) { return random_() % n; }
  double length(Vertex a, Vertex b) const {
    return glm::length(mesh_.position(a) - mesh_.position(b));
  }
  Face any_face() {
    const auto id = mesh_.ids(2).next_alive(static_cast<std::uint32_t>(pick(mesh_.capacity(2))));
    return id < mesh_.capacity(2) ? Face(id) : *mesh_.faces().begin();
  }
  glm::dvec3 jittered(const glm::dvec3& p, double by) {
    const auto unit = [&] { return static_cast<double>(random_()) / 0x1p32 - 0.5; };
    return p + by * glm::dvec3(unit(), unit(), unit());
  }
  bool contraction(Vertex a, Vertex b, Change& change) {
    contraction_ = {a, b, mesh_.position(b)};
    if (mesh_.classification(a) == mesh_.classification(b) && pick(2) == 0)
      contraction_.position =
          jittered(0.5 * (mesh_.position(a) + mesh_.position(b)), 0.5 * length(a, b));
    CollapseRules rules;
    rules.max_turn = rules.max_curve_turn = TurnLimit(180);
    if (!collapser_.judge(mesh_, contraction_, rules, plan_).accepted()) return false;
    describe(mesh_, contraction_, plan_.around_deleted(), plan_.around_kept(), change);
    return true;
  }
  bool swap(Vertex a, Vertex b, Change& change) {
    if (!find_pair(mesh_, a, b, pair_).accepted() || joined(mesh_, pair_.c, pair_.d)) return false;
    describe(mesh_, pair_, change);
    return true;
  }

  Mesh& mesh_;
  Collapser collapser_;
  std::mt19937 random_;
  std::size_t kind_ = 0;
  Contraction contraction_;
  CollapsePlan plan_;
  EdgePair pair_;
  Star star_;
};

struct Outcome {
  int made = 0, too_far = 0, uncovered = 0, cut = 0;
};

Outcome drive(Mesh& mesh, double limit, int tries, unsigned seed) {
  DistanceGuard distance(mesh, limit);
  Coverage coverage(mesh, limit);
  IntersectionGuard cuts(mesh);
  RandomOperations operations(mesh, seed);
  Change change;
  Outcome outcome;
  for (int i = 0; i < tries; ++i) {
    if (!operations.propose(change)) continue;
    if (!distance.judge(change).accepted()) {
      ++outcome.too_far;
    } else if (!coverage.judge(change).accepted()) {
      ++outcome.uncovered;
    } else if (!cuts.judge(change).accepted()) {
      ++outcome.cut;
    } else {
      coverage.applied(change);
      cuts.applied(change);
      operations.apply();
      ++outcome.made;
    }
  }
  return outcome;
}

// Points along every model edge, as triangles without area.
Mesh model_edges_of(const Mesh& mesh) {
  MeshData data;
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() != 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    const glm::dvec3 p = mesh.position(a), step = (mesh.position(b) - p) / 8.0;
    for (std::uint32_t k = 0; k < 8; k += 2) {
      const auto n = static_cast<std::uint32_t>(data.positions.size());
      for (std::uint32_t m = k; m <= k + 2; ++m) data.positions.push_back(p + double(m) * step);
      data.faces.add(Shape::Triangle, {n, n + 1, n + 2});
    }
  }
  return Mesh(data);
}

// Returns how many operations would have left something of the original behind.
int expect_kept(const MeshData& data, double limit, int tries, unsigned seed,
                std::optional<double> feature_angle_deg = {}) {
  SCOPED_TRACE(testing::Message() << "limit " << limit << " seed " << seed);
  Mesh mesh = prepared(data, feature_angle_deg);
  const Mesh original = prepared(data, feature_angle_deg);
  const Outcome outcome = drive(mesh, limit, tries, seed);
  EXPECT_GT(outcome.made, 0);
  EXPECT_GT(outcome.too_far, 0);
  const measure::Surface before(original), now(mesh);
  EXPECT_LE(measure::distance_from(now, before, 200000).max, limit);
  EXPECT_LE(measure::distance_from(before, now, 200000).max, limit);
  EXPECT_LE(self_intersections(mesh).size(), self_intersections(original).size());
  const Mesh old_edges = model_edges_of(original), new_edges = model_edges_of(mesh);
  EXPECT_LE(measure::distance_from(measure::Surface(new_edges), measure::Surface(old_edges), 1).max,
            limit);
  return outcome.uncovered;
}

TEST(Guards, RandomOperationsStayWithinTheDistanceAndCutNothing) {
  MeshData hills = zoo::grid(12);
  for (glm::dvec3& p : hills.positions) p.z = std::sin(1.3 * p.x) * std::cos(0.9 * p.y);
  int uncovered = 0;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    for (const double limit : {0.02, 0.15, 0.6}) {
      uncovered += expect_kept(hills, limit, 1500, seed);
      expect_kept(zoo::torus(24, 14), limit, 1500, seed);
    }
    expect_kept(both(hills,
                     [&] {
                       MeshData lower = hills;
                       for (glm::dvec3& p : lower.positions) p.z -= 0.1;
                       return lower;
                     }()),
                0.3, 3000, seed);
  }
  EXPECT_GT(uncovered, 0);
}

TEST(Guards, RandomOperationsOnTheZoo) {
  for (const zoo::Animal& animal : zoo::all()) {
    SCOPED_TRACE(animal.name);
    Mesh mesh = prepared(animal.data);
    const Mesh original = prepared(animal.data);
    drive(mesh, 0.2, 300, 7);
    EXPECT_LE(self_intersections(mesh).size(), self_intersections(original).size());
    EXPECT_LE(measure::distance_from(measure::Surface(mesh), measure::Surface(original), 20000).max,
              0.2);
  }
}

// Both answers of both guards against measuring the changed surface.
TEST(Guards, EveryVerdictAgreesWithMeasuring) {
  MeshData lower = zoo::grid(5), hills = zoo::grid(5);
  for (glm::dvec3& p : hills.positions) p.z = 0.3 * std::sin(2 * p.x + 3 * p.y);
  for (glm::dvec3& p : lower.positions) p.z = 0.3 * std::sin(2 * p.x + 3 * p.y) - 0.15;
  Mesh mesh = prepared(both(hills, lower));
  const Mesh original = prepared(both(hills, lower));
  const measure::Surface before(original);
  constexpr double limit = 0.1;
  DistanceGuard distance(original, limit);
  IntersectionGuard cuts(mesh);
  RandomOperations operations(mesh, 3);
  Change change;
  int answers[2][2] = {};
  for (int i = 0; i < 1000; ++i) {
    if (!operations.propose(change)) continue;
    const Mesh then(after(mesh, change));
    const bool clear = cuts.judge(change).accepted();
    ++answers[0][clear];
    ASSERT_EQ(clear, self_intersections(then).size() <= self_intersections(mesh).size());
    change.pieces.clear();  // surfaces only
    const Verdict verdict = distance.judge(change);
    const bool near = verdict.accepted();
    ++answers[1][near];
    const Mesh fresh(created_by(change));
    const double measured = measure::distance_from(measure::Surface(fresh), before, 8000).max;
    if (near) {
      ASSERT_LE(measured, limit);
    } else {
      ASSERT_GE(verdict.number(), limit * 15 / 16);
      ASSERT_GE(measured, 0.9 * limit);
    }
    if (!clear || !near || i % 3 != 0) continue;
    cuts.applied(change);
    operations.apply();
  }
  for (const auto& [no, yes] : answers) {
    EXPECT_GT(no, 50);
    EXPECT_GT(yes, 50);
  }
}

TEST(Guards, RandomOperationsOnARealMesh) {
  const std::filesystem::path file = std::filesystem::path(AOMD_SHARED_DATA) / "fandisk.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const MeshData data = io::read(file).mesh;
  const Mesh mesh(data);
  const double diagonal = measure::Surface(mesh).tree().box().diagonal();
  expect_kept(data, 2e-3 * diagonal, 20000, 1, 20.0);
}

}  // namespace
}  // namespace aomd::test::guard_random_test
