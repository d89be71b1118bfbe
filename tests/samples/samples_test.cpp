#include "core/samples/samples.h"

#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/samples/numeric.h"
#include "tests/support/surface_facts.h"

namespace aomd::samples_test {
namespace {

using test::facts_of;
using test::samples_of;
using test::SurfaceFacts;
using test::tags_of;

constexpr const char* closed[] = {"scan", "bracket", "box", "cylinder", "sphere", "globe", "torus"};

TEST(Samples, ScanComesFirst) { EXPECT_EQ(samples().front().name, "scan"); }

TEST(Samples, NamesAreUniqueAndAllWork) {
  std::set<std::string_view> names;
  for (const SampleInfo& info : samples()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.description.empty());
    EXPECT_FALSE(make_sample(info.name).faces.empty()) << info.name;
  }
}

TEST(Samples, UnknownNameListsTheKnownOnes) {
  try {
    (void)make_sample("cow");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("bracket"), std::string::npos);
  }
}

TEST(Samples, SizesHaveBounds) {
  for (const SampleInfo& info : samples()) {
    EXPECT_THROW((void)make_sample(info.name, -1), std::invalid_argument) << info.name;
    EXPECT_THROW((void)make_sample(info.name, 2'000'000'000), std::invalid_argument) << info.name;
  }
}

TEST(Samples, TheSameEveryTime) {
  for (const SampleInfo& info : samples())
    EXPECT_EQ(make_sample(info.name), make_sample(info.name));
}

/// Fails when another machine, compiler or edit makes other bits of a sample's coordinates.
std::uint64_t fingerprint(const MeshData& mesh) {
  std::uint64_t h = 14695981039346656037u;
  const auto mix = [&](std::uint64_t x) { h = (h ^ x) * 1099511628211u; };
  for (const glm::dvec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) mix(std::bit_cast<std::uint64_t>(p[axis]));
  }
  for (const std::uint32_t v : mesh.faces.vertices) mix(v);
  return h;
}

TEST(Samples, FacesHaveDistinctVerticesAndArea) {
  for (const SampleInfo& info : samples_of(2)) {
    for (const int size : {info.default_size, info.default_size / 2}) {
      const MeshData mesh = make_sample(info.name, size);
      const SurfaceFacts facts = facts_of(mesh);
      EXPECT_GT(facts.least_area, 0) << info.name;
      EXPECT_GT(facts.worst_angle, 8) << info.name << ' ' << size;
      EXPECT_EQ(facts.unused, 0u) << info.name;
    }
  }
}

TEST(Samples, ClosedOnesAreClosedAndLookOutward) {
  const std::map<std::string, long> euler{{"torus", 0}, {"bracket", 2 - 2 * 3}};
  for (const std::string name : closed) {
    for (const int size : {0, name == "scan" ? 500 : 3}) {
      const SurfaceFacts facts = facts_of(make_sample(name, size));
      EXPECT_EQ(facts.boundary, 0u) << name;
      EXPECT_EQ(facts.nonmanifold, 0u) << name;
      EXPECT_EQ(facts.misoriented, 0u) << name;
      EXPECT_EQ(facts.euler, euler.count(name) ? euler.at(name) : 2) << name;
      EXPECT_GT(facts.volume, 0) << name;
    }
  }
}

TEST(Samples, ScanHasAboutTheFacesAskedFor) {
  for (const int size : {1000, 70'000, 200'000}) {
    EXPECT_NEAR(static_cast<double>(make_sample("scan", size).faces.size()), size, 0.15 * size);
  }
}

/// Every direction from the centre meets the scan once, so that it cannot cross itself.
TEST(Samples, ScanIsStarShaped) {
  const MeshData mesh = make_sample("scan");
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t* v = &mesh.faces.vertices[3 * f];
    const glm::dvec3 &a = mesh.positions[v[0]], &b = mesh.positions[v[1]],
                     &c = mesh.positions[v[2]];
    ASSERT_GT(glm::dot(a, glm::cross(b, c)), 0) << f;
  }
}

TEST(Samples, ScanNeighboursAreNearInMemory) {
  const MeshData mesh = make_sample("scan");
  double sum = 0;
  for (std::size_t i = 1; i < mesh.positions.size(); ++i)
    sum += glm::distance(mesh.positions[i], mesh.positions[i - 1]);
  EXPECT_LT(sum / static_cast<double>(mesh.positions.size()), 3);  // the creature is about 180 long
}

TEST(Samples, AnalyticSizes) {
  EXPECT_NEAR(facts_of(make_sample("box")).volume, 1, 1e-12);
  EXPECT_NEAR(facts_of(make_sample("sphere", 40)).volume, 4.18879, 0.01);
  EXPECT_NEAR(facts_of(make_sample("cylinder", 40)).volume, 2 * 3.14159, 0.01);
  EXPECT_NEAR(facts_of(make_sample("torus", 200)).volume, 2 * 9.8696 * 0.16, 0.01);
  // Plates 4 x 4 x 1 and a quarter of a tube of radii 1 and 2, less three bores; 10 mm a unit.
  const double pi = 3.14159265;
  const double bracket = 2 * 16 + pi / 4 * (4 - 1) * 4 - pi * (2 * 0.25 + 0.65 * 0.65);
  EXPECT_NEAR(facts_of(make_sample("bracket", 20)).volume / 1000, bracket, 0.01);
}

