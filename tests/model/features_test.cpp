#include "core/model/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/io/io.h"
#include "core/mesh/mesh.h"
#include "core/model/classify.h"
#include "tests/support/feature_shapes.h"
#include "tests/support/shape_builder.h"
#include "tests/support/zoo.h"

namespace aomd::features_test {
namespace {

using test::FeatureShape;

Mesh with_edges(const MeshData& data) {
  Mesh mesh(data);
  for (const auto& [i, j] : {std::pair{2, 1}, {1, 2}, {0, 1}}) mesh.set(i, j);
  return mesh;
}

// Edges of two faces that are features: by the faces of the smooth shape, or by the angle alone.
struct Features {
  std::vector<bool> known, found;
  FeatureCount count;
};

Features features_of(const MeshData& data, double angle_deg = 20) {
  const Mesh mesh = with_edges(data);
  Column<Edge, std::uint8_t> known, found;
  find_features(mesh, {std::nullopt, true, false}, known);
  Features all;
  all.count = find_features(mesh, {angle_deg, true, true}, found);
  for (const Edge e : mesh.edges()) {
    if (mesh.row<2>(e).size() != 2) continue;
    all.known.push_back(known[e]);
    all.found.push_back(found[e]);
  }
  return all;
}

struct Score {
  double known = 0, found = 0, right = 0;

  void add(const Features& f) {
    for (std::size_t i = 0; i < f.known.size(); ++i)
      known += f.known[i], found += f.found[i], right += f.known[i] && f.found[i];
  }
  [[nodiscard]] double recall() const { return known > 0 ? right / known : 1; }
  [[nodiscard]] double precision() const { return found > 0 ? right / found : 1; }
};

std::uint32_t sharp_in(const MeshData& data) { return features_of(data).count.sharp; }

TEST(Features, OfShapesInFewFacesAreThoseOfTheSmoothShapes) {
  Score all;
  const std::vector<FeatureShape> shapes = test::feature_shapes();
  ASSERT_GE(shapes.size(), 40u);
  for (const FeatureShape& shape : shapes) {
    Score one;
    one.add(features_of(shape.data));
    all.add(features_of(shape.data));
    EXPECT_GE(one.recall(), 0.98) << shape.name;
    EXPECT_GE(one.precision(), 0.98) << shape.name;
  }
  EXPECT_GE(all.recall(), 0.98);
  EXPECT_GE(all.precision(), 0.98);
}

TEST(Features, DoNotDependOnWhereAndHowLargeAShapeIs) {
  const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, -0.7)),
                   y = glm::normalize(glm::cross(x, {0.3, -1, 0.4})), z = glm::cross(x, y);
  for (const FeatureShape& shape : test::feature_shapes())
    for (const double scale : {1e-9, 1.0, 3e8}) {
      const auto there = [&](glm::dvec3 p) { return scale * (p.x * x + p.y * y + p.z * z + x); };
      EXPECT_EQ(features_of(test::moved(shape.data, there)).found, features_of(shape.data).found)
          << shape.name << ' ' << scale;
    }
}

TEST(Features, DoNotDependOnWhichSideFacesLookTo) {
  for (const FeatureShape& shape : test::feature_shapes()) {
    MeshData turned = shape.data;
    for (std::size_t f = 0; f < turned.faces.size(); ++f)
      std::swap(turned.faces.vertices[3 * f], turned.faces.vertices[3 * f + 1]);
    Score score;
    score.add(features_of(turned));
    EXPECT_GE(std::min(score.recall(), score.precision()), 0.98) << shape.name;
  }
}

TEST(Features, AreNoneWhereNeighboursLookToOppositeSides) {
  MeshData data = zoo::grid(12);
  for (std::size_t f = 0; f < data.faces.size() / 2; ++f)
    std::swap(data.faces.vertices[3 * f], data.faces.vertices[3 * f + 1]);
  const FeatureCount count = features_of(data).count;
  EXPECT_EQ(count.sharp, 0u);
  EXPECT_EQ(count.rough, 0u);
  EXPECT_EQ(count.steps, 0u);
}

