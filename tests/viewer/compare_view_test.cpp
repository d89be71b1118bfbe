// Numbers as colours, the mesh as loaded beside the present one, and histograms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/mesh/geometry.h"
#include "tests/support/view_helpers.h"
#include "tests/support/zoo.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene::compare_view_test {
namespace {

using test::corners;
using test::cubes;
using test::drive;
using test::load;

TEST(FieldScale, LinearAndLogarithmic) {
  FieldScale scale;
  EXPECT_EQ(scale.color(1), plain_face_color()) << "nothing has a colour on an empty scale";
  scale.add(0);
  scale.add(10);
  EXPECT_EQ(scale.color(0), ramp_color(0));
  EXPECT_EQ(scale.color(5), ramp_color(0.5f));
  EXPECT_EQ(scale.color(99), ramp_color(1));
  EXPECT_EQ(scale.color(std::nan("")), plain_face_color());
  scale.low = 1, scale.high = 100, scale.logarithmic = true;
  EXPECT_EQ(scale.color(10), ramp_color(0.5f));
  EXPECT_DOUBLE_EQ(scale.at(0.5), 10);
  EXPECT_EQ(scale.color(0), plain_face_color());
  scale.map = ColorMap::Magma;
  EXPECT_EQ(scale.color(100), ramp_color(1, ColorMap::Magma));
}

TEST(ColorQuality, IsTheSmallestAngleOfEachFace) {
  Session s;
  load(s, zoo::square());
  drive(s, {"color quality"});
  ASSERT_NE(s.sheet().field(), nullptr);
  for (const Corner& corner : corners(s))
    EXPECT_EQ(corner.color, ramp_color(0.75f)) << "45 of 60 degrees";
}

TEST(ColorDistance, IsNothingAsLoadedAndMeasuredAfterwards) {
  Session s;
  drive(s, {"sample sphere 12", "color distance"});
  ASSERT_NE(s.sheet().field(), nullptr);
  EXPECT_EQ(s.sheet().field()->scale.high, 0);
  drive(s, {"strategy paper", "angle 60", "factor 8", "sweep"});
  ASSERT_GT(s.sheet().field()->scale.high, 0);
  const Mesh& mesh = s.document().mesh();
  const double percent = 100 / s.document().content().bounds.diagonal();
  double worst = 0;
  for (const Face f : mesh.faces()) {
    const double expected =
        percent * face_distance(mesh, f, s.document().copy_mesh_as_loaded().tree());
    EXPECT_NEAR(s.sheet().field()->faces[f], expected, 1e-5 * (1 + expected));
    worst = std::max(worst, expected);
  }
  EXPECT_NEAR(s.sheet().field()->scale.high, worst, 1e-5);
  drive(s, {"reset"});
  EXPECT_EQ(s.sheet().field()->scale.high, 0);
}

//  The original is the roof over an edge; the flat face below it is 1 away from the ridge's foot.
TEST(ColorDistance, OfAFlatFaceBelowAParallelOne) {
  MeshData above = zoo::triangle();
  for (glm::dvec3& p : above.positions) p.z = 0.25;
  const Mesh original(above), below(zoo::triangle());
  EXPECT_DOUBLE_EQ(face_distance(below, Face(0), TriangleTree(triangles_of(original).corners)),
                   0.25);
}

/// A sheet that is flat in a direction which numbers cannot hold exactly.
MeshData tilted_sheet() {
  MeshData data = zoo::grid(6);
  for (glm::dvec3& p : data.positions) p = {0.1 * p.x, 0.1 * p.y, 0.1 * (p.x / 3 + p.y / 7)};
  return data;
}

TEST(ColorDistance, RoundingIsNoDistance) {
  Session s;
  load(s, tilted_sheet());
  drive(s, {"color distance", "strategy paper", "coarsest on", "sweep", "expect steps > 5"});
  EXPECT_EQ(s.sheet().field()->scale.high, 0);
}

TEST(ColorCurvature, RoundingIsNoCurvature) {
  Session s;
  load(s, tilted_sheet());
  drive(s, {"color curvature"});
  EXPECT_TRUE(s.sheet().field()->scale.empty())
      << s.sheet().field()->scale.low << " to " << s.sheet().field()->scale.high;
}

TEST(ColorDistance, WaitsWhileSomethingRuns) {
  Session s;
  drive(s, {"sample sphere 24", "color distance", "strategy quality", "factor 6"});
  execute(s, "run");
  s.tick(std::chrono::microseconds(1), 0.01);
  s.refresh();
  EXPECT_EQ(s.sheet().field()->scale.high, 0) << "not measured yet";
  s.finish();
  s.refresh();
  EXPECT_GT(s.sheet().field()->scale.high, 0);
  for (const Face f : s.document().mesh().faces())
    EXPECT_FALSE(std::isnan(s.sheet().field()->faces[f]));
}

TEST(ColorDistance, InSlicesComesToTheSame) {
  Session sliced, whole;
  for (Session* s : {&sliced, &whole})
    drive(*s, {"sample sphere 24", "strategy paper", "factor 3", "sweep"});
  execute(sliced, "color distance");
  sliced.tick(std::chrono::microseconds(0), 0.01);
  sliced.refresh();
  EXPECT_FALSE(sliced.idle());
  EXPECT_TRUE(sliced.sheet().field()->scale.empty()) << "nothing is coloured before all is known";
  for (int i = 0; i < 10'000 && !sliced.idle(); ++i) {
    sliced.tick(std::chrono::microseconds(0), 0.01);
    sliced.refresh();
  }
  drive(whole, {"color distance"});
  EXPECT_TRUE(sliced.idle());
  EXPECT_EQ(sliced.sheet().field()->scale, whole.sheet().field()->scale);
  for (std::size_t i = 0; i < corners(whole).size(); ++i)
    ASSERT_EQ(corners(sliced)[i].color, corners(whole)[i].color);
  execute(sliced, "seek 3");
  sliced.refresh();
  execute(sliced, "color none");
  sliced.refresh();
  EXPECT_TRUE(sliced.idle()) << "nobody waits for colours that are not shown";
}

TEST(ColorCurvature, KeepsTheScaleOfTheMeshAsLoaded) {
  Session s;
  drive(s, {"sample torus", "color curvature"});
  ASSERT_NE(s.sheet().field(), nullptr);
  const FieldScale scale = s.sheet().field()->scale;
  EXPECT_FALSE(scale.empty());
  drive(s, {"factor 6", "sweep"});
  EXPECT_EQ(s.sheet().field()->scale, scale);
}

// Its larger principal curvature is that of the tube, everywhere.
TEST(ColorCurvature, OfATorusIsOneColour) {
  Session s;
  drive(s, {"sample torus", "color curvature"});
  const FieldScale& scale = s.sheet().field()->scale;
  EXPECT_DOUBLE_EQ(scale.high, 4 * scale.low);
  for (const Corner& corner : corners(s)) {
    const glm::vec4 difference = unpack_color(corner.color) - unpack_color(ramp_color(0.5f));
    EXPECT_LT(glm::length(difference), 0.1f);
  }
}

TEST(Fields, OfVolumesAreThoseThatAreNotAboutDecimation) {
  Session s;
  load(s, cubes(2));
  for (const char* line : {"color spacing", "color distance"}) {
    drive(s, {line});
    EXPECT_EQ(s.sheet().field(), nullptr) << line;
  }
  for (const char* line : {"color quality", "color curvature"}) {
    drive(s, {line});
    EXPECT_NE(s.sheet().field(), nullptr) << line;
  }
}

TEST(Original, IsTheMeshAsLoadedWhereverTheHistoryStands) {
  Session s;
  drive(s, {"sample bracket 4"});
  const MeshData before = to_data(s.document().mesh());
  drive(s, {"factor 6", "sweep", "swap", "step -3", "show original on"});
  ASSERT_NE(s.sheet().reference_drawing(), nullptr);
  EXPECT_EQ(to_data(s.document().copy_mesh_as_loaded().mesh()), before);
  EXPECT_EQ(s.sheet().reference_drawing()->drawable().corners.size(), 3 * before.faces.size());
  drive(s, {"show original off"});
  EXPECT_EQ(s.sheet().reference_drawing(), nullptr);
}

// What looks must not touch: the same commands give the same mesh with and without a look back.
TEST(Original, LookingBackChangesNothing) {
  const auto result = [](bool look, const char* strategy) {
    Session s;
    drive(s, {"sample scan 3000", strategy, "step 40"});
    if (look) drive(s, {"show original on", "color distance", "panel histograms on"});
    drive(s, {"step 40", "sweep", "step -7", "run"});
    return to_data(s.document().mesh());
  };
  for (const char* strategy : {"strategy paper", "strategy quality"})
    EXPECT_EQ(result(false, strategy), result(true, strategy)) << strategy;
}

TEST(CompareView, IsTwoPicturesOfASurfaceOnly) {
  Session s;
  drive(s, {"sample torus", "compare side"});
  EXPECT_TRUE(s.sheet().shows_reference());
  drive(s, {"compare off"});
  EXPECT_FALSE(s.sheet().shows_reference());
  drive(s, {"compare toggle"});
  EXPECT_TRUE(s.view.side_by_side);
  load(s, cubes(1));
  EXPECT_FALSE(s.sheet().shows_reference()) << "a volume stays as it was loaded";
  EXPECT_THROW(execute(s, "compare sideways"), CommandError);
}

TEST(Histograms, CountTheMeshAsLoadedAndThePresentOne) {
  Session s;
  drive(s, {"sample torus", "panel histograms on"});
  ASSERT_NE(s.sheet().histograms(), nullptr);
  const auto faces = static_cast<std::size_t>(s.sheet().facts().faces);
  EXPECT_FALSE(s.sheet().histograms()->changed);
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Angle).now.total, faces);
  drive(s, {"factor 4", "sweep"});
  EXPECT_TRUE(s.sheet().histograms()->changed);
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Angle).before.total, faces);
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Angle).now.total,
            s.document().mesh().count(2));
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Length).now.total,
            s.document().mesh().count(1));
  // Everything is a fourth as long as wanted at first, in the mean over the torus.
  EXPECT_NEAR(s.sheet().histograms()->of(HistogramKind::Length).before.mean, 0.25, 0.02);
  drive(s, {"coarsest on"});
  EXPECT_FALSE(s.sheet().histograms()->wanted_lengths);
  EXPECT_NEAR(s.sheet().histograms()->of(HistogramKind::Length).before.mean, 1, 1e-12);
  drive(s, {"panel decimation on"});
  EXPECT_EQ(s.sheet().histograms(), nullptr) << "nobody looks";
}