struct ModelCounts {
  const char* name;
  std::size_t vertices, edges, faces;
};

TEST(Samples, ModelsAreAsAModellerWouldCount) {
  // Bracket: 3 + 3 sheet faces, 2 long and 2 short sides, 3 bores; the bores' six rims are closed
  // edges.
  constexpr ModelCounts expected[] = {{"box", 8, 12, 6},
                                      {"plane-hole", 4, 5, 1},
                                      {"cylinder", 0, 2, 3},
                                      {"bracket", 16, 30, 13},
                                      {"nonmanifold", 8, 10, 3}};
  for (const ModelCounts& e : expected) {
    for (const int size : {0, 4}) {
      const MeshData mesh = make_sample(e.name, size);
      EXPECT_EQ(tags_of(mesh.vertex_classes, 0).size(), e.vertices) << e.name;
      EXPECT_EQ(tags_of(mesh.edges.classes, 1).size(), e.edges) << e.name;
      EXPECT_EQ(tags_of(mesh.faces.classes, 2).size(), e.faces) << e.name;
    }
  }
}

TEST(Samples, ClassificationFollowsTheRule) {
  for (const SampleInfo& info : samples_of(2)) {
    const MeshData mesh = make_sample(info.name);
    if (!mesh.classified()) continue;
    ASSERT_EQ(mesh.vertex_classes.size(), mesh.positions.size());
    ASSERT_EQ(mesh.edges.classes.size(), mesh.edges.size());
    ASSERT_EQ(mesh.faces.classes.size(), mesh.faces.size());
    for (const ModelRef m : mesh.vertex_classes) EXPECT_TRUE(m.valid() && m.dimension() <= 2);
    for (const ModelRef m : mesh.edges.classes) EXPECT_EQ(m.dimension(), 1);
    for (const ModelRef m : mesh.faces.classes) EXPECT_EQ(m.dimension(), 2);
    // What bounds a mesh entity lies on the same model entity or on its boundary.
    for (std::size_t i = 0; i < mesh.edges.vertices.size(); ++i) {
      const ModelRef end = mesh.vertex_classes[mesh.edges.vertices[i]];
      EXPECT_TRUE(end.dimension() == 0 || end == mesh.edges.classes[i / 2]) << info.name;
    }
    for (std::size_t i = 0; i < mesh.faces.vertices.size(); ++i) {
      const ModelRef corner = mesh.vertex_classes[mesh.faces.vertices[i]];
      EXPECT_TRUE(corner.dimension() < 2 || corner == mesh.faces.classes[i / 3]) << info.name;
    }
  }
}

TEST(Samples, EveryBorderEdgeOfThePlaneLiesOnAModelEdge) {
  const MeshData mesh = make_sample("plane-hole");
  EXPECT_EQ(facts_of(mesh).boundary, mesh.edges.size());
  EXPECT_EQ(facts_of(mesh).euler, 0);
}

TEST(Samples, TheSpineOfTheSheetsHasThreeFaces) {
  const SurfaceFacts facts = facts_of(make_sample("nonmanifold", 5));
  EXPECT_EQ(facts.nonmanifold, 5u);
  EXPECT_EQ(facts.euler, 1);
}

TEST(Samples, CircleIsAsExactAsTheLibrary) {
  for (int i = -50; i <= 150; ++i) {
    const glm::dvec2 p = sample::on_circle(i / 100.0);
    EXPECT_NEAR(p.x, std::cos(2 * 3.141592653589793 * i / 100.0), 2e-15);
    EXPECT_NEAR(p.y, std::sin(2 * 3.141592653589793 * i / 100.0), 2e-15);
  }
  EXPECT_EQ(sample::on_circle(0.25), glm::dvec2(0, 1));
  EXPECT_EQ(sample::on_circle(0.5), glm::dvec2(-1, 0));
}

TEST(Samples, TheSameOnEveryMachine) {
  const std::map<std::string_view, std::uint64_t> expected{
      {"scan", 16792147642834461757u},        {"bracket", 15780117524985704113u},
      {"plane-hole", 8270656187475248607u},   {"box", 4425667355271453599u},
      {"cylinder", 13460761808539655071u},    {"sphere", 15350513252662970707u},
      {"torus", 8891201044047427698u},        {"terrain", 11692341552281899948u},
      {"nonmanifold", 11647533439574616473u}, {"globe", 3816375364312373397u}};
  for (const SampleInfo& info : samples_of(2))
    EXPECT_EQ(fingerprint(make_sample(info.name)), expected.at(info.name)) << info.name;
}

}  // namespace
}  // namespace aomd::samples_test