// A ridge in the middle of a sheet, of so many edges, which are the only ones past 70 degrees.
MeshData with_ridge(std::uint32_t edges) {
  MeshData data = zoo::grid(20);
  for (std::uint32_t i = 0; i <= edges; ++i) data.positions[10 * 21 + 6 + i].z = 1;
  return data;
}

TEST(Features, AnOpenCurveHasEightEdgesOrMore) {
  const FeatureCount eight = features_of(with_ridge(8), 70).count;
  EXPECT_EQ(eight.sharp, 8u);
  EXPECT_EQ(eight.rough, 0u);
  const FeatureCount seven = features_of(with_ridge(7), 70).count;
  EXPECT_EQ(seven.sharp, 0u);
  EXPECT_EQ(seven.rough, 7u);
}

TEST(Features, OfASphereInFacetsAreNone) {
  const FeatureCount count = features_of(test::sphere(12, 6)).count;
  EXPECT_EQ(count.sharp, 0u);
  EXPECT_EQ(count.rough, 0u);
  EXPECT_EQ(count.steps, 108u);
}

TEST(Features, OfABoxAreItsTwelveEdges) {
  EXPECT_EQ(sharp_in(test::cells({{0, 0, 0}}, {3, 2, 1})), 12u);
}

TEST(Features, OfACylinderAreItsRims) {
  for (const int sides : {8, 12, 16, 24})
    EXPECT_EQ(sharp_in(test::cylinder(sides, 2, 1, false)), 2u * static_cast<unsigned>(sides));
}

// Fewer than eight sides are no cylinder.
TEST(Features, OfAPrismAreAllItsEdges) {
  for (const int sides : {3, 4, 5, 6, 7})
    EXPECT_EQ(sharp_in(test::cylinder(sides, 2, 1, true)), 3u * static_cast<unsigned>(sides));
}

// A wall round a rectangle of 3 by 2 with rounded corners of four facets each, its plane sides in
// so many pieces.
MeshData wall(int pieces) {
  test::Profile around;
  const glm::dvec2 middles[] = {{1.3, 0.8}, {-1.3, 0.8}, {-1.3, -0.8}, {1.3, -0.8}};
  for (int k = 0; k < 4; ++k) {
    const test::Profile round = test::arc(middles[k].x, middles[k].y, 0.2, 90 * k, 90 * k + 90, 4);
    const glm::dvec2 from = around.empty() ? round.front() : around.back();
    for (int i = 1; i < pieces && k > 0; ++i)
      around.push_back(from + i / static_cast<double>(pieces) * (round.front() - from));
    around.insert(around.end(), round.begin(), round.end());
  }
  return test::extruded(around, {0, 0}, 1, std::vector<int>(around.size(), 10), 12);
}

// On a mesh that is cut finely all over, the steps of a small round are curves like others: they
// cost little there, and hold what would be lost without them.
TEST(Features, OfAFineMeshAreTheStepsOfItsSmallRounds) {
  EXPECT_EQ(features_of(wall(1)).count.steps, 4u * 3 * 12);
  EXPECT_EQ(features_of(wall(40)).count.steps, 0u);
}

// A sheet of 24 by 6 squares, bent down along its middle line; height(x, y) for x >= 0.
template <typename Height>
MeshData bent_sheet(const Height& height) {
  test::Builder b;
  for (int y = 0; y <= 24; ++y)
    for (int x = -3; x <= 3; ++x) b.point({x, y, -height(std::abs(x), y)});
  for (std::uint32_t y = 0; y < 24; ++y)
    for (std::uint32_t x = 0; x < 6; ++x) {
      const std::uint32_t v = 7 * y + x;
      b.quad(v, v + 1, v + 8, v + 7, 1);
    }
  return b.data;
}

