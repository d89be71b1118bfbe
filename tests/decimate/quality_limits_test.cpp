// What holds after each operation of the quality strategy: kept vertices, least angles, how far a
// face may turn.

#include <gtest/gtest.h>

#include <memory>

#include "core/decimate/decimation.h"
#include "core/mesh/geometry.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::quality_limits_test {
namespace {

using test::classified;
using test::finding;
using test::quality;

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

TEST(QualityLimitsTest, NoEdgeBetweenSealedVerticesIsNew) {
  EXPECT_GT(new_edges_between_kept(false), 10u);
  EXPECT_EQ(new_edges_between_kept(true), 0u);
}

TEST(QualityLimitsTest, KeptVerticesStayWhereTheyAre) {
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
TEST(QualityLimitsTest, TheLeastAngleHolds) {
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
TEST(QualityLimitsTest, NoOperationMakesAnAngleBelowTheLeast) {
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
TEST(QualityLimitsTest, NoOperationTurnsAFaceByMoreThanTheAngle) {
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

// Where all else has become dear, faces look away from the original, which a bracket without model
// edges cannot do without; where no number is wanted they do not.
TEST(QualityLimitsTest, FacingYieldsToATarget) {
  MeshData data = make_sample("bracket", 5);
  data.vertex_classes.clear(), data.faces.classes.clear(), data.edges = {};
  const auto faces_left = [&](std::uint32_t target, std::uint32_t without) {
    Mesh mesh(data);
    classify(mesh, {.feature_angle_deg = {}});
    DecimationOptions options = quality(target);
    options.without = without;
    Decimation(mesh, options).run();
    EXPECT_EQ(finding(mesh), "");
    return mesh.count(2);
  };
  const std::uint32_t no_facing = 1u << static_cast<int>(Idea::Facing);
  EXPECT_LE(faces_left(54, 0), 54u);
  EXPECT_GT(faces_left(0, 0), 60u);
  EXPECT_LT(faces_left(0, no_facing), 60u);
}

// Stretched forty times, nearly every triangle is narrower than the strategy's own least angle,
// which must not stand in the way; the user's must.
TEST(QualityLimitsTest, AMeshOfSliversReachesItsTarget) {
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

}  // namespace
}  // namespace aomd::quality_limits_test
