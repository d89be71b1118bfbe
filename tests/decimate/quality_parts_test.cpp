// The numbers of the quality strategy: its queue, its quadrics, and places on triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "core/decimate/quadric.h"
#include "core/decimate/quality/original_surface.h"
#include "core/decimate/quality/vertex_queue.h"
#include "core/model/triangle_tree.h"

namespace aomd::quality_parts_test {
namespace {

TEST(VertexQueueTest, LowestFirstAndEqualsInTheOrderOfIds) {
  VertexQueue queue;
  queue.reset(6);
  EXPECT_FALSE(queue.pop().valid());
  queue.put(Vertex(2), 4), queue.put(Vertex(1), 1), queue.put(Vertex(0), 4),
      queue.put(Vertex(3), 0);
  queue.put(Vertex(4), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(queue.holds(Vertex(4)));
  EXPECT_FALSE(queue.holds(Vertex(5)));
  queue.put(Vertex(1), 8);  // moves
  queue.remove(Vertex(5));  // was not there
  for (const std::uint32_t v : {3u, 0u, 2u, 1u, 4u}) EXPECT_EQ(queue.pop(), Vertex(v));
  EXPECT_FALSE(queue.pop().valid());
  EXPECT_FALSE(queue.holds(Vertex(4)));
}

TEST(VertexQueueTest, WhatArrivesInTheBucketThatIsWorkedOffWaits) {
  VertexQueue queue;
  queue.reset(6);
  for (const std::uint32_t v : {1u, 3u, 5u}) queue.put(Vertex(v), 2);
  EXPECT_EQ(queue.pop(), Vertex(1));
  EXPECT_TRUE(queue.is_next(2) && queue.is_next(1));
  EXPECT_FALSE(queue.is_next(4));
  queue.put(Vertex(4), 2), queue.put(Vertex(0), 1);  // into it, and below
  queue.put(Vertex(3), 9);                           // leaves it
  for (const std::uint32_t v : {5u, 0u, 4u, 3u}) EXPECT_EQ(queue.pop(), Vertex(v));
  EXPECT_FALSE(queue.pop().valid());
}

// The queue on a plain map, for costs of one bucket each: powers of two.
struct PlainQueue {
  std::map<std::uint32_t, float> costs;
  std::vector<std::uint32_t> batch;
  float present = -1;

  std::uint32_t pop() {
    for (int round = 0; round < 2; ++round) {
      while (!batch.empty()) {
        const std::uint32_t v = batch.front();
        batch.erase(batch.begin());
        if (costs.count(v) == 0 || costs.at(v) != present) continue;
        costs.erase(v);
        return v;
      }
      if (costs.empty()) break;
      present = std::min_element(costs.begin(), costs.end(), [](const auto& a, const auto& b) {
                  return a.second < b.second;
                })->second;
      for (const auto& [v, cost] : costs)
        if (cost == present) batch.push_back(v);
    }
    return no_index;
  }
};

TEST(VertexQueueTest, RandomProgramsWithCostsFarApart) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    VertexQueue queue;
    queue.reset(40);
    PlainQueue plain;
    for (int i = 0; i < 3000; ++i) {
      const std::uint32_t v = random() % 40, what = random() % 8;
      if (what < 4) {
        const float cost = std::ldexp(1.0f, static_cast<int>(random() % 12) - 6);
        queue.put(Vertex(v), cost);
        plain.costs[v] = cost;
      } else if (what < 6) {
        queue.remove(Vertex(v));
        plain.costs.erase(v);
      } else {
        ASSERT_EQ(queue.pop().index, plain.pop()) << seed << ' ' << i;
        if (plain.present >= 0) {
          ASSERT_TRUE(queue.is_next(plain.present));
          ASSERT_FALSE(queue.is_next(2 * plain.present));
        }
      }
      for (std::uint32_t k = 0; k < 40; ++k)
        ASSERT_EQ(queue.holds(Vertex(k)), plain.costs.count(k) > 0);
    }
  }
}

// Any costs, and nothing that arrives: what leaves is at most half an octave dearer than the
// cheapest.
TEST(VertexQueueTest, DrainsInOrder) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponent(-120, 120);
  VertexQueue queue;
  queue.reset(200);
  for (int round = 0; round < 100; ++round) {
    std::map<std::uint32_t, float> plain;
    for (std::uint32_t v = 0; v < 200; ++v)
      if (random() % 4)
        queue.put(Vertex(v), plain[v] = random() % 20 == 0 ? 0 : std::exp2(exponent(random)));
    while (!plain.empty()) {
      if (random() % 5 == 0) {
        const std::uint32_t v = random() % 200;
        queue.remove(Vertex(v));
        plain.erase(v);
        continue;
      }
      float least = std::numeric_limits<float>::infinity();
      for (const auto& [v, cost] : plain) least = std::min(least, cost);
      const Vertex popped = queue.pop();
      ASSERT_TRUE(popped.valid());
      ASSERT_LE(plain.at(popped.index), 1.5f * least);
      plain.erase(popped.index);
    }
    ASSERT_FALSE(queue.pop().valid());
  }
}

