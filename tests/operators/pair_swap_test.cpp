// Swaps by vertex pair: exact answers on drawn meshes, the same whether the edges inside model
// faces are entities or not.

#include <gtest/gtest.h>

#include "core/mesh/geometry.h"
#include "core/mesh/verify.h"
#include "core/operators/star.h"
#include "core/operators/swap.h"
#include "tests/support/pair_bench.h"

namespace aomd::pair_swap_test {
namespace {

using namespace test;
using Bench = PairBench;

TEST(StarTest, OpenIsWhatDoesNotClose) {
  const auto star = [](std::initializer_list<Ends> faces) {
    Star s;
    for (const auto& [next, previous] : faces) s.push_back({{}, 0, Vertex(next), Vertex(previous)});
    return s;
  };
  EXPECT_FALSE(is_open(star({{1, 2}, {2, 3}, {3, 1}})));
  EXPECT_TRUE(is_open(star({{1, 2}, {2, 3}})));
  EXPECT_TRUE(is_open(star({{1, 2}, {3, 4}}))) << "two fans";
  EXPECT_TRUE(is_open(star({{4, 5}, {6, 7}})))
      << "two fans whose ends, 4 xor 5 xor 6 xor 7, give 0";
}

//   2            2
//  /|\          / \        the diagonal 2-3 becomes 0-1
// 0 | 1   ->   0---1
//  \|/          \ /
//   3            3
TEST(PairSwapTest, TurnsTheDiagonalEitherWayRound) {
  for (const Edges edges : both)
    for (const bool forward : {true, false}) {
      Bench b(zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {3, 1, 2}}));
      b.ready(edges);
      EdgePair pair;
      ASSERT_TRUE(
          find_pair(b.mesh, Vertex(forward ? 2 : 3), Vertex(forward ? 3 : 2), pair).accepted());
      EXPECT_EQ(pair.f, Face(forward ? 1 : 0));
      EXPECT_EQ(pair.g, Face(forward ? 0 : 1));
      EXPECT_EQ(pair.c, Vertex(forward ? 1 : 0));
      EXPECT_EQ(pair.d, Vertex(forward ? 0 : 1));
      EXPECT_TRUE(joined(b.mesh, Vertex(2), Vertex(3)));
      EXPECT_FALSE(joined(b.mesh, Vertex(0), Vertex(1)));
      apply_swap(b.mesh, pair);
      EXPECT_TRUE(verify(b.mesh).empty());
      EXPECT_FALSE(joined(b.mesh, Vertex(2), Vertex(3)));
      EXPECT_TRUE(joined(b.mesh, Vertex(0), Vertex(1)) && joined(b.mesh, Vertex(1), Vertex(0)));
      for (const Face f : b.mesh.faces()) {
        const auto t = b.mesh.triangle(f);
        EXPECT_GT(
            area_normal(b.mesh.position(t[0]), b.mesh.position(t[1]), b.mesh.position(t[2])).z, 0);
      }
      EXPECT_EQ(b.mesh.count(1), edges == Edges::All ? 5u : 4u);
    }
}

TEST(PairSwapTest, WhatIsNoPair) {
  for (const Edges edges : both) {
    EdgePair pair;
    Bench grid(zoo::grid(2));
    grid.ready(edges);
    EXPECT_EQ(find_pair(grid.mesh, Vertex(0), Vertex(1), pair).reason, Reason::Topology)
        << "one face";
    EXPECT_EQ(find_pair(grid.mesh, Vertex(0), Vertex(8), pair).reason, Reason::Topology)
        << "no edge";
    EXPECT_TRUE(find_pair(grid.mesh, Vertex(0), Vertex(4), pair).accepted()) << "an inner diagonal";
    Bench book(on_one_face(zoo::book()));
    book.ready(edges);
    EXPECT_EQ(find_pair(book.mesh, Vertex(0), Vertex(1), pair).reason, Reason::Topology)
        << "three faces";
    Bench ridge(zoo::make({{-1, 0, 0}, {0, 0, 1}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {3, 1, 2}}));
    ridge.ready(edges);
    EXPECT_EQ(find_pair(ridge.mesh, Vertex(2), Vertex(3), pair).reason, Reason::Classification)
        << "a ridge";
    Bench twisted(on_one_face(
        zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {1, 3, 2}})));
    twisted.ready(edges);
    EXPECT_EQ(find_pair(twisted.mesh, Vertex(2), Vertex(3), pair).reason, Reason::Topology)
        << "one way";
    Bench doubled(
        on_one_face(zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}}, {{0, 1, 2}, {1, 0, 2}})));
    doubled.ready(edges);
    EXPECT_EQ(find_pair(doubled.mesh, Vertex(0), Vertex(1), pair).reason, Reason::Topology)
        << "one apex";
  }
}

// A curve that only its edge's class tells of: the faces on both sides are of one model face.
TEST(PairSwapTest, AModelEdgeInsideAModelFaceIsNoPair) {
  for (const Edges edges : both) {
    Bench b(on_one_face(zoo::grid(2)));
    b.on(ModelRef(1, 50), {4u});
    b.on(ModelRef(1, 50), {Ends{0, 4}});
    b.ready(edges);
    EdgePair pair;
    const Verdict v = find_pair(b.mesh, Vertex(0), Vertex(4), pair);
    EXPECT_EQ(v.reason, Reason::Classification) << name(edges);
    EXPECT_EQ(v.entity, EntityRef(b.edge(0, 4)));
    EXPECT_TRUE(find_pair(b.mesh, Vertex(4), Vertex(8), pair).accepted());
  }
}

TEST(PairSwapTest, AModelEdgeWithoutFacesJoinsToo) {
  MeshData data = zoo::square();
  data.edges.add(Shape::Line, {1, 3}, ModelRef(1, 5));
  for (const Edges edges : both) {
    Bench b(on_one_face(data));
    b.ready(edges);
    ASSERT_TRUE(b.edge(1, 3).valid());
    EXPECT_TRUE(joined(b.mesh, Vertex(1), Vertex(3))) << name(edges);
  }
}

}  // namespace
}  // namespace aomd::pair_swap_test
