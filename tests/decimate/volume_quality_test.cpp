// The quality strategy among tetrahedra: nothing but shape and number of them changes, regions keep
// their volumes, whatever holds the faces and edges inside.

#include <gtest/gtest.h>

#include <cmath>

#include "core/decimate/decimation.h"
#include "core/measure/intersections.h"
#include "core/mesh/geometry.h"
#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "core/model/analytic_model.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::volume_quality_test {
namespace {

using namespace test;

DecimationOptions quality(const Mesh& mesh, double share, double regularity = 0.5) {
  DecimationOptions options;
  options.strategy = Strategy::Quality;
  options.angle_deg = usual_angle_deg(Strategy::Quality, false);
  options.target_faces = static_cast<std::uint32_t>(share * mesh.count(3));
  options.regularity = regularity;
  return options;
}

double mean_shape(const Mesh& mesh) {
  double sum = 0;
  for (const Region r : mesh.regions()) sum += tet_shape(mesh, r);
  return sum / mesh.count(3);
}

// How far vertices of the ball's surface are from its sphere, root mean square.
double off_the_sphere(const Mesh& mesh) {
  double sum = 0;
  int count = 0;
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 middle =
        (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3.0;
    if (glm::length(middle) > 0.8) continue;  // on the box
    const double off = glm::length(middle) - 0.45;
    sum += off * off;
    ++count;
  }
  return std::sqrt(sum / count);
}

// Two blocks with a wavy interface, in the middle of which a lens of a third material lies.
MeshData lens_between_blocks(int n, double thickness) {
  MeshData data = zoo::tet_grid({n, n, 5}, [n](const zoo::Cell& c) {
    const bool inner = 2 <= c.x && c.x < n - 2 && 2 <= c.y && c.y < n - 2;
    return c.z == 2 && inner ? 3 : c.z <= 2 ? 1 : 2;
  });
  for (glm::dvec3& p : data.positions) {
    const double z = p.z < 3 ? p.z - 2 : p.z - 3 + thickness;
    p.z = z + 0.5 * std::sin(0.9 * p.x) * std::sin(0.9 * p.y);
  }
  return data;
}

double smallest_angle_of_faces(const Mesh& mesh) {
  double least = 180;
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() != 2) continue;
    const auto t = mesh.triangle(f);
    least = std::min(
        least, smallest_angle_deg(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
  }
  return least;
}

MeshData scaled(MeshData data, double factor) {
  for (glm::dvec3& p : data.positions) p *= factor;
  return data;
}

MeshData to_quarter(const MeshData& data) {
  VolumeBench b(data, Levels::Listed);
  Decimation(b.mesh, quality(b.mesh, 0.25)).run();
  return to_data(b.mesh);
}

struct Sample {
  const char* name;
  int size;
};

class VolumeQuality : public testing::TestWithParam<Sample> {};

TEST_P(VolumeQuality, ReachesTheTargetAndKeepsTheModel) {
  VolumeBench b(make_sample(GetParam().name, GetParam().size), Levels::Listed);
  const VolumeOracle before = volume_oracle(to_data(b.mesh));
  const DecimationOptions options = quality(b.mesh, 0.25);
  Decimation decimation(b.mesh, options);
  std::uint32_t steps = 0;
  while (decimation.step())
    if (++steps % 100 == 0) {
      ASSERT_EQ(b.finding(), "") << steps;
      expect_kept(before, volume_oracle(to_data(b.mesh)), 0.05);
    }
  EXPECT_EQ(b.finding(), "");
  EXPECT_LE(b.mesh.count(3), options.target_faces);
  EXPECT_GE(b.mesh.count(3), 0.99 * options.target_faces);
  expect_kept(before, volume_oracle(to_data(b.mesh)), 1e-9);
}

TEST_P(VolumeQuality, IsTheSameWhateverHoldsTheInsideAndOnThreads) {
  const MeshData data = make_sample(GetParam().name, GetParam().size);
  VolumeBench listed(data, Levels::Listed), complete(data, Levels::Complete),
      shared(data, Levels::Listed);
  DecimationOptions options = quality(listed.mesh, 0.3);
  Decimation(listed.mesh, options).run();
  Decimation(complete.mesh, options).run();
  EXPECT_EQ(complete.finding(), "");
  const MeshData result = to_data(listed.mesh);
  EXPECT_EQ(result, to_data(complete.mesh));
  options.threads = 2;
  Decimation(shared.mesh, options).run();
  EXPECT_EQ(result, to_data(shared.mesh));
}

TEST_P(VolumeQuality, IsUndone) {
  VolumeBench b(make_sample(GetParam().name, GetParam().size), Levels::Listed);
  Journal journal;
  b.mesh.attach(&journal);
  const std::string start = zoo::fingerprint(b.mesh);
  Decimation(b.mesh, quality(b.mesh, 0.3)).run();
  const std::string end = zoo::fingerprint(b.mesh);
  journal.seek(b.mesh, 0);
  EXPECT_EQ(zoo::fingerprint(b.mesh), start);
  journal.seek(b.mesh, journal.size());
  EXPECT_EQ(zoo::fingerprint(b.mesh), end);
  b.mesh.attach(nullptr);
}

INSTANTIATE_TEST_SUITE_P(Samples, VolumeQuality,
                         testing::Values(Sample{"ball-in-box", 2}, Sample{"tet-bracket", 4},
                                         Sample{"layered-beam", 2}),
                         [](const auto& sample) {
                           std::string name = sample.param.name;
                           std::erase(name, '-');
                           return name;
                         });

TEST(VolumeQualityTest, FlatFacesStayFlatAndStraightEdgesStraight) {
  VolumeBench b(make_sample("layered-beam"), Levels::Listed);
  Box box;
  for (const Vertex v : b.mesh.vertices()) box.add(b.mesh.position(v));
  Decimation(b.mesh, quality(b.mesh, 0.1)).run();
  for (const Face f : b.mesh.faces())
    for (const Vertex v : b.mesh.triangle(f)) {
      const glm::dvec3 p = b.mesh.position(v);
      double off = 1;
      for (int k = 0; k < 3; ++k)
        off = std::min({off, std::abs(p[k] - box.low[k]), std::abs(p[k] - box.high[k])});
      const bool on_skin = off < 1e-3;
      EXPECT_TRUE(!on_skin || off < 1e-12) << off;
    }
}

TEST(VolumeQualityTest, RegularityTradesClosenessForShape) {
  double shape = 0, off = 0;
  for (const double regularity : {0.0, 0.5, 1.0}) {
    VolumeBench b(make_sample("ball-in-box"), Levels::Listed);
    Decimation(b.mesh, quality(b.mesh, 0.2, regularity)).run();
    const double present_shape = mean_shape(b.mesh), present_off = off_the_sphere(b.mesh);
    EXPECT_GT(present_shape, shape) << regularity;
    EXPECT_GT(present_off, off) << regularity;
    shape = present_shape, off = present_off;
  }
}

TEST(VolumeQualityTest, WithAModelAllThatLiesOnItStaysOnIt) {
  const AnalyticModel sphere = sphere_model(1);
  for (const double regularity : {0.0, 0.5, 1.0}) {
    VolumeBench b(make_sample("tet-ball", 6), Levels::Listed, smooth_skin);
    for (const Vertex v : b.mesh.vertices())
      if (b.mesh.classification(v).dimension() == 2) snap(sphere, b.mesh, v);
    DecimationOptions options = quality(b.mesh, 0.3, regularity);
    options.model = &sphere;
    std::uint32_t moves = 0;
    Decimation decimation(b.mesh, options);
    while (const auto step = decimation.step()) moves += step->kind == StepKind::Smooth;
    EXPECT_EQ(b.finding(), "");
    EXPECT_GT(moves, 100u);
    EXPECT_LE(b.mesh.count(3), options.target_faces);
    for (const Vertex v : b.mesh.vertices()) {
      if (b.mesh.classification(v).dimension() != 2) continue;
      ASSERT_NEAR(glm::length(b.mesh.position(v)), 1, 1e-12);
    }
  }
}

// Four layers around a cylinder of radius 10.
MeshData bent_plate() {
  MeshData data = zoo::tet_grid({24, 12, 4}, [](const zoo::Cell&) { return 1; });
  for (glm::dvec3& p : data.positions) {
    const double angle = 0.1 * p.x, radius = 10 + p.z;
    p = {radius * std::sin(angle), p.y, radius * std::cos(angle)};
  }
  return data;
}

double off_the_cylinder(const Mesh& mesh, Vertex v) {
  return std::abs(std::hypot(mesh.position(v).x, mesh.position(v).z) - 10);
}

// How far the vertices of a model face are from the cylinder at most.
double off_the_cylinder(const Mesh& mesh, ModelRef inner) {
  double most = 0;
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v) == inner) most = std::max(most, off_the_cylinder(mesh, v));
  return most;
}

