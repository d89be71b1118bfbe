// Generated volumes: exact counts, volumes, Euler numbers, and a classification as from a modeller.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/measure/histogram.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/support/surface_facts.h"
#include "tests/support/volume_facts.h"

namespace aomd::volume_samples_test {
namespace {

using test::samples_of;
using test::tags_of;
using test::volume_facts_of;
using test::VolumeFacts;

TEST(VolumeSamples, AreEight) {
  std::set<std::string_view> names;
  for (const SampleInfo& info : samples_of(3)) names.insert(info.name);
  EXPECT_EQ(names,
            (std::set<std::string_view>{"ball-in-box", "hex-box", "layered-beam", "mixed",
                                        "tet-ball", "tet-box", "tet-bracket", "tet-drilled"}));
}

TEST(VolumeSamples, MatchFaceToFaceAndHavePositiveVolume) {
  for (const SampleInfo& info : samples_of(3))
    for (const int size : {0, 2, 3, 5}) {
      if (info.name == "ball-in-box" && size == 5) continue;  // 96,000 regions
      const VolumeFacts facts = volume_facts_of(make_sample(info.name, size));
      EXPECT_EQ(facts.unused, 0u) << info.name;
      EXPECT_EQ(facts.crowded, 0u) << info.name << ' ' << size << ": sides that three regions use";
      EXPECT_EQ(facts.misoriented, 0u) << info.name << ' ' << size;
      EXPECT_EQ(facts.folded, 0u) << info.name << ' ' << size;
      EXPECT_GT(facts.least_volume, 0) << info.name << ' ' << size;
    }
}

TEST(VolumeSamples, ListedFacesAreJustTheSidesOfModelRegions) {
  for (const SampleInfo& info : samples_of(3))
    for (const int size : {0, 3}) {
      const VolumeFacts facts = volume_facts_of(make_sample(info.name, size));
      EXPECT_EQ(facts.listed_outward, facts.boundary) << info.name;
      EXPECT_EQ(facts.listed_inside, facts.between) << info.name;
      EXPECT_EQ(facts.listed_wrong, 0u) << info.name;
    }
}

TEST(VolumeSamples, CountsOfTheBoxes) {
  for (const long n : {1l, 2l, 5l, 10l}) {
    const VolumeFacts tets = volume_facts_of(make_sample("tet-box", static_cast<int>(n)));
    EXPECT_EQ(tets.vertices, (n + 1) * (n + 1) * (n + 1));
    EXPECT_EQ(tets.edges, 7 * n * n * n + 9 * n * n + 3 * n);
    EXPECT_EQ(tets.faces, 12 * n * n * n + 6 * n * n);
    EXPECT_EQ(tets.regions, 6 * n * n * n);
    EXPECT_EQ(tets.boundary, static_cast<std::size_t>(12 * n * n));
    const VolumeFacts hexes = volume_facts_of(make_sample("hex-box", static_cast<int>(n)));
    EXPECT_EQ(hexes.vertices, (n + 1) * (n + 1) * (n + 1));
    EXPECT_EQ(hexes.edges, 3 * n * (n + 1) * (n + 1));
    EXPECT_EQ(hexes.faces, 3 * n * n * (n + 1));
    EXPECT_EQ(hexes.regions, n * n * n);
    EXPECT_EQ(hexes.boundary, static_cast<std::size_t>(6 * n * n));
  }
}

TEST(VolumeSamples, CountsOfTheOthers) {
  for (const long n : {2l, 3l, 6l}) {
    const MeshData mesh = make_sample("mixed", static_cast<int>(n));
    const auto count = [&](Shape s) {
      return std::count(mesh.regions.shapes.begin(), mesh.regions.shapes.end(), s);
    };
    EXPECT_EQ(count(Shape::Hexahedron), (n - 1) * n * n);
    EXPECT_EQ(count(Shape::Prism), 2 * n * n);
    EXPECT_EQ(count(Shape::Pyramid), (n - 1) * n);
    EXPECT_EQ(count(Shape::Tetrahedron), 10 * (n - 1) * n + 6 * n + 6 * n * n * (n - 1));
    EXPECT_EQ(volume_facts_of(mesh).between, static_cast<std::size_t>((n - 1) * n + 2 * n));
  }
  EXPECT_EQ(volume_facts_of(make_sample("tet-drilled", 8)).regions, 6 * 32 * 4 * 4);
  for (const long n : {1l, 2l, 6l}) {
    const VolumeFacts ball = volume_facts_of(make_sample("tet-ball", static_cast<int>(n)));
    EXPECT_EQ(ball.regions, 20 * n * n * n);
    EXPECT_EQ(ball.boundary, static_cast<std::size_t>(20 * n * n));
  }
  for (const long n : {1l, 2l, 3l}) {
    const MeshData mesh = make_sample("ball-in-box", static_cast<int>(n));
    const VolumeFacts box = volume_facts_of(mesh);
    const auto in_ball =
        std::count(mesh.regions.classes.begin(), mesh.regions.classes.end(), ModelRef(3, 1));
    EXPECT_EQ(box.regions, 12 * 64 * n * n * n);  // 12 a cell, and 4 n cells along a side
    EXPECT_EQ(in_ball, 24 * n * n * n);
    EXPECT_EQ(box.boundary, static_cast<std::size_t>(6 * 2 * 16 * n * n));
    EXPECT_EQ(box.between, static_cast<std::size_t>(24 * n * n));
    const VolumeFacts beam = volume_facts_of(make_sample("layered-beam", static_cast<int>(n)));
    EXPECT_EQ(beam.regions, 6 * 10 * 2 * 4 * n * n * n);
    EXPECT_EQ(beam.between, static_cast<std::size_t>(2 * 2 * 10 * 2 * n * n));
  }
}

TEST(VolumeSamples, EulerNumbers) {
  for (const SampleInfo& info : samples_of(3))
    for (const int size : {0, 4})
      EXPECT_EQ(volume_facts_of(make_sample(info.name, size)).euler,
                info.name == "tet-drilled" || info.name == "tet-bracket" ? 0 : 1)
          << info.name;
}

/// A prism of height 1 in a circle of radius 1/2, whose corners look at those of n cells along each
/// side of a square.
double bore(int n) {
  double polygon = 0;
  for (int j = 0; j < n; ++j) {
    const double angle = std::atan(-1 + 2.0 * (j + 1) / n) - std::atan(-1 + 2.0 * j / n);
    polygon += 4 * 0.5 * 0.25 * std::sin(angle);
  }
  return polygon;
}

TEST(VolumeSamples, Volumes) {
  EXPECT_NEAR(volume_facts_of(make_sample("tet-box", 7)).volume, 1, 1e-12);
  EXPECT_NEAR(volume_facts_of(make_sample("hex-box", 7)).volume, 1, 1e-12);
  const VolumeFacts mixed = volume_facts_of(make_sample("mixed", 5));
  EXPECT_NEAR(mixed.volume, 2, 1e-12);
  EXPECT_NEAR(mixed.volume_of.at(1), 1, 1e-12);
  EXPECT_NEAR(mixed.volume_of.at(2), 1, 1e-12);
  EXPECT_NEAR(volume_facts_of(make_sample("tet-ball", 9)).volume,
              test::facts_of(make_sample("sphere", 9)).volume, 1e-12);
  EXPECT_NEAR(volume_facts_of(make_sample("tet-drilled", 8)).volume, 4 - bore(8), 1e-12);
}

// An L of a base, 5 by 2, and an upright, 3 high; and layers of 1, 2 and 1 on 10 by 2.
TEST(VolumeSamples, VolumesOfTheParts) {
  for (const int n : {1, 3})
    EXPECT_NEAR(volume_facts_of(make_sample("tet-bracket", n)).volume, 16 - bore(2 * n), 1e-12);
  const VolumeFacts beam = volume_facts_of(make_sample("layered-beam", 2));
  EXPECT_NEAR(beam.volume_of.at(1), 20, 1e-12);
  EXPECT_NEAR(beam.volume_of.at(2), 40, 1e-12);
  EXPECT_NEAR(beam.volume_of.at(3), 20, 1e-12);
}

// What the interface encloses, and the rest of the box.
TEST(VolumeSamples, VolumesOfTheBallInTheBox) {
  double missing = 0;
  for (const int n : {2, 4}) {
    const MeshData mesh = make_sample("ball-in-box", n);
    double six = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (mesh.faces.classes[f] != ModelRef(2, 7)) continue;
      const std::uint32_t* v = &mesh.faces.vertices[3 * f];
      const auto& p = mesh.positions;
      six += glm::dot(p[v[0]], glm::cross(p[v[1]], p[v[2]]));
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(glm::length(p[v[k]]), 0.45, 1e-15);
    }
    const VolumeFacts facts = volume_facts_of(mesh);
    EXPECT_NEAR(facts.volume_of.at(1), six / 6, 1e-12);
    EXPECT_NEAR(facts.volume_of.at(2), 8 - six / 6, 1e-12);
    const double before = std::exchange(missing, 4 * std::acos(-1.0) / 3 * 0.091125 - six / 6);
    if (n == 2) continue;
    EXPECT_NEAR(before / missing, 4, 0.3) << "half as coarse, a quarter off";
  }
}

TEST(VolumeSamples, AreWellShaped) {
  const std::pair<const char*, double> least[] = {
      {"ball-in-box", 38}, {"tet-bracket", 13}, {"layered-beam", 45 - 1e-9}};
  for (const auto& [name, angle] : least)
    for (const int size : {1, 2, 4})
      for (const auto& sample : measure::smallest_dihedrals(Mesh(make_sample(name, size))))
        ASSERT_GE(sample.value, angle) << name << ' ' << size;
}

TEST(VolumeSamples, FieldsOfTheBeam) {
  const MeshData mesh = make_sample("layered-beam", 2);
  ASSERT_EQ(mesh.attributes.size(), 2u);
  const Attribute &temperature = mesh.attributes[0], &stress = mesh.attributes[1];
  ASSERT_EQ(temperature.values.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    ASSERT_EQ(temperature.values[v], 400 - 8 * mesh.positions[v].x - 5 * mesh.positions[v].z);
  ASSERT_EQ(stress.values.size(), mesh.regions.size());
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    glm::dvec3 centre(0);
    for (std::size_t k = 0; k < 4; ++k)
      centre += mesh.positions[mesh.regions.vertices[4 * r + k]] / 4.0;
    ASSERT_NEAR(stress.values[r], (10 - centre.x) * (centre.z - 2), 1e-12);
  }
}

struct ModelCounts {
  const char* name;
  std::size_t vertices, edges, faces, regions;
};

TEST(VolumeSamples, ModelsAreAsAModellerWouldCount) {
  constexpr ModelCounts expected[] = {
      {"tet-box", 8, 12, 6, 1},      {"hex-box", 8, 12, 6, 1},       {"mixed", 12, 20, 11, 2},
      {"tet-drilled", 8, 14, 7, 1},  {"tet-ball", 0, 0, 1, 1},       {"ball-in-box", 8, 12, 7, 2},
      {"tet-bracket", 12, 20, 9, 1}, {"layered-beam", 16, 28, 16, 3}};
  for (const ModelCounts& e : expected)
    for (const int size : {0, 3}) {
      const MeshData mesh = make_sample(e.name, size);
      EXPECT_EQ(tags_of(mesh.vertex_classes, 0).size(), e.vertices) << e.name;
      EXPECT_EQ(tags_of(mesh.edges.classes, 1).size(), e.edges) << e.name;
      EXPECT_EQ(tags_of(mesh.faces.classes, 2).size(), e.faces) << e.name;
      EXPECT_EQ(tags_of(mesh.regions.classes, 3).size(), e.regions) << e.name;
    }
}

/// What bounds a mesh entity lies on the same model entity or on its boundary, which has a lower
/// dimension.
void expect_closure(const MeshData& mesh, int dim, const char* name) {
  const EntityList& list = mesh.list(dim);
  ASSERT_EQ(list.classes.size(), list.size()) << name;
  for (std::size_t i = 0, place = 0; i < list.size(); ++i) {
    ASSERT_EQ(list.classes[i].dimension(), dim) << name;
    for (int k = shape_template(list.shapes[i]).vertex_count; k > 0; --k, ++place) {
      const ModelRef corner = mesh.vertex_classes[list.vertices[place]];
      ASSERT_TRUE(corner.valid() && (corner.dimension() < dim || corner == list.classes[i]))
          << name;
    }
  }
}

TEST(VolumeSamples, ClassificationFollowsTheRule) {
  for (const SampleInfo& info : samples_of(3)) {
    const MeshData mesh = make_sample(info.name);
    ASSERT_EQ(mesh.vertex_classes.size(), mesh.positions.size());
    for (int dim = 1; dim <= 3; ++dim) expect_closure(mesh, dim, info.name.data());
  }
}

TEST(VolumeSamples, NothingIsFoundInThem) {
  for (const SampleInfo& info : samples_of(3))
    EXPECT_TRUE(verify(Mesh(make_sample(info.name, 2))).empty()) << info.name;
}

TEST(VolumeSamples, TheBoreIsRound) {
  const MeshData mesh = make_sample("tet-drilled", 10);
  std::set<std::int32_t> circles;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& p = mesh.positions[mesh.faces.vertices[3 * f + k]];
      if (mesh.faces.classes[f] != ModelRef(2, 7)) continue;
      ASSERT_NEAR(std::hypot(p.x, p.y), 0.5, 1e-15);
      const ModelRef corner = mesh.vertex_classes[mesh.faces.vertices[3 * f + k]];
      ASSERT_EQ(corner.dimension(), p.z == 0 || p.z == 1 ? 1 : 2);
      if (corner.dimension() == 1) circles.insert(corner.tag());
    }
  EXPECT_EQ(circles.size(), 2u);
}

