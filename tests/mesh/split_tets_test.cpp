// Regions of every shape cut into tetrahedra: conforming, of the same volume, with their classes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>

#include "core/io/io.h"
#include "core/mesh/split_tets.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/support/volume_facts.h"
#include "tests/support/zoo.h"

namespace aomd::test::split_tets_test {
namespace {

std::size_t of(const std::array<std::size_t, max_shapes>& counts, Shape shape) {
  return counts[static_cast<std::size_t>(shape)];
}

/// Expects what every cut must keep: volumes by model region, the boundary, and where two regions
/// meet.
void expect_same_body(const MeshData& whole, const MeshData& tets, const std::string& name) {
  const VolumeFacts before = volume_facts_of(whole), after = volume_facts_of(tets);
  EXPECT_EQ(tets.positions, whole.positions) << name;
  EXPECT_EQ(tets.edges, whole.edges) << name;
  EXPECT_EQ(tets.vertex_classes, whole.vertex_classes) << name;
  EXPECT_EQ(after.crowded, 0u) << name;
  EXPECT_EQ(after.misoriented, before.misoriented) << name;
  EXPECT_EQ(after.folded, before.folded) << name;
  EXPECT_EQ(after.euler, before.euler) << name;
  EXPECT_EQ(after.volume_of.size(), before.volume_of.size()) << name;
  for (const auto& [tag, volume] : before.volume_of)
    EXPECT_NEAR(after.volume_of.at(tag), volume, 1e-12) << name << ' ' << tag;
  const std::vector<Finding> findings = verify(Mesh(tets));
  EXPECT_TRUE(findings.empty()) << name << ": " << findings.front().text;
}

/// The mesh with its vertices in another order: every way to cut a hexahedron comes up.
MeshData renumbered(const MeshData& mesh, unsigned seed) {
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  MeshData result = mesh;
  for (std::size_t v = 0; v < place.size(); ++v) {
    result.positions[place[v]] = mesh.positions[v];
    result.vertex_classes[place[v]] = mesh.vertex_classes[v];
  }
  for (int dim = 1; dim <= 3; ++dim)
    for (std::uint32_t& v : result.list(dim).vertices) v = place[v];
  return result;
}

TEST(SplitToTets, NumbersOfPieces) {
  const SplitToTets split = split_to_tets(zoo::hybrid());
  EXPECT_EQ(of(split.cut, Shape::Hexahedron), 1u);
  EXPECT_EQ(of(split.pieces, Shape::Hexahedron), 6u);
  EXPECT_EQ(of(split.pieces, Shape::Prism), 3u);
  EXPECT_EQ(of(split.pieces, Shape::Pyramid), 2u);
  EXPECT_EQ(of(split.pieces, Shape::Quad), 2u);
  EXPECT_EQ(of(split.cut, Shape::Tetrahedron), 0u);
  EXPECT_EQ(split.mesh.regions.size(), 6u + 3 + 2 + 2);
  EXPECT_EQ(split.text(),
            "1 hexahedron into 6 tetrahedra, 1 prism into 3 tetrahedra, 1 pyramid into 2 "
            "tetrahedra, 1 quad into 2 triangles");
}

//  3--2
//  | /|  from the smallest of 1, 2, 6, 5, on the side that the hexahedron and the prism share
//  |/ |
TEST(SplitToTets, ClassesStay) {
  const MeshData tets = split_to_tets(zoo::hybrid()).mesh;
  EXPECT_EQ(tets.faces.vertices, (std::vector<std::uint32_t>{1, 2, 6, 1, 6, 5}));
  EXPECT_EQ(tets.faces.classes, (std::vector<ModelRef>{ModelRef(2, 7), ModelRef(2, 7)}));
  const std::vector<ModelRef>& classes = tets.regions.classes;
  EXPECT_EQ(std::count(classes.begin(), classes.end(), ModelRef(3, 1)), 6 + 2);
  EXPECT_EQ(std::count(classes.begin(), classes.end(), ModelRef(3, 2)), 1 + 3 + 1);
  const VolumeFacts facts = volume_facts_of(tets);
  EXPECT_EQ(facts.listed_inside, 2u);
  EXPECT_EQ(facts.listed_wrong, 0u);
}

TEST(SplitToTets, TheZoo) {
  for (const zoo::Animal& animal : zoo::volumes()) {
    const SplitToTets split = split_to_tets(animal.data);
    expect_same_body(animal.data, split.mesh, animal.name);
    EXPECT_EQ(split.inverted, 0u) << animal.name;
  }
}

TEST(SplitToTets, SamplesUnderAnyNumbering) {
  for (const char* name : {"hex-box", "mixed"})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const MeshData whole = renumbered(make_sample(name, 3), seed);
      const SplitToTets split = split_to_tets(whole);
      expect_same_body(whole, split.mesh, name);
      EXPECT_EQ(split.inverted, 0u);
      const VolumeFacts facts = volume_facts_of(split.mesh);
      EXPECT_EQ(facts.listed_wrong, 0u) << name;
      EXPECT_EQ(facts.listed_outward, facts.boundary) << name;
      EXPECT_EQ(facts.listed_inside, facts.between) << name;
    }
}

TEST(SplitToTets, AttributesGoToThePieces) {
  MeshData data = zoo::hybrid();
  data.attributes = {{"p", 0, 1, false, std::vector<double>(13, 4)},
                     {"q", 2, 1, true, {8}},
                     {"r", 3, 3, false, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}}};
  const std::vector<Attribute> pieces = split_to_tets(data).mesh.attributes;
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0], data.attributes[0]);
  EXPECT_EQ(pieces[1].values, (std::vector<double>{8, 8}));
  ASSERT_EQ(pieces[2].values.size(), 3u * 13);
  for (std::size_t i = 0; i < 13; ++i) {
    const double first = i < 6 ? 1 : i < 8 ? 4 : i < 9 ? 7 : i < 12 ? 10 : 13;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(pieces[2].values[3 * i + k], first + static_cast<double>(k)) << i;
  }
}

