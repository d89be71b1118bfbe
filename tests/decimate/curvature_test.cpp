#include "core/decimate/spacing/curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/decimate/spacing/spacing.h"
#include "tests/support/zoo.h"

namespace aomd::curvature_test {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  std::size_t count = 0;
};

template <typename Which>
Range range_of(const Mesh& mesh, const Column<Vertex, double>& column, Which&& which) {
  Range range;
  for (const Vertex v : mesh.vertices()) {
    if (!which(v)) continue;
    range.low = std::min(range.low, column[v]);
    range.high = std::max(range.high, column[v]);
    ++range.count;
  }
  return range;
}

Range range_of(const Mesh& mesh, int smoothing = 2) {
  return range_of(mesh, vertex_curvatures(mesh, smoothing), [](Vertex) { return true; });
}

MeshData scaled(MeshData data, double factor) {
  for (glm::dvec3& p : data.positions) p *= factor;
  return data;
}

TEST(CurvatureTest, AFlatSheetHasNone) {
  EXPECT_EQ(range_of(Mesh(zoo::grid(6))).high, 0);
  const Mesh mesh(zoo::grid(6));
  const auto spacing = evaluate_spacing(mesh, {SpacingByCurvature{.largest = 0.25}, {}});
  EXPECT_EQ(spacing[Vertex(24)], 0.25 * std::sqrt(72.0)) << "the largest";
}

// Normals are exact on a sphere. What is left is the tilt of triangles and neighbours against a
// vertex, of second order in edge / radius = 0.08: seen over three rings up to (3 * 0.08)^2 / 8 =
// 0.7%, over one 0.15%.
TEST(CurvatureTest, OfASphereIsOneByItsRadius) {
  for (const double radius : {1.0, 250.0, 1e-3}) {
    const Mesh mesh(scaled(make_sample("sphere", 16), radius));
    const Range smooth = range_of(mesh), raw = range_of(mesh, 0);
    EXPECT_NEAR(smooth.low * radius, 1, 0.007);
    EXPECT_NEAR(smooth.high * radius, 1, 0.007);
    EXPECT_NEAR(raw.low * radius, 1, 0.0015);
    EXPECT_NEAR(raw.high * radius, 1, 0.0015);
  }
}

TEST(CurvatureTest, TwiceAsFineIsFourTimesAsNear) {
  const auto error = [](int size) {
    const Range range = range_of(Mesh(make_sample("sphere", size)));
    return std::max(range.high - 1, 1 - range.low);
  };
  EXPECT_LT(error(32), error(16) / 3.8);
  EXPECT_LT(error(64), error(32) / 3.8);
}

// Radius 1, closed by two flat caps at model edges. Edges along the circles are 2 pi / 60 long.
TEST(CurvatureTest, OfACylinderIsOneByItsRadiusUpToTheRimAndTheCapsHaveNone) {
  const Mesh mesh(make_sample("cylinder", 10));
  double bottom = 1e9, top = -1e9;
  for (const Vertex v : mesh.vertices())
    bottom = std::min(bottom, mesh.position(v).z), top = std::max(top, mesh.position(v).z);
  const auto curvature = vertex_curvatures(mesh);
  const auto at_rim = [&](Vertex v) { return mesh.classification(v).dimension() <= 1; };
  const auto on_cap = [&](Vertex v) {
    return !at_rim(v) && (mesh.position(v).z == bottom || mesh.position(v).z == top);
  };
  const Range caps = range_of(mesh, curvature, on_cap), rims = range_of(mesh, curvature, at_rim);
  const Range side = range_of(mesh, curvature, [&](Vertex v) { return !at_rim(v) && !on_cap(v); });
  ASSERT_TRUE(caps.count > 100 && rims.count > 100 && side.count > 100);
  EXPECT_LT(caps.high, 1e-12);
  for (const Range& round : {rims, side}) {
    EXPECT_NEAR(round.low, 1, 0.015);
    EXPECT_NEAR(round.high, 1, 0.015);
  }
}

// The angle between two model faces is no curvature; where nothing tells them apart it is.
TEST(CurvatureTest, ABoxHasNoneUnlessItIsUnclassified) {
  MeshData data = make_sample("box", 6);
  EXPECT_LT(range_of(Mesh(data)).high, 1e-12);
  data.vertex_classes.clear();
  data.edges = {};
  data.faces.classes.clear();
  EXPECT_GT(range_of(Mesh(data)).high, 1);
}

// A flat sheet with a hole of radius 0.6: only the hole's rim bends, and that along itself.
TEST(CurvatureTest, OfAModelEdgeIsThatOfTheCurve) {
  const Mesh mesh(make_sample("plane-hole", 64));
  const auto curvature = vertex_curvatures(mesh);
  const auto at_hole = [&](Vertex v) {
    return std::abs(glm::length(mesh.position(v) - glm::dvec3(2, 2, 0)) - 0.6) < 1e-9;
  };
  const Range rim = range_of(mesh, curvature, at_hole);
  ASSERT_GT(rim.count, 20u);
  EXPECT_NEAR(rim.low, 1 / 0.6, 0.01);
  EXPECT_NEAR(rim.high, 1 / 0.6, 0.01);
  EXPECT_LT(range_of(mesh, curvature, [&](Vertex v) { return !at_hole(v); }).high, 1e-12);
}

