// Self-intersections where hundreds of faces have a corner, an edge or all corners in common.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include "core/measure/crowded_pairs.h"
#include "core/measure/distinct.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/model/triangle_intersection.h"
#include "tests/support/zoo.h"

namespace aomd::test::crowded_pairs_test {
namespace {

using measure::count_self_intersections;
using measure::IntersectingPair;
using measure::self_intersections;

// Every face against every other.
std::vector<IntersectingPair> by_trying(const Mesh& mesh) {
  const Triangles all = triangles_of(mesh);
  std::vector<IntersectingPair> pairs;
  for (std::size_t i = 0; i < all.faces.size(); ++i)
    for (std::size_t j = i + 1; j < all.faces.size(); ++j)
      if (all.faces[i] != all.faces[j] && !without_area(all.corners[i]) &&
          !without_area(all.corners[j]) && intersect(all.corners[i], all.corners[j]))
        pairs.push_back({all.faces[i], all.faces[j]});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void expect_as_by_trying(const MeshData& data) {
  const Mesh mesh(data);
  ASSERT_TRUE(measure::crowded(triangles_of(mesh).corners));
  const auto expected = by_trying(mesh);
  EXPECT_EQ(self_intersections(mesh), expected);
  for (const int threads : {1, 3}) {
    const auto counted = count_self_intersections(mesh, threads);
    EXPECT_EQ(counted.pairs, expected.size());
    ASSERT_LE(counted.first.size(), 8u);
    for (const IntersectingPair& pair : counted.first)
      EXPECT_TRUE(std::binary_search(expected.begin(), expected.end(), pair));
  }
}

//    2--1
//    | /|     n triangles around 0, on a cone that is open or, with height 0, flat
//    3-0-n
glm::dvec3 on_circle(double turns, double height) {
  return {std::cos(2 * M_PI * turns), std::sin(2 * M_PI * turns), height};
}

MeshData cone(std::uint32_t n, double height) {
  MeshData data;
  data.positions = {{0, 0, 0}};
  for (std::uint32_t i = 0; i < n; ++i)
    data.positions.push_back(on_circle(static_cast<double>(i) / n, height));
  for (std::uint32_t i = 0; i < n; ++i)
    data.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % n});
  return data;
}

// n pages on the edge 0-1.
MeshData pages(std::uint32_t n) {
  MeshData data;
  data.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    data.positions.push_back(on_circle(static_cast<double>(i) / n, 0.25 + 0.5 * (i % 2)));
    data.faces.add(Shape::Triangle, {0, 1, 2 + i});
  }
  return data;
}

// Two cones base to base.
MeshData two_tips(std::uint32_t n) {
  MeshData data = cone(n, 1);
  data.positions.emplace_back(0, 0, 2);
  for (std::uint32_t i = 0; i < n; ++i)
    data.faces.add(Shape::Triangle, {n + 1, 1 + (i + 1) % n, 1 + i});
  return data;
}

// Strips of `length` squares in planes around a line that they share.
MeshData strips(std::uint32_t n, std::uint32_t length) {
  MeshData data;
  for (std::uint32_t j = 0; j <= length; ++j) data.positions.emplace_back(0, 0, j);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto outer = static_cast<std::uint32_t>(data.positions.size());
    for (std::uint32_t j = 0; j <= length; ++j)
      data.positions.push_back(on_circle(static_cast<double>(i) / n, j));
    for (std::uint32_t j = 0; j < length; ++j) {
      data.faces.add(Shape::Triangle, {j, j + 1, outer + j});
      data.faces.add(Shape::Triangle, {j + 1, outer + j + 1, outer + j});
    }
  }
  return data;
}

// Fans in planes around a line of `length` edges that they share, from its first end or its last.
MeshData fans_at_line(std::uint32_t n, std::uint32_t length) {
  MeshData data;
  for (std::uint32_t j = 0; j <= length; ++j) data.positions.emplace_back(0, 0, j);
  for (std::uint32_t i = 0; i < n; ++i) {
    data.positions.push_back(on_circle(static_cast<double>(i) / n, i % 2 == 0 ? 0 : length));
    for (std::uint32_t j = 0; j < length; ++j)
      data.faces.add(Shape::Triangle, {j, j + 1, length + 1 + i});
  }
  return data;
}

std::uint32_t add_point(MeshData& data, glm::dvec3 p) {
  data.positions.push_back(p);
  return static_cast<std::uint32_t>(data.positions.size() - 1);
}

TEST(CrowdTest, FansAndBooksAreClean) {
  for (const MeshData& data : {cone(400, 0), cone(400, 1), pages(400), two_tips(400),
                               strips(300, 3), fans_at_line(300, 3)}) {
    EXPECT_EQ(count_self_intersections(Mesh(data)).pairs, 0u);
    expect_as_by_trying(data);
  }
}

