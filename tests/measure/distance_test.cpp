// Distances and turned normals between tiny surfaces whose answers are known.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/measure/distance.h"
#include "core/measure/normals.h"
#include "tests/support/zoo.h"

namespace aomd::test::distance_test {
namespace {

using measure::Distance;
using measure::Surface;

Distance between(const MeshData& from, const MeshData& to, std::size_t samples) {
  const Mesh a(from), b(to);
  return measure::distance_from(Surface(a), Surface(b), samples);
}

MeshData moved(MeshData data, const glm::dvec3& by) {
  for (glm::dvec3& p : data.positions) p += by;
  return data;
}

TEST(SurfaceDistance, ParallelSquares) {
  const Distance d = between(zoo::square(), moved(zoo::square(), {0, 0, 0.25}), 1000);
  EXPECT_DOUBLE_EQ(d.max, 0.25);
  EXPECT_DOUBLE_EQ(d.rms, 0.25);
  EXPECT_DOUBLE_EQ(d.mean, 0.25);
  EXPECT_NEAR(static_cast<double>(d.samples), 1000, 1);
  EXPECT_EQ(d.nearest - d.worst, glm::dvec3(0, 0, 0.25));
}

//  3--2
//  | /     the upper half of the square is missing: a point (x, y) of it is (y - x) / sqrt(2) away
//  |/ |
//  0--1
TEST(SurfaceDistance, MeanAndRmsAreIntegralsOverTheArea) {
  const MeshData half = zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}});
  const Distance d = between(zoo::square(), half, 20000);
  EXPECT_DOUBLE_EQ(d.max, std::sqrt(0.5));
  EXPECT_NEAR(d.mean, std::sqrt(0.5) / 6, 1e-4);
  EXPECT_NEAR(d.rms, std::sqrt(1.0 / 24), 1e-4);
  EXPECT_EQ(d.worst, glm::dvec3(0, 1, 0));
  EXPECT_NEAR(glm::length(d.nearest - glm::dvec3(0.5, 0.5, 0)), 0, 1e-15);
  const Distance back = between(half, zoo::square(), 20000);
  EXPECT_NEAR(back.max, 0, 1e-15);
}

// Cut finely or coarsely, large faces beside small ones: the area decides, not the faces.
TEST(SurfaceDistance, SamplesFollowTheArea) {
  MeshData uneven = zoo::grid(8);                                     // 8 x 8, flat
  for (glm::dvec3& p : uneven.positions) p.x *= p.x <= 4 ? 0.25 : 1;  // faces of width 1/4, 2 and 1
  for (glm::dvec3& p : uneven.positions) p.z = p.x;                   // climbs over the floor
  const MeshData floor = zoo::make({{-9, -9, 0}, {20, -9, 0}, {-9, 40, 0}}, {{0, 1, 2}});
  const Distance d = between(uneven, floor, 20000);
  EXPECT_DOUBLE_EQ(d.max, 8);
  EXPECT_NEAR(d.mean, 4, 1e-3);
  EXPECT_NEAR(d.rms, 8 / std::sqrt(3.0), 1e-3);
}

//  +-----+
//  | \ / |     the middle is lifted by 1/2; seen from the flat square the largest distance is
//  |  4  |     inside a face
//  | / \ |
//  +-----+
TEST(SurfaceDistance, TheLargestMayLieInsideAFace) {
  const MeshData tent = zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.5}},
                                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const Distance d = between(zoo::square(), tent, 100000);
  const double exact = std::sqrt(0.125);
  EXPECT_LE(d.max, exact);
  EXPECT_GT(d.max, exact - 0.005);
  EXPECT_LT(glm::length(d.worst - glm::dvec3(0.5, 0.5, 0)), 0.01);
  EXPECT_DOUBLE_EQ(between(tent, zoo::square(), 1).max, 0.5);  // its tip is a vertex
}

TEST(SurfaceDistance, BothWaysTakesTheLarger) {
  const Mesh square(zoo::square()), half(zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}));
  const auto forth = measure::mutual_distance(Surface(half), Surface(square), 1000);
  const auto back = measure::mutual_distance(Surface(square), Surface(half), 1000);
  EXPECT_NEAR(forth.to_result.max, 0, 1e-15);
  EXPECT_GT(forth.to_original.rms, 0.2);
  EXPECT_EQ(forth.max(), back.max());
  EXPECT_EQ(forth.rms(), back.rms());
  EXPECT_EQ(forth.mean(), back.mean());
}

