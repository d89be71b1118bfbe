#include "core/decimate/decimation.h"

#include <gtest/gtest.h>

#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::decimation_test {
namespace {

struct Job {
  explicit Job(const MeshData& data, const DecimationOptions& options) : mesh(data) {
    classify(mesh);
    before = zoo::euler(mesh);
    decimation.emplace(mesh, options);
  }
  Mesh mesh;
  int before = 0;
  std::optional<Decimation> decimation;
};

TEST(DecimationTest, AFlatSheetBecomesTwoTriangles) {
  Job run(zoo::grid(12), {.coarsest = true});
  EXPECT_EQ(run.decimation->run(), Decimation::Stop::Done);
  EXPECT_EQ(run.mesh.count(2), 2u);
  EXPECT_EQ(run.mesh.count(0), 4u);
  EXPECT_TRUE(verify(run.mesh).empty());
}

TEST(DecimationTest, SafeKeepsTheTopologyOfTheZoo) {
  for (const zoo::Animal& animal : zoo::all())
    for (const double angle : {10.0, 60.0, 150.0}) {
      Job run(animal.data, {.coarsest = true, .angle_deg = angle});
      run.decimation->run();
      EXPECT_EQ(zoo::euler(run.mesh), run.before) << animal.name << ' ' << angle;
      EXPECT_TRUE(verify(run.mesh).empty()) << animal.name;
    }
}

// A collapse takes what is shorter than half the spacing, so that edges end between half of it and
// all of it, and on a sheet nothing but the length refuses.
TEST(DecimationTest, TheFactorIsHowMuchLongerEdgesBecome) {
  for (const auto& [factor, longer] : {std::pair(2.0, 2.085), {4.0, 4.329}}) {
    Job run(zoo::grid(48), {.factor = factor});
    run.decimation->run();
    double sum = 0;
    for (const Edge e : run.mesh.edges()) {
      const auto [a, b] = run.mesh.edge_vertices(e);
      sum += glm::length(run.mesh.position(a) - run.mesh.position(b));
    }
    const double average_before = (2 + std::sqrt(2)) / 3;
    EXPECT_NEAR(sum / run.mesh.count(1) / average_before, longer, 0.01) << factor;
  }
}

// A spacing that grows from far below leaves what no longer fits together: 964 of 400 faces.
TEST(DecimationTest, ThePapersStrategyReachesATarget) {
  for (const std::uint32_t target : {2000u, 666u, 400u}) {
    Job run(make_sample("scan", 8000), {.target_faces = target});
    run.decimation->run();
    EXPECT_LE(run.mesh.count(2), target);
    EXPECT_GE(run.mesh.count(2) + 1, target) << "a collapse takes two faces at most";
    EXPECT_EQ(zoo::euler(run.mesh), run.before);
  }
}

// Closed surfaces have an even number of faces: the last collapse leads to the number itself.
TEST(DecimationTest, NoStrategyGoesBeyondItsTarget) {
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality})
    for (const std::uint32_t target : {1000u, 1001u, 500u}) {
      Job run(zoo::torus(40, 30), {.strategy = strategy, .target_faces = target, .angle_deg = 60});
      run.decimation->run();
      EXPECT_EQ(run.mesh.count(2), target - target % 2) << int(strategy);
    }
}

TEST(DecimationTest, TheFirstSweepsAreImprovedAndNoOthers) {
  for (const int passes : {0, 1, 2, 4}) {
    Job run(make_sample("scan", 8000), {.coarsest = true, .improve_passes = passes});
    run.decimation->run();
    const auto& sweeps = run.decimation->sweeps();
    ASSERT_GT(sweeps.size(), 5u);
    for (std::size_t i = 0; i < sweeps.size(); ++i)
      EXPECT_EQ(sweeps[i].swaps + sweeps[i].smooths > 0, int(i) < passes) << passes << ' ' << i;
  }
}

TEST(DecimationTest, StepSweepAndRunGiveTheSameMesh) {
  const MeshData data = zoo::torus(40, 30);
  const DecimationOptions options{.coarsest = true, .angle_deg = 20};
  Job whole(data, options), steps(data, options), slices(data, options), sweeps(data, options);
  whole.decimation->run();
  while (steps.decimation->step()) {
  }
  while (slices.decimation->run(std::chrono::microseconds(1)) != Decimation::Stop::Done) {
  }
  while (!sweeps.decimation->done()) sweeps.decimation->sweep();
  const std::string expected = zoo::fingerprint(whole.mesh);
  EXPECT_EQ(zoo::fingerprint(steps.mesh), expected);
  EXPECT_EQ(zoo::fingerprint(slices.mesh), expected);
  EXPECT_EQ(zoo::fingerprint(sweeps.mesh), expected);
  EXPECT_LT(whole.mesh.count(2), 500u);
}