std::size_t tried_pairs(const MeshData& data) {
  std::size_t pairs = 0;
  measure::crowded_pairs(triangles_of(data).corners, 1,
                         [&](std::uint32_t, std::uint32_t) { ++pairs; });
  return pairs;
}

// The work is counted, not timed: a constant number of pairs for each face.
TEST(CrowdTest, TheWorkGrowsWithTheFaces) {
  for (const std::uint32_t n : {1000u, 8000u}) {
    for (const MeshData& data : {cone(n, 0), cone(n, 1), pages(n), two_tips(n), fans_at_line(n, 4)})
      EXPECT_LE(tried_pairs(data), 8 * data.faces.size());
    EXPECT_LE(tried_pairs(strips(n, 4)), 256 * n);
  }
}

TEST(CrowdTest, TheNumberOfFacesAtACornerDecides) {
  EXPECT_FALSE(measure::crowded(triangles_of(cone(240, 0)).corners));
  EXPECT_TRUE(measure::crowded(triangles_of(cone(257, 0)).corners));
}

TEST(CrowdTest, AFaceThroughAFanMeetsTheFacesThatItCuts) {
  MeshData data = cone(400, 0);
  const std::uint32_t a = add_point(data, {0.5, 0, -1}), b = add_point(data, {0.5, 0.001, 1}),
                      c = add_point(data, {0.5, -0.001, 1});
  data.faces.add(Shape::Triangle, {a, b, c});
  const auto counted = count_self_intersections(Mesh(data));
  EXPECT_EQ(counted.pairs, 2u);
  EXPECT_EQ(counted.first,
            (std::vector<IntersectingPair>{{Face(0), Face(400)}, {Face(399), Face(400)}}));
  expect_as_by_trying(data);
}

TEST(CrowdTest, TwoPagesInOneHalfPlaneAreAPair) {
  MeshData data = pages(400);
  data.faces.add(Shape::Triangle, {1, 0, add_point(data, {0.5, 0, 0.5})});  // as page 0
  const auto counted = count_self_intersections(Mesh(data));
  EXPECT_EQ(counted.pairs, 1u);
  EXPECT_EQ(counted.first, (std::vector<IntersectingPair>{{Face(0), Face(400)}}));
  expect_as_by_trying(data);
}

// Its direction from the edge is too small to be told in doubles.
TEST(CrowdTest, APageAlongTheEdge) {
  MeshData data = pages(400);
  data.faces.add(Shape::Triangle, {0, 1, add_point(data, {1e-40, 0, 0.5})});
  expect_as_by_trying(data);
  EXPECT_EQ(count_self_intersections(Mesh(data)).pairs, 1u);
}

//  2 3
//  |\|\       300 copies of 0 1 2 and two faces through them: 300 * 299 / 2 + 2 * 300
//  0-1-4
TEST(CrowdTest, CopiesAreCountedAndNotListed) {
  MeshData data =
      zoo::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1, 1}}, {{3, 4, 5}});
  for (std::uint32_t i = 0; i < 300; ++i)
    if (i % 2 == 0)
      data.faces.add(Shape::Triangle, {0, 1, 2});
    else
      data.faces.add(Shape::Triangle, {2, 1, 0});
  data.faces.add(Shape::Triangle, {3, 5, 4});
  const auto counted = count_self_intersections(Mesh(data));
  EXPECT_EQ(counted.pairs, 300u * 299 / 2 + 2 * 300 + 1);
  EXPECT_EQ(counted.first[0], (IntersectingPair{Face(0), Face(1)}));
  expect_as_by_trying(data);
}

TEST(CrowdTest, CopiesOfQuadsWhicheverTheirFirstCornerIs) {
  MeshData data;
  data.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, -1}, {1, 1, 1}, {1.5, 1, 1}};
  for (std::uint32_t i = 0; i < 200; ++i) {
    data.faces.add(Shape::Quad, {0, 1, 2, 3});
    data.faces.add(Shape::Quad, {3, 0, 1, 2});
  }
  data.faces.add(Shape::Triangle, {4, 5, 6});
  EXPECT_EQ(count_self_intersections(Mesh(data)).pairs, 400u * 399 / 2 + 400);
  expect_as_by_trying(data);
}

