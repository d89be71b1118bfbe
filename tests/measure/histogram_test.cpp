// Histograms of tiny meshes whose angles, lengths and valences are known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/measure/histogram.h"
#include "tests/support/zoo.h"

namespace aomd::test::histogram_test {
namespace {

using measure::entities_in;
using measure::Histogram;
using measure::make_histogram;
using measure::Sample;

std::vector<Sample> samples_of(std::initializer_list<double> values) {
  std::vector<Sample> samples;
  for (const double value : values)
    samples.push_back({Face(static_cast<std::uint32_t>(samples.size())), value});
  return samples;
}

Mesh with_edges(const MeshData& data) {
  Mesh mesh(data);
  mesh.set(0, 1);
  return mesh;
}

std::vector<double> values_of(const std::vector<Sample>& samples) {
  std::vector<double> values;
  for (const Sample& sample : samples) values.push_back(sample.value);
  return values;
}

TEST(Histogram, BinsHoldTheirLowerBoundAndTheLastOneBoth) {
  const auto samples = samples_of({0, 0.5, 1, 1.999, 2, 3, 4});
  const Histogram h = make_histogram(samples, 0, 4, 4);
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{2, 2, 1, 2}));
  EXPECT_EQ(h.total, 7u);
  EXPECT_DOUBLE_EQ(h.least, 0);
  EXPECT_DOUBLE_EQ(h.largest, 4);
  EXPECT_DOUBLE_EQ(h.mean, 12.499 / 7);
  EXPECT_DOUBLE_EQ(h.bound(1), 1);
  EXPECT_DOUBLE_EQ(h.bound(4), 4);
}

TEST(Histogram, WhatLiesBeyondCountsAtTheEnds) {
  const auto samples = samples_of({-5, 9, 1});
  const Histogram h = make_histogram(samples, 0, 2, 2);
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{1, 2}));
  EXPECT_DOUBLE_EQ(h.least, -5);
  EXPECT_DOUBLE_EQ(h.largest, 9);
  EXPECT_EQ(entities_in(samples, h, 0), (std::vector<EntityRef>{Face(0)}));
  EXPECT_EQ(entities_in(samples, h, 1), (std::vector<EntityRef>{Face(1), Face(2)}));
}

TEST(Histogram, OfNothingIsEmpty) {
  const Histogram h = make_histogram({}, 0, 1, 3);
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_EQ(h.total, 0u);
  EXPECT_EQ(h.mean, 0);
}

TEST(SmallestAngles, OfRightTrianglesAndAQuad) {
  for (const Sample& sample : measure::smallest_angles(Mesh(zoo::square())))
    EXPECT_NEAR(sample.value, 45, 1e-12);
  MeshData quad;
  quad.positions = {{0, 0, 0}, {std::sqrt(3.0), 0, 0}, {std::sqrt(3.0), 1, 0}, {0, 1, 0}};
  quad.faces.add(Shape::Quad, {0, 1, 2, 3});
  const auto angles = measure::smallest_angles(Mesh(quad));
  ASSERT_EQ(angles.size(), 1u);
  EXPECT_NEAR(angles[0].value, 30, 1e-12);
}

TEST(SmallestDihedrals, OfAnUnitCubeIs90) {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  data.regions.add(Shape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
  const auto angles = measure::smallest_dihedrals(Mesh(data));
  ASSERT_EQ(angles.size(), 1u);
  EXPECT_EQ(angles[0].entity, EntityRef(Region(0)));
  EXPECT_NEAR(angles[0].value, 90, 1e-9);
}

TEST(LengthRatios, OfATriangle345) {
  MeshData data;
  data.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  data.faces.add(Shape::Triangle, {0, 1, 2});
  const Mesh mesh = with_edges(data);
  Column<Vertex, double> wanted(3, 2.0);
  wanted[Vertex(1)] = 4;
  // 3 over (2+4)/2, 5 over (4+2)/2, 4 over 2, whatever the order of the edges
  std::vector<double> values = values_of(measure::length_ratios(mesh, wanted));
  std::sort(values.begin(), values.end());
  ASSERT_EQ(values.size(), 3u);
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_DOUBLE_EQ(values[1], 5.0 / 3);
  EXPECT_DOUBLE_EQ(values[2], 2);
  wanted[Vertex(1)] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(measure::length_ratios(mesh, wanted).size(), 1u)
      << "no limit at one end is none for the edge";
  wanted[Vertex(0)] = 0;
  EXPECT_TRUE(measure::length_ratios(mesh, wanted).empty());
}

TEST(Valences, OfTheSquareAndWithoutUnusedVertices) {
  MeshData data = zoo::square();
  data.positions.emplace_back(9, 9, 9);
  std::vector<double> values = values_of(measure::valences(with_edges(data)));
  std::sort(values.begin(), values.end());
  EXPECT_EQ(values, (std::vector<double>{2, 2, 3, 3}));
}

}  // namespace
}  // namespace aomd::test::histogram_test
