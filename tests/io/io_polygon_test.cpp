#include "core/io/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/samples/numeric.h"

namespace aomd::io::detail::io_polygon_test {
namespace {

using Points = std::vector<glm::dvec3>;
using Triangles = std::vector<std::uint32_t>;

Triangles split(const Points& points) {
  Triangles polygon(points.size()), out;
  for (std::uint32_t i = 0; i < polygon.size(); ++i) polygon[i] = i;
  triangulate(points, polygon, out);
  return out;
}

glm::dvec3 area_of(const Points& p, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return glm::cross(p[b] - p[a], p[c] - p[a]) * 0.5;
}

/// Every triangle on the polygon's side, and their areas as large as the polygon's: no overlap,
/// nothing missing.
void expect_sound(const Points& points, const char* name) {
  const Triangles t = split(points);
  ASSERT_EQ(t.size(), 3 * (points.size() - 2)) << name;
  glm::dvec3 whole(0);
  for (std::size_t i = 0; i < points.size(); ++i)
    whole += glm::cross(points[i], points[(i + 1) % points.size()]) * 0.5;
  double sum = 0;
  for (std::size_t i = 0; i < t.size(); i += 3) {
    const glm::dvec3 area = area_of(points, t[i], t[i + 1], t[i + 2]);
    EXPECT_GE(glm::dot(area, whole), -1e-12) << name;
    sum += glm::length(area);
  }
  EXPECT_NEAR(sum, glm::length(whole), 1e-9 * sum) << name;
}

TEST(Polygon, QuadsTakeTheShorterDiagonal) {
  EXPECT_EQ(split({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}}), (Triangles{0, 1, 3, 1, 2, 3}));
  EXPECT_EQ(split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{0, 1, 2, 0, 2, 3}));
}

//  c--__       the shorter diagonal a-c runs outside, behind the concave corner d
//   d  __b
//  a--
TEST(Polygon, ConcaveQuadsDoNotFold) {
  const Points dart{{0, 0, 0}, {4, 0.5, 0}, {0, 1, 0}, {1, 0.5, 0}};
  for (int turn = 0; turn < 4; ++turn) {
    Points turned = dart;
    std::rotate(turned.begin(), turned.begin() + turn, turned.end());
    expect_sound(turned, "dart");
    std::reverse(turned.begin(), turned.end());
    expect_sound(turned, "dart, reversed");
  }
}

TEST(Polygon, ConcavePolygonsInEveryPlane) {
  const double outline[][2] = {{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {3, 1},
                               {3, 4}, {2, 4}, {2, 1}, {1, 1}, {1, 4}, {0, 4}};
  for (int axis = 0; axis < 3; ++axis) {
    Points points;
    for (const auto& [u, v] : outline) {
      glm::dvec3 p(u + 100);
      p[axis] = 0.3 * u + 0.2 * v;
      p[(axis + 1) % 3] = u, p[(axis + 2) % 3] = v;
      points.push_back(p);
    }
    expect_sound(points, "comb");
    std::reverse(points.begin(), points.end());
    expect_sound(points, "comb, reversed");
  }
}

TEST(Polygon, CornersOnStraightSides) {
  expect_sound(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},
      "square with midpoints");
}

TEST(Polygon, StarsOfManyCorners) {
  for (const std::size_t n : {7u, 50u, 1000u, 4000u}) {
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 p = (1.5 + sample::hashed(i)) *
                           sample::on_circle(static_cast<double>(i) / static_cast<double>(n));
      points.emplace_back(p.x, p.y, 0);
    }
    expect_sound(points, "star");
  }
}

TEST(Polygon, WithoutAreaStillGivesTriangles) {
  EXPECT_EQ(split(Points(6, glm::dvec3(1))).size(), 12u);
  EXPECT_EQ(split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 9u);
  EXPECT_EQ(split({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 5, 0}}).size(), 9u)
      << "crosses itself";
}

}  // namespace
}  // namespace aomd::io::detail::io_polygon_test