/// Fails when another machine, compiler or edit makes other bits of a sample.
std::uint64_t fingerprint(const MeshData& mesh) {
  std::uint64_t h = 14695981039346656037u;
  const auto mix = [&](std::uint64_t x) { h = (h ^ x) * 1099511628211u; };
  for (const glm::dvec3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) mix(std::bit_cast<std::uint64_t>(p[axis]));
  for (int dim = 1; dim <= 3; ++dim) {
    for (const std::uint32_t v : mesh.list(dim).vertices) mix(v);
    for (const ModelRef m : mesh.list(dim).classes) mix(m.bits());
  }
  return h;
}

TEST(VolumeSamples, TheSameOnEveryMachine) {
  const std::map<std::string_view, std::uint64_t> expected{
      {"tet-box", 3841751856467483900u},     {"hex-box", 71534001561822612u},
      {"mixed", 9505855578600326422u},       {"tet-drilled", 8942414415395368173u},
      {"tet-ball", 12918813644667153295u},   {"ball-in-box", 4107320185469819167u},
      {"tet-bracket", 4247356571551694771u}, {"layered-beam", 15656205709896221055u}};
  for (const SampleInfo& info : samples_of(3)) {
    EXPECT_EQ(fingerprint(make_sample(info.name)), expected.at(info.name)) << info.name;
    EXPECT_EQ(make_sample(info.name), make_sample(info.name));
  }
}

}  // namespace
}  // namespace aomd::volume_samples_test
