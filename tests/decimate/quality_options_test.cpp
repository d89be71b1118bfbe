// What the options of the quality strategy come to, and passes from outside.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/decimate/decimation.h"
#include "core/measure/distance.h"
#include "core/measure/statistics.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::quality_options_test {
namespace {

using test::classified;
using test::finding;
using test::quality;

SweepStatistics total(const Decimation& decimation) {
  SweepStatistics sum;
  for (const SweepStatistics& s : decimation.sweeps())
    sum.collapses += s.collapses, sum.swaps += s.swaps, sum.smooths += s.smooths;
  return sum;
}

TEST(QualityOptionsTest, SwapsAndSmoothingCanBeLeftOut) {
  for (const bool swap : {true, false})
    for (const bool smooth : {true, false}) {
      Mesh mesh = classified(make_sample("scan", 3000));
      DecimationOptions options = quality(mesh.count(2) / 4);
      options.swap = swap, options.smooth = smooth;
      Decimation decimation(mesh, options);
      decimation.run();
      const SweepStatistics made = total(decimation);
      EXPECT_GT(made.collapses, 0u);
      EXPECT_EQ(made.swaps > 0, swap);
      EXPECT_EQ(made.smooths > 0, smooth) << "swap " << swap;
    }
}

// But for the one that watches which way faces look: on this scan all do as they should.
TEST(QualityOptionsTest, EveryIdeaMakesADifference) {
  const auto result = [](std::uint32_t without) {
    Mesh mesh = classified(make_sample("scan", 3000));
    DecimationOptions options = quality(mesh.count(2) / 10, 0);
    options.without = without;
    Decimation(mesh, options).run();
    return test::without_edges(mesh);
  };
  const std::string with_all = result(0);
  for (int k = 0; k < idea_count; ++k)
    EXPECT_EQ(result(1u << k) != with_all, static_cast<Idea>(k) != Idea::Facing)
        << idea_name(static_cast<Idea>(k));
}

// A sheet of n x n squares of which a part is a bump, the rest flat.
MeshData bump(int n, double part) {
  MeshData data = zoo::grid(n);
  for (glm::dvec3& p : data.positions) {
    const double r = std::hypot(p.x - n / 2.0, p.y - n / 2.0) / (n * part);
    if (r < 1) p.z = n * part * std::pow(1 - r * r, 2) / 2;
  }
  return data;
}

// What lies in flat places has no say in how many points come to a face: 6,561 vertices are enough
// for 400 faces where all are bent, and not where a fifth is.
TEST(QualityOptionsTest, PointsAreDenseWhereTheBentPartHasFew) {
  const auto result = [](double part, std::uint32_t without) {
    Mesh mesh = classified(bump(80, part));
    DecimationOptions options = quality(400, 0);
    options.without = without;
    Decimation(mesh, options).run();
    return test::without_edges(mesh);
  };
  const std::uint32_t no_dense_points = 1u << static_cast<int>(Idea::DensePoints);
  EXPECT_EQ(result(0.8, no_dense_points), result(0.8, 0));
  EXPECT_NE(result(0.25, no_dense_points), result(0.25, 0));
}

// From accuracy to regular faces no step goes back by more than 3 %.
TEST(QualityOptionsTest, TheWayFromAccuracyToRegularFacesIsSmooth) {
  const Mesh original = classified(make_sample("scan", 12000));
  const measure::Surface before(original);
  double rms = 0, angle = 0;
  for (int tenth = 0; tenth <= 10; ++tenth) {
    Mesh mesh = classified(make_sample("scan", 12000));
    Decimation(mesh, quality(1000, tenth / 10.0)).run();
    const double now = measure::mutual_distance(before, measure::Surface(mesh), 50'000).rms();
    const double angle_now = measure::measure_quality(mesh).min_angle_mean_deg;
    EXPECT_GE(now, 0.97 * rms) << "at " << tenth / 10.0;
    EXPECT_GE(angle_now, 0.97 * angle) << "at " << tenth / 10.0;
    rms = now;
    angle = angle_now;
  }
}

// One to a little above the target, three to the target and after it.
TEST(QualityOptionsTest, TheLastCollapsesAreImprovedThreeTimes) {
  Mesh mesh = classified(make_sample("scan", 3000));
  Decimation decimation(mesh, quality(mesh.count(2) / 4));
  decimation.run();
  ASSERT_EQ(decimation.sweeps().size(), 4u);
  for (const SweepStatistics& sweep : decimation.sweeps()) EXPECT_GT(sweep.smooths, 0u);
}

// All that collapses know of a cube without model edges is what they add up.
TEST(QualityOptionsTest, ACubeKeepsItsCornersWithoutModelEdges) {
  MeshData data = make_sample("box", 8);
  data.vertex_classes.clear(), data.faces.classes.clear(), data.edges = {};
  Mesh mesh(data);
  classify(mesh, {.feature_angle_deg = {}});
  DecimationOptions options = quality(48);
  options.swap = options.smooth = false;
  options.without = 1u << static_cast<int>(Idea::SecondStage);
  Decimation(mesh, options).run();
  EXPECT_LE(mesh.count(2), 48u);
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) {
        double nearest = 1;
        for (const Vertex v : mesh.vertices())
          nearest = std::min(nearest, glm::length(mesh.position(v) - glm::dvec3(x, y, z)));
        EXPECT_LE(nearest, 0.01) << x << y << z;
      }
}

TEST(QualityOptionsTest, TheSpacingIsThatOfTheStart) {
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality}) {
    Mesh mesh = classified(zoo::torus(40, 30));
    Decimation decimation(mesh, {.strategy = strategy, .factor = 3, .angle_deg = 30});
    const double before = decimation.spacing(Vertex(0));
    Column<Vertex, double> wanted(mesh.capacity(0));
    for (const Vertex v : mesh.vertices()) wanted[v] = decimation.spacing(v);
    decimation.run();
    decimation.invalidate();
    EXPECT_GT(before, 0);
    for (const Vertex v : mesh.vertices())
      ASSERT_EQ(decimation.spacing(v), wanted[v]) << int(strategy);
  }
}

