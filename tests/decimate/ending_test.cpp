// Every run ends, whatever the coordinates are: faces without length, all of a surface in one
// point, and numbers near the end of what there is.

#include <gtest/gtest.h>

#include <limits>

#include "core/decimate/decimation.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::ending_test {
namespace {

constexpr int many = 20000;  // times 64 candidates: far beyond what these meshes need

// The faces that are left; none where it would have gone on.
std::optional<std::uint32_t> faces_after(const MeshData& data, const DecimationOptions& options) {
  Mesh mesh = test::classified(data);
  const std::string before = test::finding(mesh);
  Decimation decimation(mesh, options);
  int asked = 0;
  const auto stop = decimation.run({}, [&] { return ++asked == many; });
  EXPECT_TRUE(!before.empty() || test::finding(mesh).empty()) << test::finding(mesh);
  if (stop != Decimation::Stop::Done) return {};
  return mesh.count(2);
}

// Three vertices of their own, each at one of these two places.
MeshData with_a_face_on(MeshData data, const glm::dvec3& a, const glm::dvec3& b) {
  const auto first = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(), {a, a, b});
  data.faces.add(Shape::Triangle, {first, first + 1, first + 2});
  return data;
}

constexpr std::uint32_t out_of_reach = 4;

TEST(EndingTest, AFaceWithoutLengthIsLeftAndTheRestIsAsWithoutIt) {
  const DecimationOptions options{.target_faces = out_of_reach};
  const MeshData torus = zoo::torus(12, 9);
  const std::uint32_t alone = *faces_after(torus, options);
  EXPECT_EQ(faces_after(with_a_face_on(torus, {9, 9, 9}, {9, 9, 9}), options), alone + 1);
  EXPECT_EQ(faces_after(with_a_face_on(torus, {9, 9, 9}, {9, 9, 10}), options), alone + 1);
}

TEST(EndingTest, ASurfaceInOnePointEnds) {
  MeshData data = zoo::torus(12, 9);
  for (glm::dvec3& p : data.positions) p = {1, 2, 3};
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality})
    EXPECT_EQ(faces_after(data, {.strategy = strategy, .target_faces = out_of_reach}), 216u);
}

TEST(EndingTest, MeshesPastTheRangeOfSinglePrecisionAreRefused) {
  for (const double size : {1e-21, 1e-19, 1e17, 1e19}) {
    MeshData data = zoo::square();
    for (glm::dvec3& p : data.positions) p *= size;
    EXPECT_EQ(decimation_obstacle(Mesh(data)) == nullptr, size == 1e-19 || size == 1e17) << size;
  }
}

TEST(EndingTest, NumbersNearTheEndOfWhatThereIsEndOrAreRefused) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double size : {1e-320, 1e-200, 1e-30, 1e-19, 1e17, 1e30, 1e200, 1e307, infinite})
    for (const Strategy strategy : {Strategy::Paper, Strategy::Quality})
      for (const bool one : {true, false}) {
        MeshData data = zoo::torus(12, 9);
        for (glm::dvec3& p : data.positions) p *= one ? 1 : size;
        if (one) data.positions[0].x = size;
        EXPECT_TRUE(decimation_obstacle(Mesh(data)) ||
                    faces_after(data, {.strategy = strategy, .target_faces = out_of_reach}))
            << size << ' ' << int(strategy) << one;
      }
}

// Thousands of faces around each vertex: none is moved where each new face would be held against
// all the others.
TEST(EndingTest, CopiesOfOneFaceEndUnderGuardsToo) {
  MeshData data = zoo::triangle();
  for (int copy = 1; copy < 20000; ++copy) data.faces.add(Shape::Triangle, {0, 1, 2});
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality})
    for (const TopologyRule topology : {TopologyRule::Safe, TopologyRule::Paper})
      EXPECT_EQ(faces_after(data, {.strategy = strategy,
                                   .target_faces = out_of_reach,
                                   .max_distance = 0.1,
                                   .no_intersections = true,
                                   .topology = topology}),
                20000u);
}

// Lengths over tens of decades: the spacing goes from one to the next in few sweeps.
TEST(EndingTest, TheSpacingGrowsInFewSweepsWhereLengthsAreFarApart) {
  MeshData data = zoo::make({}, {});
  for (const double size : {1e-12, 1.0, 1e12})
    for (const double at : {0.0, 1.0}) data = with_a_face_on(data, {at, at, size}, {at, at, 0});
  Mesh mesh = test::classified(data);
  Decimation decimation(mesh, {.target_faces = 1});
  decimation.run();
  EXPECT_LE(decimation.sweeps().size(), 20u);
}

}  // namespace
}  // namespace aomd::ending_test
