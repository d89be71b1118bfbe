// The guards of a decimation: what they must refuse, on tiny surfaces whose answers are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/decimate/guard/coverage.h"
#include "core/decimate/guard/distance_guard.h"
#include "core/decimate/guard/intersection_guard.h"
#include "core/measure/intersections.h"
#include "core/operators/smooth.h"
#include "tests/support/guard_helpers.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/volume_bench.h"

namespace aomd::test::guard_test {
namespace {

using measure::self_intersections;

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

// A flattened tent is furthest from the original in the middle: sqrt(1/8) from its slopes, not 1/2
// from its tip. All corners but one have not moved, and that one need not be the worst either.
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

// The faces stay in the plane of the sheet, where every distance is 0; only the border's own curve
// tells.
//
//    +--+--+
//    |     |
//    +- 1 -+    the border from 0 over 1 to 2: without 1 it leaves the old one by 0.3
//    0     2
TEST(DistanceGuard, ABorderStaysWithinTheDistanceOfItself) {
  MeshData sheet = zoo::grid(4);
  sheet.positions[2].y = 0.3;
  const Mesh mesh = prepared(sheet);
  const Change straight =
      move_of(mesh, Vertex(2), {2, 0.6, 0});  // further in: every face stays on the sheet
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

Change move_on_model(const Mesh& mesh, Vertex v, const glm::dvec3& to) {
  Star star;
  gather_model_faces(mesh, v, star);
  Change change;
  describe(mesh, v, star, to, change);
  return change;
}

Vertex vertex_at(const Mesh& mesh, const glm::dvec3& place) {
  for (const Vertex v : mesh.vertices())
    if (mesh.position(v) == place) return v;
  return {};
}

//    region 3
//   --------------  at 1.1     closer to each other than the distance of 0.15: what has gone 0.21
//   ___/\_________  at 1       up from the lower one is near the upper one, and that does not count
//    region 1
TEST(DistanceGuard, AnInterfaceIsNotNearBecauseAnotherOneIs) {
  MeshData layers = zoo::tet_grid({4, 4, 4}, [](const zoo::Cell& c) { return c.z + 1; });
  for (glm::dvec3& p : layers.positions)
    if (p.z >= 2) p.z -= 0.9;
  for (const Levels levels : both_levels) {
    const VolumeBench b(layers, levels);
    const Vertex v = vertex_at(b.mesh, {2, 2, 1});
    ASSERT_TRUE(v.valid());
    DistanceGuard guard(b.mesh, 0.15);
    EXPECT_TRUE(guard.judge(move_on_model(b.mesh, v, {2, 2, 1.14})).accepted());
    const Verdict far = guard.judge(move_on_model(b.mesh, v, {2, 2, 1.21}));
    EXPECT_EQ(far.reason, Reason::Distance) << name(levels);
    EXPECT_GT(far.number(), 0.15);
    EXPECT_LE(far.number(), 0.21);
  }
}

//   1       3     a model edge with a corner at 2, 0.3 below the line from 1 to 3, whose points are
//    \_   _/      no further than 0.288 from the legs
//      \2/
TEST(Coverage, ACornerOfTheOriginalIsNotCutOff) {
  MeshData bent = zoo::tet_grid({4, 2, 2}, [](const zoo::Cell&) { return 1; });
  for (glm::dvec3& p : bent.positions) p.y += 0.3 * std::abs(p.x - 2);
  const VolumeBench b(bent, Levels::Listed, {.feature_angle_deg = 40});
  const Vertex corner = vertex_at(b.mesh, {2, 2, 2}), end = vertex_at(b.mesh, {1, 2.3, 2});
  ASSERT_EQ(b.mesh.classification(corner).dimension(), 1);
  Star deleted, kept;
  gather_model_faces(b.mesh, corner, deleted);
  gather_model_faces(b.mesh, end, kept);
  Change change;
  describe(b.mesh, {corner, end, b.mesh.position(end)}, deleted, kept, change);
  EXPECT_TRUE(DistanceGuard(b.mesh, 0.29).judge(change).accepted());
  const Verdict cut = Coverage(b.mesh, 0.29).judge(change);
  EXPECT_EQ(cut.reason, Reason::Distance);
  EXPECT_EQ(cut.entity, EntityRef(end));
  EXPECT_NEAR(cut.number(), 0.3, 1e-12);
  Coverage enough(b.mesh, 0.301);
  EXPECT_TRUE(enough.judge(change).accepted());
  enough.applied(change);
  const Edge piece = change.pieces[0].edge;
  Change back;  // what now stands for the corner may not go to the other side
  back.old_pieces = {piece};
  back.pieces = {{change.pieces[0].curve, end, {glm::dvec3(1, 2.4, 2), {3, 2.4, 2}}, piece}};
  EXPECT_NEAR(enough.judge(back).number(), 0.4, 1e-12);
}

//   d----c     b and d are 0.1 higher than a and c: with the other diagonal all corners stay where
//   they |  / |     are, and the middle of a-c is 0.099 from what takes its place a----b
TEST(Coverage, AllPointsOfAFaceAreCoveredNotItsCornersAlone) {
  Mesh mesh =
      prepared(zoo::make({{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}}, {{0, 1, 2}, {0, 2, 3}}));
  EdgePair pair;
  ASSERT_TRUE(find_pair(mesh, Vertex(0), Vertex(2), pair).accepted());
  Change change;
  describe(mesh, pair, change);
  const double middle = 0.1 / std::sqrt(1.02);
  const Verdict far = Coverage(mesh, 0.99 * middle).judge(change);
  EXPECT_EQ(far.reason, Reason::Distance);
  EXPECT_NEAR(far.number(), middle, 0.01 * middle);
  Coverage enough(mesh, 1.01 * middle);
  EXPECT_TRUE(enough.judge(change).accepted());

  Coverage restarted(mesh, 0.5 * middle);  // what is off may stay so, and not get further
  apply_swap(mesh, pair);
  restarted.restart(mesh);
  EXPECT_TRUE(restarted.judge(move_of(mesh, Vertex(1), {1, 0, 0.06})).accepted());
  ASSERT_TRUE(find_pair(mesh, Vertex(1), Vertex(3), pair).accepted());
  describe(mesh, pair, change);
  EXPECT_TRUE(restarted.judge(change).accepted());
  EXPECT_EQ(restarted.judge(move_of(mesh, Vertex(2), {1, 1, 0.3})).reason, Reason::Distance);
}

// A tetrahedron above a cube, whose tip goes down through either half of the cube's upper side.
TEST(IntersectionGuard, BothHalvesOfAQuadAreGuarded) {
  for (const glm::dvec2 at : {glm::dvec2(0.75, 0.25), glm::dvec2(0.25, 0.75)}) {
    const VolumeBench b(zoo::make_volume({{0, 0, 0},
                                          {1, 0, 0},
                                          {1, 1, 0},
                                          {0, 1, 0},
                                          {0, 0, 1},
                                          {1, 0, 1},
                                          {1, 1, 1},
                                          {0, 1, 1},
                                          {at.x, at.y, 1.5},
                                          {at.x + 0.1, at.y, 2},
                                          {at.x, at.y + 0.1, 2},
                                          {at.x - 0.1, at.y - 0.1, 2}},
                                         {{Shape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}},
                                          {Shape::Tetrahedron, {8, 9, 10, 11}}}),
                        Levels::Listed);
    IntersectionGuard guard(b.mesh);
    const Vertex tip(8);
    EXPECT_TRUE(guard.judge(move_on_model(b.mesh, tip, {at, 1.1})).accepted());
    const Verdict through = guard.judge(move_on_model(b.mesh, tip, {at, 0.5}));
    EXPECT_EQ(through.reason, Reason::Intersection) << at.x;
    EXPECT_EQ(b.mesh.shape(through.entity), Shape::Quad);
  }
}

//      ____
//     / /\ \       two tents, one below the other: without its own tip, the upper one would be cut
//    / /  \ \      by the lower one's
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
  const Mesh mesh =
      prepared(both(tent(0.5), tent(1, -0.5)));  // the inner tip stands out of the outer tent
  const std::size_t start = self_intersections(mesh).size();
  ASSERT_GT(start, 0u);
  IntersectionGuard guard(mesh);
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(9), {0, 0, 0.9})).accepted());  // as before
  EXPECT_TRUE(guard.judge(move_of(mesh, Vertex(9), {0, 0, 0.3})).accepted());  // not any more
  bool some_add = false;
  for (const double x : {-0.4, -0.2, 0.1, 0.3})
    for (const double z : {-0.3, 0.2, 0.9, 2.0}) {
      const Change more = move_of(mesh, Vertex(5), {x, -0.3, z});
      const std::size_t then = self_intersections(Mesh(after(mesh, more))).size();
      EXPECT_EQ(guard.judge(more).accepted(), then <= start) << x << ' ' << z;
      some_add = some_add || then > start;
    }
  EXPECT_TRUE(some_add);
}

