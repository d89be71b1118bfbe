// Clipping, shrinking and the edges inside: of surfaces and of volumes.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "tests/support/view_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::scene::inside_view_test {
namespace {

using test::corners;
using test::cubes;
using test::drive;
using test::load;

double area(std::span<const Corner> corners) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    sum += 0.5 * glm::length(glm::cross(corners[i + 1].position - corners[i].position,
                                        corners[i + 2].position - corners[i].position));
  return sum;
}

std::size_t drawn(std::span<const Corner> corners) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    count += corners[i].position != corners[i + 1].position;
  return count;
}

TEST(Clip, OfASurfaceByWholeFaces) {
  Session s;
  load(s, zoo::grid(4));  // 4 x 4 squares of two faces
  drive(s, {"clip x 0.5 cells"});
  EXPECT_EQ(drawn(corners(s)), 16u);
  drive(s, {"clip x 0.25 cells"});
  EXPECT_EQ(drawn(corners(s)), 8u);
  drive(s, {"clip x 0.25 cells flip"});
  EXPECT_EQ(drawn(corners(s)), 24u);
  drive(s, {"clip x 0.25"});
  EXPECT_EQ(drawn(corners(s)), 32u) << "cutting is the renderer's";
  drive(s, {"clip off"});
  EXPECT_FALSE(s.view.clip);
}

TEST(Clip, OfAVolumeByWholeRegionsShowsTheirNeighbours) {
  Session s;
  load(s, cubes(2));
  drive(s, {"clip z 0.5 cells"});
  EXPECT_EQ(drawn(corners(s)), 2u * (2 * 4 + 4 * 2));  // a plate of 2 x 2 x 1
  EXPECT_NEAR(area(corners(s)), 16, 1e-5);
  drive(s, {"clip z 0 cells"});
  EXPECT_EQ(drawn(corners(s)), 0u);
}

TEST(Clip, FacesOfTheFileGoWithTheirRegions) {
  MeshData data = cubes(2);
  const std::uint32_t m = 3, top = 2;
  data.faces.add(Shape::Quad, {top, m * m + top, m * m + m + top, m + top}, ModelRef(2, 7));
  Session s;
  load(s, data);
  drive(s, {"clip z 0.5 cells"});
  EXPECT_EQ(drawn(corners(s)), 32u);
  drive(s, {"clip z 0.5 cells flip"});
  EXPECT_EQ(drawn(corners(s)), 32u);
}

/// Triangles in the outermost planes across an axis, and how far a corner's normal is from theirs.
std::pair<int, float> shading_of_walls(std::span<const Corner> corners, int axis) {
  float low = 0, high = 0;
  for (const Corner& c : corners) {
    low = std::min(low, c.position[axis]);
    high = std::max(high, c.position[axis]);
  }
  std::pair<int, float> result{0, 0.0f};
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const float at = corners[i].position[axis];
    if (at != low && at != high) continue;
    if (corners[i + 1].position[axis] != at || corners[i + 2].position[axis] != at) continue;
    ++result.first;
    for (std::size_t k = i; k < i + 3; ++k)
      result.second = std::max(result.second, 1 - std::abs(unpack_normal(corners[k].normal)[axis]));
  }
  return result;
}

TEST(Clip, WhatIsCutOpenDoesNotShadeTheOutsideBesideIt) {
  Session s;
  drive(s, {"sample ball-in-box 1", "clip y 0.5 cells flip", "step 10"});
  for (const int axis : {0, 2}) {
    const auto [triangles, worst] = shading_of_walls(corners(s), axis);
    EXPECT_GT(triangles, 8) << axis;
    EXPECT_LT(worst, 1e-3f) << axis;
  }
}

TEST(Clip, CutsASectionThroughEveryRegion) {
  Session s;
  load(s, cubes(2));
  drive(s, {"clip x 0.25"});
  const auto cells = s.sheet().drawing().drawable().cells.values();
  EXPECT_EQ(cells.size(), 3u * 2 * 4);
  EXPECT_NEAR(area(cells), 4, 1e-5);
  for (const Corner& corner : cells) {
    EXPECT_NEAR(corner.position.x, -0.5, 1e-4);
    EXPECT_LT(corner.position.x, -0.5) << "a hair inside, where the plane does not clip it";
    EXPECT_GT(unpack_normal(corner.normal).x, 0.99);
  }
  for (std::size_t i = 0; i < cells.size(); i += 3)
    EXPECT_GT(glm::cross(cells[i + 1].position - cells[i].position,
                         cells[i + 2].position - cells[i].position)
                  .x,
              0)
        << "seen from what is cut off";
  drive(s, {"clip x 0.25 flip"});
  EXPECT_LT(unpack_normal(s.sheet().drawing().drawable().cells[0].normal).x, -0.99);
  drive(s, {"hide region:1"});
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 0u);
}

/// Of two materials, which share a face in the plane x = 0.
MeshData two_tets() {
  MeshData data;
  data.positions = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}};
  data.regions.add(Shape::Tetrahedron, {0, 2, 1, 3}, ModelRef(3, 1));
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 4}, ModelRef(3, 2));
  return data;
}

