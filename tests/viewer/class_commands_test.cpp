// The classification edited by commands: history, decimation, refusals, files.

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "core/io/io.h"
#include "core/mesh/verify.h"
#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"
#include "viewer/drawing/selection_drawing.h"
#include "viewer/explain/model_entity.h"

namespace aomd::scene::class_commands_test {
namespace {

using test::drive;

std::string refusal(Session& s, const std::string& line) {
  try {
    execute(s, line);
  } catch (const CommandError& error) {
    s.refresh();
    return error.what();
  }
  return "";
}

//  6---7---8    model face 1 in a border of four model edges
//  | / | / |
//  3---4---5
//  | / | / |
//  0---1---2
class ClassCommandsTest : public testing::Test {
 protected:
  ClassCommandsTest() { take(zoo::grid(2)); }

  void take(const MeshData& data) {
    s.show(make_loaded(data, "grid"));
    s.refresh();
  }
  const Mesh& mesh() const { return s.document().mesh(); }
  std::string edge(std::uint32_t a, std::uint32_t b) const {
    return std::to_string(mesh().find_edge(Vertex(a), Vertex(b)).index);
  }
  std::string line() const { return edge(3, 4) + " " + edge(4, 5); }

  Session s;
};

TEST_F(ClassCommandsTest, PromotingIsOneCommandThatUndoTakesBack) {
  drive(s, {"select edge " + line(), "promote", "expect model-edges = 7",
            "expect model-vertices = 6", "expect commands = 1", "undo", "expect model-edges = 4",
            "expect model-vertices = 4", "redo", "expect model-edges = 7"});
  EXPECT_EQ(s.document().marks()[0].label, "promote");
  drive(s, {"demote edge " + line(), "expect model-edges = 6", "demote vertex 3 5",
            "expect model-edges = 4", "expect model-vertices = 4", "expect commands = 3"});
}

TEST_F(ClassCommandsTest, AssigningAndSplittingGiveTags) {
  drive(s, {"promote edge " + line(), "split-face face:1", "expect model-faces = 2"});
  EXPECT_EQ(s.status, "split-face: now 2 model faces, 7 model edges, 6 model vertices");
  drive(s, {"select face 0 1", "assign face:new border", "expect model-faces = 3"});
  EXPECT_EQ(mesh().classification(Face(0)), ModelRef(2, 3));
  drive(s, {"assign face:9 face 0 1", "expect model-faces = 3"});
  EXPECT_EQ(mesh().classification(Face(1)), ModelRef(2, 9));
  EXPECT_TRUE(verify(mesh()).empty());
}

TEST_F(ClassCommandsTest, ARefusalNamesTheRuleAndChangesNothing) {
  EXPECT_EQ(refusal(s, "demote edge " + edge(0, 1)),
            "demote: edge " + edge(0, 1) +
                " has 1 face and would lie inside model face 1: inside a model face every edge has "
                "two faces");
  EXPECT_FALSE(s.sheet().drawing().drawable().selected.lines.empty())
      << "what breaks the rule is shown";
  EXPECT_NE(refusal(s, "assign face:7 face 0")
                .find("what bounds an entity lies on the same model entity"),
            std::string::npos);
  EXPECT_NE(refusal(s, "assign edge:1 face 0").find("of its own dimension"), std::string::npos);
  EXPECT_EQ(refusal(s, "promote edge " + edge(0, 1)), "promote: nothing would change");
  EXPECT_NE(refusal(s, "promote").find("nothing is selected"), std::string::npos);
  EXPECT_NE(refusal(s, "split-face edge:1").find("only a model face"), std::string::npos);
  EXPECT_EQ(s.document().journal().size(), 0u);
  EXPECT_EQ(s.document().marks().size(), 0u);
  drive(s, {"sample mixed"});
  EXPECT_NE(refusal(s, "promote vertex 0").find("cannot be edited"), std::string::npos);
}

TEST_F(ClassCommandsTest, DecimationKeepsAPromotedLine) {
  take(zoo::grid(8));
  std::string ids;
  for (std::uint32_t i = 0; i < 8; ++i) ids += " " + edge(36 + i, 37 + i);  // the middle line
  for (const char* strategy : {"strategy paper", "strategy quality"}) {
    drive(s, {strategy, "coarsest on", "promote edge" + ids, "run"});
    double length = 0;
    for (const Edge e : mesh().edges()) {
      const auto [a, b] = mesh().edge_vertices(e);
      const auto on_line = [&](Vertex v) { return mesh().position(v).y == 4; };
      if (mesh().classification(e).dimension() == 1 && on_line(a) && on_line(b))
        length += glm::length(mesh().position(a) - mesh().position(b));
    }
    EXPECT_EQ(length, 8) << strategy;
    EXPECT_LT(mesh().count(2), 30u) << strategy;
    EXPECT_TRUE(verify(mesh()).empty());
    drive(s, {"undo", "undo", "expect model-edges = 4", "expect faces = 128"});
  }
}

// The guard measures new pieces of a model edge by the model edge as it was when it was promoted.
TEST_F(ClassCommandsTest, AModelEdgePromotedFirstIsPartOfTheOriginal) {
  take(zoo::grid(8));
  std::string ids;
  for (std::uint32_t i = 0; i < 8; ++i) ids += " " + edge(36 + i, 37 + i);
  DecimationOptions options = s.document().options();
  options.max_distance = 0.01;
  s.document().set_options(options);
  drive(s, {"run", "undo", "promote edge" + ids, "run"});
  std::uint32_t left = 0;
  for (const Vertex v : mesh().vertices()) left += mesh().position(v).y == 4;
  EXPECT_LT(left, 9u) << "vertices of the line have gone";
}

TEST_F(ClassCommandsTest, BranchesKeepTheirClassification) {
  drive(s, {"promote edge " + edge(3, 4), "undo", "promote edge " + edge(4, 5),
            "expect model-edges = 6"});
  ASSERT_EQ(mesh().classification(mesh().find_edge(Vertex(3), Vertex(4))).dimension(), 2);
  drive(s, {"branch switch 1"});
  EXPECT_EQ(mesh().classification(mesh().find_edge(Vertex(3), Vertex(4))).dimension(), 1);
  EXPECT_EQ(mesh().classification(mesh().find_edge(Vertex(4), Vertex(5))).dimension(), 2);
  EXPECT_TRUE(verify(mesh()).empty());
}

TEST_F(ClassCommandsTest, AFeatureAngleIsTriedOutWithoutChangingAnything) {
  take(zoo::torus(9, 7));
  const auto count = [&] { return s.document().journal().size(); };
  drive(s, {"feature-preview 30"});
  ASSERT_NE(s.document().trial(), nullptr);
  const FeaturePreview preview = s.document().trial()->preview;
  EXPECT_EQ(count(), 0u);
  EXPECT_FALSE(s.sheet().drawing().drawable().selected.lines.empty());
  drive(s, {"feature-angle 30"});
  EXPECT_EQ(s.document().trial(), nullptr);
  EXPECT_EQ(s.document().content().classified.model_edges, preview.model_edges);
  EXPECT_EQ(s.document().content().classified.model_vertices, preview.model_vertices);
  drive(s, {"feature-preview 10", "feature-preview off"});
  EXPECT_EQ(s.document().trial(), nullptr);
  EXPECT_TRUE(s.sheet().drawing().drawable().selected.lines.empty());
}

TEST_F(ClassCommandsTest, AModelEntityIsTold) {
  drive(s, {"promote edge " + line(), "split-face face:1"});
  const ModelEntityFacts face = model_entity_facts(mesh(), ModelRef(2, 1));
  EXPECT_EQ(face.counts, (std::array<std::size_t, 4>{0, 3, 4, 0}));
  EXPECT_EQ(face.facts[0], (std::pair<std::string, std::string>("Area", "2")));
  EXPECT_EQ(face.beside, std::vector{ModelRef(2, 2)});
  EXPECT_EQ(face.bounded_by.size(), 8u);  // four model edges, four model vertices
  EXPECT_EQ(face.ids, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  const ModelRef middle = mesh().classification(mesh().find_edge(Vertex(3), Vertex(4)));
  const ModelEntityFacts edge = model_entity_facts(mesh(), middle);
  EXPECT_EQ(edge.facts[0].second, "2");
  EXPECT_EQ(edge.bounds, (std::vector{ModelRef(2, 1), ModelRef(2, 2)}));
  EXPECT_EQ(edge.bounded_by.size(), 2u);
  EXPECT_EQ(edge.beside.size(), 4u);
  const ModelEntityFacts corner = model_entity_facts(mesh(), mesh().classification(Vertex(3)));
  EXPECT_EQ(corner.bounds.size(), 5u);  // three model edges, two model faces
}

TEST_F(ClassCommandsTest, ASelectionIsWrittenWithWhatBoundsIt) {
  drive(s, {"promote edge " + line(), "select face 0 1 2 3"});
  const auto file = std::filesystem::path(testing::TempDir()) / "part of grid.ply";
  execute(s, "export-selection " + file.string());
  EXPECT_EQ(s.status, "Saved 4 faces in " + file.string());
  const MeshData part = io::read(file).mesh;
  EXPECT_EQ(part.positions.size(), 6u);
  EXPECT_EQ(part.faces.size(), 4u);
  EXPECT_EQ(part.edges.size(), 6u);  // all around: the middle line, and half of the border
  EXPECT_EQ(part.vertex_classes[4], mesh().classification(Vertex(4)));
  std::filesystem::remove(file);
  drive(s, {"select edge 0"});
  EXPECT_NE(refusal(s, "export-selection x.ply").find("no faces or regions"), std::string::npos);
}

TEST_F(ClassCommandsTest, FitTakesEntitiesAndModelEntities) {
  take(zoo::grid(8));
  drive(s, {"fit"});
  const double whole = s.view.camera.distance;
  drive(s, {"fit face 0"});
  EXPECT_LT(s.view.camera.distance, whole);
  drive(s, {"select class edge:1", "fit", "fit edge:1"});
  EXPECT_EQ(s.view.camera.target, box_of(mesh(), s.sheet().selection.entities()).center());
  EXPECT_NE(refusal(s, "fit face:77").find("nothing lies on face:77"), std::string::npos);
  EXPECT_NE(refusal(s, "fit nonsense 3").find("none of vertex"), std::string::npos);
}

TEST_F(ClassCommandsTest, AnyProgramOfEditsIsUndoneToTheStart) {
  std::mt19937 random(7);
  const auto below = [&](std::uint32_t n) {
    return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random);
  };
  const std::array<const char*, 3> kinds = {"vertex", "edge", "face"};
  for (int round = 0; round < 6; ++round) {
    take(zoo::grid(6));
    drive(s, {round % 2 == 0 ? "strategy paper" : "strategy quality", "factor 3"});
    const MeshData start = to_data(mesh());
    for (int i = 0; i < 60; ++i) {
      const std::uint32_t dim = below(3);
      std::string entities = kinds[dim];
      for (std::uint32_t n = 1 + below(3); n > 0; --n) {
        std::uint32_t id = below(mesh().capacity(static_cast<int>(dim)));
        while (!mesh().alive({static_cast<int>(dim), id}))
          id = below(mesh().capacity(static_cast<int>(dim)));
        entities += " " + std::to_string(id);
      }
      const std::array<std::string, 9> lines = {
          "promote " + entities,
          "promote " + entities,
          "demote " + entities,
          "assign " + std::string(kinds[dim]) + ":new border " + entities,
          "assign face:2 " + entities,
          "undo",
          "redo",
          "step 3",
          "split-face face:1"};
      refusal(s, lines[below(lines.size())]);
      s.finish();
      s.refresh();
      ASSERT_TRUE(verify(mesh()).empty());
    }
    while (s.document().undo()) {
    }
    EXPECT_EQ(to_data(mesh()), start);
  }
}

}  // namespace
}  // namespace aomd::scene::class_commands_test
