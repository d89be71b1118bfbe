// Values on the corners of faces: seams, and what becomes of both when a surface is decimated.

#include <set>

#include <gtest/gtest.h>

#include "core/fields/seams.h"
#include "core/repair/repair.h"
#include "core/repair/triangulate.h"
#include "tests/support/field_helpers.h"

namespace aomd::test::carry_corners_test {
namespace {

/// Which side of the cube around a point is nearest, and where on it, each from -1 to 1.
struct OnCube {
  int side = 0;
  double u = 0, v = 0;
};

OnCube on_cube(const glm::dvec3& p) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(p[k]) > std::abs(p[axis])) axis = k;
  const double scale = std::abs(p[axis]);
  return {2 * axis + (p[axis] > 0), p[(axis + 1) % 3] / scale, p[(axis + 2) % 3] / scale};
}

/// A sphere as a cube of n x n cells a side, with one chart for each: all of it is one piece, and
/// texture coordinates jump by 10 from side to side.
MeshData cube_sphere(int n) {
  MeshData mesh;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto [at, fresh] =
        known.try_emplace(c, static_cast<std::uint32_t>(mesh.positions.size()));
    if (fresh) mesh.positions.push_back(glm::normalize(glm::dvec3(c[0], c[1], c[2])));
    return at->second;
  };
  Attribute uv{"uv", 2, 2, false, {}};
  uv.meaning = Meaning::Texture;
  for (int side = 0; side < 6; ++side)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (const bool upper : {false, true}) {
          std::vector<std::array<int, 2>> at{{i, j}, {i + 1, j + 1}, {i, j + 1}};
          if (upper) at = {{i, j}, {i + 1, j}, {i + 1, j + 1}};
          const int axis = side / 2, sign = side % 2 == 0 ? -1 : 1;
          if (sign < 0) std::reverse(at.begin(), at.end());
          std::vector<std::uint32_t> v;
          for (const auto& [a, b] : at) {
            std::array<int, 3> c{};
            c[static_cast<std::size_t>(axis)] = sign * n;
            c[static_cast<std::size_t>((axis + 1) % 3)] = 2 * a - n;
            c[static_cast<std::size_t>((axis + 2) % 3)] = 2 * b - n;
            v.push_back(vertex(c));
            uv.values.push_back(10 * side + (2.0 * a - n) / n);
            uv.values.push_back((2.0 * b - n) / n);
          }
          mesh.faces.add(Shape::Triangle, {v[0], v[1], v[2]});
        }
  mesh.corners = {uv};
  return mesh;
}

Carried decimated_with_seams(const MeshData& original, double share, int threads = 1) {
  ClassifyOptions how;
  how.seams = fields::seams_of(original);
  return decimated(original, share, threads, how);
}

TEST(Seams, AreWhereCornersDiffer) {
  const MeshData mesh = cube_sphere(6);
  EXPECT_EQ(fields::seams_of(mesh).size(), 12u * 6);
  const fields::Cells faces(mesh, 2);
  const fields::Charts charts(faces, mesh.corners[0]);
  const std::vector<std::uint32_t> numbers = charts.numbers();
  EXPECT_EQ(std::set<std::uint32_t>(numbers.begin(), numbers.end()).size(), 6u);
  MeshData smooth = mesh;
  smooth.corners[0].values.assign(smooth.corners[0].values.size(), 1);
  EXPECT_TRUE(fields::seams_of(smooth).empty());
  smooth = mesh;
  smooth.corners[0].meaning = Meaning::Normal;
  EXPECT_TRUE(fields::seams_of(smooth).empty()) << "facets have jumps everywhere";
}

TEST(Seams, BecomeModelEdges) {
  const MeshData data = cube_sphere(6);
  Mesh mesh(data), other(data);
  ClassifyOptions how;
  how.feature_angle_deg = {};
  how.seams = fields::seams_of(data);
  const ClassifyResult with = classify(mesh, how);
  EXPECT_EQ(with.model_edges, 12);
  EXPECT_EQ(with.model_vertices, 8);
  EXPECT_EQ(with.model_faces, 6);
  how.seams.clear();
  EXPECT_EQ(classify(other, how).model_faces, 1);
}

