// The guards of a decimation: what they must refuse, on tiny surfaces whose answers are known, and what they
// promise, after random operations that nothing else holds back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <random>

#include <glm/geometric.hpp>

#include "core/decimate/distance_guard.h"
#include "core/decimate/intersection_guard.h"
#include "core/io/io.h"
#include "core/measure/distance.h"
#include "core/measure/intersections.h"
#include "core/model/classify.h"
#include "core/operators/smooth.h"
#include "tests/zoo.h"

namespace aomd::test {
namespace {

using measure::self_intersections;

// Borders are model edges, and where an angle is given what is sharper.
Mesh prepared(const MeshData& data, std::optional<double> feature_angle_deg = {}) {
  Mesh mesh(data);
  ClassifyOptions options;
  options.feature_angle_deg = feature_angle_deg;
  classify(mesh, options);
  for (const auto& [i, j] : {std::pair{2, 0}, {0, 1}, {0, 2}}) mesh.set(i, j);
  return mesh;
}

Change move_of(const Mesh& mesh, Vertex v, const glm::dvec3& to) {
  Star star;
  gather(mesh, v, star);
  Change change;
  describe(mesh, v, star, to, change);
  return change;
}

Change contraction_of(const Mesh& mesh, const Contraction& c) {
  Star deleted, kept;
  gather(mesh, c.deleted, deleted);
  gather(mesh, c.kept, kept);
  Change change;
  describe(mesh, c, deleted, kept, change);
  return change;
}

void add(MeshData& data, const Triangle& t) {
  const auto n = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(), t.begin(), t.end());
  data.faces.add(Shape::Triangle, {n, n + 1, n + 2});
}

MeshData created_by(const Change& change) {
  MeshData data;
  for (const NewFace& f : change.created) add(data, f.corners);
  return data;
}

// The surface as it is after a change, vertices not shared: what the changed mesh is to be measured by.
MeshData after(const Mesh& mesh, const Change& change) {
  MeshData data = created_by(change);
  for (const Face f : mesh.faces()) {
    if (std::find(change.replaced.begin(), change.replaced.end(), f) != change.replaced.end()) continue;
    const auto t = mesh.triangle(f);
    add(data, {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
  }
  return data;
}

//  3-----2
//  | \ / |     a tent: 4 stands h above the middle of a square
//  |  4  |
//  | / \ |
//  0-----1
MeshData tent(double height, double floor = 0, double half = 0.5) {
  return zoo::make({{-half, -half, floor},
                    {half, -half, floor},
                    {half, half, floor},
                    {-half, half, floor},
                    {0, 0, height}},
                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

MeshData both(MeshData a, const MeshData& b) {
  const auto n = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t f = 0; f < b.faces.size(); ++f) {
    const std::uint32_t* v = &b.faces.vertices[3 * f];
    a.faces.add(Shape::Triangle, {v[0] + n, v[1] + n, v[2] + n});
  }
  return a;
}

TEST(Changes, AContractionReplacesBothStarsOnlyWhereItMoves) {
  const Mesh mesh = prepared(zoo::grid(4));
  const Vertex d(12), k(13);  // in the middle: 6 faces each, 2 shared
  const Change still = contraction_of(mesh, {d, k, mesh.position(k)});
  EXPECT_EQ(still.replaced.size(), 6u);
  EXPECT_EQ(still.created.size(), 4u);
  EXPECT_TRUE(still.pieces.empty());
  const Change moving = contraction_of(mesh, {d, k, {2.5, 2, 0}});
  EXPECT_EQ(moving.replaced.size(), 10u);
  EXPECT_EQ(moving.created.size(), 8u);
  for (const NewFace& f : moving.created) {
    EXPECT_EQ(f.vertices[0], k);
    EXPECT_EQ(f.corners[0], glm::dvec3(2.5, 2, 0));
    EXPECT_EQ(f.corners[1], mesh.position(f.vertices[1]));
    EXPECT_GE(area_normal(f.corners[0], f.corners[1], f.corners[2]).z, 0);
  }
}

TEST(Changes, AContractionAlongTheBoundaryMakesOnePieceOfTwo) {
  const Mesh mesh = prepared(zoo::grid(4));
  const Change change = contraction_of(mesh, {Vertex(2), Vertex(3), mesh.position(Vertex(3))});
  ASSERT_EQ(change.pieces.size(), 1u);
  EXPECT_EQ(change.pieces[0].at, Vertex(3));
  EXPECT_EQ(change.pieces[0].ends[0], glm::dvec3(3, 0, 0));
  EXPECT_EQ(change.pieces[0].ends[1], glm::dvec3(1, 0, 0));
}

TEST(Changes, AContractionThatMovesAlongTheBoundaryMakesTwoPiecesOfThree) {
  const Mesh mesh = prepared(zoo::grid(4));
  const Change change = contraction_of(mesh, {Vertex(2), Vertex(1), {1.5, 0, 0}});
  ASSERT_EQ(change.pieces.size(), 2u);
  EXPECT_EQ(change.pieces[0].ends[1], glm::dvec3(3, 0, 0));
  EXPECT_EQ(change.pieces[1].ends[1], glm::dvec3(0, 0, 0));
}

TEST(Changes, ASwapMakesWhatApplyingMakes) {
  Mesh mesh = prepared(zoo::square());
  EdgePair pair;
  ASSERT_TRUE(find_pair(mesh, Vertex(0), Vertex(2), pair).accepted());
  Change change;
  describe(mesh, pair, change);
  apply_swap(mesh, pair);
  ASSERT_EQ(change.created.size(), 2u);
  for (const NewFace& f : change.created) {
    auto now = mesh.triangle(f.face), said = f.vertices;
    std::rotate(now.begin(), std::min_element(now.begin(), now.end()), now.end());
    std::rotate(said.begin(), std::min_element(said.begin(), said.end()), said.end());
    EXPECT_EQ(now, said);
  }
}

// A flattened tent is furthest from the original in the middle: sqrt(1/8) from its slopes, not 1/2 from its
// tip. All corners but one have not moved, and that one need not be the worst either.
TEST(DistanceGuard, ATentMayBeFlattenedByTheDistanceToItsSlopes) {
  const Mesh mesh = prepared(tent(0.5));
  const Change flat = move_of(mesh, Vertex(4), {0, 0, 0});
  EXPECT_TRUE(DistanceGuard(mesh, std::sqrt(0.125) + 1e-9).judge(flat).accepted());
  const Verdict verdict = DistanceGuard(mesh, std::sqrt(0.125) - 1e-9).judge(flat);
  EXPECT_EQ(verdict.reason, Reason::Distance);
  EXPECT_EQ(verdict.entity.dimension, 2);
  EXPECT_GT(verdict.number(), 0.9 * std::sqrt(0.125));
}

//      4---5         a ridge of height 1/4 from 4 to 5; 5 onto 2 or 4 onto 0 would cut it
//     /|   |\        .
TEST(DistanceGuard, ARidgeIsNotCut) {
  MeshData roof = zoo::grid(4);
  for (glm::dvec3& p : roof.positions) p.z = p.y == 2 ? 0.25 : 0;
  const Mesh mesh = prepared(roof);
  const Change cut =
      contraction_of(mesh, {Vertex(12), Vertex(7), mesh.position(Vertex(7))});  // off the ridge
  EXPECT_EQ(DistanceGuard(mesh, 0.2).judge(cut).reason, Reason::Distance);
  EXPECT_TRUE(DistanceGuard(mesh, 0.25).judge(cut).accepted());
  const Change along = contraction_of(mesh, {Vertex(12), Vertex(13), mesh.position(Vertex(13))});
  EXPECT_TRUE(DistanceGuard(mesh, 1e-6).judge(along).accepted());
}

// The faces stay in the plane of the sheet, where every distance is 0; only the border's own curve tells.
//
//    +--+--+
//    |     |
//    +- 1 -+    the border from 0 over 1 to 2: without 1 it leaves the old one by 0.3
//    0     2
TEST(DistanceGuard, ABorderStaysWithinTheDistanceOfItself) {
  MeshData sheet = zoo::grid(4);
  sheet.positions[2].y = 0.3;
  const Mesh mesh = prepared(sheet);
  const Change straight = move_of(mesh, Vertex(2), {2, 0.6, 0});  // further in: every face stays on the sheet
  ASSERT_EQ(straight.pieces.size(), 2u);
  EXPECT_TRUE(DistanceGuard(mesh, 0.3 + 1e-9).judge(straight).accepted());
  const Verdict verdict = DistanceGuard(mesh, 0.25).judge(straight);
  EXPECT_EQ(verdict.reason, Reason::Distance);
  EXPECT_EQ(verdict.entity, EntityRef(Vertex(2)));
}

TEST(DistanceGuard, NothingButWhatLiesOnTheOriginalAtDistanceZero) {
  const Mesh mesh = prepared(zoo::grid(4));
  DistanceGuard guard(mesh, 0);
  EXPECT_EQ(guard.judge(move_of(mesh, Vertex(12), {2, 2, 1e-9})).reason, Reason::Distance);
}

//      ____
//     / /\ \       two tents, one below the other: without its own tip, the upper one would be cut by the
//    / /  \ \      lower one's
TEST(IntersectionGuard, ACollapseThatLetsTheLowerSheetPokeThroughIsRefused) {
  Mesh mesh = prepared(both(tent(1), tent(0.6, -0.5)));
  IntersectionGuard guard(mesh);
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(4), {0, 0, 0.61})).accepted());
  const Verdict low = guard.judge(move_of(mesh, Vertex(4), {0, 0, 0.2}));
  EXPECT_EQ(low.reason, Reason::Intersection);
  EXPECT_GE(low.entity.index, 4u);  // a face of the lower tent
  const Change collapse = contraction_of(mesh, {Vertex(4), Vertex(0), mesh.position(Vertex(0))});
  EXPECT_EQ(guard.judge(collapse).reason, Reason::Intersection);

  const Change down = move_of(mesh, Vertex(9), {0, 0, -0.4});  // the lower tip out of the way
  ASSERT_TRUE(guard.judge(down).accepted());
  EXPECT_EQ(guard.judge(collapse).reason, Reason::Intersection);  // judged, but not made yet
  guard.applied(down);
  apply_smooth(mesh, Vertex(9), {0, 0, -0.4});
  EXPECT_TRUE(guard.judge(collapse).accepted());
}

// Vertex 4 of a flat tent, moved out over the side 1-2: its faces come to lie on each other.
TEST(IntersectionGuard, TheCreatedFacesCountAmongThemselves) {
  const Mesh mesh = prepared(tent(0));
  IntersectionGuard guard(mesh);
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(4), {0.4, 0, 0})).accepted());
  EXPECT_EQ(guard.judge(move_of(mesh, Vertex(4), {0.6, 0, 0})).reason, Reason::Intersection);
}

