// Selecting, what is said about it, and why edges stay: as scripts drive it.

#include <gtest/gtest.h>

#include "tests/support/session_helpers.h"
#include "viewer/drawing/picking.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene::selection_test {
namespace {

using test::drive;

TEST(Selecting, ReplacesAddsRemovesAndRefusesWhatIsNotThere) {
  Session s;
  drive(s, {"sample sphere 8", "select edge 3 5 4 3", "expect selected = 3", "select add vertex 0",
            "expect selected = 4", "select remove edge 5", "expect selected = 3"});
  EXPECT_EQ(s.sheet().selection.entities()[0], EntityRef(Vertex(0)));
  EXPECT_EQ(selection_text(s.sheet().selection), "2 edges, 1 vertex");
  EXPECT_THROW(execute(s, "select face 100000"), CommandError);
  EXPECT_THROW(execute(s, "select face"), CommandError);
  EXPECT_THROW(execute(s, "select nonsense"), CommandError);
  EXPECT_EQ(s.sheet().selection.size(), 3u) << "a wrong line changes nothing";
  drive(s, {"select none", "expect selected = 0"});
  drive(s, {"sample bracket", "select class face:1"});
  EXPECT_EQ(s.sheet().selection.size(),
            s.document().mesh().class_lists()->entities(2, ModelRef(2, 1)).size());
}

TEST(Selecting, GrowTakesWhatSharesAVertex) {
  Session s;
  drive(s, {"sample sphere 8", "select vertex 0", "select grow"});
  const Mesh& mesh = s.document().mesh();
  EXPECT_EQ(s.sheet().selection.size(), 1 + mesh.row<1>(Vertex(0)).size());
  drive(s, {"select face 0", "select grow"});
  std::set<Face> around;
  for (const Vertex v : mesh.triangle(Face(0)))
    for (const Face f : mesh.row<2>(v)) around.insert(f);
  EXPECT_EQ(s.sheet().selection.size(), around.size());
}

TEST(Selecting, ABarOfAHistogramIsWhatItCounts) {
  Session s;
  drive(s, {"sample torus", "factor 4", "sweep", "panel histograms on", "select bar angle 31"});
  const HistogramPair& angles = s.sheet().histograms()->of(HistogramKind::Angle);
  EXPECT_GT(s.sheet().selection.size(), 0u);
  EXPECT_EQ(s.sheet().selection.size(), angles.now.counts[angles.now.bin(31)]);
  EXPECT_EQ(s.sheet().selection.entities()[0].dimension, 2);
  drive(s, {"panel decimation on", "select bar valence 6"});
  for (const EntityRef e : s.sheet().selection.entities())
    EXPECT_EQ(s.document().mesh().row<1>(Vertex(e.index)).size(), 6u);
  EXPECT_GT(s.sheet().selection.size(), 0u);
  drive(s, {"select bar length 0.01"});
  EXPECT_TRUE(s.sheet().selection.empty());
  EXPECT_THROW(execute(s, "select bar area 1"), CommandError);
  EXPECT_THROW(execute(s, "select bar angle"), CommandError);
  drive(s, {"sample tet-box", "select bar angle 45"});
  EXPECT_GT(s.sheet().selection.size(), 0u);
  EXPECT_EQ(s.sheet().selection.entities()[0].dimension, 3) << "of a volume regions";
}

/// Whether a region reaches to both sides of a height, or lies below it.
struct Reach {
  double low = 1e9, high = -1e9;
  Reach(const Mesh& mesh, EntityRef region) {
    VertexBuffer buffer;
    for (const std::uint32_t v : mesh.vertices_of(region, buffer)) {
      low = std::min(low, mesh.position(Vertex(v)).z);
      high = std::max(high, mesh.position(Vertex(v)).z);
    }
  }
};

TEST(Selecting, SectionsAndShrunkenRegionsGiveTheirRegions) {
  Session s;
  drive(s, {"sample tet-box", "camera top", "clip z 0.45", "pick 0.03 0.05"});
  const Mesh& mesh = s.document().mesh();
  const Box box = s.document().content().bounds;
  ASSERT_EQ(s.sheet().selection.single().dimension, 3);
  const Reach cut(mesh, s.sheet().selection.single());
  const double plane = box.low.z + 0.45 * (box.high.z - box.low.z);
  EXPECT_TRUE(cut.low < plane && plane < cut.high) << cut.low << " " << plane << " " << cut.high;
  const std::size_t tinted = s.sheet().drawing().drawable().selected.faces.size();
  drive(s, {"clip off"});
  EXPECT_LT(s.sheet().drawing().drawable().selected.faces.size(), tinted)
      << "the section is tinted with it";
  drive(s, {"camera iso", "shrink 0.3", "pick-level region", "select box -1 -1 1 1"});
  EXPECT_GT(s.sheet().selection.size(), 1u);
  drive(s, {"pick 0.03 0.05"});
  EXPECT_EQ(s.sheet().selection.single().dimension, 3);
  drive(s, {"pick-level vertex", "pick 0.03 0.05"});
  EXPECT_TRUE(s.sheet().selection.empty());
}

TEST(Selecting, NothingIsSaidOfTheEdgesOfHexahedra) {
  Session s;
  drive(s, {"sample sphere 8", "color verdict"});
  EXPECT_NE(s.sheet().verdicts(), nullptr);
  drive(s, {"sample hex-box"});
  EXPECT_EQ(s.sheet().verdicts(), nullptr);
}

TEST(Selecting, SurvivesStepsAsFarAsEntitiesLive) {
  Session s;
  drive(s, {"sample sphere 12", "coarsest on", "angle 60"});
  std::string all = "select edge";
  for (const Edge e : s.document().mesh().edges()) all += " " + std::to_string(e.index);
  const auto before = static_cast<std::size_t>(s.document().mesh().count(1));
  drive(s, {all});
  EXPECT_EQ(s.sheet().selection.size(), before);
  drive(s, {"step"});
  EXPECT_EQ(s.sheet().selection.size(), before - 3) << "a collapse takes three edges";
  for (const EntityRef e : s.sheet().selection.entities())
    EXPECT_TRUE(s.document().mesh().alive(e));
  drive(s, {"step -1"});
  EXPECT_EQ(s.sheet().selection.size(), before - 3) << "what comes back is not selected again";
  drive(s, {"sample sphere 8"});
  EXPECT_TRUE(s.sheet().selection.empty());
}

TEST(Selecting, AnEdgeIsJudgedAsTheLoopWould) {
  Session s;
  drive(s, {"sample sphere 12", "run", "select refused angle"});
  ASSERT_GT(s.sheet().selection.size(), 0u);
  const std::string edge = std::to_string(s.sheet().selection.entities()[0].index);
  drive(s, {"select edge " + edge});
  ASSERT_NE(s.sheet().inquiry().verdict(), nullptr);
  const CollapseWay& way = s.sheet().inquiry().verdict()->ways[s.sheet().inquiry().verdict()->best];
  EXPECT_EQ(way.outlook.verdict.reason, Reason::Angle);
  EXPECT_NE(way.words.find("would turn by"), std::string::npos) << way.words;
  EXPECT_FALSE(s.sheet().drawing().drawable().preview.faces.empty());
  drive(s, {"preview off"});
  EXPECT_TRUE(s.sheet().drawing().drawable().preview.faces.empty());
  drive(s, {"preview best", "angle 90"});
  EXPECT_NE(s.sheet()
                .inquiry()
                .verdict()
                ->ways[s.sheet().inquiry().verdict()->best]
                .outlook.verdict.reason,
            Reason::Angle)
      << "new options are followed";
}

// The middle of an edge of the scan that is near the middle of the picture.
TEST(Selecting, ThePreviewIsOfTheEdgeThatTheMousePointsAt) {
  Session s;
  drive(s, {"sample scan 2000", "strategy paper", "pick-level face"});
  const Mesh& mesh = s.document().mesh();
  const Projector project(s.view, s.document().content().bounds);
  const EntityRef under_middle = s.pick({0, 0});
  ASSERT_EQ(under_middle.dimension, 2);
  const auto [a, b, c] = mesh.triangle(Face(under_middle.index));
  const Edge edge = mesh.find_edge(a, b), other = mesh.find_edge(b, c);
  drive(s, {"pick-level edge"});
  const auto point_at = [&](Edge e) {
    s.hover(project.ndc(project(middle_of(mesh, e))));
    s.refresh();
    ASSERT_TRUE(s.sheet().inquiry().hovered() &&
                s.sheet().inquiry().hovered()->entity == EntityRef(e));
  };
  const auto& faces = s.sheet().drawing().drawable().preview.faces;
  point_at(edge);
  const std::vector<Corner> of_edge(faces.values().begin(), faces.values().end());
  EXPECT_FALSE(of_edge.empty());
  EXPECT_FALSE(s.sheet().inquiry().hovered_words().empty());
  s.hover({});
  s.refresh();
  EXPECT_TRUE(faces.empty());
  drive(s, {"select edge " + std::to_string(edge.index)});
  const std::vector<Corner> of_selected(faces.values().begin(), faces.values().end());
  point_at(other);
  const auto positions = [](std::span<const Corner> corners) {
    std::vector<glm::vec3> all;
    for (const Corner& each : corners) all.push_back(each.position);
    return all;
  };
  EXPECT_FALSE(faces.empty());
  EXPECT_NE(positions(faces.values()), positions(of_selected))
      << "what the mouse points at comes first";
  s.hover({});
  s.refresh();
  EXPECT_EQ(positions(faces.values()), positions(of_selected));
  point_at(other);
  drive(s, {"preview off"});
  EXPECT_TRUE(faces.empty());
}

TEST(Selecting, ThePreviewOfASwapIsTheOtherDiagonal) {
  Session s;
  drive(s, {"sample sphere 12", "step 40"});
  const Mesh& mesh = s.document().mesh();
  const Edge edge = *mesh.edges().begin();
  drive(s, {"select edge " + std::to_string(edge.index), "preview swap"});
  ASSERT_NE(s.sheet().inquiry().verdict(), nullptr);
  ASSERT_TRUE(s.sheet().inquiry().verdict()->swap);
  const EdgePair& pair = s.sheet().inquiry().verdict()->swap->pair;
  const Drawable& drawable = s.sheet().drawing().drawable();
  const Overlay& preview = drawable.preview;
  ASSERT_EQ(preview.faces.size(), 6u) << "two faces";
  const auto shows = [&](Vertex v) {
    const glm::vec3 p(mesh.position(v) - drawable.origin);
    const auto corners = preview.faces.values();
    return std::count_if(corners.begin(), corners.end(),
                         [&](const Corner& c) { return c.position == p; });
  };
  EXPECT_EQ(shows(pair.c), 2) << "the far corners belong to both";
  EXPECT_EQ(shows(pair.d), 2);
  EXPECT_EQ(shows(pair.a), 1);
  EXPECT_EQ(shows(pair.b), 1);
  drive(s, {"preview best"});
  EXPECT_NE(preview.faces.size(), 6u);
}

TEST(Selecting, TheColoursCountEveryEdgeOnce) {
  Session s;
  drive(s, {"sample scan 2000", "color verdict"});
  ASSERT_NE(s.sheet().verdicts(), nullptr);
  const auto sum = [&] {
    std::int64_t n = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(reason_count); ++i)
      n += s.sheet().verdicts()->counts()[i];
    return n;
  };
  EXPECT_EQ(sum(), s.sheet().facts().edges);
  drive(s, {"step 5"});
  EXPECT_EQ(sum(), s.sheet().facts().edges);
  // After a few steps only their surroundings were judged again: all of it must agree with a fresh
  // look.
  for (int i = 0; i < reason_count; ++i) {
    const auto reason = static_cast<Reason>(i);
    EXPECT_EQ(static_cast<std::int64_t>(find_edges_refused_for(s.document(), reason).size()),
              s.sheet().verdicts()->counts()[static_cast<std::size_t>(i)])
        << reason_word(reason);
  }
  drive(s, {"run"});
  EXPECT_EQ(sum(), s.sheet().facts().edges);
  EXPECT_EQ(s.sheet().verdicts()->counts()[0], 0) << "nothing is left that could go";
  drive(s, {"color none"});
  EXPECT_EQ(s.sheet().verdicts(), nullptr);
}

