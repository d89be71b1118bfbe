// What the paper's strategy leaves as it is, and how far it improves.

#include <gtest/gtest.h>

#include <memory>

#include "core/decimate/decimation.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::paper_loop_test {
namespace {

Mesh classified_scan() {
  Mesh mesh(make_sample("scan", 2000));
  classify(mesh);
  return mesh;
}

TEST(PaperLoopTest, FourSweepsAreImprovedUnlessToldOtherwise) {
  Mesh mesh = classified_scan();
  Decimation decimation(mesh, {.coarsest = true});
  decimation.run();
  const auto& sweeps = decimation.sweeps();
  ASSERT_GT(sweeps.size(), 5u);
  for (std::size_t k = 0; k < sweeps.size(); ++k)
    EXPECT_EQ(sweeps[k].swaps + sweeps[k].smooths > 0, k < 4) << k;
}

TEST(PaperLoopTest, KeptVerticesAndTheFacesBetweenThemStay) {
  Mesh mesh = classified_scan();
  const Mesh before = classified_scan();
  const auto keep =
      std::make_shared<Column<Vertex, std::uint8_t>>(mesh.capacity(0), std::uint8_t{0});
  for (const Vertex v : mesh.vertices()) (*keep)[v] = v.index % 2 == 0 || v.index < 400;
  DecimationOptions options{.coarsest = true, .angle_deg = 40};
  options.keep = keep;
  Decimation(mesh, options).run();
  EXPECT_LT(mesh.count(2), before.count(2) - 200);
  for (const Vertex v : before.vertices()) {
    if (!options.kept(v)) continue;
    ASSERT_TRUE(mesh.alive(v));
    EXPECT_EQ(mesh.position(v), before.position(v));
  }
  for (const Face f : before.faces()) {
    const auto t = before.triangle(f);
    if (!options.kept(t[0], t[1], t[2])) continue;
    ASSERT_TRUE(mesh.alive(f));
    EXPECT_EQ(mesh.triangle(f), t);
  }
}

//        2
//     /     \         swapped, 2-3 is shorter than 0-1
//   0---------1
//     \     /
//        3
TEST(PaperLoopTest, AFaceBetweenKeptVerticesIsNotSwapped) {
  const MeshData rhombus =
      zoo::make({{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  for (const bool whole : {true, false})
    for (const std::uint32_t apex : {2u, 3u}) {
      Mesh mesh(rhombus);
      classify(mesh);
      Column<Vertex, std::uint8_t> keep(4, std::uint8_t{0});
      for (const std::uint32_t v : {0u, 1u, apex}) keep[Vertex(v)] = whole || v != apex;
      DecimationOptions options;
      options.keep = std::make_shared<Column<Vertex, std::uint8_t>>(keep);
      Decimation decimation(mesh, options);
      EXPECT_EQ(decimation.swap_pass(), whole ? 0u : 1u) << apex;
    }
}

//  0 - - 1
//   \      \           2 goes into 3 only after 1 has gone into 2: before, the border would turn
//    \       2 - 3     by more than 45 degrees. Lengths let no other edge go.
//     \      |  /
//       - -  4
TEST(PaperLoopTest, AnEdgeOfTheBorderIsJudgedAgainWhenTheNextOneIsGone) {
  const ModelRef rim(1, 1), left(1, 2), right(1, 3), inside(2, 1);
  MeshData data;
  data.positions = {{-8.66, 5, 0}, {-0.5, 0.866, 0}, {0, 0, 0}, {6, 0, 0}, {0, -10, 0}};
  data.vertex_classes = {{0, 1}, rim, rim, {0, 2}, {0, 3}};
  data.edges.add(Shape::Line, {2, 3}, rim);
  data.edges.add(Shape::Line, {1, 2}, rim);
  data.edges.add(Shape::Line, {0, 1}, rim);
  data.edges.add(Shape::Line, {0, 4}, left);
  data.edges.add(Shape::Line, {3, 4}, right);
  for (const auto& [a, b] : {std::array{1u, 0u}, std::array{2u, 1u}, std::array{3u, 2u}})
    data.faces.add(Shape::Triangle, {4, a, b}, inside);
  for (const bool turned : {false, true}) {
    for (std::size_t f = 0; turned && f < 3; ++f)
      std::swap(data.faces.vertices[3 * f + 1], data.faces.vertices[3 * f + 2]);
    Mesh mesh(data);
    mesh.set(0, 1);  // all edges are entities: those that are listed come first in a sweep
    DecimationOptions options{.swap = false, .smooth = false};
    const auto spacing = std::make_shared<Column<Vertex, double>>(5);
    (*spacing)[Vertex(1)] = 4, (*spacing)[Vertex(2)] = 16;
    options.spacing = spacing;
    Decimation decimation(mesh, options);
    EXPECT_EQ(decimation.sweep(), 1u);
    EXPECT_EQ(decimation.last_refusal(Edge(0)), Reason::Angle);
    EXPECT_FALSE(mesh.alive(Vertex(1)));
    decimation.run();
    EXPECT_FALSE(mesh.alive(Vertex(2))) << turned;
    EXPECT_EQ(mesh.count(2), 1u);
  }
}

}  // namespace
}  // namespace aomd::paper_loop_test