// On a stretch of its way the surface beside a crease turns so much that the crease looks like a
// step there.
TEST(Features, ACreaseIsCarriedOnOverWhatLooksLikeSteps) {
  const double slope[] = {std::tan(M_PI / 12), std::tan(M_PI / 5.3)};
  const FeatureCount count =
      features_of(bent_sheet([&](int x, int y) {
        const bool round = y >= 10 && y <= 14;
        return slope[0] * std::min(x, 1) + slope[round ? 1 : 0] * std::max(x - 1, 0);
      })).count;
  EXPECT_EQ(count.sharp, 24u);
  EXPECT_EQ(count.steps, 0u);
}

// A tube of twelve sides, open at both ends. On its first half one side is drawn out to a corner
// that fades into the round: an open chain, but a feature.
TEST(Features, ACornerThatFadesIntoARoundIsKept) {
  test::Builder b;
  std::vector<test::Indices> loops;
  for (int k = 0; k <= 12; ++k) {
    test::Loop loop = test::circle(12, 1, 0.5 * k);
    loop[0].x += 0.41 * std::max(0.0, 1 - k / 6.0);
    loops.push_back(b.points(loop));
  }
  for (std::size_t k = 0; k < 12; ++k)
    b.band(loops[k], loops[k + 1], [](std::size_t) { return 1; });
  const FeatureCount count = features_of(b.data).count;
  EXPECT_EQ(count.sharp, 5u);
  EXPECT_EQ(count.rough, 0u);
}

TEST(Features, StepsAreNoModelEdges) {
  Mesh mesh(test::together({test::sphere(12, 6), test::sphere(10, 8)}));
  const ClassifyResult r = classify(mesh, {.keep_present = false});
  EXPECT_EQ(r.model_vertices, 0);
  EXPECT_EQ(r.model_edges, 0);
  EXPECT_EQ(r.model_faces, 2);
}

TEST(Features, AtAnyAngleOfASphereAreNone) {
  for (const double angle : {5.0, 10.0, 15.0, 30.0})
    EXPECT_EQ(features_of(test::sphere(16, 8), angle).count.sharp, 0u) << angle;
}

// What parts from elsewhere keep: sharp edges that are features, roughness, steps.
TEST(Features, OfPartsFromElsewhere) {
  const std::filesystem::path folder = AOMD_SHARED_DATA;
  if (!exists(folder)) GTEST_SKIP() << "no shared data";
  const auto check = [&](const char* file, std::uint32_t sharp, std::uint32_t steps) {
    MeshData data = io::read(folder / file).mesh;
    const FeatureCount count = features_of(data).count;
    EXPECT_EQ(count.sharp, sharp) << file;
    EXPECT_EQ(count.steps, steps) << file;
  };
  check("fandisk.off", 876, 0);
  check("featuretype.stl", 1435, 0);
  check("fixed_top.ply", 2366, 0);
  check("tray_bottom.stl", 1900, 0);
  check("turbine.off", 1588, 0);
  check("bunny.ply", 0, 0);
}

// A frame meshed from its CAD model, of which 4,766 edges past 20 degrees lie between two faces:
// all of these that are corners are found, rims of coarse holes among them.
TEST(Features, OfAFrameAreTheEdgesOfItsModel) {
  const std::filesystem::path file = std::filesystem::path(AOMD_SHARED_DATA) / "frame_cad_v41.msh";
  if (!exists(file)) GTEST_SKIP() << "no shared data";
  Mesh mesh(io::read(file).mesh);
  const FeatureCount count = classify(mesh, {.keep_present = false}).features;
  EXPECT_EQ(count.sharp, 4848u);
  EXPECT_EQ(count.rough, 325u);
  EXPECT_EQ(count.steps, 1414u);
}

}  // namespace
}  // namespace aomd::features_test
