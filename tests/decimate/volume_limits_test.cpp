// What the quality strategy for volumes holds regions to, and what it says where it refuses: their
// volumes, sizes inside them, removals of edges.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/base/text.h"
#include "core/decimate/decimation.h"
#include "core/decimate/explain/explanation.h"
#include "core/decimate/explain/stop_words.h"
#include "core/decimate/spacing/spacing.h"
#include "core/measure/volume_comparison.h"
#include "core/mesh/tet_geometry.h"
#include "core/model/discrete_model.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::volume_limits_test {
namespace {

using namespace test;

DecimationOptions quality(const Mesh& mesh, double share) {
  DecimationOptions options;
  options.strategy = Strategy::Quality;
  options.angle_deg = usual_angle_deg(Strategy::Quality, false);
  options.target_faces = static_cast<std::uint32_t>(share * mesh.count(3));
  return options;
}

// The volume of each model region, with the vertices of a contraction where it puts them.
std::map<ModelRef, double> volumes(const Mesh& mesh, const Contraction& c) {
  std::map<ModelRef, double> sums;
  for (const Region r : mesh.regions()) {
    std::array<glm::dvec3, 4> p;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vertex v = mesh.tetrahedron(r)[k];
      p[k] = v == c.deleted || v == c.kept ? c.position : mesh.position(v);
    }
    sums[mesh.classification(r)] += six_volumes(p[0], p[1], p[2], p[3]) / 6;
  }
  return sums;
}

// Two blocks with a wavy interface, in the middle of which a thin lens of a third material lies: it
// cannot pay for what it owes.
MeshData lens() {
  MeshData data = zoo::tet_grid({12, 12, 5}, [](const zoo::Cell& c) {
    const bool inner = 2 <= c.x && c.x < 10 && 2 <= c.y && c.y < 10;
    return c.z == 2 && inner ? 3 : c.z <= 2 ? 1 : 2;
  });
  for (glm::dvec3& p : data.positions) {
    const double z = p.z < 3 ? p.z - 2 : p.z - 3 + 0.03;
    p.z = z + 0.5 * std::sin(0.9 * p.x) * std::sin(0.9 * p.y);
  }
  return data;
}

// What a refusal says of a region is what the contraction would do to it, and more than the limit.
TEST(VolumeLimits, ARefusalSaysByHowMuchARegionWouldChange) {
  VolumeBench b(lens(), Levels::Complete);
  const std::map<ModelRef, double> before = volumes(b.mesh, {});
  const DecimationOptions options = quality(b.mesh, 0.1);
  Decimation decimation(b.mesh, options);
  decimation.run();
  int refused = 0;
  for (const Edge e : b.mesh.edges()) {
    const CollapseOutlook o = decimation.outlook(e).front();
    if (o.verdict.reason != Reason::Volume) continue;
    const Contraction& c = o.contraction;
    if (c.position != b.mesh.position(c.kept)) continue;  // of several places that were tried
    ++refused;
    const ModelRef region = b.mesh.classification(o.verdict.entity);
    const double was = before.at(region),
                 percent = 100 * (volumes(b.mesh, c).at(region) - was) / was;
    EXPECT_NEAR(o.verdict.number(), percent, 1e-9);
    EXPECT_GT(std::abs(o.verdict.number()), 0.1);
    const std::string words = explain_collapse(b.mesh, o, options);
    EXPECT_EQ(words, "Model region " + std::to_string(region.tag()) + " would be " +
                         number_text(std::abs(percent), 3) + " % " +
                         (percent < 0 ? "smaller" : "larger") + "; 0.1 % is the limit.");
    const auto checks = collapse_checks(o, options);
    EXPECT_STREQ(checks.back().name, "Volumes");
    EXPECT_EQ(checks.back().state, CheckResult::State::Failed);
  }
  EXPECT_GT(refused, 0);
  EXPECT_GE(decimation.edges_left()[static_cast<std::size_t>(Reason::Volume)], refused);
}

TEST(VolumeLimits, WhatVolumesStoppedHasWords) {
  EdgesByReason edges{};
  edges[static_cast<std::size_t>(Reason::Volume)] = 7;
  EXPECT_EQ(words_of_edges_left(edges, {}, true),
            "of 7 edges left, 7 would change a region's volume too much");
}

