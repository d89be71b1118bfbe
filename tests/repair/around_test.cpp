// The corners around vertices while faces change: rows keep their order, gaps are closed unseen.

#include "core/repair/around.h"
#include "tests/support/repair_helpers.h"

namespace aomd::test::around_test {
namespace {

using repair_detail::Around;
using repair_detail::AtSide;
using repair_detail::Surface;
using zoo::make;

//  3--2--5
//  | /| /|     two squares in two triangles each
//  |/ |/ |
//  0--1--4
MeshData squares() {
  return make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
              {{0, 1, 2}, {0, 2, 3}, {1, 5, 2}, {1, 4, 5}});
}

std::vector<std::uint32_t> faces_at(const Surface& surface, const Around& around, std::uint32_t v) {
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t c : around.corners(v)) faces.push_back(surface.face_of(c));
  return faces;
}

using Ids = std::vector<std::uint32_t>;

TEST(AroundTest, WhatIsAddedComesLastAndTheRestKeepsItsOrder) {
  MeshData data = squares();
  Surface surface(data);
  Around around(surface);
  EXPECT_EQ(faces_at(surface, around, 2), (Ids{0, 1, 2}));
  const std::uint32_t corner = surface.first_corner(0) + 2;  // of face 0 at vertex 2
  around.remove(corner);
  EXPECT_EQ(around.count(2), 2u);
  around.add(corner);
  EXPECT_EQ(around.count(2), 3u);
  EXPECT_EQ(faces_at(surface, around, 2), (Ids{1, 2, 0}));
  around.remove(surface.first_corner(1) + 1);
  around.remove(corner);
  EXPECT_EQ(faces_at(surface, around, 2), (Ids{2}));
}

TEST(AroundTest, ACornerMovesToAnotherVertex) {
  MeshData data = squares();
  Surface surface(data);
  Around around(surface);
  const std::uint32_t corner = surface.first_corner(2);  // of face 2 at vertex 1
  around.remove(corner);
  surface.set_vertex(corner, 4);
  around.add(corner);
  EXPECT_EQ(faces_at(surface, around, 1), (Ids{0, 3}));
  EXPECT_EQ(faces_at(surface, around, 4), (Ids{3, 2}));
  EXPECT_EQ(around.neighbours(4), (Ids{1, 2, 5}));
}

TEST(AroundTest, SidesAreOfTheFacesThatHaveThem) {
  MeshData data = squares();
  Surface surface(data);
  const Around around(surface);
  const AtSide inside = around.at_side(2, 1);
  EXPECT_EQ(inside.count(), 2u);
  EXPECT_EQ(Ids(inside.first().begin(), inside.first().end()), (Ids{0, 2}));
  EXPECT_EQ(around.at_side(0, 1).count(), 1u);
  EXPECT_EQ(around.at_side(3, 5).count(), 0u);
  EXPECT_TRUE(around.meet(1, 2));
  EXPECT_FALSE(around.meet(0, 5));
  EXPECT_TRUE(around.at_border(2));
  EXPECT_EQ(around.met(0), (Ids{1, 2, 2, 3}));
}

}  // namespace
}  // namespace aomd::test::around_test