// Vertices that have gone since have a spacing as well.
TEST(Histograms, OfLengthsAsLoadedAreTheSameBeforeAndAfterARun) {
  Session early, late;
  const std::vector<std::string_view> open = {"sample scan 2000", "strategy paper", "factor 4"};
  const auto as_loaded = [](Session& s) {
    drive(s, {"panel histograms on"});
    std::vector<double> ratios;
    for (const measure::Sample& each : s.sheet().histograms()->of(HistogramKind::Length).earlier)
      ratios.push_back(each.value);
    return ratios;
  };
  for (Session* s : {&early, &late})
    for (const std::string_view line : open) drive(*s, {line});
  drive(late, {"run"});
  const std::vector<double> ratios = as_loaded(early);
  EXPECT_EQ(as_loaded(late), ratios);
  const double mean =
      std::accumulate(ratios.begin(), ratios.end(), 0.0) / static_cast<double>(ratios.size());
  EXPECT_NEAR(mean, 0.25, 0.01)
      << "edges are as long as their neighbours, and the spacing is four times that";
}

TEST(Histograms, OfAVolumeAreItsDihedralAngles) {
  Session s;
  load(s, cubes(2));
  drive(s, {"panel histograms on"});
  ASSERT_NE(s.sheet().histograms(), nullptr);
  EXPECT_TRUE(s.sheet().histograms()->volume);
  EXPECT_EQ(s.sheet().histograms()->of(HistogramKind::Angle).now.total, 8u);
  EXPECT_NEAR(s.sheet().histograms()->of(HistogramKind::Angle).now.mean, 90, 1e-9);
}