TEST(CrowdTest, DistinctTrianglesHaveOneOfEachWayRound) {
  MeshData data = cone(300, 0);
  for (int i = 0; i < 3; ++i) {
    data.faces.add(Shape::Triangle, {1, 2, 0});  // face 0 from another corner
    data.faces.add(Shape::Triangle, {2, 1, 0});  // its back
  }
  const auto all = measure::distinct(triangles_of(data).corners);
  ASSERT_EQ(all.triangles.size(), 301u);
  EXPECT_EQ(all.count(0), 4u);
  EXPECT_EQ(all.count(1), 1u);
  EXPECT_EQ(all.count(300), 3u);
  EXPECT_EQ(all.triangles[300], triangles_of(data).corners[301]);
  // where nothing is crowded all stay
  const MeshData dirty = zoo::dirty();
  EXPECT_EQ(measure::distinct(triangles_of(dirty).corners).triangles, triangles_of(dirty).corners);
  EXPECT_TRUE(measure::distinct(triangles_of(dirty).corners).copies.empty());
}

TEST(CrowdTest, CopiesCountInNormals) {
  MeshData up = cone(300, 0), both = up;
  for (int i = 0; i < 5; ++i) both.faces.add(Shape::Triangle, {2, 1, 0});
  const TriangleTree original(triangles_of(up).corners);
  const auto deviation = measure::measure_normals(original, Mesh(both));
  EXPECT_EQ(deviation.triangles, 305u);
  EXPECT_EQ(deviation.above_10deg, 5u);
  EXPECT_EQ(deviation.flips, 5u);
}

// A face that stands in the way of both, seen from either tip, and one on which a tip lies.
TEST(CrowdTest, AFaceThroughTwoCrowds) {
  for (const double x : {0.5, -1e-9}) {
    MeshData data = two_tips(400);
    const std::uint32_t a = add_point(data, {x, -0.3, -1}), b = add_point(data, {x, 0.3, 3}),
                        c = add_point(data, {x, 0.3, -1});
    data.faces.add(Shape::Triangle, {a, b, c});
    expect_as_by_trying(data);
  }
  MeshData data = two_tips(400);
  const std::uint32_t a = add_point(data, {1, 1, 0}), b = add_point(data, {-1, 0, 0}),
                      c = add_point(data, {1, -1, 0});
  data.faces.add(Shape::Triangle, {a, b, c});
  expect_as_by_trying(data);
}

// Their boxes overlap, so that tilted ones are made; what is nearest stays what it was.
TEST(CrowdTest, TheNearestFaceOfFansAndBooks) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  for (const MeshData& data : {cone(3000, 0), cone(3000, 0.3), pages(3000)}) {
    const std::vector<Triangle> all = triangles_of(data).corners;
    const TriangleTree tree(all);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 p(place(random), place(random), i % 2 == 0 ? 0.3 : place(random));
      double expected = std::numeric_limits<double>::infinity();
      for (const Triangle& t : all) {
        const glm::dvec3 d = nearest_point(t, p) - p;
        expected = std::min(expected, glm::dot(d, d));
      }
      EXPECT_EQ(tree.nearest(p).distance2, expected);
      std::size_t within = 0;
      tree.within(p, expected, [&](std::uint32_t) { ++within; });
      EXPECT_GE(within, 1u);
    }
  }
}

// Corners of their own at equal places, as a soup has them.
TEST(CrowdTest, PlacesCountNotNumbers) {
  MeshData shared = pages(300), soup;
  for (const std::uint32_t v : shared.faces.vertices) soup.positions.push_back(shared.positions[v]);
  for (std::uint32_t f = 0; f < 300; ++f)
    soup.faces.add(Shape::Triangle, {3 * f, 3 * f + 1, 3 * f + 2});
  EXPECT_EQ(count_self_intersections(Mesh(soup)).pairs, 0u);
  expect_as_by_trying(soup);
}

// Triangles at one of two crowded corners, at both, and elsewhere; some twice, some flat.
MeshData random_crowd(std::mt19937& random) {
  std::uniform_int_distribution<int> whole(-6, 6);
  const auto pick = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}};
  for (int i = 0; i < 250; ++i)
    data.positions.emplace_back(whole(random), whole(random), whole(random));
  for (int i = 0; i < 700; ++i) {
    const std::uint32_t a = 2 + pick(250), b = 2 + pick(250), c = 2 + pick(250);
    const std::uint32_t kind = pick(5);
    if (a == b || b == c || a == c) continue;
    if (kind == 0) data.faces.add(Shape::Triangle, {a, b, c});
    if (kind == 1) data.faces.add(Shape::Triangle, {0, a, b});
    if (kind == 2) data.faces.add(Shape::Triangle, {a, 0, 1});
    if (kind == 3) data.faces.add(Shape::Triangle, {b, a, pick(2)});
    if (kind == 4) data.faces.add(Shape::Quad, {1, a, b, c});
  }
  return data;
}

TEST(CrowdTest, RandomCrowdsAsByTrying) {
  std::mt19937 random(5);
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(round);
    expect_as_by_trying(random_crowd(random));
  }
}

}  // namespace
}  // namespace aomd::test::crowded_pairs_test
