// Measuring on several threads: the same tree, pairs, angles and distances for any number of them.

#include <gtest/gtest.h>

#include "core/measure/distance.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "tests/support/zoo.h"

namespace aomd::test::measure_threads_test {
namespace {

// Two chain links: each ring goes through the other's hole and is wide enough to cut it.
MeshData links() {
  MeshData data = zoo::torus(90, 60);
  const MeshData other = data;
  const auto shift = static_cast<std::uint32_t>(data.positions.size());
  for (const glm::dvec3& p : other.positions) data.positions.emplace_back(p.x + 1.5, p.z, p.y);
  for (std::size_t f = 0; f < other.faces.size(); ++f) {
    const std::uint32_t* v = &other.faces.vertices[3 * f];
    data.faces.add(Shape::Triangle, {v[0] + shift, v[1] + shift, v[2] + shift});
  }
  return data;
}

TEST(MeasureThreadsTest, TheSameTree) {
  const Triangles all = triangles_of(links());
  const TriangleTree one(all.corners);
  for (const int threads : {2, 3, 7}) {
    const TriangleTree several(all.corners, threads);
    ASSERT_EQ(several.size(), one.size());
    for (std::uint32_t n = 0; n < one.size(); ++n) {
      ASSERT_EQ(several.source(n), one.source(n)) << threads;
      ASSERT_EQ(several.triangle(n), one.triangle(n)) << threads;
    }
  }
}

TEST(MeasureThreadsTest, TheSameIntersections) {
  const Mesh mesh(links());
  const auto one = measure::self_intersections(mesh);
  EXPECT_GT(one.size(), 100u);
  for (const int threads : {2, 3, 7})
    EXPECT_EQ(measure::self_intersections(mesh, threads), one) << threads;
}

TEST(MeasureThreadsTest, TheSameAnglesAndDistances) {
  const Mesh original(links()), result(zoo::torus(40, 31));
  const measure::Surface from(original), to(result);
  const auto turned = measure::measure_normals(from.tree(), result);
  const auto distance = measure::distance_from(from, to, 100000);
  EXPECT_GT(turned.above_10deg, 0u);
  EXPECT_GT(distance.max, 1);
  for (const int threads : {2, 3, 7}) {
    const auto several = measure::measure_normals(from.tree(), result, threads);
    EXPECT_EQ(several.triangles, turned.triangles);
    EXPECT_EQ(several.above_10deg, turned.above_10deg);
    EXPECT_EQ(several.above_60deg, turned.above_60deg);
    EXPECT_EQ(several.flips, turned.flips);
    const auto same =
        measure::distance_from(from, measure::Surface(result, threads), 100000, threads);
    EXPECT_EQ(same.samples, distance.samples);
    EXPECT_EQ(same.max, distance.max);
    EXPECT_EQ(same.rms, distance.rms);
    EXPECT_EQ(same.mean, distance.mean);
    EXPECT_EQ(same.worst, distance.worst);
    EXPECT_EQ(same.nearest, distance.nearest);
  }
}

}  // namespace
}  // namespace aomd::test::measure_threads_test