TEST(QuadricTest, SumsOfPlanesAndPoints) {
  Quadric plane;
  plane.add_plane({0, 0, 1}, -2, 3);  // 3 (z - 2)^2
  EXPECT_EQ(plane({7, 8, 5}), 27);
  EXPECT_EQ(plane({1, 1, 2}), 0);
  EXPECT_EQ(plane.trace(), 3);
  Quadric point;
  point.add_point({1, 2, 3}, 2);  // twice the squared distance
  EXPECT_EQ(point({1, 2, 5}), 8);
  EXPECT_EQ(point.trace(), 6);
  plane += point;
  EXPECT_EQ(plane({1, 2, 5}), 35);
  Quadric slanted;
  slanted.add_plane({0.6, 0.8, 0}, -5, 1);
  EXPECT_NEAR(slanted({3, 4, 9}), 0, 1e-14);
  EXPECT_NEAR(slanted({0, 0, 0}), 25, 1e-14);
}

TEST(QuadricTest, ExactMinima) {
  glm::dvec3 x;
  Quadric corner;
  corner.add_plane({1, 0, 0}, -1, 2), corner.add_plane({0, 1, 0}, -2, 4),
      corner.add_plane({0, 0, 1}, -3, 8);
  ASSERT_TRUE(corner.minimum({9, 9, 9}, 0, x));
  EXPECT_EQ(x, glm::dvec3(1, 2, 3));
  Quadric plane;
  plane.add_plane({0, 0, 1}, -2, 1);
  ASSERT_TRUE(plane.minimum({5, 6, 7}, 1, x));  // (z - 2)^2 + |x - (5, 6, 7)|^2
  EXPECT_EQ(x, glm::dvec3(5, 6, 4.5));
  EXPECT_FALSE(plane.minimum({5, 6, 7}, 0, x)) << "a whole plane of minima";
  EXPECT_FALSE(Quadric().minimum({0, 0, 0}, 0, x));
}

TEST(QuadricTest, TheMinimumIsBelowItsSurroundings) {
  std::mt19937 random(4);
  std::normal_distribution<double> number;
  const auto any = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 200; ++i) {
    Quadric q;
    for (int k = 0; k < 5; ++k)
      q.add_plane(glm::normalize(any()), number(random), 0.1 + std::abs(number(random)));
    q.add_point(any(), 0.5);
    glm::dvec3 x;
    ASSERT_TRUE(q.minimum(any(), 0, x));
    for (int k = 0; k < 20; ++k) EXPECT_LT(q(x), q(x + 0.01 * any()));
  }
}

struct Corners {
  glm::dvec3 a, b, c;
};

// The least squared distance to n x n / 2 places of a triangle: a bound from above, and exact where
// the nearest place is one of them.
double sampled_distance2(const glm::dvec3& p, const Corners& t) {
  constexpr int n = 40;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const glm::dvec3 s =
          (double(i) * t.a + double(j) * t.b + double(n - i - j) * t.c) / double(n) - p;
      least = std::min(least, glm::dot(s, s));
    }
  return least;
}

// Returns the squared distance, after the barycentric coordinates are known to name a place that
// has it.
double barycentric_distance2(const glm::dvec3& p, const Corners& t, double tolerance) {
  glm::dvec3 at;
  const double d2 = nearest_barycentric(p, t.a, t.b, t.c, at);
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(at[k] >= -1e-12 && at[k] <= 1 + 1e-12) << at[k];
  EXPECT_NEAR(at.x + at.y + at.z, 1, 1e-12);
  const glm::dvec3 d = at.x * t.a + at.y * t.b + at.z * t.c - p;
  EXPECT_NEAR(d2, glm::dot(d, d), tolerance);
  return d2;
}

TEST(NearestBarycentricTest, AgainstSamplesOfTheTriangle) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto any = [&] { return glm::dvec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 3000; ++i) {
    Corners t{any(), any(), any()};
    if (i % 3 == 0) t.c = t.a + 0.4 * (t.b - t.a) + 1e-3 * any();  // a sliver
    const glm::dvec3 p = 2.0 * any(), exact = nearest_point({t.a, t.b, t.c}, p) - p;
    const double d2 = barycentric_distance2(p, t, 1e-9);
    ASSERT_LE(d2, sampled_distance2(p, t) + 1e-9);
    ASSERT_NEAR(d2, glm::dot(exact, exact), 1e-9);
  }
}

// Corners that fall together or into a line; the nearest places are among the samples.
constexpr glm::dvec3 origin(0, 0, 0), one(1, 0, 0), two(2, 0, 0);
constexpr Corners without_area[] = {
    {origin, origin, one}, {origin, one, one}, {origin, one, origin}, {origin, origin, origin},
    {origin, one, two},    {one, two, origin}, {two, origin, one}};
constexpr glm::dvec3 places[] = {{0.5, 1, 0}, {-1, 1, 0}, {1.5, 0, 1}, {5, 0, 0}, {0, 0, 0}};

TEST(NearestBarycentricTest, TrianglesWithoutArea) {
  for (const Corners& t : without_area)
    for (const glm::dvec3& p : places)
      EXPECT_NEAR(barycentric_distance2(p, t, 1e-12), sampled_distance2(p, t), 1e-12)
          << t.a.x << ' ' << t.b.x << ' ' << t.c.x << " from " << p.x;
}

TEST(NearestPointTest, TrianglesWithoutArea) {
  for (const Corners& t : without_area)
    for (const glm::dvec3& p : places) {
      const glm::dvec3 d = nearest_point({t.a, t.b, t.c}, p) - p;
      EXPECT_NEAR(glm::dot(d, d), sampled_distance2(p, t), 1e-12)
          << t.a.x << ' ' << t.b.x << ' ' << t.c.x << " from " << p.x;
    }
}

}  // namespace
}  // namespace aomd::quality_parts_test
