// Vertices with very many faces: they wait until they have fewer, so that time follows the number
// of faces and not its square.

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/operators/collapse.h"
#include "core/operators/swap.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::crowd_test {
namespace {

glm::dvec3 on_circle(std::uint32_t i, std::uint32_t n, double z = 0) {
  return {std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), z};
}

// A flat cone: the tip 0, which has all edges to the others as its candidates, and n around it.
MeshData fan(std::uint32_t n, double height = 0.1) {
  MeshData data;
  data.positions.emplace_back(0, 0, height);
  for (std::uint32_t i = 0; i < n; ++i) data.positions.push_back(on_circle(i, n));
  for (std::uint32_t i = 0; i < n; ++i)
    data.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % n});
  return data;
}

// A cylinder of 4 n - 4 faces, its caps fans around one of their rim vertices each.
MeshData drum(std::uint32_t n) {
  MeshData data;
  for (const double z : {0.0, 1.0})
    for (std::uint32_t i = 0; i < n; ++i) data.positions.push_back(on_circle(i, n, z));
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    data.faces.add(Shape::Triangle, {i, j, n + j});
    data.faces.add(Shape::Triangle, {i, n + j, n + i});
    if (i == 0 || j == 0) continue;
    data.faces.add(Shape::Triangle, {0, j, i});
    data.faces.add(Shape::Triangle, {n, n + i, n + j});
  }
  return data;
}

Mesh ready(const MeshData& data) {
  Mesh mesh(data);
  mesh.set(0, 1), mesh.set(0, 2);
  return mesh;
}

TEST(CrowdTest, AVertexWithMoreThan512FacesWaits) {
  for (const std::uint32_t faces : {512u, 513u}) {
    const Mesh mesh = ready(fan(faces, 0));
    const Vertex tip(0);
    const CollapseRules rules{.topology = TopologyRule::Paper};
    const auto judge = [&](Vertex deleted, Vertex kept) {
      Collapser collapser(mesh);
      CollapsePlan plan;
      const Verdict by_edge =
          collapser.judge(mesh, mesh.find_edge(deleted, kept), deleted, rules, plan);
      const Verdict by_ends =
          collapser.judge(mesh, Contraction{deleted, kept, mesh.position(kept)}, rules, plan);
      EXPECT_EQ(by_edge.reason, by_ends.reason);
      EXPECT_EQ(by_edge.entity, by_ends.entity);
      return by_ends;
    };
    EXPECT_EQ(judge(tip, Vertex(3)).accepted(), faces == 512);
    EXPECT_EQ(judge(tip, Vertex(3)).entity, faces == 512 ? EntityRef() : EntityRef(tip));
    EXPECT_EQ(judge(Vertex(3), tip).reason == Reason::Topology, faces == 513);
    EXPECT_TRUE(judge(Vertex(1), Vertex(2)).accepted()) << "its neighbours do not wait";
  }
}

// Two cones base to base: the other diagonal of an edge around would join the tips.
TEST(CrowdTest, NoSwapJoinsTwoCrowdedVertices) {
  for (const std::uint32_t n : {512u, 513u}) {
    MeshData data = fan(n);
    data.positions.emplace_back(0, 0, -0.1);
    for (std::uint32_t i = 0; i < n; ++i)
      data.faces.add(Shape::Triangle, {n + 1, 1 + (i + 1) % n, 1 + i});
    const Mesh mesh = ready(data);
    EXPECT_EQ(joined(mesh, Vertex(0), Vertex(n + 1)), n == 513);
    EXPECT_TRUE(joined(mesh, Vertex(0), Vertex(7)));
    EXPECT_TRUE(joined(mesh, Vertex(7), Vertex(0)));
    EXPECT_FALSE(joined(mesh, Vertex(1), Vertex(3)));
  }
}

// Within one stage: the next would find the edges of the tip anyway.
TEST(CrowdTest, WhoeverHasNoMoreThan512FacesLeftIsWaitedForNoLonger) {
  Mesh mesh = test::classified(fan(1500, 0));
  DecimationOptions options{.strategy = Strategy::Quality, .coarsest = true};
  options.without = 1u << static_cast<int>(Idea::SecondStage);
  Decimation(mesh, options).run();
  EXPECT_FALSE(mesh.alive(Vertex(0)));
}

// Candidates judged on the way to a number of faces.
std::uint64_t work(const MeshData& data, Strategy strategy, std::uint32_t target) {
  Mesh mesh = test::classified(data);
  const int euler = zoo::euler(mesh);
  Decimation decimation(mesh, {.strategy = strategy, .target_faces = target, .angle_deg = 30});
  decimation.run();
  EXPECT_EQ(mesh.count(2), target);
  EXPECT_EQ(zoo::euler(mesh), euler);
  EXPECT_EQ(test::finding(mesh), "");
  std::uint64_t judged = 0;
  for (const SweepStatistics& s : decimation.sweeps()) {
    judged += s.collapses;
    for (const std::uint32_t n : s.refused) judged += n;
  }
  return judged;
}

TEST(CrowdTest, TheWorkFollowsTheNumberOfFaces) {
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality})
    for (const bool drums : {true, false}) {
      const auto of = [&](std::uint32_t n) {
        return work(drums ? drum(n) : fan(4 * n), strategy, 400);
      };
      const std::uint64_t small = of(1000), large = of(8000);
      EXPECT_LE(large, 10 * small) << int(strategy) << drums;
    }
}

}  // namespace
}  // namespace aomd::crowd_test