TEST(VolumeLimits, AtMostSixPartsOfASentence) {
  EdgesByReason edges{};
  for (int r = 0; r < 6; ++r) edges[static_cast<std::size_t>(r) + 2] = 100 - 10 * r;
  EXPECT_EQ(words_of_edges_left(edges, {}, true),
            "of 450 edges left, 100 join parts of the model that stay, 90 would pinch or tear the "
            "model, 80 would leave a face without area, 70 would turn a face by more than 10 "
            "degrees, 60 would make the shape worse and 50 are to stay");
  edges[static_cast<std::size_t>(Reason::Volume)] = 5;
  const std::string words = words_of_edges_left(edges, {}, true);
  EXPECT_TRUE(words.ends_with(", 60 would make the shape worse and 55 stay for other reasons"))
      << words;
}

// With everything as entities too, and with both halves of the distance.
TEST(VolumeLimits, ADistanceIsHeldTheSameWhateverHoldsTheInside) {
  const MeshData data = make_sample("ball-in-box", 2);
  std::vector<MeshData> results;
  for (const Levels levels : both_levels) {
    VolumeBench b(data, levels);
    DecimationOptions options = quality(b.mesh, 0.05);
    options.max_distance = 0.02;
    Decimation decimation(b.mesh, options);
    decimation.run();
    EXPECT_GT(decimation.edges_left()[static_cast<std::size_t>(Reason::Distance)], 0);
    results.push_back(to_data(b.mesh));
    results.back().edges = {};
  }
  EXPECT_EQ(results[0].positions, results[1].positions);
  EXPECT_EQ(results[0].regions, results[1].regions);
}

// Two layers of a few large cells with a rough interface, whose faces are larger than the distance.
MeshData rough_layers(std::uint32_t seed) {
  MeshData data = zoo::tet_grid({9, 9, 4}, [](const zoo::Cell& c) { return c.z < 2 ? 1 : 2; });
  std::mt19937 random(seed);
  for (glm::dvec3& p : data.positions)
    if (p.z == 2) p.z += 0.5 * (double(random() % 2001) / 1000 - 1);
  return data;
}

// Between the vertices too, and both ways.
TEST(VolumeLimits, ADistanceHoldsForAllPointsOfAnInterface) {
  std::size_t decided = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Mesh original(rough_layers(seed));
    VolumeBench b(to_data(original), Levels::Listed, smooth_skin);
    DecimationOptions options = quality(b.mesh, 0.05);
    options.max_distance = 0.35;
    Decimation decimation(b.mesh, options);
    decimation.run();
    decided += decimation.edges_left()[static_cast<std::size_t>(Reason::Distance)];
    const Mesh result(to_data(b.mesh));
    const measure::VolumeComparison c =
        compare_volumes(measure::Volume(original), measure::Volume(result), 20'000);
    for (const measure::InterfaceChange& surface : c.surfaces())
      EXPECT_LE(surface.distance().max, options.max_distance) << seed;
  }
  EXPECT_GT(decided, 0u);
}

TEST(VolumeLimits, FreeVolumesChangeAndKeptOnesDoNot) {
  std::array<std::uint32_t, 2> left{};
  for (const bool keep : {true, false}) {
    VolumeBench b(lens(), Levels::Listed);
    const std::map<ModelRef, double> before = volumes(b.mesh, {});
    DecimationOptions options = quality(b.mesh, 0.1);
    options.keep_volumes = keep;
    Decimation decimation(b.mesh, options);
    decimation.run();
    EXPECT_EQ(b.finding(), "");
    double most = 0;
    for (const auto& [region, volume] : volumes(b.mesh, {}))
      most = std::max(most, 100 * std::abs(volume - before.at(region)) / before.at(region));
    EXPECT_EQ(keep, most < 0.1) << most;
    if (!keep) {
      EXPECT_GT(most, 1);
      EXPECT_EQ(decimation.edges_left()[static_cast<std::size_t>(Reason::Volume)], 0);
    }
    left[keep ? 0 : 1] = b.mesh.count(3);
  }
  EXPECT_LT(left[1], left[0]);
}

