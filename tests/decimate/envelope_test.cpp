// The envelope of a surface, which the distance guard asks: what lies in it, and what does not.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/decimate/guard/envelope.h"
#include "core/mesh/geometry.h"
#include "tests/support/zoo.h"

namespace aomd::test::envelope_test {
namespace {

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
    const glm::dvec3 middle =
        (whole.positions[v[0]] + whole.positions[v[1]] + whole.positions[v[2]]) / 3.0;
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
//   -------------'      a sheet that is folded back under itself at x = 6: there is nothing
//                       further right
TEST(Envelope, AFoldEndsThePatch) {
  MeshData folded = zoo::grid(12);
  for (glm::dvec3& p : folded.positions)
    if (p.x > 6) p = {12 - p.x, p.y, -0.01 * (p.x - 6)};
  EXPECT_TRUE(
      contains(envelope_with_patches(folded, 0.3), {glm::dvec3(1, 2, 0), {5, 2, 0}, {3, 9, 0}}));
  EXPECT_FALSE(
      contains(envelope_with_patches(folded, 0.3), {glm::dvec3(3, 2, 0), {7, 5, 0}, {3, 9, 0}}));
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
      ASSERT_LE(without.tree().nearest(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])).distance2,
                0.05 * 0.05);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_LT(inside, 350);
  EXPECT_LE(unlike, 4);
}

}  // namespace
}  // namespace aomd::test::envelope_test
