// Regions listed inside out are found by their neighbours, whatever their shape; what is tangled,
// folded or crowded stays as it is listed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "core/mesh/orient_regions.h"
#include "core/mesh/tet_geometry.h"
#include "tests/support/volume_facts.h"
#include "tests/support/zoo.h"

namespace aomd::test::orient_regions_test {
namespace {

using Ids = std::vector<std::uint32_t>;

// The vertices of each shape seen in a mirror, by their places in the template.
const std::vector<std::size_t>& mirror_of(Shape shape) {
  static const std::vector<std::size_t> tetrahedron{0, 2, 1, 3}, pyramid{0, 3, 2, 1, 4},
      prism{0, 2, 1, 3, 5, 4}, hexahedron{0, 3, 2, 1, 4, 7, 6, 5};
  return shape == Shape::Tetrahedron ? tetrahedron
         : shape == Shape::Pyramid   ? pyramid
         : shape == Shape::Prism     ? prism
                                     : hexahedron;
}

MeshData mirrored(const MeshData& mesh, const Ids& regions) {
  MeshData result = mesh;
  std::size_t first = 0;
  for (std::uint32_t r = 0; r < mesh.regions.size(); ++r) {
    const std::vector<std::size_t>& mirror = mirror_of(mesh.regions.shapes[r]);
    if (std::binary_search(regions.begin(), regions.end(), r))
      for (std::size_t k = 0; k < mirror.size(); ++k)
        result.regions.vertices[first + k] = mesh.regions.vertices[first + mirror[k]];
    first += mirror.size();
  }
  return result;
}

Ids some_of(std::size_t n, double share, unsigned seed) {
  std::mt19937 random(seed);
  Ids chosen;
  for (std::uint32_t r = 0; r < n; ++r)
    if (std::bernoulli_distribution(share)(random)) chosen.push_back(r);
  return chosen;
}

Ids all_of(std::size_t n) { return some_of(n, 1, 0); }

// Expects that those are turned, and that this leads to `right`.
void expect_turned(MeshData listed, const Ids& regions, const MeshData& right,
                   const std::string& name) {
  EXPECT_EQ(orient_regions(listed), regions) << name;
  EXPECT_EQ(listed, right) << name;
}

double volume_of_tet(const MeshData& mesh, std::size_t i) {
  const auto at = [&](std::size_t k) { return mesh.positions[mesh.regions.vertices[4 * i + k]]; };
  return six_volumes(at(0), at(1), at(2), at(3));
}

Ids negative(const MeshData& tets) {
  Ids ids;
  for (std::uint32_t r = 0; r < tets.regions.size(); ++r)
    if (volume_of_tet(tets, r) < 0) ids.push_back(r);
  return ids;
}

std::vector<zoo::Animal> right_meshes() {
  std::vector<zoo::Animal> list = zoo::volumes();
  for (const char* name : {"hex-box", "mixed", "tet-drilled", "ball-in-box"})
    list.push_back({name, make_sample(name, 3)});
  return list;
}

TEST(OrientRegions, WhatIsRightStays) {
  for (const auto& [name, mesh] : right_meshes()) expect_turned(mesh, {}, mesh, name);
}

TEST(OrientRegions, SomeOfEveryShape) {
  for (const auto& [name, mesh] : right_meshes())
    for (const double share : {0.01, 0.3, 0.7, 0.99, 1.0})
      for (unsigned seed = 0; seed < 5; ++seed) {
        const Ids odd = some_of(mesh.regions.size(), share, seed);
        expect_turned(mirrored(mesh, odd), odd, mesh, name);
      }
}

TEST(OrientRegions, BodiesApartAreTurnedEachByItself) {
  MeshData mesh = make_sample("tet-box", 2);
  const auto n = static_cast<std::uint32_t>(mesh.regions.size());
  const auto m = static_cast<std::uint32_t>(mesh.positions.size());
  MeshData pair = mesh;
  for (const glm::dvec3& p : mesh.positions) pair.positions.push_back(p + glm::dvec3(5, 0, 0));
  for (const std::uint32_t v : mesh.regions.vertices) pair.regions.vertices.push_back(v + m);
  pair.regions.shapes.resize(2 * n, Shape::Tetrahedron);
  pair.regions.classes.resize(2 * n, ModelRef(3, 1));
  Ids second;
  for (std::uint32_t r = n; r < 2 * n; ++r) second.push_back(r);
  expect_turned(mirrored(pair, second), second, pair, "the second");
}

// A vertex that lies where it should not turns tetrahedra around it inside out, which agree with
// their neighbours.
TEST(OrientRegions, TheTangledStay) {
  MeshData mesh = make_sample("tet-box", 4);
  const auto inner = std::find_if(mesh.vertex_classes.begin(), mesh.vertex_classes.end(),
                                  [](ModelRef on) { return on.dimension() == 3; });
  mesh.positions[static_cast<std::size_t>(inner - mesh.vertex_classes.begin())] += 0.3;
  const Ids tangled = negative(mesh);
  ASSERT_GT(tangled.size(), 2u);
  expect_turned(mesh, {}, mesh, "tangled");

  Ids odd;
  for (const std::uint32_t r : some_of(mesh.regions.size(), 0.2, 1))
    if (!std::binary_search(tangled.begin(), tangled.end(), r)) odd.push_back(r);
  ASSERT_GT(odd.size(), 10u);
  expect_turned(mirrored(mesh, odd), odd, mesh, "tangled, and some are odd");

  const Ids all = all_of(mesh.regions.size());
  expect_turned(mirrored(mesh, all), all, mesh, "all, also those that this leaves inside out");
}

// Two tetrahedra that lie on one side of their face are folded, and no numbering unfolds them.
TEST(OrientRegions, TheFoldedStay) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 3}, {0, 0, -1}};
  for (const std::uint32_t top : {3u, 4u}) mesh.regions.add(Shape::Tetrahedron, {0, 1, 2, top});
  expect_turned(mesh, {}, mesh, "both upright");
  mesh.positions.push_back({-1, 0.2, 0.2});
  mesh.regions.add(Shape::Tetrahedron, {0, 3, 2, 6});
  const MeshData right = mesh;
  ASSERT_GT(volume_of_tet(right, 2), 0);
  expect_turned(mirrored(right, {2}), {2}, right, "beside one that is not");
}