TEST(Selecting, LookingChangesNoResult) {
  for (const char* strategy : {"strategy paper", "strategy quality"}) {
    Session asked, silent;
    drive(asked, {"sample scan 2000", strategy, "color verdict", "select edge 17", "angle 20",
                  "hover 0 0", "sweep", "select refused angle", "undo", "redo", "color none"});
    drive(silent, {"sample scan 2000", strategy, "angle 20", "sweep", "undo", "redo"});
    EXPECT_EQ(asked.sheet().facts(), silent.sheet().facts()) << strategy;
    for (const Vertex v : silent.document().mesh().vertices()) {
      ASSERT_TRUE(asked.document().mesh().alive(v));
      EXPECT_EQ(asked.document().mesh().position(v), silent.document().mesh().position(v));
    }
  }
}

TEST(Selecting, AMenuIsForWhatLiesThereOrForTheSelectionItIsPartOf) {
  Session s;
  drive(s, {"sample bracket 4", "pick-level face", "menu 0 0"});
  ASSERT_EQ(s.sheet().selection.size(), 1u);
  ASSERT_TRUE(s.view.menu.has_value());
  const EntityRef face = s.sheet().selection.single();
  EXPECT_EQ(face, s.pick({0, 0}));
  drive(s, {"copy selection"});
  EXPECT_EQ(s.clipboard.get(), "face " + std::to_string(face.index) + "\n");
  drive(s, {"select grow", "menu off"});
  EXPECT_FALSE(s.view.menu.has_value());
  const std::size_t several = s.sheet().selection.size();
  ASSERT_GT(several, 1u);
  drive(s, {"menu 0 0"});
  EXPECT_EQ(s.sheet().selection.size(), several) << "it is part of the selection";
  drive(s, {"menu -0.99 -0.99"});
  EXPECT_EQ(s.sheet().selection.size(), several) << "nothing lies there";
  drive(s, {"sample sphere 8"});
  EXPECT_FALSE(s.view.menu.has_value());
}

TEST(Selecting, WhatIsCopiedNamesFactsAndNeighbours) {
  Session s;
  drive(s, {"sample plane-hole", "select vertex 0", "why"});
  const std::string text = s.log.value_or("");
  EXPECT_EQ(text.rfind("Vertex 0\nLies on: model ", 0), 0u) << text;
  EXPECT_NE(text.find("Smoothing: "), std::string::npos) << text;
  const std::size_t faces = s.document().mesh().row<2>(Vertex(0)).size();
  EXPECT_NE(text.find("Faces " + std::to_string(faces) + ":"), std::string::npos) << text;
  drive(s, {"sample tet-box", "select region 0", "why"});
  EXPECT_NE(s.log->find("Vertices 4:"), std::string::npos) << *s.log;
  EXPECT_EQ(s.sheet().inquiry().verdict(), nullptr) << "nothing is said of regions";
  drive(s, {"sample hex-box", "select vertex 0", "why"});
  EXPECT_NE(s.log->find("Regions ("), std::string::npos) << "nothing stored leads up: " << *s.log;
}

}  // namespace
}  // namespace aomd::scene::selection_test
