// The quality strategy's options, passes from outside, and surfaces that are hardly any.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/decimate/decimation.h"
#include "core/measure/distance.h"
#include "core/measure/statistics.h"
#include "core/mesh/geometry.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd {
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

/// How many edges of the result between kept vertices the mesh before did not have, where a third
/// of them, in bands, is kept.
std::size_t new_edges_between_kept(bool sealed) {
  const MeshData data = make_sample("torus", 60);
  const auto keep =
      std::make_shared<Column<Vertex, std::uint8_t>>(data.positions.size(), std::uint8_t{0});
  for (std::uint32_t v = 0; v < data.positions.size(); ++v) (*keep)[Vertex(v)] = v / 40 % 3 == 0;
  Mesh mesh = classified(data), before = classified(data);
  DecimationOptions options = quality(1);
  options.keep = keep;
  options.seal_kept = sealed;
  options.swap = false;
  Decimation(mesh, options).run();
  EXPECT_EQ(finding(mesh), "");
  EXPECT_LT(mesh.count(0), before.count(0));
  std::size_t fresh = 0;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    fresh += options.kept(a) && options.kept(b) && !before.find_edge(a, b).valid();
  }
  return fresh;
}

TEST(QualityOptionsTest, NoEdgeBetweenSealedVerticesIsNew) {
  EXPECT_GT(new_edges_between_kept(false), 10u);
  EXPECT_EQ(new_edges_between_kept(true), 0u);
}

TEST(QualityOptionsTest, KeptVerticesStayWhereTheyAre) {
  Mesh mesh = classified(make_sample("torus", 60));
  const auto keep =
      std::make_shared<Column<Vertex, std::uint8_t>>(mesh.capacity(0), std::uint8_t{0});
  std::vector<glm::dvec3> positions;
  for (std::uint32_t v = 0; v < mesh.capacity(0); v += 7) (*keep)[Vertex(v)] = 1;
  for (const Vertex v : mesh.vertices()) positions.push_back(mesh.position(v));
  DecimationOptions options = quality(1);
  options.keep = keep;
  Decimation(mesh, options).run();
  EXPECT_LT(mesh.count(0), positions.size() / 2);
  for (std::uint32_t v = 0; v < positions.size(); v += 7) {
    ASSERT_TRUE(mesh.alive(Vertex(v)));
    EXPECT_EQ(mesh.position(Vertex(v)), positions[v]);
  }
}

