// Counts, quality, flips and self-intersections on tiny meshes with exact answers.

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include <glm/geometric.hpp>

#include "core/io/io.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/measure/statistics.h"
#include "tests/support/zoo.h"

namespace aomd::test::measure_test {
namespace {

using measure::self_intersections;

std::size_t cuts(std::vector<glm::dvec3> positions, const zoo::Triangles& triangles) {
  return self_intersections(Mesh(zoo::make(std::move(positions), triangles))).size();
}

//  3--2        1--4
//  | /|  and   | /   share vertex positions, not indices
//  |/ |        0
//  0--1
TEST(Intersections, NeighboursDoNotIntersect) {
  EXPECT_EQ(self_intersections(Mesh(zoo::square())).size(), 0u);
  EXPECT_EQ(self_intersections(Mesh(zoo::tetrahedron())).size(), 0u);
  EXPECT_EQ(self_intersections(Mesh(zoo::octahedron())).size(), 0u);
  EXPECT_EQ(self_intersections(Mesh(zoo::book())).size(), 0u);
  // a seam: the shared edge exists twice
  EXPECT_EQ(cuts({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                 {{0, 1, 2}, {3, 4, 5}}),
            0u);
}

//        5
//     1--|--2
//      \ | /      the upright triangle stands through the lying one
//        0
TEST(Intersections, OneTriangleThroughAnother) {
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1, 1}},
                 {{0, 1, 2}, {3, 4, 5}}),
            1u);
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {5, 5, -1}, {5, 5, 1}, {6, 5, 1}},
                 {{0, 1, 2}, {3, 4, 5}}),
            0u);
}

TEST(Intersections, TouchingCounts) {
  // the tip of the second stands on the inside of the first
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}},
                 {{0, 1, 2}, {3, 4, 5}}),
            1u);
  // a vertex in the middle of the other's side
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {2, -1, 0}, {3, -1, 0}},
                 {{0, 1, 2}, {3, 4, 5}}),
            1u);
}

//  2
//  | \        both in one plane: (0,1,2) and (0,1,3) lie on the same side of 0-1
//  |3 \       .
//  0---1
TEST(Intersections, FoldsAtASharedEdge) {
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}}), 1u);
  EXPECT_EQ(cuts({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1e-12}}, {{0, 1, 2}, {1, 0, 3}}), 0u);
  // a tilted plane, where doubles cannot tell and the exact predicates must
  EXPECT_EQ(cuts({{0, 0, 0}, {3, 3, 9}, {1, 7, 3}, {1, 2, 3}}, {{0, 1, 2}, {1, 0, 3}}), 1u);
  EXPECT_EQ(cuts({{0, 0, 0}, {3, 3, 9}, {1, 7, 3}, {2, -1, 6}}, {{0, 1, 2}, {1, 0, 3}}), 0u);
}

//     2   4
//    / \ /
//   0---1---3    sectors around 1
TEST(Intersections, SectorsAtASharedVertex) {
  EXPECT_EQ(cuts({{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {4, 0, 0}, {3, 2, 0}}, {{0, 1, 2}, {1, 3, 4}}),
            0u);
  // the second sector lies inside the first
  EXPECT_EQ(
      cuts({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0.2, 0}, {1, 0.4, 0}}, {{0, 1, 2}, {0, 3, 4}}),
      1u);
  // upright through the first, sharing its corner
  EXPECT_EQ(cuts({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}, {1, 1, -1}}, {{0, 1, 2}, {0, 3, 4}}),
            1u);
}

TEST(Intersections, RepeatedFacesArePairsAndFlatOnesAreNot) {
  EXPECT_EQ(cuts({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}), 1u);
  EXPECT_EQ(cuts({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}), 0u);
  EXPECT_EQ(cuts({}, {}), 0u);
}

// Copies are counted, not looked at two by two: thousands of them are no reason to list millions.
TEST(Intersections, CopiesOfAFaceAreCounted) {
  for (const std::uint64_t copies : {2, 3, 40000}) {
    MeshData data = zoo::triangle();
    for (std::uint64_t copy = 1; copy < copies; ++copy)
      data.faces.add(Shape::Triangle, {copy % 2 == 0 ? 0u : 2u, copy % 2 == 0 ? 2u : 0u, 1u});
    data.positions.insert(data.positions.end(), {{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 0.2, 1}});
    data.faces.add(Shape::Triangle, {3, 4, 5});  // through all of them
    const std::uint64_t pairs = copies * (copies - 1) / 2 + copies;
    EXPECT_EQ(measure::count_self_intersections(Mesh(data)).pairs, pairs);
    EXPECT_TRUE(copies > 3 || self_intersections(Mesh(data)).size() == pairs);
  }
}