// A face of three: each stands for itself.
TEST(OrientRegions, CrowdedFacesJoinNothing) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 2}, {0, 0, -1}};
  for (const std::uint32_t top : {3u, 4u}) mesh.regions.add(Shape::Tetrahedron, {0, 1, 2, top});
  mesh.regions.add(Shape::Tetrahedron, {0, 2, 1, 5});
  for (const Ids& odd : {Ids{}, Ids{0}, Ids{1, 2}, Ids{0, 1, 2}})
    expect_turned(mirrored(mesh, odd), odd, mesh, "crowded");
}

TEST(OrientRegions, TheFlatAndTheRepeatedStay) {
  MeshData flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}};
  flat.regions.add(Shape::Tetrahedron, {0, 1, 2, 3});
  flat.regions.add(Shape::Tetrahedron, {0, 1, 2, 4});
  for (const Ids& odd : {Ids{}, Ids{0}}) {
    const MeshData listed = mirrored(flat, odd);
    expect_turned(listed, {}, listed, "flat");
  }
  MeshData twice;
  twice.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  twice.regions.add(Shape::Tetrahedron, {0, 1, 2, 3});
  twice.regions.add(Shape::Tetrahedron, {0, 2, 1, 3});
  expect_turned(twice, {}, twice, "repeated");
}

// A ring of prisms that closes in a mirror has no right numbering: five upright ones, one after the
// other, of which the last stands inside out.
MeshData one_sided_ring(std::mt19937& random) {
  MeshData ring;
  std::uniform_real_distribution<double> place(-1, 1);
  for (int i = 0; i < 15; ++i)
    ring.positions.push_back({place(random), place(random), place(random)});
  for (std::uint32_t v = 0; v < 12; v += 3)
    ring.regions.add(Shape::Prism, {v, v + 1, v + 2, v + 3, v + 4, v + 5});
  ring.regions.add(Shape::Prism, {12, 13, 14, 1, 0, 2});
  return ring;
}

