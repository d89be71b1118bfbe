// Numbers as colours of a volume: on its skin, on sections, and inside.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "core/measure/volume_statistics.h"
#include "tests/support/view_helpers.h"

namespace aomd::scene::volume_colors_test {
namespace {

using test::corners;
using test::drive;
using test::load;

/// The corner of a cube: edges of 1 and of sqrt(2), dihedral angles of 90 and of acos(1/sqrt(3)).
MeshData corner_tet() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, ModelRef(3, 1));
  return data;
}

const double corner_dihedral_deg = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi;

std::span<const Corner> cells(Session& s) {
  s.refresh();
  return s.sheet().drawing().drawable().cells.values();
}

TEST(VolumeColors, QualityIsTheSmallestDihedralAngleOfTheRegion) {
  Session s;
  load(s, corner_tet());
  drive(s, {"color quality"});
  const ScalarField& field = *s.sheet().field();
  EXPECT_DOUBLE_EQ(field.scale.low, 0);
  EXPECT_NEAR(field.scale.high, std::acos(1.0 / 3) * 180 / std::numbers::pi, 1e-9);
  const Color color = field.scale.color(corner_dihedral_deg);
  ASSERT_EQ(corners(s).size(), 12u);
  for (const Corner& c : corners(s)) EXPECT_EQ(c.color, color);
  for (const char* line : {"clip x 0.5", "shrink 0.2"}) {
    drive(s, {line});
    ASSERT_FALSE(cells(s).empty());
    for (const Corner& c : cells(s)) EXPECT_EQ(c.color, color) << line;
  }
}

TEST(VolumeColors, SpacingRunsAcrossSections) {
  Session s;
  load(s, corner_tet());
  drive(s, {"color spacing", "factor 4"});
  const double low = 4, high = 4 * (1 + 2 * std::sqrt(2.0)) / 3;
  const FieldScale& scale = s.sheet().field()->scale;
  EXPECT_DOUBLE_EQ(scale.low, low);
  EXPECT_DOUBLE_EQ(scale.high, high);
  // Half-way from the corner of the cube to another vertex, and between two others.
  drive(s, {"clip x 0.5"});
  ASSERT_EQ(cells(s).size(), 3u);
  for (const Corner& c : cells(s)) {
    const glm::dvec3 at = glm::dvec3(c.position) + s.sheet().drawing().drawable().origin;
    const bool on_axis = std::abs(at.y) < 1e-6 && std::abs(at.z) < 1e-6;
    EXPECT_EQ(c.color, scale.color(static_cast<float>(on_axis ? (low + high) / 2 : high)));
  }
}

TEST(VolumeColors, ModelFacesAreHeldAgainstThemselves) {
  Session s;
  drive(s, {"sample ball-in-box 3", "coarsest on", "angle 60", "run", "color distance"});
  const FieldScale& scale = s.sheet().field()->scale;
  ASSERT_GT(scale.high, 0);
  const Box& box = s.document().content().bounds;
  std::size_t on_box = 0, on_ball = 0;
  for (std::size_t i = 0; i + 2 < corners(s).size(); i += 3) {
    if (corners(s)[i].position == corners(s)[i + 1].position) continue;
    bool wall = false;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {box.low[axis], box.high[axis]})
        wall = wall || std::all_of(&corners(s)[i], &corners(s)[i] + 3, [&](const Corner& c) {
                 return std::abs(c.position[axis] + s.sheet().drawing().drawable().origin[axis] -
                                 side) < 1e-6;
               });
    if (wall) {
      EXPECT_EQ(corners(s)[i].color, scale.color(0)) << "planes stay where they are";
    }
    ++(wall ? on_box : on_ball);
  }
  EXPECT_GT(on_box, 0u);
  EXPECT_GT(on_ball, 0u);
}

TEST(VolumeColors, WhatLiesOnNoModelFaceHasNoDistance) {
  Session s;
  drive(s, {"sample ball-in-box 3", "coarsest on", "angle 60", "run", "color distance",
            "clip x 0.4 cells"});
  const auto all = corners(s);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const Corner& c) { return c.color == plain_face_color(); }));
}

using Drawn = std::tuple<float, float, float, Color>;

std::vector<Drawn> drawn(Session& s) {
  std::vector<Drawn> all;
  const auto add = [&](std::span<const Corner> corners) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      for (std::size_t k = i; corners[i].position != corners[i + 1].position && k < i + 3; ++k)
        all.emplace_back(corners[k].position.x, corners[k].position.y, corners[k].position.z,
                         corners[k].color);
  };
  add(corners(s));
  add(cells(s));
  std::sort(all.begin(), all.end());
  return all;
}

TEST(VolumeColors, PatchesEndInTheSameColours) {
  for (const char* color : {"color quality", "color spacing", "color distance"}) {
    Session patched, anew;
    drive(patched, {"sample ball-in-box 2", "clip y 0.4 flip", color});
    for (int i = 0; i < 40; ++i) drive(patched, {"step 1"});
    drive(anew, {"sample ball-in-box 2", "step 40", "clip y 0.4 flip", color});
    EXPECT_EQ(drawn(patched), drawn(anew)) << color;
  }
}

TEST(VolumeColors, WhatIsNotDecimatedHasNoSpacing) {
  Session s;
  drive(s, {"sample hex-box 2", "color spacing"});
  EXPECT_EQ(s.sheet().field(), nullptr);
  drive(s, {"color distance"});
  EXPECT_EQ(s.sheet().field(), nullptr);
  drive(s, {"color quality"});
  ASSERT_NE(s.sheet().field(), nullptr);
  for (const Corner& c : corners(s)) EXPECT_EQ(c.color, s.sheet().field()->scale.color(90));
}

}  // namespace
}  // namespace aomd::scene::volume_colors_test