ModelRef inner_side(const Mesh& mesh) {
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 2 && off_the_cylinder(mesh, v) < 1e-9)
      return mesh.classification(v);
  return {};
}

// Collapses that cost the surface much wait until improvement helps no others, and where closeness
// comes first, moves hold on to it: a target that needs many tetrahedra from inside does not ruin
// the surface before any of them has been improved.
TEST(VolumeQualityTest, DearCollapsesWaitForImprovement) {
  for (const double share : {0.25, 0.1}) {
    VolumeBench b(bent_plate(), Levels::Listed);
    const ModelRef inner = inner_side(b.mesh);
    ASSERT_EQ(inner.dimension(), 2);
    const DecimationOptions options = quality(b.mesh, share, 0);
    Decimation(b.mesh, options).run();
    EXPECT_LE(b.mesh.count(3), options.target_faces);
    EXPECT_LT(off_the_cylinder(b.mesh, inner), 5e-4) << share;
  }
}

// Two wavy sheets, one above the other, with next to nothing between them.
MeshData narrow_gap() {
  MeshData data = zoo::tet_grid({16, 16, 5}, [](const zoo::Cell& c) { return c.z == 2 ? 0 : 1; });
  for (glm::dvec3& p : data.positions)
    p.z = 0.3 * (p.z < 3 ? p.z : p.z - 0.9) + std::sin(0.45 * p.x) * std::sin(0.45 * p.y);
  return data;
}