// A plate one layer of flat tetrahedra thick: the target is out of reach for the floor on the
// shape, which is lowered, but not below that.
TEST(VolumeLimits, WhereTheFloorIsLoweredNoAngleFallsBelowTenDegrees) {
  MeshData data = zoo::tet_grid({24, 24, 1}, [](const zoo::Cell&) { return 1; });
  for (glm::dvec3& p : data.positions) p.z *= 0.2;
  VolumeBench b(data, Levels::Listed);
  EXPECT_NEAR(smallest_dihedral(b.mesh), std::atan(0.2) * 180 / M_PI, 1e-9);
  Decimation decimation(b.mesh, quality(b.mesh, 0.1));
  decimation.run();
  EXPECT_GE(smallest_dihedral(b.mesh), 10);
  EXPECT_LT(b.mesh.count(3), 2500u) << "of 3456";
  EXPECT_EQ(b.finding(), "");
}

// Collapses, removals, moves, moves onto a model and the payment of debts: the least angle is
// nearly that of the input, and every stage would come to lie below it.
TEST(VolumeLimits, EveryStageKeepsTheLeastDihedralAngle) {
  const MeshData data = make_sample("ball-in-box", 3);
  const double start = smallest_dihedral(Mesh(data));
  ASSERT_GT(start, 38);
  for (const bool snaps : {false, true}) {
    VolumeBench b(data, Levels::Listed);
    const DiscreteModel model(b.mesh);
    DecimationOptions options = quality(b.mesh, 0.1);
    options.min_dihedral_deg = 36;
    if (snaps) options.model = &model;
    Decimation(b.mesh, options).run();
    EXPECT_GE(smallest_dihedral(b.mesh), 36 - 1e-9) << snaps;
    EXPECT_LT(b.mesh.count(3), 0.6 * data.regions.size());
  }
}

TEST(VolumeLimits, ARefusedAngleSaysWhatTheLimitIs) {
  VolumeBench b(make_sample("ball-in-box", 2), Levels::Complete);
  DecimationOptions options = quality(b.mesh, 0.1);
  options.min_dihedral_deg = 36;
  Decimation decimation(b.mesh, options);
  decimation.run();
  int said = 0;
  for (const Edge e : b.mesh.edges()) {
    const auto o = decimation.swap_outlook(e);
    ASSERT_EQ(o->limits.min_dihedral_deg, 36);
    if (o->verdict.reason != Reason::Shape) continue;
    ++said;
    EXPECT_TRUE(explain_swap(b.mesh, e, *o).ends_with(" degrees; the limit is 36."))
        << explain_swap(b.mesh, e, *o);
  }
  EXPECT_GT(said, 0);
}

// The rims of a drilled hole, and what its wall owes at the end: curves count in what a collapse
// costs, and debts spread before they are paid, so that none makes a bump.
TEST(VolumeLimits, RimsAndWallsStayClose) {
  VolumeBench b(make_sample("tet-drilled", 6), Levels::Listed);
  const Mesh original(to_data(b.mesh));
  Decimation(b.mesh, quality(b.mesh, 0.2)).run();
  const Mesh result(to_data(b.mesh));
  const measure::VolumeComparison c =
      compare_volumes(measure::Volume(original), measure::Volume(result), 50'000);
  EXPECT_LT(c.curves.both.rms, 0.0013 * c.diagonal);
  EXPECT_LT(distance_over(c.interfaces, true)->max, 0.018 * c.diagonal);
}

// No edge between two vertices that are to stay makes way, poor as the tetrahedra around it are.
TEST(VolumeLimits, EdgesBetweenKeptVerticesStay) {
  MeshData data = make_sample("tet-box", 6);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.04, 0.04);
  for (std::size_t v = 0; v < data.positions.size(); ++v)
    if (data.vertex_classes[v].dimension() == 3)
      data.positions[v] += glm::dvec3(place(random), place(random), place(random));
  VolumeBench b(data, Levels::Complete);
  DecimationOptions options = quality(b.mesh, 0.9);
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(b.mesh.capacity(0), std::uint8_t{0});
  for (const Vertex v : b.mesh.vertices()) (*keep)[v] = b.mesh.position(v).x > 0.3;
  options.keep = keep;
  std::vector<std::array<Vertex, 2>> between;
  for (const Edge e : b.mesh.edges()) {
    const auto [p, q] = b.mesh.edge_vertices(e);
    if ((*keep)[p] != 0 && (*keep)[q] != 0) between.push_back({p, q});
  }
  Decimation(b.mesh, options).run();
  EXPECT_LT(b.mesh.count(3), 0.95 * data.regions.size());
  for (const auto& [p, q] : between) EXPECT_TRUE(b.mesh.find_edge(p, q).valid());
}

