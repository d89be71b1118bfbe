// What is asked, pointed at and previewed inside of volumes.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/io/io.h"
#include "core/operators/ball.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/view_helpers.h"
#include "viewer/drawing/selection_drawing.h"
#include "viewer/explain/entity_verdict.h"

namespace aomd::scene::volume_inquiry_test {
namespace {

using test::drive;

const EntityVerdict& verdict(Session& s) { return *s.sheet().inquiry().verdict(); }

std::size_t triangles_in(const Session& s, Color color) {
  const auto corners = s.sheet().drawing().drawable().preview.faces.values();
  return static_cast<std::size_t>(std::count_if(
             corners.begin(), corners.end(),
             [&](Corner c) { return (c.color & 0xffffffu) == (color & 0xffffffu); })) /
         3;
}

/// The first edge with both ends inside model regions of which `fits` holds.
template <typename Fits>
Edge inner_edge(Session& s, Fits&& fits) {
  const Mesh& mesh = s.document().mesh();
  Decimation& decimation = *s.document().build_decimation_to_judge();
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    const bool inside =
        mesh.classification(a).dimension() == 3 && mesh.classification(b).dimension() == 3;
    if (inside && fits(*judge(decimation, mesh, e))) return e;
  }
  return {};
}

void select(Session& s, Edge e) { drive(s, {"select edge " + std::to_string(e.index)}); }

TEST(VolumeInquiry, EveryEdgeIsAnsweredInWords) {
  for (const char* strategy : {"paper", "quality"}) {
    Session s;
    drive(s, {"sample ball-in-box 1", std::string("strategy ") + strategy, "select edge 0"});
    const Mesh& mesh = s.document().mesh();
    ASSERT_GT(mesh.count(1), 1000u);
    for (const Edge e : mesh.edges()) {
      select(s, e);
      ASSERT_FALSE(short_words(verdict(s)).empty()) << e.index;
      ASSERT_FALSE(verdict(s).swap_words.empty()) << e.index;
      ASSERT_EQ(verdict(s).swap_words.find("nan"), std::string::npos) << e.index;
    }
  }
}

// The last edge and face of all, of a file that lists neither.
TEST(VolumeInquiry, EdgesAndFacesOfAFreshVolumeAreSelectedByTheirIds) {
  const aomd::test::TemporaryFolder folder;
  const std::string file = (folder / "ball.vtk").string();
  MeshData ball = make_sample("tet-ball", 2);
  ball.faces = ball.edges = {};
  io::write(file, ball);
  Session known;
  drive(known, {"open " + file, "select edge 0"});
  const std::uint32_t edges = known.document().mesh().count(1),
                      faces = known.document().mesh().count(2);
  for (const auto& [kind, id] : {std::pair{"edge", edges - 1}, std::pair{"face", faces - 1}}) {
    Session s;
    drive(s, {"open " + file});
    EXPECT_EQ(s.document().mesh().count(1) + s.document().mesh().count(2), 0u);
    drive(s, {std::string("select ") + kind + ' ' + std::to_string(id), "expect selected = 1"});
    EXPECT_EQ(s.document().mesh().count(1), edges);
    EXPECT_EQ(s.document().mesh().count(2), faces);
  }
  EXPECT_THROW(drive(known, {"select edge " + std::to_string(edges)}), CommandError);
}

TEST(VolumeInquiry, RemovingAnInnerEdgeIsExplainedByTetrahedra) {
  Session s;
  drive(s, {"sample ball-in-box 1", "select edge 0"});
  const Edge poor = inner_edge(
      s, [](const EntityVerdict& j) { return j.swap->verdict.reason == Reason::Quality; });
  ASSERT_TRUE(poor.valid());
  select(s, poor);
  EXPECT_NE(verdict(s).swap_words.find("smallest dihedral angle of "), std::string::npos);
  EXPECT_NE(verdict(s).swap_words.find("would not pay"), std::string::npos);
}

TEST(VolumeInquiry, ADihedralAngleBelowTheLimitIsNamedWithIt) {
  for (const char* strategy : {"paper", "quality"}) {
    Session s;
    drive(s, {"sample ball-in-box 1", std::string("strategy ") + strategy, "min-dihedral 60",
              "select edge 0"});
    const Edge thin = inner_edge(s, [](const EntityVerdict& j) {
      return j.ways[j.best].outlook.verdict.reason == Reason::Shape;
    });
    ASSERT_TRUE(thin.valid()) << strategy;
    select(s, thin);
    const std::string words = short_words(verdict(s));
    EXPECT_NE(words.find("Tetrahedron "), std::string::npos) << words;
    EXPECT_NE(words.find(" would have an angle of "), std::string::npos) << words;
    EXPECT_NE(words.find(" degrees; the limit is 60."), std::string::npos) << words;
  }
}

TEST(VolumeInquiry, UnderACutInnerEdgesArePointedAtAndJudged) {
  Session s;
  drive(s, {"sample ball-in-box 1", "clip x 0.5 cells", "camera right", "fit", "pick-level edge"});
  EXPECT_FALSE(s.document().content().prepared);
  const Mesh& mesh = s.document().mesh();
  std::size_t inner = 0;
  for (double x = -0.9; x < 0.9; x += 0.1)
    for (double y = -0.9; y < 0.9; y += 0.1) {
      s.sheet().hover(glm::dvec2(x, y));
      s.refresh();
      const Hovered* at = s.sheet().inquiry().hovered();
      if (at == nullptr || mesh.classification(at->entity).dimension() != 3) continue;
      ++inner;
      EXPECT_FALSE(s.sheet().inquiry().hovered_words().empty());
      EXPECT_FALSE(s.sheet().drawing().drawable().hovered.lines.empty());
      EXPECT_FALSE(s.sheet().drawing().drawable().preview.lines.empty());
    }
  EXPECT_GT(inner, 10u);
  EXPECT_TRUE(s.document().content().prepared);
}

TEST(VolumeInquiry, EdgesRefusedForAReasonAreFoundInAFreshVolumeToo) {
  Session fresh, prepared;
  drive(fresh, {"sample ball-in-box 1", "select refused none"});
  drive(prepared, {"sample ball-in-box 1", "select edge 0", "select refused none"});
  const auto found = [](const Session& s) {
    const auto entities = s.sheet().selection.entities();
    return std::vector<EntityRef>(entities.begin(), entities.end());
  };
  EXPECT_GT(found(fresh).size(), 100u);
  EXPECT_EQ(found(fresh), found(prepared));
}

TEST(VolumeInquiry, WithoutACutPointingPreparesNothing) {
  Session s;
  drive(s, {"sample ball-in-box 1", "pick-level edge", "hover 0 0", "clip x 0.5", "hover 0 0"});
  EXPECT_FALSE(s.document().content().prepared);
}

TEST(VolumeInquiry, APreviewShowsWhatVanishesAndWhatStretches) {
  Session s;
  drive(s, {"sample ball-in-box 1", "select edge 0"});
  const Edge e = inner_edge(
      s, [](const EntityVerdict& j) { return j.ways[j.best].outlook.verdict.accepted(); });
  ASSERT_TRUE(e.valid());
  select(s, e);
  const Mesh& mesh = s.document().mesh();
  const Contraction& c = verdict(s).ways[verdict(s).best].outlook.contraction;
  Ball ball;
  gather(mesh, c.deleted, ball);
  const auto ring = static_cast<std::size_t>(
      std::count_if(ball.begin(), ball.end(), [&](const BallRegion& r) { return r.uses(c.kept); }));
  EXPECT_GE(ring, 3u);
  EXPECT_EQ(triangles_in(s, vanishing_color()), 4 * ring);
  EXPECT_EQ(triangles_in(s, deciding_style().color), 0u);
  drive(s, {"preview off"});
  EXPECT_TRUE(s.sheet().drawing().drawable().preview.faces.empty());
}

TEST(VolumeInquiry, TheTetrahedronThatDecidesIsDrawnAsItWouldBe) {
  Session s;
  drive(s, {"sample ball-in-box 1", "select edge 0"});
  const Edge e = inner_edge(s, [](const EntityVerdict& j) {
    return j.ways[j.best].outlook.verdict.entity.dimension == 3;
  });
  ASSERT_TRUE(e.valid());
  select(s, e);
  EXPECT_EQ(triangles_in(s, deciding_style().color), 4u);
}

TEST(VolumeInquiry, AHiddenEdgeIsSeenThroughGlassThatEndsThere) {
  Session s;
  drive(s, {"sample ball-in-box 1", "select edge 0"});
  EXPECT_FALSE(s.sheet().preview_cut()) << "it lies on the surface";
  const Edge e = inner_edge(s, [](const EntityVerdict&) { return true; });
  select(s, e);
  const auto plane = s.sheet().preview_cut();
  ASSERT_TRUE(plane);
  const glm::dvec3 normal(*plane);
  EXPECT_NEAR(glm::length(normal), 1, 1e-12);
  for (const Vertex v : s.document().mesh().edge_vertices(e))
    EXPECT_NEAR(glm::dot(normal, s.document().mesh().position(v)) + plane->w, 0, 1e-12);
  const glm::dvec3 sight =
      s.view.camera.ray({0, 0}, s.view.aspect, s.document().content().bounds).direction;
  EXPECT_GT(glm::dot(normal, sight), 0) << "what lies before the edge is taken away";
  for (const char* line :
       {"clip x 0.5", "show interior-edges on", "preview off", "neighbours face"}) {
    drive(s, {line});
    EXPECT_FALSE(s.sheet().preview_cut()) << line;
    drive(s, {"clip off", "show interior-edges off", "preview on", "neighbours off"});
    EXPECT_TRUE(s.sheet().preview_cut());
  }
}

TEST(VolumeInquiry, RegionsAreListedWithTheirVolumes) {
  Session s;
  drive(s, {"sample ball-in-box 1", "panel histograms on"});
  const auto regions = [&] { return s.sheet().histograms()->regions; };
  ASSERT_EQ(regions().size(), 2u);
  EXPECT_EQ(regions()[0].now.model, ModelRef(3, 1));
  EXPECT_EQ(regions()[0].now.count + regions()[1].now.count, 768);
  const Box& box = s.document().content().bounds;
  const glm::dvec3 size = box.high - box.low;
  EXPECT_NEAR(regions()[0].now.volume + regions()[1].now.volume, size.x * size.y * size.z, 1e-12);
  EXPECT_EQ(regions()[0].percent(), 0);
  drive(s, {"angle 60", "run"});
  EXPECT_LT(regions()[0].now.count, regions()[0].before.count);
  EXPECT_LT(regions()[0].percent(), -0.1) << "the printed loop lets balls shrink";
  EXPECT_TRUE(regions()[0].large());
  EXPECT_NEAR(regions()[0].now.volume + regions()[1].now.volume, size.x * size.y * size.z, 1e-12);
}

}  // namespace
}  // namespace aomd::scene::volume_inquiry_test
