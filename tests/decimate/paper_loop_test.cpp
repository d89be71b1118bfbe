// What the paper's strategy leaves as it is, and how far it improves.

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/decimate/decimation.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd {
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

// What a collapse changes around it is judged again, at the border too, where the faces around a
// vertex form no ring.
TEST(PaperLoopTest, AtTheEndNoEdgeMayGo) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    MeshData data = zoo::grid(10);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.3, 0.3);
    for (glm::dvec3& p : data.positions) p += glm::dvec3(shift(random), shift(random), 0);
    Mesh mesh(data);
    classify(mesh);
    Decimation decimation(mesh, {.coarsest = true, .swap = false, .smooth = false});
    decimation.run();
    Vertex deleted;
    for (const Edge e : mesh.edges())
      EXPECT_FALSE(decimation.judge(e, deleted).accepted()) << seed << ' ' << e.index;
  }
}

}  // namespace
}  // namespace aomd
