// Surfaces that are hardly any, and such of all sizes, by the quality strategy.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/decimate/decimation.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::hardly_a_surface_test {
namespace {

using test::classified;
using test::finding;
using test::quality;

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
}  // namespace aomd::hardly_a_surface_test