// The plane z = 0 and a needle through it, over hundreds of decades, and the needle beside it.
TEST(Intersections, CoordinatesFarApartAreToldToo) {
  for (const double size : {1e-280, 1e-150, 1e-60, 1.0, 1e60, 1e150, 1e280})
    for (const double up : {1e-20, 1.0, 1e20})
      for (const bool through : {true, false}) {
        const double x = through ? 1 : -1, high = size * up;
        EXPECT_EQ(cuts({{0, 0, 0},
                        {4 * size, 0, 0},
                        {0, 4 * size, 0},
                        {x * size, size, -high},
                        {x * size, size, high},
                        {x * size, 1.5 * size, high}},
                       {{0, 1, 2}, {3, 4, 5}}),
                  through ? 1u : 0u)
            << size << ' ' << up;
      }
}

TEST(Intersections, PairsAreNamedInOrder) {
  const auto pairs = self_intersections(Mesh(zoo::make({{0, 0, 0},
                                                        {4, 0, 0},
                                                        {0, 4, 0},
                                                        {1, 1, -1},
                                                        {1, 1, 1},
                                                        {2, 1, 1},
                                                        {9, 9, 9},
                                                        {9, 8, 9},
                                                        {8, 9, 9}},
                                                       {{6, 7, 8}, {3, 4, 5}, {0, 1, 2}})));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, Face(1));
  EXPECT_EQ(pairs[0].second, Face(2));
}

TEST(Intersections, SharedFiles) {
  const std::pair<const char*, std::size_t> known[] = {{"dragon.ply", 1822}, {"bunny.ply", 0}};
  for (const auto& [name, pairs] : known) {
    const auto path = std::filesystem::path(AOMD_SHARED_DATA) / name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared data is not here";
    EXPECT_EQ(self_intersections(Mesh(io::read(path).mesh)).size(), pairs) << name;
  }
}

TEST(TriangleTree, FindsTheNearestPoint) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return glm::dvec3(uniform(random), uniform(random), uniform(random)); };
  std::vector<Triangle> triangles(200);
  for (auto& t : triangles) {
    const glm::dvec3 centre = point();
    t = {centre + 0.2 * point(), centre + 0.2 * point(), centre + 0.2 * point()};
  }
  const TriangleTree tree(triangles);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p = 1.5 * point();
    double best = 1e300;
    for (const auto& t : triangles) {
      const glm::dvec3 d = nearest_point(t, p) - p;
      best = std::min(best, glm::dot(d, d));
    }
    EXPECT_EQ(tree.nearest(p).distance2, best);
    EXPECT_EQ(tree.nearest(p, static_cast<std::uint32_t>(i)).distance2, best);
    int near = 0;
    tree.within(p, best, [&](std::uint32_t) { ++near; });
    EXPECT_GE(near, 1);
  }
  EXPECT_FALSE(Face(TriangleTree({}).nearest({0, 0, 0}).triangle).valid());
}