// As on surfaces: what is close may cut each other, unless that is ruled out.
TEST(VolumeQualityTest, ANarrowGapStaysOpenWhereThatIsAskedFor) {
  VolumeBench free(narrow_gap(), Levels::Listed), guarded(narrow_gap(), Levels::Listed);
  ASSERT_EQ(measure::count_self_intersections(free.mesh, 1).pairs, 0u);
  DecimationOptions options = quality(free.mesh, 0.1);
  Decimation(free.mesh, options).run();
  options.no_intersections = true;
  Decimation(guarded.mesh, options).run();
  EXPECT_GT(measure::count_self_intersections(free.mesh, 1).pairs, 0u);
  EXPECT_EQ(measure::count_self_intersections(guarded.mesh, 1).pairs, 0u);
}

TEST(VolumeQualityTest, ThinRegionsKeepTheirVolumes) {
  for (const double thickness : {0.03, 0.1})
    for (const double share : {0.5, 0.2}) {
      VolumeBench b(lens_between_blocks(12, thickness), Levels::Listed);
      const std::uint32_t start = b.mesh.count(3);
      const VolumeOracle before = volume_oracle(to_data(b.mesh));
      Decimation(b.mesh, quality(b.mesh, share)).run();
      EXPECT_EQ(b.finding(), "");
      EXPECT_LT(b.mesh.count(3), 0.7 * start) << thickness;
      expect_kept(before, volume_oracle(to_data(b.mesh)), 1e-3);
    }
}