TEST(SurfaceDistance, VerticesThatNothingUsesDoNotCount) {
  MeshData more = zoo::square();
  more.positions.emplace_back(0, 0, 100);
  EXPECT_NEAR(between(more, zoo::square(), 100).max, 0, 1e-15);
  EXPECT_NEAR(between(zoo::square(), more, 100).max, 0, 1e-15);
}

TEST(SurfaceDistance, QuadsAreSampledWhole) {
  MeshData quad;
  quad.positions = zoo::square().positions;
  quad.faces.add(Shape::Quad, {0, 1, 2, 3});
  EXPECT_NEAR(between(quad, zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}), 20000).mean,
              std::sqrt(0.5) / 6, 1e-4);
}

TEST(SurfaceDistance, WithoutAreaTheVerticesAreTheSamples) {
  const MeshData needle = zoo::make({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const Distance d = between(needle, moved(zoo::square(), {0, 0, 2}), 100);
  EXPECT_EQ(d.samples, 3u);
  EXPECT_DOUBLE_EQ(d.max, 2);
  EXPECT_DOUBLE_EQ(d.mean, 2);
}

TEST(SurfaceDistance, NothingToMeasureIsZero) {
  EXPECT_EQ(between(zoo::square(), MeshData(), 10).max, 0);
  EXPECT_EQ(between(MeshData(), zoo::square(), 10).samples, 0u);
}

// The unit triangle, turned about its first side by each angle.
Mesh turned(const std::vector<double>& angles) {
  MeshData data;
  for (const double angle : angles) {
    const auto first = static_cast<std::uint32_t>(data.positions.size());
    const double a = angle * M_PI / 180;
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), {1, 0, 0}, {0.5, std::cos(a), std::sin(a)}})
      data.positions.push_back(p);
    data.faces.add(Shape::Triangle, {first, first + 1, first + 2});
  }
  return Mesh(data);
}

TEST(NormalDeviation, CountsByAngle) {
  const Mesh flat(zoo::make({{-9, -9, 0}, {9, -9, 0}, {0, 20, 0}}, {{0, 1, 2}}));
  const auto d = measure::measure_normals(Surface(flat).tree(),
                                          turned({0, 9.9, 10.1, 59.9, 60.1, 89, 91, 180}));
  EXPECT_EQ(d.triangles, 8u);
  EXPECT_EQ(d.above_10deg, 6u);
  EXPECT_EQ(d.above_60deg, 4u);
  EXPECT_EQ(d.flips, 2u);
  EXPECT_EQ(d.percent(d.flips), 25);
}

//    1
//   /|\       a roof, seen along its ridge; a face beyond the ridge is nearest to the ridge, on
//  0 | 2      which both sides lie
TEST(NormalDeviation, OnARidgeTheBetterSideCounts) {
  const Mesh roof(zoo::make({{-1, 0, 0}, {-1, 4, 0}, {0, 0, 1}, {0, 4, 1}, {1, 0, 0}, {1, 4, 0}},
                            {{0, 2, 3}, {0, 3, 1}, {2, 4, 5}, {2, 5, 3}}));
  for (const double slope : {1.0, -1.0}) {
    const Mesh above(zoo::make({{-0.3, 1, 2 + slope * -0.3}, {0.3, 1, 2 + slope * 0.3}, {0, 2, 2}},
                               {{0, 1, 2}}));
    EXPECT_EQ(measure::measure_normals(Surface(roof).tree(), above).above_10deg, 0u) << slope;
  }
}

TEST(NormalDeviation, FacesWithoutAreaAreOnlyCounted) {
  const Mesh flat(zoo::square()),
      needle(zoo::make({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, {{0, 1, 2}}));
  const auto d = measure::measure_normals(Surface(flat).tree(), needle);
  EXPECT_EQ(d.triangles, 1u);
  EXPECT_EQ(d.above_10deg, 0u);
  EXPECT_EQ(measure::measure_normals(TriangleTree({}), flat).above_10deg, 0u);
  EXPECT_EQ(measure::measure_normals(TriangleTree({}), Mesh()).percent(0), 0);
}

}  // namespace
}  // namespace aomd::test::distance_test