TEST(IntersectionGuard, WhatCutsItselfAlreadyMayDoSoButNotMore) {
  const Mesh mesh = prepared(both(tent(0.5), tent(1, -0.5)));  // the inner tip stands out of the outer tent
  const std::size_t start = self_intersections(mesh).size();
  ASSERT_GT(start, 0u);
  IntersectionGuard guard(mesh);
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(9), {0, 0, 0.9})).accepted());  // as before
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(9), {0, 0, 0.3})).accepted());  // not any more
  const Change more = move_of(mesh, Vertex(9), {0.1, 0.05, 0.9});
  const std::size_t then = self_intersections(Mesh(after(mesh, more))).size();
  EXPECT_EQ(guard.judge(more).accepted(), then <= start);
}

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
      collapser_.apply_accepted(mesh_, contraction_);
    else if (kind_ == 1)
      apply_swap(mesh_, pair_);
    else
      apply_smooth(mesh_, contraction_.kept, contraction_.position);
  }

 private:
  std::size_t pick(std::size_t n) { return random_() % n; }
  double length(Vertex a, Vertex b) const { return glm::length(mesh_.position(a) - mesh_.position(b)); }
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
      contraction_.position = jittered(0.5 * (mesh_.position(a) + mesh_.position(b)), 0.5 * length(a, b));
    CollapseRules rules;
    rules.max_turn = rules.max_curve_turn = TurnLimit(180);
    if (!collapser_.judge(mesh_, contraction_, rules).accepted()) return false;
    describe(mesh_, contraction_, collapser_.star(0), collapser_.star(1), change);
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
  EdgePair pair_;
  Star star_;
};