// Six times the least volume of a prism, or of its mirror image, over all ways to cut its sides.
double least_volume(const MeshData& prisms, std::size_t r, double sign) {
  const std::uint32_t* const v = &prisms.regions.vertices[6 * r];
  double sum = 0;
  for (const SubEntity& side : shape_template(Shape::Prism).faces) {
    const std::vector<std::uint32_t> c = corners_of(v, side);
    const auto at = [&](std::size_t i) { return prisms.positions[c[i % c.size()]]; };
    std::vector<double> cuts;
    for (std::size_t from = 0; from < c.size(); ++from) {
      cuts.push_back(0);
      for (std::size_t k = 1; k + 1 < c.size(); ++k)
        cuts.back() +=
            sign * six_volumes(prisms.positions[v[0]], at(from), at(from + k), at(from + k + 1));
    }
    sum += *std::min_element(cuts.begin(), cuts.end());
  }
  return sum;
}

// A pyramid, listed before all, on a side of the first prism that comes after those between prisms.
MeshData with_pyramid_first(const MeshData& ring, std::mt19937& random) {
  MeshData result;
  const auto place = [](std::uint32_t v) { return v % 3 * 5 + v / 3; };
  result.positions.resize(15);
  for (std::uint32_t v = 0; v < 15; ++v) result.positions[place(v)] = ring.positions[v];
  std::uniform_real_distribution<double> apart(-2, 2);
  result.positions.push_back({apart(random), apart(random), apart(random)});
  result.regions.add(Shape::Pyramid, {place(1), place(2), place(5), place(4), 15});
  for (std::size_t i = 0; i < ring.regions.vertices.size(); ++i)
    result.regions.vertices.push_back(place(ring.regions.vertices[i]));
  result.regions.shapes.resize(1 + ring.regions.size(), Shape::Prism);
  return result;
}

TEST(OrientRegions, OneSidedRingsStay) {
  std::mt19937 random(3);
  int rings = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const MeshData ring = one_sided_ring(random);
    const VolumeFacts facts = volume_facts_of(ring);
    ASSERT_EQ(facts.misoriented, 1u);
    ASSERT_EQ(facts.boundary, 15u);
    bool wanted = least_volume(ring, 4, -1) > 0;
    for (std::size_t r = 0; r < 4; ++r) wanted = wanted && least_volume(ring, r, 1) > 0;
    if (!wanted) continue;
    ++rings;
    expect_turned(ring, {}, ring, "one after the other");
    const Ids odd{1, 2};
    expect_turned(mirrored(ring, odd), {}, mirrored(ring, odd), "in another order");
    const MeshData more = with_pyramid_first(mirrored(ring, odd), random);
    expect_turned(more, {}, more, "joined to another one late");
  }
  EXPECT_GT(rings, 0);
}

// However bent its sides are, a region or its mirror image is inside out, and not both.
TEST(OrientRegions, BentRegionsAreInsideOutOneWayRound) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(0, 1);
  for (const Shape shape : {Shape::Pyramid, Shape::Prism, Shape::Hexahedron})
    for (int trial = 0; trial < 500; ++trial) {
      MeshData mesh;
      for (std::uint32_t v = 0; v < std::uint32_t(shape_template(shape).vertex_count); ++v) {
        mesh.positions.push_back({place(random), place(random), place(random)});
        mesh.regions.vertices.push_back(v);
      }
      mesh.regions.shapes = {shape};
      MeshData other = mirrored(mesh, {0});
      EXPECT_NE(orient_regions(mesh).size(), orient_regions(other).size()) << trial;
      EXPECT_EQ(mesh, other);
    }
}

// Dirt of every kind: nothing but the order of vertices changes.
TEST(OrientRegions, RandomDirt) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    MeshData mesh;
    for (int i = 0; i < 9; ++i) {
      std::uniform_real_distribution<double> place(0, 1);
      mesh.positions.push_back({place(random), place(random), place(random)});
    }
    for (int i = 0; i < 25; ++i) {
      Ids v{0, 1, 2, 3, 4, 5, 6, 7, 8};
      std::shuffle(v.begin(), v.end(), random);
      mesh.regions.add(Shape::Tetrahedron, {v[0], v[1], v[2], v[3]});
    }
    MeshData oriented = mesh;
    const Ids turned = orient_regions(oriented);
    EXPECT_TRUE(std::is_sorted(turned.begin(), turned.end()));
    EXPECT_EQ(oriented, mirrored(mesh, turned));
  }
}

}  // namespace
}  // namespace aomd::test::orient_regions_test
