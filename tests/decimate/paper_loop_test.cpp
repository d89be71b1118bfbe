// What the paper's strategy leaves as it is, and how far it improves.

#include <gtest/gtest.h>

#include <memory>

#include "core/decimate/decimation.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"

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

}  // namespace
}  // namespace aomd