double smallest_angle(const Mesh& mesh) {
  double least = 180;
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    least = std::min(
        least, smallest_angle_deg(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
  }
  return least;
}

// A sphere starts with angles above 50 degrees, so that no face may get one below the limit.
TEST(QualityOptionsTest, TheLeastAngleHolds) {
  for (const double regularity : {0.0, 0.5, 1.0}) {
    Mesh mesh = classified(make_sample("sphere", 12));
    ASSERT_GT(smallest_angle(mesh), 50);
    DecimationOptions options = quality(mesh.count(2) / 8);
    options.min_angle_deg = 25, options.regularity = regularity;
    Decimation decimation(mesh, options);
    while (decimation.step())
      ASSERT_GE(smallest_angle(mesh), 25 - 1e-9) << decimation.sweeps().size();
  }
}

// Face by face: an operation leaves no angle below the limit, unless there was a smaller one where
// it worked.
TEST(QualityOptionsTest, NoOperationMakesAnAngleBelowTheLeast) {
  Mesh mesh = classified(make_sample("scan", 2000));
  DecimationOptions options = quality(mesh.count(2) / 8);
  options.min_angle_deg = 25, options.regularity = 0;
  Decimation decimation(mesh, options);
  const auto angles = [&] {
    std::vector<double> all(mesh.capacity(2), 180.0);
    for (const Face f : mesh.faces()) {
      const auto t = mesh.triangle(f);
      all[f.index] =
          smallest_angle_deg(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    }
    return all;
  };
  std::vector<double> before = angles();
  while (const auto made = decimation.step()) {
    const std::vector<double> after = angles();
    double worst_before = 180, worst_after = 180;
    for (std::size_t f = 0; f < after.size(); ++f)
      if (before[f] != after[f]) {
        worst_before = std::min(worst_before, before[f]);
        worst_after = std::min(worst_after, after[f]);
      }
    ASSERT_GE(worst_after, std::min(25.0, worst_before) - 1e-9) << step_name(made->kind);
    before = after;
  }
}

// Nothing that happens to a face which stays turns it by more than the limit.
TEST(QualityOptionsTest, NoOperationTurnsAFaceByMoreThanTheAngle) {
  Mesh mesh = classified(make_sample("scan", 3000));
  DecimationOptions options = quality(mesh.count(2) / 5);
  options.angle_deg = 8, options.swap = false;
  Decimation decimation(mesh, options);
  const auto normals = [&] {
    std::vector<glm::dvec3> all(mesh.capacity(2), glm::dvec3(0.0));
    for (const Face f : mesh.faces()) {
      const auto t = mesh.triangle(f);
      all[f.index] = area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    }
    return all;
  };
  const TurnLimit limit(8.0001);
  std::vector<glm::dvec3> before = normals();
  while (const auto made = decimation.step()) {
    const std::vector<glm::dvec3> after = normals();
    for (const Face f : mesh.faces())
      ASSERT_TRUE(limit.allows(before[f.index], after[f.index])) << step_name(made->kind);
    before = after;
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

// Stretched forty times, nearly every triangle is narrower than the strategy's own least angle,
// which must not stand in the way; the user's must.
TEST(QualityOptionsTest, AMeshOfSliversReachesItsTarget) {
  MeshData data = make_sample("terrain", 40);
  for (glm::dvec3& p : data.positions) p.x *= 40;
  const auto faces_left = [&](double min_angle_deg) {
    Mesh mesh(data);
    classify(mesh);
    const std::uint32_t target = mesh.count(2) / 8;
    Decimation(mesh, {.strategy = Strategy::Quality,
                      .target_faces = target,
                      .angle_deg = 60,
                      .min_angle_deg = min_angle_deg,
                      .regularity = 1})
        .run();
    EXPECT_TRUE(verify(mesh).empty());
    return static_cast<double>(mesh.count(2)) / target;
  };
  EXPECT_LE(faces_left(0), 1.0);
  EXPECT_GT(faces_left(20), 1.1);
}

TEST(QualityOptionsTest, AMeshAtItsTargetKeepsItsFaces) {
  Mesh mesh = classified(make_sample("torus", 60));
  const std::uint32_t faces = mesh.count(2);
  Decimation decimation(mesh, quality(faces));
  decimation.run();
  EXPECT_EQ(mesh.count(2), faces);
  EXPECT_EQ(total(decimation).collapses, 0u);
}

// What is hardly a surface: no crash, no number that is none, and the mesh still one.
void expect_survives(const MeshData& data, const std::string& name) {
  for (const bool derived : {true, false})
    for (const std::uint32_t target : {0u, 1u, 3u})
      for (const TopologyRule topology : {TopologyRule::Safe, TopologyRule::Paper}) {
        Mesh mesh(data);
        if (derived) classify(mesh);
        DecimationOptions options = quality(target);
        options.topology = topology, options.angle_deg = 150;
        Decimation decimation(mesh, options);
        decimation.run();
        EXPECT_TRUE(decimation.done()) << name;
        decimation.improve();
        decimation.invalidate();
        decimation.run();
        EXPECT_EQ(finding(mesh), "") << name;
      }
}

TEST(HardlyASurfaceTest, Nothing) {
  expect_survives({}, "empty");
  MeshData points;
  points.positions = {{0, 0, 0}, {1, 2, 3}};
  expect_survives(points, "points");
  points.edges.add(Shape::Line, {0, 1});
  expect_survives(points, "an edge");
}

TEST(HardlyASurfaceTest, OneTriangle) {
  expect_survives(zoo::triangle(), "triangle");
  expect_survives(zoo::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), "in a line");
  expect_survives(zoo::make({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}), "in a point");
}

TEST(HardlyASurfaceTest, AllInALineOrInAPoint) {
  MeshData line = zoo::grid(6), point = zoo::grid(6), folded = zoo::grid(6);
  for (glm::dvec3& p : line.positions) p = {p.x + 7 * p.y, 0, 0};
  for (glm::dvec3& p : point.positions) p = {3, 4, 5};
  for (glm::dvec3& p : folded.positions) p = {p.x, 0, 0};  // many vertices in one place
  expect_survives(line, "line");
  expect_survives(point, "point");
  expect_survives(folded, "folded");
}

// A sheet with some faces that have no area, and some vertices in one place.
MeshData with_coincident_vertices(MeshData data, std::uint32_t every) {
  for (std::uint32_t v = every; v + 1 < data.positions.size(); v += every)
    data.positions[v + 1] = data.positions[v];
  return data;
}

TEST(HardlyASurfaceTest, CoincidentVertices) {
  for (const std::uint32_t every : {2u, 3u, 5u}) {
    expect_survives(with_coincident_vertices(zoo::grid(8), every), "grid");
    expect_survives(with_coincident_vertices(zoo::torus(12, 9), every), "torus");
    expect_survives(with_coincident_vertices(make_sample("scan", 2000), every), "scan");
    expect_survives(with_coincident_vertices(make_sample("nonmanifold", 4), every), "nonmanifold");
  }
}

TEST(HardlyASurfaceTest, AFewFacesWithoutAreaDoNotStandInTheWay) {
  MeshData data = make_sample("torus", 60);
  for (std::uint32_t v = 50; v + 1 < data.positions.size(); v += 100)
    data.positions[v + 1] = data.positions[v];
  Mesh mesh = classified(data);
  const std::uint32_t target = mesh.count(2) / 4;
  Decimation(mesh, quality(target)).run();
  EXPECT_LE(mesh.count(2), target);
}

TEST(HardlyASurfaceTest, IsolatedVerticesStay) {
  MeshData data = zoo::torus(20, 12);
  for (int i = 0; i < 9; ++i) data.positions.emplace_back(i, 100, 0);
  Mesh mesh = classified(data);
  Decimation(mesh, quality(100)).run();
  EXPECT_LE(mesh.count(2), 100u);
  EXPECT_EQ(mesh.count(0), mesh.count(2) / 2 + 9);
  for (std::uint32_t v = 240; v < 249; ++v) EXPECT_EQ(mesh.position(Vertex(v)).y, 100);
}

MeshData scaled(MeshData data, double scale) {
  for (glm::dvec3& p : data.positions) p *= scale;
  return data;
}

TEST(ScaleTest, CountsDoNotDependOnTheUnit) {
  for (const char* name : {"scan", "terrain"}) {
    const MeshData data = make_sample(name, name[0] == 's' ? 3000 : 30);
    const auto target = static_cast<std::uint32_t>(data.faces.size()) / 5;
    for (const std::uint32_t goal : {target, 0u}) {
      DecimationOptions options = quality(goal);
      if (goal == 0) options = {.strategy = Strategy::Quality, .factor = 3, .angle_deg = 30};
      Mesh unit = classified(data);
      Decimation(unit, options).run();
      for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
        Mesh mesh = classified(scaled(data, scale));
        Decimation(mesh, options).run();
        EXPECT_EQ(finding(mesh), "");
        EXPECT_NEAR(mesh.count(2), unit.count(2), 0.01 * unit.count(2))
            << name << ' ' << scale << ' ' << goal;
      }
    }
  }
}

// Powers of two change no digit: the result is the same one, to the last bit.
TEST(ScaleTest, AnotherUnitGivesTheSameSurface) {
  const MeshData data = make_sample("scan", 3000);
  const DecimationOptions options = quality(600);
  Mesh unit = classified(data);
  Decimation(unit, options).run();
  for (const int power : {-40, -10, 10, 40}) {
    Mesh mesh = classified(scaled(data, std::ldexp(1, power)));
    Decimation(mesh, options).run();
    for (const Vertex v : mesh.vertices()) mesh.move(v, mesh.position(v) * std::ldexp(1, -power));
    EXPECT_EQ(zoo::fingerprint(mesh) == zoo::fingerprint(unit), true) << power;
  }
}

}  // namespace
}  // namespace aomd