// After the run each edge has been judged as it is now, and the last sweep has counted it.
void expect_all_judged(Job& run) {
  std::uint32_t refused = 0;
  Vertex deleted;
  for (const Edge e : run.mesh.edges()) {
    const Verdict fresh = run.decimation->judge(e, deleted);
    EXPECT_FALSE(fresh.accepted()) << "edge " << e.index;
    EXPECT_EQ(fresh.reason, run.decimation->last_refusal(e))
        << "a remembered refusal must still be true";
    ++refused;
  }
  std::uint32_t counted = 0;
  for (const std::uint32_t n : run.decimation->sweeps().back().refused) counted += n;
  EXPECT_EQ(counted, refused) << "the last sweep counts every edge that is left";
}

TEST(DecimationTest, NothingIsLeftThatCouldCollapse) {
  Job run(zoo::torus(40, 30), {.coarsest = true, .angle_deg = 20});
  run.decimation->run();
  expect_all_judged(run);
}

// Each of the four vertices of a swap wakes its edges, each neighbour of a moved vertex too.
TEST(DecimationTest, WhatSwapsAndSmoothingMakePossibleIsSeen) {
  for (const char* name : {"terrain", "sphere"})
    for (const bool coarsest : {true, false})
      for (const bool swap : {true, false})
        for (const double angle : {5.0, 10.0}) {
          SCOPED_TRACE(name + std::to_string(angle) + (swap ? " swaps" : " smoothing"));
          Job run(make_sample(name, 24), {.factor = 3,
                                          .coarsest = coarsest,
                                          .angle_deg = angle,
                                          .improve_passes = 2,
                                          .swap = swap,
                                          .smooth = !swap});
          run.decimation->run();
          ASSERT_GT(run.decimation->sweeps().size(), 2u) << "the last sweep is not improved";
          expect_all_judged(run);
        }
}

TEST(DecimationTest, CancelLeavesAValidMeshAndCanGoOn) {
  const MeshData data = zoo::torus(40, 30);
  Job run(data, {.coarsest = true, .angle_deg = 20}),
      whole(data, {.coarsest = true, .angle_deg = 20});
  int asked = 0;
  EXPECT_EQ(run.decimation->run({}, [&] { return ++asked == 3; }), Decimation::Stop::Cancelled);
  EXPECT_FALSE(run.decimation->done());
  EXPECT_TRUE(verify(run.mesh).empty());
  run.decimation->run();
  whole.decimation->run();
  EXPECT_EQ(zoo::fingerprint(run.mesh), zoo::fingerprint(whole.mesh));
}

TEST(DecimationTest, ALargerAngleAllowsMore) {
  std::uint32_t last = no_index;
  for (const double angle : {5.0, 10.0, 20.0, 40.0}) {
    Job run(zoo::torus(40, 30), {.coarsest = true, .angle_deg = angle});
    run.decimation->run();
    EXPECT_LT(run.mesh.count(2), last);
    last = run.mesh.count(2);
  }
}

TEST(DecimationTest, NewOptionsStartAfresh) {
  Job run(zoo::torus(40, 30), {.coarsest = true, .angle_deg = 5});
  run.decimation->run();
  const std::uint32_t coarse = run.mesh.count(2);
  DecimationOptions options = run.decimation->options();
  options.angle_deg = 40;
  run.decimation->set_options(options);
  EXPECT_FALSE(run.decimation->done());
  run.decimation->run();
  EXPECT_LT(run.mesh.count(2), coarse);
}

TEST(DecimationTest, AMisclassifiedMeshIsRefused) {
  Mesh mesh(zoo::square());
  mesh.set_classification(Face(0), ModelRef(2, 1));
  mesh.set_classification(Vertex(0), ModelRef(3, 1));
  EXPECT_THROW(Decimation(mesh, {}), std::invalid_argument);
}

TEST(DecimationTest, ReleasesWhatItRequested) {
  Job run(zoo::torus(12, 9), {});
  EXPECT_TRUE(run.mesh.stored(0, 1) && run.mesh.stored(0, 2));
  run.decimation.reset();
  EXPECT_FALSE(run.mesh.stored(0, 1) || run.mesh.stored(0, 2));
}

TEST(DecimationTest, SwapsAndSmoothingImproveTheSmallestAngle) {
  const auto worst = [](const DecimationOptions& options) {
    Job run(zoo::torus(40, 30), options);
    run.decimation->run();
    double sum = 0;
    for (const Face f : run.mesh.faces()) {
      const auto t = run.mesh.triangle(f);
      sum += smallest_angle_deg(run.mesh.position(t[0]), run.mesh.position(t[1]),
                                run.mesh.position(t[2]));
    }
    return sum / run.mesh.count(2);
  };
  EXPECT_GT(worst({.factor = 3, .angle_deg = 30}),
            worst({.factor = 3, .angle_deg = 30, .swap = false, .smooth = false}) + 1);
}

}  // namespace
}  // namespace aomd::decimation_test