//  a model edge through a flat sheet, with teeth:
//
//  5---6---7---8---9---10--11
//  |               3       |
//  0---1---2---/-\-4-...       the curve is 0 1 2 3 4 ..., up and down by turns
TEST(CurvatureTest, TeethOfAJaggedModelEdgeCancel) {
  MeshData data;
  constexpr std::uint32_t n = 12;
  for (std::uint32_t i = 0; i <= n; ++i) data.positions.emplace_back(i, i % 2 == 0 ? 0.1 : -0.1, 0);
  for (std::uint32_t i = 0; i <= n; ++i) data.positions.emplace_back(i, 2, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    data.faces.add(Shape::Triangle, {i, i + 1, n + 1 + i}, ModelRef(2, 1));
    data.faces.add(Shape::Triangle, {i + 1, n + 2 + i, n + 1 + i}, ModelRef(2, 1));
    data.edges.add(Shape::Line, {i, i + 1}, ModelRef(1, 1));
  }
  data.vertex_classes.assign(data.positions.size(), ModelRef(2, 1));
  for (std::uint32_t i = 0; i <= n; ++i) data.vertex_classes[i] = ModelRef(i % n == 0 ? 0 : 1, 1);
  const Mesh mesh(data);
  const auto curvature = vertex_curvatures(mesh);
  for (std::uint32_t i = 2; i + 2 <= n; ++i) EXPECT_LT(curvature[Vertex(i)], 1e-12) << i;
  EXPECT_GT(curvature[Vertex(1)], 0.1) << "at the end there is nothing on one side to cancel with";
}

TEST(CurvatureTest, SmoothingKeepsNoiseOut) {
  MeshData data = make_sample("sphere", 16);
  std::uint32_t state = 7;
  for (glm::dvec3& p : data.positions)
    p *= 1 + 0.002 * (((state = state * 1664525u + 1013904223u) >> 16) / 32768.0 - 1);
  const Mesh mesh(data);
  const auto worst = [&](int smoothing) { return range_of(mesh, smoothing).high; };
  EXPECT_GT(worst(0), 1.35);
  EXPECT_LT(worst(2), 1.15);
}

TEST(CurvatureTest, DoesNotDependOnWhereTheMeshLies) {
  MeshData data = make_sample("cylinder", 6);
  const glm::dmat3 turn(glm::normalize(glm::dvec3(2, -1, 2)), glm::normalize(glm::dvec3(2, 2, -1)),
                        glm::normalize(glm::dvec3(-1, 2, 2)));
  const Mesh before(data);
  for (glm::dvec3& p : data.positions) p = turn * p + glm::dvec3(3, -5, 7);
  const Mesh after(data);
  const auto expected = vertex_curvatures(before), found = vertex_curvatures(after);
  for (const Vertex v : before.vertices()) EXPECT_NEAR(found[v], expected[v], 1e-12);
}

TEST(CurvatureTest, DoesNotDependOnWhichSideIsOutside) {
  MeshData data = zoo::torus(24, 18);
  const Mesh before(data);
  for (std::size_t i = 0; i < data.faces.vertices.size(); i += 3)
    std::swap(data.faces.vertices[i], data.faces.vertices[i + 1]);
  const Mesh after(data);
  const auto expected = vertex_curvatures(before), found = vertex_curvatures(after);
  for (const Vertex v : before.vertices()) EXPECT_NEAR(found[v], expected[v], 1e-12);
}

//  0---+---1    a face without area on a side of another, also with two corners at one place
TEST(CurvatureTest, FacesWithoutAreaDoNotCount) {
  for (const double along : {0.5, 0.0}) {
    MeshData data = zoo::torus(24, 18);
    const Mesh before(data);
    const auto between = static_cast<std::uint32_t>(data.positions.size());
    data.positions.push_back(glm::mix(data.positions[0], data.positions[1], along));
    data.faces.add(Shape::Triangle, {0, between, 1});
    const Mesh after(data);
    const auto expected = vertex_curvatures(before, 0), found = vertex_curvatures(after, 0);
    EXPECT_EQ(found[Vertex(between)], 0);
    for (const Vertex v : before.vertices()) EXPECT_EQ(found[v], expected[v]) << v.index;
  }
}

TEST(CurvatureTest, IsFiniteWhateverTheFaces) {
  for (const zoo::Animal& animal : zoo::all()) {
    const Mesh mesh(animal.data);
    const auto curvature = vertex_curvatures(mesh);
    for (const Vertex v : mesh.vertices()) EXPECT_TRUE(std::isfinite(curvature[v])) << animal.name;
  }
}

TEST(CurvatureTest, OfAVolumeIsThatOfItsModelFaces) {
  Mesh mesh(make_sample("tet-ball", 8));
  const auto curvature = vertex_curvatures(mesh);
  const auto inside = [&](Vertex v) { return mesh.classification(v).dimension() == 3; };
  EXPECT_EQ(range_of(mesh, curvature, inside).high, 0);
  const Range surface = range_of(mesh, curvature, [&](Vertex v) { return !inside(v); });
  ASSERT_GT(surface.count, 100u);
  mesh.set(3, 2);
  const auto complete = vertex_curvatures(mesh);
  for (const Vertex v : mesh.vertices())
    EXPECT_EQ(complete[v], curvature[v]) << "faces inside do not count";
}

}  // namespace
}  // namespace aomd::curvature_test