TEST(VolumeQualityTest, IsTheSameAtEveryScale) {
  for (const char* sample : {"ball-in-box", "tet-bracket"}) {
    const MeshData data = make_sample(sample, 2), usual = to_quarter(data);
    for (const double factor : {0x1p-62, 0x1p-44, 0x1p-20, 0x1p40, 0x1p54})
      EXPECT_EQ(scaled(to_quarter(scaled(data, factor)), 1 / factor), usual) << factor;
  }
}

TEST(VolumeQualityTest, NoFaceGetsAnAngleBelowTheLeast) {
  for (const Strategy strategy : {Strategy::Quality, Strategy::Paper}) {
    VolumeBench b(make_sample("ball-in-box", 3),
                  strategy == Strategy::Paper ? Levels::Complete : Levels::Listed);
    DecimationOptions options = quality(b.mesh, 0.1);
    options.strategy = strategy;
    options.min_angle_deg = 30;
    EXPECT_GT(smallest_angle_of_faces(b.mesh), 30);
    Decimation decimation(b.mesh, options);
    decimation.run();
    EXPECT_GT(decimation.sweeps().front().collapses, 100);
    EXPECT_GE(smallest_angle_of_faces(b.mesh), 30 - 1e-9);
  }
}

// The smallest dihedral angle that is left of a sample with a limit; a target so far that all other
// floors are lowered on the way to it.
double smallest_dihedral_of(const MeshData& data, Strategy strategy, double least_deg) {
  VolumeBench b(data, strategy == Strategy::Paper ? Levels::Complete : Levels::Listed);
  const std::uint32_t before = b.mesh.count(3);
  DecimationOptions options = quality(b.mesh, 0.01);
  options.strategy = strategy;
  options.min_dihedral_deg = least_deg;
  Decimation(b.mesh, options).run();
  EXPECT_EQ(b.finding(), "");
  EXPECT_LT(b.mesh.count(3), 0.5 * before);
  return smallest_dihedral(b.mesh);
}

TEST(VolumeQualityTest, NoTetrahedronGetsADihedralAngleBelowTheLeast) {
  for (const char* sample : {"ball-in-box", "layered-beam"})
    for (const Strategy strategy : {Strategy::Quality, Strategy::Paper}) {
      const MeshData data = make_sample(sample, 3);
      const double start = smallest_dihedral(Mesh(data)),
                   free = smallest_dihedral_of(data, strategy, 0), least = 0.5 * (free + start);
      ASSERT_LT(free, start - 5) << sample;
      EXPECT_GE(smallest_dihedral_of(data, strategy, least), least - 1e-9) << sample;
    }
}

TEST(VolumeQualityTest, KeptVerticesAndOtherShapesStay) {
  VolumeBench b(make_sample("tet-bracket"), Levels::Listed);
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(b.mesh.capacity(0), std::uint8_t{0});
  std::vector<std::pair<Vertex, glm::dvec3>> kept;
  for (const Vertex v : b.mesh.vertices())
    if (v.index % 7 == 0) {
      (*keep)[v] = 1;
      kept.emplace_back(v, b.mesh.position(v));
    }
  DecimationOptions options = quality(b.mesh, 0.3);
  options.keep = keep;
  Decimation(b.mesh, options).run();
  for (const auto& [v, position] : kept) {
    ASSERT_TRUE(b.mesh.alive(v));
    EXPECT_EQ(b.mesh.position(v), position);
  }
  VolumeBench mixed(zoo::hybrid(), Levels::Complete);
  const MeshData start = to_data(mixed.mesh);
  Decimation decimation(mixed.mesh, quality(mixed.mesh, 0.5));
  decimation.run();
  EXPECT_EQ(to_data(mixed.mesh).regions, start.regions);
  EXPECT_GT(decimation.edges_left()[static_cast<std::size_t>(Reason::Kept)], 0);
}

}  // namespace
}  // namespace aomd::volume_quality_test