double mean_length(const Mesh& mesh, double low, double high) {
  double sum = 0;
  int count = 0;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    const glm::dvec3 p = mesh.position(a), q = mesh.position(b), middle = 0.5 * (p + q);
    const double depth =
        std::min({middle.x, middle.y, middle.z, 16 - middle.x, 16 - middle.y, 16 - middle.z});
    if (depth < low || depth > high) continue;
    sum += glm::length(p - q);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

TEST(VolumeLimits, EdgesGetLongerAwayFromTheSurface) {
  for (const Strategy strategy : {Strategy::Quality, Strategy::Paper}) {
    VolumeBench b(zoo::tet_grid({16, 16, 16}, [](const zoo::Cell&) { return 1; }),
                  Levels::Complete);
    DecimationOptions options;
    options.strategy = strategy;
    options.spacing = std::make_shared<Column<Vertex, double>>(
        evaluate_spacing(b.mesh, {SpacingBySurface{1}, 0.6}));
    const std::uint32_t faces = b.mesh.count(2);
    Decimation(b.mesh, options).run();
    EXPECT_LT(b.mesh.count(2), faces);
    const double outside = mean_length(b.mesh, 0, 1.2), inside = mean_length(b.mesh, 5, 8);
    EXPECT_GT(outside, 1) << "nothing on the outside is shorter than half its size";
    EXPECT_GT(inside, 1.5 * outside) << static_cast<int>(strategy);
  }
}

// Every edge of a run says why it is not removed, or it can be.
TEST(VolumeLimits, RemovalsAreExplained) {
  VolumeBench b(make_sample("ball-in-box", 2), Levels::Complete);
  Decimation decimation(b.mesh, quality(b.mesh, 0.3));
  std::set<Reason> reasons;
  for (int part = 0; part < 2; ++part) {
    for (const Edge e : b.mesh.edges()) {
      const auto o = decimation.swap_outlook(e);
      ASSERT_TRUE(o.has_value());
      const std::string words = explain_swap(b.mesh, e, *o);
      EXPECT_TRUE(words.ends_with('.')) << words;
      EXPECT_EQ(words.find("invalid"), std::string::npos) << words;
      reasons.insert(o->verdict.reason);
      if (o->verdict.reason == Reason::Classification) {
        EXPECT_EQ(b.mesh.classification(e).dimension() == 1,
                  words == "The edge lies on model edge " +
                               std::to_string(b.mesh.classification(e).tag()) + ".")
            << words;
      }
    }
    decimation.run();
  }
  for (const Reason r : {Reason::None, Reason::Classification, Reason::Quality, Reason::Angle})
    EXPECT_TRUE(reasons.contains(r)) << reason_name(r);
}

// 0 and 1 are the ends of an edge with four tetrahedra around it, of which two are thin.
TEST(VolumeLimits, ARemovalThatPaysAndOneThatDoesNot) {
  for (const double height : {0.2, 2.0}) {
    VolumeBench b(ring_around_an_edge({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                      {0, 0, -height}, {0, 0, height}),
                  Levels::Complete);
    Decimation decimation(b.mesh, quality(b.mesh, 0.9));
    const Edge e = b.mesh.find_edge(Vertex(0), Vertex(1));
    const SwapOutlook o = *decimation.swap_outlook(e);
    EXPECT_EQ(o.verdict.reason, height < 1 ? Reason::Quality : Reason::None);
    const std::string words = explain_swap(b.mesh, e, o);
    if (height < 1)
      EXPECT_TRUE(words.starts_with("It would not pay: the tetrahedra would have no ")) << words;
    else
      EXPECT_EQ(words,
                "The tetrahedra around it would make way for better ones that do without it.");
  }
}

}  // namespace
}  // namespace aomd::volume_limits_test
