// The tetrahedra around a vertex, seen from it, and the geometry of one.

#include <gtest/gtest.h>

#include <numbers>

#include "core/mesh/tet_geometry.h"
#include "core/operators/ball.h"
#include "tests/support/zoo.h"

namespace aomd::ball_test {
namespace {

TEST(BallTest, EachTetrahedronStandsUprightFromEachOfItsVertices) {
  Mesh mesh(zoo::one_tet());
  const Request up = mesh.request(0, 3);
  for (const Vertex v : mesh.vertices()) {
    Ball ball;
    gather(mesh, v, ball);
    ASSERT_EQ(ball.size(), 1u);
    const BallRegion& r = ball[0];
    EXPECT_EQ(mesh.tetrahedron(r.region)[r.slot], v);
    EXPECT_FALSE(r.uses(v));
    EXPECT_DOUBLE_EQ(six_volumes(mesh.position(v), mesh.position(r.others[0]),
                                 mesh.position(r.others[1]), mesh.position(r.others[2])),
                     1.0);
  }
}

TEST(BallTest, OnlyModelFacesAreGathered) {
  MeshData data = zoo::one_tet();
  data.faces = {};
  data.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 1));
  data.faces.add(Shape::Triangle, {0, 1, 3}, ModelRef(3, 1));
  Mesh mesh(data);
  const Request rows = mesh.request_listed(0, 2);
  Star star;
  gather_model_faces(mesh, Vertex(0), star);
  ASSERT_EQ(star.size(), 1u);
  EXPECT_EQ(star[0].face, Face(0));
}

TEST(TetGeometryTest, ShapeIsOneForTheRegularOneAndAngleIsItsOwn) {
  const glm::dvec3 a(1, 1, 1), b(-1, 1, -1), c(1, -1, -1), d(-1, -1, 1);
  const double sign = six_volumes(a, b, c, d) > 0 ? 1 : -1;
  EXPECT_NEAR(sign * tet_shape(a, b, c, d), 1, 1e-15);
  EXPECT_NEAR(smallest_dihedral_cosine(a, b, c, d), 1.0 / 3, 1e-15);
  EXPECT_NEAR(-sign * tet_shape(b, a, c, d), 1, 1e-15) << "inside out";
}

TEST(TetGeometryTest, SmallestDihedralOfACorner) {
  // Three right angles at the corner, and three of atan(sqrt 2) at the face opposite to it.
  EXPECT_NEAR(smallest_dihedral_cosine({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
              1 / std::numbers::sqrt3, 1e-15);
}

TEST(TetGeometryTest, UprightMeansBeyondRounding) {
  const glm::dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_TRUE(is_upright(a, b, c, {0, 0, 1e-9}));
  EXPECT_FALSE(is_upright(a, b, c, {0, 0, 1e-15}));
  EXPECT_FALSE(is_upright(a, b, c, {0, 0, -1}));
  EXPECT_EQ(smallest_dihedral_cosine(a, b, {2, 0, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(tet_shape(a, a, a, a), 0);
}

}  // namespace
}  // namespace aomd::ball_test
