// What commands tell a decimation: strategies, aims and limits, and the history of the quality
// strategy.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/measure/distance.h"
#include "core/measure/volume_statistics.h"
#include "tests/support/message.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::document_options_test {
namespace {

using test::drive;

/// Positions and faces, exactly.
struct State {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> faces;
  friend bool operator==(const State&, const State&) = default;
};

State state(const Session& s) {
  const MeshData data = to_data(s.document().mesh());
  return {data.positions, {data.faces.vertices.begin(), data.faces.vertices.end()}};
}

std::size_t size(const Session& s) { return s.document().journal().size(); }

constexpr auto quality = {"sample scan 3000", "strategy quality", "target-faces 500"};

void drive_quality(Session& s) {
  for (const char* line : quality) drive(s, {line});
}

TEST(Aims, ANumberOfFacesMayBeAShareOfThoseAsLoaded) {
  Session s;
  drive(s, {"sample sphere 12"});
  const auto faces = s.sheet().loaded_facts().faces;
  drive(s, {"target-faces 25%"});
  EXPECT_EQ(s.document().options().target_faces, faces / 4);
  drive(s, {"sweep", "target-faces 10%"});
  EXPECT_EQ(s.document().options().target_faces, faces / 10) << "not of what is left";
  drive(s, {"sample tet-ball 3", "target-faces 50%"});
  EXPECT_EQ(s.document().options().target_faces, 270u);
  for (const char* line : {"target-faces 101%", "target-faces -1%", "target-faces %"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
}

TEST(Quality, ARunIsUndoneAndRedoneExactly) {
  Session s;
  drive_quality(s);
  const State start = state(s);
  drive(s, {"run"});
  EXPECT_LE(s.sheet().facts().faces, 500);
  EXPECT_GE(s.sheet().facts().faces, 495);
  EXPECT_EQ(s.sheet().facts().euler(), 2);
  const State end = state(s);
  drive(s, {"undo"});
  EXPECT_EQ(s.sheet().facts(), s.sheet().loaded_facts());
  EXPECT_TRUE(state(s) == start);
  drive(s, {"redo"});
  EXPECT_TRUE(state(s) == end);
}

TEST(Quality, StepByStepEqualsARun) {
  Session whole, steps;
  drive_quality(whole);
  drive(whole, {"run"});
  drive_quality(steps);
  std::size_t before = 0;
  do {
    before = size(steps);
    drive(steps, {before < 100 ? "step" : "step 97"});
  } while (size(steps) > before);
  EXPECT_EQ(size(steps), size(whole));
  EXPECT_TRUE(state(steps) == state(whole));
  drive(steps, {"seek 0"});
  EXPECT_EQ(steps.sheet().facts(), steps.sheet().loaded_facts());
}

TEST(Quality, GoesOnAfterStepsWereTakenBack) {
  Session s;
  drive_quality(s);
  drive(s, {"step 500", "step -200", "run"});
  EXPECT_LE(s.sheet().facts().faces, 500);
  EXPECT_EQ(s.sheet().facts().euler(), 2);
  drive(s, {"reset"});
  EXPECT_EQ(s.sheet().facts(), s.sheet().loaded_facts());
}

TEST(Quality, ARunAfterAResetIsTheSameAgain) {
  Session fresh, late;
  drive_quality(fresh);
  drive(fresh, {"run"});
  drive(late, {"sample scan 3000", "sweep", "strategy quality", "target-faces 500", "swap", "reset",
               "run"});
  EXPECT_TRUE(state(late) == state(fresh));
}

// The vertices of a mesh that is fitted to a finer one on a sphere go beyond the sphere.
TEST(Quality, KeepsToTheMeshAsLoadedWhateverAnotherStrategyHasDone) {
  Session s;
  drive(s, {"sample sphere 24", "angle 40", "sweep", "strategy quality", "smooth"});
  double sum = 0;
  for (const Vertex v : s.document().mesh().vertices())
    sum += glm::length(s.document().mesh().position(v));
  EXPECT_GT(sum / s.document().mesh().count(0), 1.001);
}

TEST(Quality, ProgressOfALaterRunStaysBetween0And1) {
  Session s;
  drive_quality(s);
  drive(s, {"run", "reset", "target-faces 400"});
  execute(s, "run");
  double last = s.document().run_progress();
  EXPECT_GE(last, 0);
  EXPECT_LT(last, 0.2);
  while (s.document().running()) {
    s.document().tick(std::chrono::microseconds(1));
    EXPECT_LE(s.document().run_progress(), 1);
    last = s.document().run_progress();
  }
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(Options, OneAimEndsTheOthers) {
  Session s;
  drive(s, {"sample sphere 12", "coarsest on", "target-faces 100"});
  const DecimationOptions& options = s.document().options();
  EXPECT_FALSE(options.coarsest);
  EXPECT_EQ(options.target_faces, 100u);
  drive(s, {"spacing 2 * h"});
  EXPECT_EQ(options.target_faces, 0u);
  EXPECT_EQ(s.document().spacing_source(), "2 * h");
  drive(s, {"coarsest on"});
  EXPECT_EQ(s.document().spacing_source(), "");
  EXPECT_TRUE(options.coarsest);
  drive(s, {"spacing curvature", "factor 3"});
  EXPECT_FALSE(options.spacing || options.coarsest || options.target_faces > 0);
  EXPECT_EQ(options.factor, 3);
  drive(s, {"target-faces 100", "target-faces off", "spacing 2 * h", "spacing off"});
  EXPECT_FALSE(options.spacing || options.target_faces > 0);
}

TEST(Options, TheUsualAngleFollowsTheStrategyAndAnotherStays) {
  Session s;
  const DecimationOptions& options = s.document().options();
  EXPECT_EQ(options.strategy, Strategy::Paper);
  EXPECT_EQ(options.angle_deg, 10);
  drive(s, {"strategy quality"});
  EXPECT_EQ(options.angle_deg, 60);
  drive(s, {"coarsest on"});
  EXPECT_EQ(options.angle_deg, 10);
  drive(s, {"coarsest off", "angle 25", "strategy paper"});
  EXPECT_EQ(options.angle_deg, 25);
}

TEST(Options, SpacingIsThatOfTheMeshAsLoaded) {
  Session s;
  drive(s, {"sample sphere 12", "spacing 2 * h"});
  const auto wanted = s.document().wanted_lengths();
  drive(s, {"sweep"});
  ASSERT_GT(size(s), 50u);
  const State present = state(s);
  drive(s, {"spacing 2 * h"});
  EXPECT_TRUE(state(s) == present);
  const auto again = s.document().wanted_lengths();
  for (const Vertex v : s.document().mesh().vertices()) EXPECT_EQ(again[v], wanted[v]);
  drive(s, {"sample sphere 8"});
  EXPECT_EQ(s.document().spacing_source(), "");
  EXPECT_FALSE(s.document().options().spacing);
}

TEST(Options, WrongOnesChangeNothingAndSayWhy) {
  Session s;
  EXPECT_THROW(execute(s, "spacing h"), CommandError) << "without a mesh";
  drive(s, {"sample sphere 8", "spacing 3 * h"});
  const DecimationOptions before = s.document().options();
  for (const char* line :
       {"strategy", "strategy best", "strategy paper now", "regularity 1.5", "regularity",
        "target-faces 0", "target-faces many", "target-faces 5 6", "min-angle 61", "min-angle -1",
        "min-dihedral 71", "min-dihedral -1", "max-distance -1", "max-distance 101",
        "no-intersections maybe", "spacing", "spacing 2 *", "spacing x"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  EXPECT_TRUE(s.document().options() == before);
  EXPECT_EQ(s.document().spacing_source(), "3 * h");
  EXPECT_EQ(
      aomd::test::message([&] { execute(s, "spacing 2 *"); }),
      "spacing \"2 *\", character 4: something is missing at the end (and there is no such file)");
}

TEST(Options, ADistanceIsToTheMeshAsLoadedWheneverItIsSet) {
  Session s;
  drive(s, {"sample sphere 24", "strategy paper", "angle 60", "coarsest on", "step 300"});
  const Mesh original(to_data(s.document().copy_mesh_as_loaded().mesh()));
  const measure::Surface as_loaded(original);
  const auto distance = [&] {
    return measure::distance_from(measure::Surface(s.document().mesh()), as_loaded, 20'000).max;
  };
  const double percent = 120 * distance() / s.document().content().bounds.diagonal();
  drive(s, {"max-distance " + std::to_string(percent), "run"});
  EXPECT_LE(distance(), s.document().options().max_distance);
  const auto faces = s.document().mesh().count(2);
  drive(s, {"max-distance 0", "run"});
  EXPECT_LT(s.document().mesh().count(2), faces);
  EXPECT_GT(distance(), 2 * percent / 100 * s.document().content().bounds.diagonal());
  drive(s, {"max-distance 1", "sample sphere 8"});
  EXPECT_EQ(s.document().options().max_distance, 0) << "its unit was another mesh's";
}

TEST(Options, NoIntersectionsIsAnOption) {
  Session s;
  drive(s, {"sample sphere 12", "no-intersections on"});
  EXPECT_TRUE(s.document().options().no_intersections);
  drive(s, {"run", "no-intersections toggle"});
  EXPECT_FALSE(s.document().options().no_intersections);
}

TEST(Options, VolumesMayBeFree) {
  Session s;
  drive(s, {"sample ball-in-box 2", "strategy quality", "volume free"});
  EXPECT_FALSE(s.document().options().keep_volumes);
  drive(s, {"target-faces 300", "run", "volume keep"});
  EXPECT_TRUE(s.document().options().keep_volumes);
  EXPECT_THROW(execute(s, "volume most"), CommandError);
}

TEST(Options, SpacingInsideAVolumeFollowsItsSurface) {
  Session s;
  drive(s, {"sample ball-in-box 3", "factor 1", "spacing surface"});
  ASSERT_TRUE(s.document().options().spacing);
  EXPECT_EQ(s.document().spacing_source(), "surface");
  const std::uint32_t regions = s.document().mesh().count(3);
  drive(s, {"run"});
  EXPECT_LT(s.document().mesh().count(3), regions);
}

TEST(Options, AMinAngleIsCounted) {
  Session s;
  drive(s, {"sample sphere 12", "min-angle 40", "sweep", "expect refused-shape > 0", "reset",
            "min-angle 0", "sweep", "expect refused-shape = 0"});
}

TEST(Options, AMinDihedralHoldsForTetrahedra) {
  Session s;
  drive(s, {"sample ball-in-box 3", "min-dihedral 30", "target-faces 100", "run"});
  EXPECT_EQ(s.document().options().min_dihedral_deg, 30);
  EXPECT_GE(measure::measure_volume(s.document().mesh()).min_dihedral_deg, 30 - 1e-9);
}

}  // namespace
}  // namespace aomd::scene::document_options_test