TEST(Corners, StayOnTheirSideOfASeam) {
  const MeshData mesh = cube_sphere(20);
  const Carried result = decimated_with_seams(mesh, 0.1);
  EXPECT_TRUE(result.along.notes.empty());
  ASSERT_LT(result.mesh.faces.size(), mesh.faces.size() / 8);
  ASSERT_EQ(result.mesh.corners.size(), 1u);
  const Attribute& uv = result.mesh.corners[0];
  EXPECT_EQ(uv.meaning, Meaning::Texture);
  ASSERT_EQ(uv.values.size(), 2 * result.mesh.faces.vertices.size());
  const fields::Cells faces(result.mesh, 2);
  double worst = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const int side = on_cube(faces.centre(f)).side;
    for (std::size_t k = 0; k < 3; ++k) {
      const double u = uv.values[6 * f + 2 * k], v = uv.values[6 * f + 2 * k + 1];
      ASSERT_NEAR(u, 10 * side, 1 + 1e-9) << "another chart";
      const int axis = side / 2;
      const glm::dvec3 p = faces.corner(f, k);
      worst = std::max({worst, std::abs(u - 10 * side - p[(axis + 1) % 3] / std::abs(p[axis])),
                        std::abs(v - p[(axis + 2) % 3] / std::abs(p[axis]))});
    }
  }
  EXPECT_LT(worst, 0.05) << "of 2";
  EXPECT_EQ(fields::Charts(faces, uv).seams().size(), fields::seams_of(result.mesh).size());
  const std::vector<std::uint32_t> numbers = fields::Charts(faces, uv).numbers();
  EXPECT_EQ(std::set<std::uint32_t>(numbers.begin(), numbers.end()).size(), 6u)
      << "no seam that was not there";
}

/// Both sides of one seam belong to the same chart.
TEST(Corners, OnACylinderWithOneSeam) {
  const std::uint32_t n = 48, rows = 12;
  MeshData mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i < n; ++i)
      mesh.positions.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0.2 * j);
  Attribute uv{"uv", 2, 2, false, {}};
  uv.meaning = Meaning::Texture;
  const auto add = [&](std::array<std::array<std::uint32_t, 2>, 3> at) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = at[k][1] * n + at[k][0] % n;
      uv.values.push_back(static_cast<double>(at[k][0]) / n);
      uv.values.push_back(static_cast<double>(at[k][1]) / rows);
    }
    mesh.faces.add(Shape::Triangle, {v[0], v[1], v[2]});
  };
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
      add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  mesh.corners = {uv};
  const MeshData result = decimated_with_seams(mesh, 0.2).mesh;
  ASSERT_LT(result.faces.size(), mesh.faces.size() / 4);
  const fields::Cells faces(result, 2);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const glm::dvec3 c = faces.centre(f);
    const double angle = std::atan2(c.y, c.x), own = angle / (2 * M_PI) + (angle < 0);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(result.corners[0].values[6 * f + 2 * k], own, 0.2) << f;
      ASSERT_NEAR(result.corners[0].values[6 * f + 2 * k + 1], faces.corner(f, k).z / 2.4, 0.02);
    }
  }
}

TEST(Corners, FacesThatStayKeepTheirBits) {
  const MeshData mesh = cube_sphere(4);
  MeshData result = mesh;
  result.corners.clear();
  result.positions[0] *= 0.99;
  (void)io::carry_along(mesh, result);
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c) {
    const std::size_t f = c / 3 * 3;
    const bool moved = mesh.faces.vertices[f] == 0 || mesh.faces.vertices[f + 1] == 0 ||
                       mesh.faces.vertices[f + 2] == 0;
    if (moved) continue;
    EXPECT_EQ(result.corners[0].values[2 * c], mesh.corners[0].values[2 * c]);
    EXPECT_EQ(result.corners[0].values[2 * c + 1], mesh.corners[0].values[2 * c + 1]);
  }
}

TEST(Corners, TheSameForAnyNumberOfThreads) {
  const MeshData mesh = cube_sphere(8);
  EXPECT_TRUE(decimated_with_seams(mesh, 0.3, 1).mesh == decimated_with_seams(mesh, 0.3, 3).mesh);
}

TEST(Corners, FollowRepairAndTriangulation) {
  MeshData quads;
  quads.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  quads.faces.add(Shape::Quad, {0, 1, 2, 3});
  Attribute uv{"uv", 2, 2, false, {0, 0, 5, 0, 5, 5, 0, 5}};
  uv.meaning = Meaning::Texture;
  quads.corners = {uv};
  EXPECT_EQ(triangulate_quads(quads), 1u);
  ASSERT_EQ(quads.corners[0].values.size(), 12u);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_EQ(quads.corners[0].values[2 * c], 5 * quads.positions[quads.faces.vertices[c]].x);
  std::swap(quads.faces.vertices[4], quads.faces.vertices[5]);  // turned over
  std::swap_ranges(quads.corners[0].values.begin() + 8, quads.corners[0].values.begin() + 10,
                   quads.corners[0].values.begin() + 10);
  (void)repair(quads);
  ASSERT_EQ(quads.corners[0].values.size(), 12u);
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(quads.corners[0].values[2 * c], 5 * quads.positions[quads.faces.vertices[c]].x);
    EXPECT_EQ(quads.corners[0].values[2 * c + 1], 5 * quads.positions[quads.faces.vertices[c]].y);
  }
}

}  // namespace
}  // namespace aomd::test::carry_corners_test