TEST(QualityOptionsTest, ASpacingOfAConstantGivesEdgesOfAboutThatLength) {
  Mesh mesh = classified(zoo::grid(48));
  DecimationOptions options{.strategy = Strategy::Quality};
  options.spacing = std::make_shared<Column<Vertex, double>>(mesh.capacity(0), 6.0);
  Decimation decimation(mesh, options);
  EXPECT_EQ(decimation.spacing(Vertex(5)), 6);
  decimation.run();
  EXPECT_EQ(finding(mesh), "");
  double sum = 0;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    sum += glm::length(mesh.position(a) - mesh.position(b));
  }
  EXPECT_NEAR(sum / mesh.count(1), 4.469, 0.01) << "edges shorter than 3 go";
}

// Passes from outside between steps: the candidates that were known may be no edges any more.
TEST(QualityOptionsTest, PassesBetweenStepsKeepTheMesh) {
  for (const TopologyRule topology : {TopologyRule::Safe, TopologyRule::Paper})
    for (const char* name : {"torus", "scan", "terrain"}) {
      Mesh mesh = classified(make_sample(name, name[0] == 's' ? 2000 : 50));
      const int euler = zoo::euler(mesh);
      DecimationOptions options = quality(mesh.count(2) / 8);
      options.topology = topology;
      Decimation decimation(mesh, options);
      while (!decimation.done()) {
        for (int i = 0; i < 25; ++i) decimation.step();
        decimation.swap_pass();
        decimation.smooth_pass();
        ASSERT_EQ(finding(mesh), "") << name;
      }
      EXPECT_EQ(zoo::euler(mesh), euler)
          << name << (topology == TopologyRule::Safe ? " safe" : " paper");
    }
}

//   2
//  /|\          the diagonal 2-3 of a long kite
// 0 | 1
//  \|/
//   3
TEST(QualityOptionsTest, ASwapPassImprovesAMeshAsItIs) {
  Mesh mesh =
      classified(zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}}, {{0, 3, 2}, {3, 1, 2}}));
  Decimation decimation(mesh, quality(2));
  EXPECT_EQ(decimation.swap_pass(), 1u);
  EXPECT_FALSE(mesh.find_edge(Vertex(2), Vertex(3)).valid());
}

TEST(QualityOptionsTest, AMeshAtItsTargetKeepsItsFaces) {
  Mesh mesh = classified(make_sample("torus", 60));
  const std::uint32_t faces = mesh.count(2);
  Decimation decimation(mesh, quality(faces));
  decimation.run();
  EXPECT_EQ(mesh.count(2), faces);
  EXPECT_EQ(total(decimation).collapses, 0u);
}

}  // namespace
}  // namespace aomd::quality_options_test
