// A drawable and facts that followed the history are those made from scratch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <glm/geometric.hpp>

#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::scene::drawing_test {
namespace {

using test::drive;

template <typename T>
std::size_t dirty_bytes(const Patched<T>& array) {
  std::size_t count = 0;
  for (const ElementRange& r : array.dirty()) count += r.size();
  return count * sizeof(T);
}

std::size_t dirty_bytes(const Drawable& d) {
  return dirty_bytes(d.corners) + dirty_bytes(d.model_edges) + dirty_bytes(d.model_vertices) +
         dirty_bytes(d.highlight_lines) + dirty_bytes(d.highlight_discs);
}

void clean(Drawable& d) {
  d.corners.clean();
  d.model_edges.clean();
  d.model_vertices.clean();
  d.highlight_lines.clean();
  d.highlight_discs.clean();
}

using Bytes = std::vector<std::string>;

/// The live elements, whatever place they have.
template <typename T, typename Alive>
Bytes sorted(const Patched<T>& array, Alive&& alive) {
  Bytes result;
  for (const T& value : array.values())
    if (alive(value)) result.emplace_back(reinterpret_cast<const char*>(&value), sizeof(T));
  std::sort(result.begin(), result.end());
  return result;
}

/// What a renderer would show.
Bytes content(const Drawable& d) {
  Bytes all;
  for (const Corner& c : d.corners.values())
    all.emplace_back(reinterpret_cast<const char*>(&c), sizeof c);
  const Bytes edges = sorted(d.model_edges, [](const Segment& s) { return s.width_px > 0; });
  const Bytes vertices = sorted(d.model_vertices, [](const Disc& v) { return v.radius_px > 0; });
  all.insert(all.end(), edges.begin(), edges.end());
  all.insert(all.end(), vertices.begin(), vertices.end());
  return all;
}

void expect_as_from_scratch(Session& s) {
  s.refresh();
  SurfaceChanges everything;
  everything.everything = true;
  SurfaceDrawing fresh;
  fresh.set_bounds(s.document().content().bounds);
  FieldKeeper fields;
  SurfaceChanges none;
  fields.update(s.view.coloring, {s.document().mesh(), s.document()}, none);
  fresh.set_field(fields.field());
  fresh.update(s.document().mesh(), s.view, everything);
  FactsKeeper facts;
  facts.update(s.document().mesh(), everything);
  EXPECT_EQ(s.sheet().facts(), facts.facts());
  EXPECT_TRUE(content(s.sheet().drawing().drawable()) == content(fresh.drawable()));
}

/// Random operations, scrubbing, restyling; after each the patched drawable must be the rebuilt
/// one.
void follow_randomly(const std::string& sample, unsigned seed) {
  Session s;
  drive(s, {sample, "angle 40", "factor 8"});
  std::mt19937 random(seed);
  const std::vector<std::string> moves = {"step",
                                          "step 7",
                                          "step -1",
                                          "step -5",
                                          "undo",
                                          "redo",
                                          "swap",
                                          "smooth",
                                          "hide face:1 toggle",
                                          "highlight face:1",
                                          "highlight",
                                          "feature-angle 30",
                                          "feature-angle off",
                                          "seek 11",
                                          "sweep",
                                          "topology paper",
                                          "topology safe",
                                          "color quality",
                                          "color distance",
                                          "color curvature",
                                          "color classification",
                                          "clip x 0.4 cells",
                                          "clip off",
                                          "shrink 0.2",
                                          "shrink 0",
                                          "step 30"};
  for (int i = 0; i < 60; ++i) {
    const std::string& move = moves[random() % moves.size()];
    SCOPED_TRACE(sample + ", move " + std::to_string(i) + ": " + move);
    // Several moves between two looks, too: what came and went must not show.
    execute(s, move);
    s.finish();
    if (random() % 3 != 0) expect_as_from_scratch(s);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Drawing, PatchedIsAsFromScratch) {
  for (const char* sample : {"sample sphere 12", "sample bracket 4", "sample torus 16",
                             "sample nonmanifold 4", "sample plane-hole 4", "sample cylinder 8"})
    for (const unsigned seed : {1u, 2u, 3u}) {
      follow_randomly(sample, seed);
      if (HasFailure()) return;
    }
}

TEST(Drawing, PatchedIsAsFromScratchOverAWholeRun) {
  Session s;
  drive(s, {"sample scan 6000"});
  execute(s, "run");
  while (s.document().running()) {
    s.document().tick(std::chrono::microseconds(300));
    expect_as_from_scratch(s);
    ASSERT_FALSE(HasFailure());
  }
}

TEST(Drawing, OneCollapseTouchesLittle) {
  Session s;
  drive(s, {"sample sphere 40", "show operation off"});
  const std::size_t whole = s.sheet().drawing().drawable().corners.size() * sizeof(Corner);
  std::size_t most = 0;
  std::size_t sum = 0;
  constexpr std::size_t steps = 200;
  for (std::size_t i = 0; i < steps; ++i) {
    clean(s.sheet().drawing().drawable());
    drive(s, {"step"});
    most = std::max(most, dirty_bytes(s.sheet().drawing().drawable()));
    sum += dirty_bytes(s.sheet().drawing().drawable());
  }
  RecordProperty("mean_bytes", static_cast<int>(sum / steps));
  RecordProperty("most_bytes", static_cast<int>(most));
  RecordProperty("whole_bytes", static_cast<int>(whole));
  EXPECT_LT(sum / steps, 4096u);
  EXPECT_LT(most, 16384u);
  EXPECT_GT(whole, 100 * sum / steps);
}

TEST(Drawing, UndoAndNewWorkInBetweenNeedsNoFreshStart) {
  Session s;
  drive(s, {"sample sphere 40", "step 20", "undo"});
  clean(s.sheet().drawing().drawable());
  drive(s, {"angle 50", "step"});
  EXPECT_LT(dirty_bytes(s.sheet().drawing().drawable()), 16384u);
  expect_as_from_scratch(s);
}

TEST(Drawing, NormalsAreCrispAtModelEdgesAndSmoothElsewhere) {
  Session s;
  drive(s, {"sample box 3"});
  for (const Corner& c : s.sheet().drawing().drawable().corners.values()) {
    const glm::vec3 n = glm::abs(unpack_normal(c.normal));
    EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1, 0.01);
  }
  drive(s, {"sample sphere 24"});
  const Drawable& sphere = s.sheet().drawing().drawable();
  for (const Corner& c : sphere.corners.values()) {
    const glm::vec3 outward = glm::normalize(c.position + glm::vec3(sphere.origin));
    EXPECT_GT(glm::dot(glm::normalize(unpack_normal(c.normal)), outward), 0.995f);
  }
}

TEST(Drawing, HiddenFacesAreDeadSlotsAndHighlightedOnesBrightWithoutAFreshStart) {
  Session s;
  drive(s, {"sample box 3"});
  clean(s.sheet().drawing().drawable());
  drive(s, {"highlight face:1"});
  const auto flagged = [&] {
    const auto corners = s.sheet().drawing().drawable().corners.values();
    return std::count_if(corners.begin(), corners.end(),
                         [](const Corner& c) { return c.flags == highlighted; });
  };
  EXPECT_EQ(flagged(), 3 * 18);
  drive(s, {"hide face:1"});
  EXPECT_EQ(flagged(), 0);
  drive(s, {"hide face:1 off"});
  EXPECT_EQ(flagged(), 3 * 18);
}

//  3--2    sides are 1 long, the diagonal from 0 to 2 is sqrt(2): their means are 1 at 1 and 3,
//  | /|    1.138 at 0 and 2
//  |/ |
//  0--1
TEST(SpacingColors, AreTheWantedLengthsOfTheVertices) {
  Session s;
  s.show(make_loaded(zoo::square(), "square"));
  drive(s, {"color spacing", "factor 3"});
  ASSERT_NE(s.sheet().field(), nullptr);
  EXPECT_DOUBLE_EQ(s.sheet().field()->scale.low, 3);
  EXPECT_DOUBLE_EQ(s.sheet().field()->scale.high, 2 + std::sqrt(2.0));
  const auto color = [&](std::size_t corner) {
    return s.sheet().drawing().drawable().corners.values()[corner].color;
  };
  for (const std::size_t long_one : {0, 2, 3, 4})
    EXPECT_EQ(color(long_one), ramp_color(1)) << long_one;
  for (const std::size_t short_one : {1, 5})
    EXPECT_EQ(color(short_one), ramp_color(0)) << short_one;
  drive(s, {"factor 6"});
  EXPECT_DOUBLE_EQ(s.sheet().field()->scale.low, 6) << "it follows the options";
  drive(s, {"coarsest on"});
  EXPECT_TRUE(s.sheet().field()->scale.empty());
  EXPECT_EQ(color(0), plain_face_color());
  drive(s, {"color classification"});
  EXPECT_EQ(s.sheet().field(), nullptr);
  EXPECT_EQ(color(0), color_of(s.document().mesh().classification(Face(0))));
}

TEST(SpacingColors, StayWithTheVerticesWhileTheMeshChanges) {
  Session s;
  s.show(make_loaded(zoo::torus(12, 9), "torus"));
  drive(s, {"color spacing"});
  const ScalarField before = *s.sheet().field();
  drive(s, {"sweep", "undo", "redo"});
  EXPECT_EQ(s.sheet().field()->scale.low, before.scale.low);
  EXPECT_EQ(s.sheet().field()->scale.high, before.scale.high);
  const Mesh& mesh = s.document().mesh();
  for (const Face f : mesh.faces())
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(s.sheet().drawing().drawable().corners.values()[3 * f.index + i].color,
                before.color(f, mesh.triangle(f)[i]));
}

TEST(SpacingColors, AnotherMeshHasItsOwnAndWhatIsNotDecimatedNone) {
  Session s;
  s.show(make_loaded(zoo::torus(12, 9), "torus"));
  drive(s, {"color spacing"});
  s.show(make_loaded(zoo::grid(20), "grid"));
  drive(s, {"factor 2"});
  EXPECT_DOUBLE_EQ(s.sheet().field()->scale.low, 2);
  drive(s, {"sample hex-box 2"});
  EXPECT_EQ(s.sheet().field(), nullptr);
  s.show(make_loaded(zoo::grid(3), "grid"));
  s.refresh();
  ASSERT_NE(s.sheet().field(), nullptr);
  EXPECT_EQ(s.sheet().field()->vertices.size(), 16u);
}

TEST(Facts, OfTinyMeshes) {
  Session s;
  s.show(make_loaded(zoo::square(), "square"));
  s.refresh();
  EXPECT_EQ(s.sheet().facts().euler(), 1);
  EXPECT_EQ(s.sheet().facts().boundary, 4);
  EXPECT_EQ(s.sheet().facts().edges, 5);
  MeshData with_unused = zoo::tetrahedron();
  with_unused.positions.emplace_back(9, 9, 9);
  s.show(make_loaded(with_unused, "tetrahedron"));
  s.refresh();
  EXPECT_EQ(s.sheet().facts().unused, 1);
  EXPECT_EQ(s.sheet().facts().euler(), 2);
  EXPECT_EQ(s.sheet().facts().boundary, 0);
}

}  // namespace
}  // namespace aomd::scene::drawing_test
