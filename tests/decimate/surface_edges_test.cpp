// The paper's strategy without entities for the edges inside model faces: the same sweeps, the same
// verdicts and the same surface as with them.

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/decimate/decimation.h"
#include "core/decimate/paper/surface_edges.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::surface_edges_test {
namespace {

struct Surface {
  const char* name;
  MeshData data;
};

std::vector<Surface> surfaces() {
  std::vector<Surface> all;
  all.push_back({"scan", make_sample("scan", 3000)});
  all.push_back({"grid", zoo::grid(12)});
  all.push_back({"torus", zoo::torus(24, 16)});
  MeshData doubled = zoo::torus(16, 12);  // faces repeated, others at one edge, others back to back
  for (const std::uint32_t v : {0u, 3u, 40u, 77u}) {
    doubled.faces.add(Shape::Triangle, {v, v + 1, v + 14});
    doubled.faces.add(Shape::Triangle, {v + 1, v, v + 25});
    doubled.faces.add(Shape::Triangle, {v, v + 14, v + 1});
  }
  all.push_back({"doubled", std::move(doubled)});
  return all;
}

std::unique_ptr<Mesh> classified(const MeshData& data, bool all_edges) {
  auto mesh = std::make_unique<Mesh>(data);
  classify(*mesh);
  if (!all_edges) mesh->keep_model_edges_only();
  return mesh;
}

TEST(SurfaceEdgesTest, TheyAreNumberedAsEntitiesAre) {
  for (const Surface& surface : surfaces()) {
    SCOPED_TRACE(surface.name);
    const auto all = classified(surface.data, true), few = classified(surface.data, false);
    EXPECT_LT(few->count(1), all->count(1) / 2);
    const Request faces = few->request(0, 2), ends = all->request(0, 1);
    const SurfaceEdges edges(*few);
    ASSERT_EQ(edges.ids().size(), all->count(1));
    for (const Edge e : all->edges()) {
      ASSERT_EQ(edges.ends(e), all->edge_vertices(e));
      const auto [a, b] = edges.ends(e);
      ASSERT_EQ(edges.find(*few, a, b), e);
      ASSERT_EQ(edges.find(*few, b, a), e);
    }
  }
}

TEST(SurfaceEdgesTest, NeighboursComeInTheOrderOfEdges) {
  for (const Surface& surface : surfaces()) {
    SCOPED_TRACE(surface.name);
    const auto all = classified(surface.data, true), few = classified(surface.data, false);
    const Request faces = few->request(0, 2), ends = all->request(0, 1);
    const SurfaceEdges edges(*few);
    SurfaceEdges::Scratch scratch;
    for (const Vertex v : all->vertices()) {
      std::vector<Vertex> expected;
      for (const Edge e : all->row<1>(v)) expected.push_back(all->other_end(e, v));
      const auto found = edges.neighbours(*few, v, scratch);
      ASSERT_EQ(std::vector<Vertex>(found.begin(), found.end()), expected);
    }
  }
}

void expect_the_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.faces().list(), b.faces().list());
  for (const Face f : a.faces()) ASSERT_EQ(a.triangle(f), b.triangle(f));
  ASSERT_EQ(a.vertices().list(), b.vertices().list());
  for (const Vertex v : a.vertices()) ASSERT_EQ(a.position(v), b.position(v));
}

DecimationOptions random_options(std::mt19937& random) {
  DecimationOptions options;
  options.topology = random() % 2 ? TopologyRule::Paper : TopologyRule::Safe;
  options.coarsest = random() % 2;
  options.factor = 1.5 + random() % 8;
  options.angle_deg = random() % 2 ? 10 : 50;
  options.min_angle_deg = random() % 3 ? 0 : 15;
  options.target_faces = random() % 2 ? 0 : 100 + random() % 400;
  options.swap = random() % 4, options.smooth = random() % 4;
  options.no_intersections = random() % 4 == 0;
  if (random() % 4 == 0) options.max_distance = 0.05;
  return options;
}

TEST(SurfaceEdgesTest, WithoutEntitiesTheSurfaceIsTheSame) {
  std::mt19937 random(7);
  for (const Surface& surface : surfaces())
    for (int run = 0; run < 12; ++run) {
      SCOPED_TRACE(surface.name + std::to_string(run));
      const auto all = classified(surface.data, true), few = classified(surface.data, false);
      const DecimationOptions options = random_options(random);
      Decimation with(*all, options), without(*few, options);
      EXPECT_FALSE(few->stored(0, 1));
      with.run();
      without.run();
      EXPECT_EQ(with.sweeps(), without.sweeps());
      EXPECT_EQ(with.edges_left(), without.edges_left());
      expect_the_same(*all, *few);
      EXPECT_EQ(test::finding(*few), "");
    }
}

TEST(SurfaceEdgesTest, EdgesThatAreEntitiesAreJudgedAsBefore) {
  const MeshData data = zoo::grid(12);
  const auto all = classified(data, true), few = classified(data, false);
  Decimation with(*all, {.factor = 2}), without(*few, {.factor = 2});
  for (Decimation* d : {&with, &without}) d->run();
  ASSERT_GT(few->count(1), 10u);
  for (const Edge e : few->edges()) {
    const auto [a, b] = few->edge_vertices(e);
    const Edge entity = all->find_edge(a, b);
    Vertex expected, deleted;
    EXPECT_EQ(without.judge(e, deleted).reason, with.judge(entity, expected).reason);
    EXPECT_EQ(deleted, expected);
    EXPECT_EQ(without.last_refusal(e), with.last_refusal(entity));
    EXPECT_EQ(without.swap_outlook(e)->verdict.reason, with.swap_outlook(entity)->verdict.reason);
    for (const CollapseOutlook& own : without.outlook(e))
      for (const CollapseOutlook& other : with.outlook(entity))
        if (other.contraction.deleted == own.contraction.deleted) {
          EXPECT_EQ(own.verdict.reason, other.verdict.reason);
        }
  }
}

}  // namespace
}  // namespace aomd::surface_edges_test