TEST(FaceTree, AFaceIsFoundWhereItWasPut) {
  FaceTree tree(prepared(zoo::grid(4)));
  tree.put(Face(0), {glm::dvec3{9, 9, 9}, {10, 9, 9}, {9, 10, 9}});
  std::vector<Face> found;
  const auto note = [&](const FaceTree::Item& item, const Box&) { found.push_back(item.face); };
  Box there;
  there.add(glm::dvec3(9.5, 9.5, 9));
  tree.touching(there, note);
  EXPECT_EQ(found, std::vector{Face(0)});
}

// A face without area touches nothing, but it is there: it may get corners that have some.
TEST(FaceTree, AFaceWithoutAreaKeepsItsPlace) {
  FaceTree tree(prepared(zoo::grid(4)));
  tree.put(Face(31), {glm::dvec3{1, 1, 0}, {2, 2, 0}, {3, 3, 0}});
  for (std::uint32_t f = 0; f < 20; ++f) tree.remove(Face(f));
  tree.tidy();
  ASSERT_EQ(tree.item(Face(31)).face, Face(31));
  tree.put(Face(31), {glm::dvec3{9, 9, 9}, {10, 9, 9}, {9, 10, 9}});
  std::vector<Face> found;
  Box there;
  there.add(glm::dvec3(9.5, 9.5, 9));
  tree.touching(there, [&](const FaceTree::Item& item, const Box&) { found.push_back(item.face); });
  EXPECT_EQ(found, std::vector{Face(31)});
}

}  // namespace
}  // namespace aomd::test::guard_test