//      c
//     /|\        p is nearest to a corner, to a side, to the inside
//    a-+-b
TEST(TriangleTree, NearestPointOfATriangle) {
  const Triangle t{glm::dvec3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(nearest_point(t, {-1, -1, 3}), glm::dvec3(0, 0, 0));
  EXPECT_EQ(nearest_point(t, {3, -1, 0}), glm::dvec3(2, 0, 0));
  EXPECT_EQ(nearest_point(t, {-1, 4, 0}), glm::dvec3(0, 2, 0));
  EXPECT_EQ(nearest_point(t, {1, -5, 0}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(nearest_point(t, {-2, 1, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(nearest_point(t, {2, 2, 0}), glm::dvec3(1, 1, 0));
  EXPECT_EQ(nearest_point(t, {0.5, 0.5, 7}), glm::dvec3(0.5, 0.5, 0));
}

TEST(Statistics, CountsTheBook) {
  const measure::Counts counts = measure::count_entities(Mesh(zoo::book()));
  EXPECT_EQ(counts.vertices, 5u);
  EXPECT_EQ(counts.edges, 7u);
  EXPECT_EQ(counts.faces, 3u);
  EXPECT_EQ(counts.boundary_edges, 6u);
  EXPECT_EQ(counts.nonmanifold_edges, 1u);
  EXPECT_EQ(counts.components, 1u);
  EXPECT_EQ(counts.euler, 1);
  EXPECT_EQ(counts.by_shape[static_cast<std::size_t>(Shape::Triangle)], 3u);
}

TEST(Statistics, BowTieIsOneComponentAndItsUnusedVertexIsNone) {
  const measure::Counts counts = measure::count_entities(Mesh(zoo::bow_tie()));
  EXPECT_EQ(counts.unused_vertices, 1u);
  EXPECT_EQ(counts.vertices, 6u);
  EXPECT_EQ(counts.components, 1u);
  EXPECT_EQ(counts.euler, 5 - 6 + 2);
}

TEST(Statistics, StoredEdgesChangeNothing) {
  Mesh mesh(zoo::octahedron());
  const auto before = measure::count_entities(mesh);
  mesh.set(0, 1);
  const auto after = measure::count_entities(mesh);
  EXPECT_EQ(before.edges, 12u);
  EXPECT_EQ(after.edges, 12u);
  EXPECT_EQ(after.boundary_edges, 0u);
  EXPECT_EQ(after.euler, 2);
}

TEST(Statistics, ClassesAreCountedByDimension) {
  MeshData data = zoo::triangle();
  data.vertex_classes = {ModelRef(0, 1), ModelRef(1, 1), {}};
  data.faces.classes = {ModelRef(2, 5)};
  const auto counts = measure::count_entities(Mesh(data));
  EXPECT_EQ(counts.by_class, (std::array<std::size_t, 4>{1, 1, 1, 0}));
}

TEST(Statistics, QualityOfTwoTriangles) {
  // 45 degrees; and atan(1/8), 7.1 degrees
  const auto quality = measure::measure_quality(
      Mesh(zoo::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 0, 0}}, {{0, 1, 2}, {0, 3, 2}})));
  EXPECT_NEAR(quality.min_angle_worst_deg, 7.1250163, 1e-6);
  EXPECT_NEAR(quality.min_angle_mean_deg, (45 + 7.1250163) / 2, 1e-6);
  EXPECT_EQ(quality.faces_below_10deg_pct, 50);
  EXPECT_EQ(measure::measure_quality(Mesh()).min_angle_mean_deg, 0);
}

TEST(Statistics, AnglesDoNotDependOnTheSize) {
  for (const double size : {1e-300, 1e-150, 1e-100, 1e-60, 1.0, 1e60, 1e100, 1e160, 1.7e308}) {
    const Mesh mesh(zoo::make({{-size, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}));
    const measure::Quality quality = measure::measure_quality(mesh);
    EXPECT_NEAR(quality.min_angle_mean_deg, 45, 1e-9) << size;
    EXPECT_EQ(quality.min_angle_worst_deg, quality.min_angle_mean_deg) << size;
  }
}

//  3--2
//  |  |  a quad is two triangles of the same face
//  0--1
TEST(TriangleTree, QuadsAreSplit) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  data.faces.add(Shape::Quad, {0, 1, 2, 3});
  for (const auto& all : {triangles_of(data), triangles_of(Mesh(data))}) {
    EXPECT_EQ(all.faces, (std::vector<Face>{Face(0), Face(0)}));
    ASSERT_EQ(all.corners.size(), 2u);
    EXPECT_EQ(all.corners[1][1], data.positions[2]);
  }
}

TEST(Statistics, FlipsAreFacesTurnedOver) {
  const Mesh square(zoo::square());
  const TriangleTree original(triangles_of(square).corners);
  EXPECT_EQ(measure::measure_normals(original, square).flips, 0u);
  const Mesh turned(
      zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}));
  EXPECT_EQ(measure::measure_normals(original, turned).flips, 1u);
  EXPECT_EQ(measure::measure_normals(original, Mesh()).flips, 0u);
}

// A book of four pages, the last of them twice and the other way round, a wire along a rim and one
// beside it, and a vertex that nothing uses.
TEST(Counts, TellEdgesByTheirFaces) {
  MeshData data = zoo::book();
  data.positions.insert(data.positions.end(), {{0, -1, 0.5}, {0, 5, 0}, {0, 6, 0}});
  data.faces.add(Shape::Triangle, {0, 1, 5});
  data.faces.add(Shape::Triangle, {1, 0, 5});
  data.edges.add(Shape::Line, {2, 0});
  data.edges.add(Shape::Line, {6, 2});
  const measure::Counts counts = measure::count_entities(Mesh(data));
  EXPECT_EQ(counts.edges, 10u);
  EXPECT_EQ(counts.nonmanifold_edges, 1u);
  EXPECT_EQ(counts.boundary_edges, 6u);
  EXPECT_EQ(counts.components, 1u);
  EXPECT_EQ(counts.unused_vertices, 1u);
  EXPECT_EQ(counts.euler, 7 - 10 + 5);
}

TEST(Counts, KnowPiecesOfQuadsAndTriangles) {
  MeshData data = zoo::square();
  for (int k = 0; k < 4; ++k) data.positions.emplace_back(k, 3, k % 2);
  data.faces.add(Shape::Quad, {4, 5, 7, 6});
  const measure::Counts counts = measure::count_entities(Mesh(data));
  EXPECT_EQ(counts.components, 2u);
  EXPECT_EQ(counts.edges, 9u);
  EXPECT_EQ(counts.boundary_edges, 8u);
}

}  // namespace
}  // namespace aomd::test::measure_test