TEST(Clip, APlaneThroughSidesShowsWhatStays) {
  Session s;
  load(s, two_tets());
  const auto cells = [&] { return s.sheet().drawing().drawable().cells.values(); };
  for (const auto& [line, tag] : {std::pair{"clip x 0.5", 1}, {"clip x 0.5 flip", 2}}) {
    drive(s, {line});
    ASSERT_EQ(cells().size(), 3u) << line;
    EXPECT_NEAR(area(cells()), 0.5, 1e-6) << line;
    for (const Corner& c : cells()) EXPECT_EQ(c.color, color_of(ModelRef(3, tag))) << line;
  }
  drive(s, {"clip x 0.5", "hide region:1"});
  EXPECT_EQ(cells().size(), 0u) << "what only touches the plane lies behind it";
}

TEST(Clip, APlaneThroughSidesThatAreRoundedShowsWhatStays) {
  Session s;
  MeshData data = two_tets();
  data.positions[1].x = 1e-12;
  data.positions[2].x = -1e-12;
  load(s, data);
  drive(s, {"clip x 0.5", "hide region:1"});
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 0u);
}

TEST(Clip, WholeCellsLeaveNoModelEdgeInTheAir) {
  for (const char* sample : {"sample tet-box 3", "sample ball-in-box 2", "sample bracket 3"})
    for (const char* clip : {"clip x 0.45 cells", "clip y 0.3 cells flip", "clip z 0.52 cells"}) {
      Session s;
      drive(s, {sample, clip});
      std::set<std::array<float, 3>> places;
      const auto place = [](const glm::vec3& p) { return std::array{p.x, p.y, p.z}; };
      for (std::size_t i = 0; i + 2 < corners(s).size(); i += 3)
        for (std::size_t k = i; corners(s)[i].position != corners(s)[i + 1].position && k < i + 3;
             ++k)
          places.insert(place(corners(s)[k].position));
      const Drawable& drawable = s.sheet().drawing().drawable();
      std::size_t edges = 0;
      for (const Segment& e : drawable.model_edges.values()) {
        if (e.width_px == 0) continue;
        ++edges;
        EXPECT_TRUE(places.contains(place(e.a)) && places.contains(place(e.b)))
            << sample << ", " << clip;
      }
      EXPECT_GT(edges, 0u);
      for (const Disc& d : drawable.model_vertices.values())
        EXPECT_TRUE(d.radius_px == 0 || places.contains(place(d.center))) << sample << ", " << clip;
    }
}

TEST(Clip, SectionsOfTetrahedraFillTheSquare) {
  Session s;
  drive(s, {"sample mixed", "clip z 0.37"});
  const Box& box = s.document().content().bounds;
  const double square = (box.high.x - box.low.x) * (box.high.y - box.low.y);
  EXPECT_NEAR(area(s.sheet().drawing().drawable().cells.values()), square, 1e-4 * square);
  drive(s, {"clip off"});
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 0u);
}

TEST(Shrink, PullsFacesAndRegionsToTheirMiddles) {
  Session s;
  load(s, zoo::triangle());
  const double whole = area(corners(s));
  drive(s, {"shrink 0.5"});
  EXPECT_NEAR(area(corners(s)), 0.25 * whole, 1e-6);
  load(s, cubes(2));
  drive(s, {"shrink 0.5"});
  EXPECT_EQ(drawn(corners(s)), 0u);
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 3u * 12 * 8);
  EXPECT_NEAR(area(s.sheet().drawing().drawable().cells.values()), 8 * 6 * 0.25, 1e-5);
  drive(s, {"clip x 0.5 cells"});
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 3u * 12 * 4);
  drive(s, {"shrink 0", "clip off"});
  EXPECT_EQ(s.sheet().drawing().drawable().cells.size(), 0u);
  EXPECT_THROW(execute(s, "shrink 1"), CommandError);
}

TEST(InteriorEdges, AreThoseOnNoOuterSide) {
  Session s;
  load(s, cubes(2));
  EXPECT_EQ(s.sheet().drawing().drawable().interior_edges.size(), 0u);
  drive(s, {"show interior-edges on"});
  EXPECT_EQ(s.sheet().drawing().drawable().interior_edges.size(), 6u);
  drive(s, {"clip x 0.5 cells"});
  EXPECT_EQ(s.sheet().drawing().drawable().interior_edges.size(), 1u)
      << "what was inside now lies outside";
}

TEST(Clip, CommandsSayWhatIsWrong) {
  Session s;
  load(s, zoo::square());
  for (const char* line :
       {"clip", "clip w 0.5", "clip x", "clip x 1.5", "clip x 0.5 sideways", "clip off 3"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  drive(s, {"clip Y 0.75 cells flip"});
  EXPECT_EQ(s.view.clip, (Clip{1, 0.75, true, true}));
}

}  // namespace
}  // namespace aomd::scene::inside_view_test