std::size_t bright_faces(Session& s) {
  const auto all = corners(s);
  return static_cast<std::size_t>(std::count_if(
             all.begin(), all.end(),
             [](const Corner& c) { return (c.flags & CornerFlag::highlighted) != 0; })) /
         3;
}

TEST(Mark, BrightensFacesEdgesAndVertices) {
  Session s;
  load(s, zoo::square());
  drive(s, {"mark angle 45"});
  EXPECT_EQ(bright_faces(s), 2u);
  drive(s, {"mark angle 5"});
  EXPECT_EQ(bright_faces(s), 0u);
  drive(s, {"mark valence 3"});
  EXPECT_EQ(s.sheet().drawing().drawable().highlight_discs.size(), 2u);
  drive(s, {"coarsest on", "mark length 1.3"});  // the diagonal over the mean of all five
  EXPECT_EQ(s.sheet().drawing().drawable().highlight_lines.size(), 1u);
  EXPECT_EQ(s.sheet().drawing().drawable().highlight_discs.size(), 0u);
  drive(s, {"mark off"});
  EXPECT_EQ(s.sheet().drawing().drawable().highlight_lines.size(), 0u);
  EXPECT_THROW(execute(s, "mark area 1"), CommandError);
  EXPECT_THROW(execute(s, "mark angle"), CommandError);
}

TEST(Mark, TintsTheRegionsOfAVolume) {
  Session s;
  load(s, cubes(2));
  const auto tinted = [&] { return s.sheet().drawing().drawable().selected.faces.size() / 3; };
  drive(s, {"mark angle 89.9"});
  EXPECT_EQ(tinted(), 8u * 12) << "two triangles a side";
  drive(s, {"select region 3"});
  EXPECT_EQ(tinted(), 9u * 12);
  drive(s, {"mark angle 5"});
  EXPECT_EQ(tinted(), 12u);
  drive(s, {"select none", "mark angle 89.9", "shrink 0.3"});
  EXPECT_EQ(tinted(), 8u * 24) << "the shrunken ones too";
  drive(s, {"mark off"});
  EXPECT_EQ(tinted(), 0u);
}

TEST(Mark, FollowsTheMesh) {
  Session s;
  drive(s, {"sample torus", "mark angle 31", "factor 4", "sweep", "panel decimation on"});
  const auto& pair = s.sheet().histograms()->of(HistogramKind::Angle);
  EXPECT_EQ(bright_faces(s), pair.now.counts[pair.now.bin(31)]);
  EXPECT_GT(bright_faces(s), 0u);
}

}  // namespace
}  // namespace aomd::scene::compare_view_test
