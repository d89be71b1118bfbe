// Values at vertices that fit best in between: by hand, and of decimated surfaces.

#include <algorithm>
#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "core/fields/fitted_values.h"
#include "core/measure/field_comparison.h"
#include "tests/support/field_helpers.h"
#include "tests/support/painted_sphere.h"

namespace aomd::test::fitted_values_test {
namespace {

using fields::fit_values;
using fields::FitPoint;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// One triangle with a point at each corner and one in the middle, each of area 1.
std::vector<FitPoint> corners_and_middle() {
  const std::array<std::uint32_t, 3> corners{0, 1, 2};
  return {{corners, {1, 0, 0}, 1},
          {corners, {0, 1, 0}, 1},
          {corners, {0, 0, 1}, 1},
          {corners, {0.25f, 0.25f, 0.5f}, 1}};
}

const std::vector<bool> first_alone{true, false, false};

/// With x at the first corner: x^2 at the corner and (x / 4 - 2)^2 in the middle are to be least.
/// Their slopes come to 17/16 x = 1/2, but the vertex is held at 0 by 1/20 of 1 + 1/4.
TEST(FittedValues, AreThoseOfTheLeastSquares) {
  std::vector<double> values{0, 0, 0};
  fit_values(1, corners_and_middle(), first_alone, std::array{0.0, 0.0, 0.0, 2.0}, values);
  EXPECT_NEAR(values[0], 0.5 / (17.0 / 16 + 0.05 * 1.25), 1e-3) << "the second pass is held too";
  EXPECT_EQ(values[1], 0);
  EXPECT_EQ(values[2], 0);
}

TEST(FittedValues, StayWithinWhatIsWanted) {
  std::vector<double> values{1, 0, 0};
  fit_values(1, corners_and_middle(), first_alone, std::array{1.0, 0.0, 0.0, 1.0}, values);
  EXPECT_EQ(values[0], 1) << "1.1 would be better, and is nowhere";
}

TEST(FittedValues, OfAConstantAreTheConstant) {
  const double tenth = 0.1;
  std::vector<double> values(3, tenth);
  fit_values(1, corners_and_middle(), {true, true, true}, std::vector<double>(4, tenth), values);
  EXPECT_EQ(values, std::vector<double>(3, tenth));
}

TEST(FittedValues, EachComponentHasItsOwn) {
  std::vector<double> one{0, 0, 0}, other{7, 7, 7}, both{0, 7, 0, 7, 0, 7};
  const std::vector<bool> all(3, true);
  fit_values(1, corners_and_middle(), all, std::array{0.0, 0.0, 0.0, 2.0}, one);
  fit_values(1, corners_and_middle(), all, std::array{7.0, 9.0, 3.0, 5.0}, other);
  fit_values(2, corners_and_middle(), all, std::array{0.0, 7.0, 0.0, 9.0, 0.0, 3.0, 2.0, 5.0},
             both);
  EXPECT_EQ(both, (std::vector{one[0], other[0], one[1], other[1], one[2], other[2]}));
}

TEST(FittedValues, WhatIsNoNumberHasNoSay) {
  std::vector<double> values{0, 0, 0};
  fit_values(1, corners_and_middle(), first_alone, std::array{0.0, 0.0, 0.0, no_number}, values);
  EXPECT_EQ(values, std::vector<double>(3, 0));
  values[2] = no_number;
  fit_values(1, corners_and_middle(), first_alone, std::array{5.0, 0.0, 0.0, 2.0}, values);
  EXPECT_EQ(values[0], 0) << "a corner of the triangle has no number";
}

TEST(FittedValues, WhatLiesNowhereWeighsNothing) {
  std::vector<FitPoint> points = corners_and_middle();
  points.back() = {{}, glm::vec3(0.0f), 0};
  std::vector<double> values{0, 0, 0};
  fit_values(1, points, first_alone, std::array{0.0, 0.0, 0.0, 2.0}, values);
  EXPECT_EQ(values, std::vector<double>(3, 0));
}

/// A sphere with grey land and sea, and a border that is a face or two wide.
MeshData land_and_sea(int size) {
  return painted_sphere(size, "grey", 1, [](double height) {
    return std::vector{60 + 120 * std::clamp(0.5 + 5 * height, 0.0, 1.0)};
  });
}

double rms(const MeshData& a, const MeshData& b) {
  return measure::compare_fields(a, b, 1).at(0).rms;
}

/// The same array as one that is no colour is taken at the places of the vertices.
TEST(FittedValues, ColoursOfASurfaceAreCloserThanThoseAtItsVertices) {
  MeshData colours = make_sample("sphere", 40);
  colours.attributes = {field(colours, "shade", 0, [](const glm::dvec3& p) {
    return 0.5 + 0.5 * std::sin(6 * glm::normalize(p).x);
  })};
  MeshData numbers = colours;
  colours.attributes[0].meaning = Meaning::Colour;
  const MeshData fitted = decimated(colours, 0.1).mesh, taken = decimated(numbers, 0.1).mesh;
  ASSERT_EQ(fitted.positions, taken.positions);
  EXPECT_LT(rms(colours, fitted), 0.6 * rms(numbers, taken));
}

TEST(FittedValues, ColoursAreNotStrongerThanThoseAround) {
  const MeshData mesh = land_and_sea(40), result = decimated(mesh, 0.1).mesh;
  const std::vector<double>& grey = result.attributes[0].values;
  EXPECT_EQ(*std::min_element(grey.begin(), grey.end()), 60);
  EXPECT_EQ(*std::max_element(grey.begin(), grey.end()), 180);
}

TEST(FittedValues, DoNotDependOnThreads) {
  const MeshData mesh = land_and_sea(20);
  EXPECT_EQ(decimated(mesh, 0.2, 1).mesh, decimated(mesh, 0.2, 3).mesh);
}

TEST(FittedValues, OfVerticesThatStayAreTheirOwn) {
  const MeshData mesh = land_and_sea(10);
  MeshData result = mesh;
  result.attributes.clear();
  result.positions[5] *= 1.01;
  (void)io::carry_along(mesh, result);
  std::vector<double> before = mesh.attributes[0].values, after = result.attributes[0].values;
  for (std::vector<double>* values : {&before, &after}) values->erase(values->begin() + 5);
  EXPECT_EQ(after, before);
}

/// An array of floats that are colours may have none at some vertices.
TEST(FittedValues, OfColoursThatAreNoNumbersStayNone) {
  MeshData mesh = land_and_sea(20);
  Attribute& grey = mesh.attributes[0];
  grey.integer = false;
  grey.type = NumberType::Float32;
  std::fill(grey.values.begin(), grey.values.end(), no_number);
  const MeshData none = decimated(mesh, 0.2).mesh;
  for (const double x : none.attributes[0].values) EXPECT_TRUE(std::isnan(x));
}

}  // namespace
}  // namespace aomd::test::fitted_values_test