struct Outcome {
  int made = 0, too_far = 0, cut = 0;
};

Outcome drive(Mesh& mesh, double limit, int tries, unsigned seed) {
  DistanceGuard distance(mesh, limit);
  IntersectionGuard cuts(mesh);
  RandomOperations operations(mesh, seed);
  Change change;
  Outcome outcome;
  for (int i = 0; i < tries; ++i) {
    if (!operations.propose(change)) continue;
    if (!distance.judge(change).accepted()) {
      ++outcome.too_far;
    } else if (!cuts.judge(change).accepted()) {
      ++outcome.cut;
    } else {
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

void expect_kept(const MeshData& data, double limit, int tries, unsigned seed,
                 std::optional<double> feature_angle_deg = {}) {
  SCOPED_TRACE(testing::Message() << "limit " << limit << " seed " << seed);
  Mesh mesh = prepared(data, feature_angle_deg);
  const Mesh original = prepared(data, feature_angle_deg);
  const Outcome outcome = drive(mesh, limit, tries, seed);
  EXPECT_GT(outcome.made, 0);
  EXPECT_GT(outcome.too_far, 0);
  const measure::Surface before(original), now(mesh);
  EXPECT_LE(measure::distance_from(now, before, 200000).max, limit);
  EXPECT_LE(self_intersections(mesh).size(), self_intersections(original).size());
  const Mesh old_edges = model_edges_of(original), new_edges = model_edges_of(mesh);
  EXPECT_LE(measure::distance_from(measure::Surface(new_edges), measure::Surface(old_edges), 1).max, limit);
}

TEST(Guards, RandomOperationsStayWithinTheDistanceAndCutNothing) {
  MeshData hills = zoo::grid(12);
  for (glm::dvec3& p : hills.positions) p.z = std::sin(1.3 * p.x) * std::cos(0.9 * p.y);
  for (unsigned seed = 1; seed <= 2; ++seed) {
    for (const double limit : {0.02, 0.15, 0.6}) {
      expect_kept(hills, limit, 1500, seed);
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
}

TEST(Guards, RandomOperationsOnTheZoo) {
  for (const zoo::Animal& animal : zoo::all()) {
    SCOPED_TRACE(animal.name);
    Mesh mesh = prepared(animal.data);
    const Mesh original = prepared(animal.data);
    drive(mesh, 0.2, 300, 7);
    EXPECT_LE(self_intersections(mesh).size(), self_intersections(original).size());
    EXPECT_LE(measure::distance_from(measure::Surface(mesh), measure::Surface(original), 20000).max, 0.2);
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

Envelope envelope_with_patches(const MeshData& data, double distance) {
  std::vector<std::array<std::uint32_t, 3>> vertices(data.faces.size());
  for (std::size_t k = 0; k < data.faces.vertices.size(); ++k)
    vertices[k / 3][k % 3] = data.faces.vertices[k];
  return {triangles_of(data).corners, distance, vertices};
}

bool contains(Envelope envelope, const Triangle& t) {
  std::uint32_t hint = no_index;
  return envelope.contains(t, hint).inside;
}

// A flat sheet of n x n with a hole of 2 x 2 in its middle.
MeshData pierced(std::uint32_t n) {
  const MeshData whole = zoo::grid(n);
  MeshData data = whole;
  data.faces = {};
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    const std::uint32_t* v = &whole.faces.vertices[3 * f];
    const glm::dvec3 middle = (whole.positions[v[0]] + whole.positions[v[1]] + whole.positions[v[2]]) / 3.0;
    if (std::abs(middle.x - 0.5 * n) > 1 || std::abs(middle.y - 0.5 * n) > 1)
      data.faces.add(Shape::Triangle, {v[0], v[1], v[2]});
  }
  return data;
}

// Of a triangle over the hole, two corners and the middle are near the sheet on one side.
TEST(Envelope, AHoleIsNoSurface) {
  const Triangle over{glm::dvec3(3.2, 4, 0.1), {6.4, 4.6, 0.1}, {3.2, 7.6, 0.1}};
  EXPECT_TRUE(contains(envelope_with_patches(zoo::grid(12), 0.3), over));
  EXPECT_FALSE(contains(envelope_with_patches(pierced(12), 0.3), over));
}

TEST(Envelope, WhatItContainsIsNearAtEveryPoint) {
  constexpr double distance = 0.2;
  Envelope envelope(triangles_of(pierced(4)).corners, distance);
  std::mt19937 random(2);
  const auto unit = [&] { return double(random() % 1000) / 999; };
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    Triangle t;
    for (glm::dvec3& p : t) p = {4 * unit(), 4 * unit(), 0.1 * unit()};
    std::uint32_t hint = no_index;
    if (!envelope.contains(t, hint).inside) continue;
    ++inside;
    for (int k = 0; k < 300; ++k) {
      const double u = unit(), v = (1 - u) * unit();
      const glm::dvec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      ASSERT_LE(envelope.tree().nearest(p).distance2, distance * distance);
    }
  }
  EXPECT_GT(inside, 300);
}

//   -------------.
//   -------------'      a sheet that is folded back under itself at x = 6: there is nothing further right
TEST(Envelope, AFoldEndsThePatch) {
  MeshData folded = zoo::grid(12);
  for (glm::dvec3& p : folded.positions)
    if (p.x > 6) p = {12 - p.x, p.y, -0.01 * (p.x - 6)};
  EXPECT_TRUE(contains(envelope_with_patches(folded, 0.3), {glm::dvec3(1, 2, 0), {5, 2, 0}, {3, 9, 0}}));
  EXPECT_FALSE(contains(envelope_with_patches(folded, 0.3), {glm::dvec3(3, 2, 0), {7, 5, 0}, {3, 9, 0}}));
}

// The envelope of a flat square is convex: a triangle lies in it where its corners do.
TEST(Envelope, OfASquareContainsWhatHasItsCornersInIt) {
  constexpr double distance = 0.2;
  Envelope envelope(triangles_of(zoo::square()).corners, distance);
  std::mt19937 random(1);
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    Triangle t;
    double most = 0;
    for (glm::dvec3& p : t) {
      for (int k = 0; k < 3; ++k) p[k] = double(random() % 1000) / 999;
      p = glm::dvec3(1.6, 1.6, 0.2) * p - glm::dvec3(0.3, 0.3, 0.1);
      most = std::max(most, std::sqrt(envelope.tree().nearest(p).distance2));
    }
    std::uint32_t hint = no_index;
    const bool yes = envelope.contains(t, hint).inside;
    ++(yes ? inside : outside);
    ASSERT_TRUE(yes ? most <= distance : most >= distance * 15 / 16) << most;
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
}

// Patches only save time: large triangles at a fine torus, judged with them and without.
TEST(Envelope, PatchesChangeNoAnswerByMoreThanTheResolution) {
  const MeshData data = zoo::torus(120, 60);
  const Triangles all = triangles_of(data);
  Envelope with = envelope_with_patches(data, 0.05), without(all.corners, 0.05);
  std::mt19937 random(5);
  int inside = 0, unlike = 0;
  for (int i = 0; i < 400; ++i) {
    const Triangle& start = all.corners[random() % all.corners.size()];
    Triangle t = start;
    for (glm::dvec3& p : t) {  // large, with its corners on the surface
      const glm::dvec3 to = start[0] + (p - start[0]) * double(1 + random() % 12);
      p = without.tree().nearest(to).point;
    }
    std::uint32_t a = no_index, b = no_index;
    const bool yes = with.contains(t, a).inside;
    inside += yes;
    unlike += yes != without.contains(t, b).inside;
    if (!yes) continue;
    for (int k = 0; k < 200; ++k) {
      const double u = double(random() % 1000) / 999, v = (1 - u) * double(random() % 1000) / 999;
      ASSERT_LE(without.tree().nearest(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])).distance2, 0.05 * 0.05);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_LT(inside, 350);
  EXPECT_LE(unlike, 4);
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
}  // namespace aomd::test