TEST(SplitToTets, RegionsInsideOutAreTurned) {
  MeshData data = make_sample("hex-box", 2);
  std::uint32_t* v = data.regions.vertices.data() + 8;  // the second one
  for (int k = 0; k < 4; ++k) std::swap(v[k], v[k + 4]);
  const SplitToTets split = split_to_tets(data);
  EXPECT_EQ(split.inverted, 0u);
  const VolumeFacts facts = volume_facts_of(split.mesh);
  EXPECT_EQ(facts.misoriented, 0u);
  EXPECT_NEAR(facts.volume, 1, 1e-12);
  EXPECT_GT(facts.least_volume, 0);
}

// A corner pushed beyond the middle of the cube: two of the six tetrahedra have it.
TEST(SplitToTets, PiecesOfBentRegionsAreCounted) {
  MeshData data = make_sample("hex-box", 1);
  data.positions[1] = {0.2, 0.6, 0.6};
  EXPECT_EQ(split_to_tets(data).inverted, 2u);
}

TEST(SplitToTets, SurfacesAndTetrahedraStay) {
  const MeshData quad = make_sample("torus", 12), tets = make_sample("tet-drilled", 3);
  for (const MeshData& mesh : {quad, tets}) {
    const SplitToTets split = split_to_tets(mesh);
    EXPECT_EQ(split.mesh, mesh);
    EXPECT_EQ(split.text(), "");
  }
}

TEST(SplitToTets, SharedFiles) {
  struct Expected {
    const char* name;
    std::size_t tets, turned;
    double volume;  ///< up to the digits of the file
  };
  const Expected files[] = {
      {"hybrid_lshape_v41.msh", 48 + 2 * 48 + 3 * 24, 0, 0.75},
      {"mixed_knowles_v22.msh", 2 * 3936 + 3 * 4128 + 6 * 3680, 10432, 0.0125},
      {"mixed_knowles.vtk", 2 * 3936 + 3 * 4128 + 6 * 3680, 6304, 0.0125},
      {"beam_hex.vtk", 48, 0, 8},
      {"beam_wedge.vtk", 24, 0, 4},
      {"brick_prism.vtk", 3 * 29640, 0, 2}};
  for (const Expected& file : files) {
    const auto path = std::filesystem::path(AOMD_SHARED_DATA) / file.name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared data is not here";
    const io::ReadResult whole = io::read(path);
    EXPECT_EQ(whole.turned.size(), file.turned) << file.name;
    const SplitToTets split = split_to_tets(whole.mesh);
    EXPECT_EQ(split.inverted, 0u) << file.name;
    const VolumeFacts facts = volume_facts_of(split.mesh);
    EXPECT_EQ(static_cast<std::size_t>(facts.regions), file.tets) << file.name;
    EXPECT_NEAR(facts.volume, file.volume, 1e-11) << file.name;
    EXPECT_EQ(facts.euler, 1) << file.name;
    EXPECT_EQ(facts.crowded + facts.misoriented + facts.folded, 0u) << file.name;
    EXPECT_TRUE(verify(Mesh(split.mesh)).empty()) << file.name;
  }
}

}  // namespace
}  // namespace aomd::test::split_tets_test
