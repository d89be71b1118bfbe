// Commands that give a model and keep smoothing on it.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <glm/geometric.hpp>

#include "core/model/analytic_model.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/gmsh_model.h"
#include "core/model/mesh_on_model.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"
#include "viewer/base/text.h"

namespace aomd::scene::model_view_test {
namespace {

using test::drive;

constexpr const char* box = "SetFactory(\"OpenCASCADE\");\nBox(1) = {-1, -1, -1, 2, 2, 2};\n";
constexpr const char* cylinder =
    "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 0, 0, 3, 1};\n";

/// How far the vertices are from the model entities that they lie on, at most.
double distance_to(const Model& model, const Mesh& mesh) {
  double largest = 0;
  for (const Vertex v : mesh.vertices()) {
    const glm::dvec3 p = mesh.position(v);
    largest = std::max(largest, glm::length(model.snap(mesh.classification(v), p) - p));
  }
  return largest;
}

double distance_to_original(const Session& s, const char* sample, int size) {
  Mesh mesh(make_sample(sample, size));
  classify(mesh, s.document().content().classify_options);
  return distance_to(DiscreteModel(mesh), s.document().mesh());
}

std::string error_of(Session& session, const std::string& line) {
  try {
    drive(session, {line});
    return "";
  } catch (const ModelError& error) {
    return error.what();
  }
}

TEST(SnapCommand, VerticesStayOnTheFacetsOfTheMeshAsOpened) {
  Session s;
  drive(s, {"sample cylinder 12", "factor 3", "sweep 2", "improve"});
  EXPECT_GT(distance_to_original(s, "cylinder", 12), 1e-4);
  drive(s, {"reset", "snap model", "sweep 2", "improve", "run"});
  EXPECT_LT(distance_to_original(s, "cylinder", 12), 1e-13);
  EXPECT_GT(s.document().last_sweep()->faces, 0u);
  drive(s, {"sample bracket", "run"});  // it holds for the next mesh too
  EXPECT_LT(distance_to_original(s, "bracket", 0), 1e-13);
}

TEST(SnapCommand, TheOriginalIsTheMeshAsOpenedHoweverLateItIsAskedFor) {
  Session s;
  drive(s, {"sample cylinder 12", "factor 3", "improve-passes 0",
            "sweep"});  // collapses keep vertices where they are
  const std::size_t done = s.document().journal().size();
  drive(s, {"step -3", "snap model", "snap none", "snap model"});
  EXPECT_EQ(s.document().journal().size(), done);
  drive(s, {"smooth"});
  EXPECT_GT(s.document().journal().size(), done - 3);
  EXPECT_LT(distance_to_original(s, "cylinder", 12), 1e-13);
  const MeshFacts after = s.sheet().facts();
  drive(s, {"undo", "redo"});
  EXPECT_EQ(s.sheet().facts(), after);
  drive(s, {"reset"});
  EXPECT_EQ(s.sheet().facts(), s.sheet().loaded_facts());
}

TEST(SnapCommand, AnotherClassificationStartsAnotherOriginal) {
  Session s;
  drive(s, {"sample sphere 12", "snap model", "smooth", "feature-angle 3", "smooth", "step 5"});
  drive(s, {"undo", "undo", "undo", "feature-angle 90", "smooth", "run", "undo", "undo", "undo",
            "run"});
  EXPECT_LT(distance_to_original(s, "sphere", 12), 1e-13);
}

TEST(SnapCommand, AClassificationInTheSamePlaceOfTheHistoryIsAnotherOne) {
  Session s;
  drive(s, {"sample scan 2000", "snap model", "feature-angle 14", "smooth", "undo", "undo"});
  drive(s, {"feature-angle 7", "smooth"});
  EXPECT_EQ(s.document().marks().size(), 2u);
  EXPECT_LT(distance_to_original(s, "scan", 2000), 1e-13);
}

TEST(SnapCommand, SettingItEndsARun) {
  Session s;
  drive(s, {"sample sphere 24"});
  execute(s, "run");
  s.document().tick(std::chrono::microseconds(1));
  drive(s, {"snap model"});
  EXPECT_FALSE(s.document().running());
  drive(s, {"run", "snap none", "run"});
  EXPECT_THROW(drive(s, {"snap facets"}), CommandError);
  EXPECT_THROW(drive(s, {"snap"}), CommandError);
}

TEST(ModelCommand, WrongFilesAreRefusedAndKeepEverything) {
  const aomd::test::TemporaryFolder folder;
  std::ofstream(folder / "bad.step") << "not a model";
  Session s;
  EXPECT_THROW(drive(s, {"model a.step"}), CommandError);  // no mesh yet
  drive(s, {"sample sphere 8", "step 2"});
  for (const char* name : {"bad.step", "absent.geo"}) {
    const std::string path = folder / name;
    EXPECT_NE(error_of(s, "model \"" + path + "\"").find(path), std::string::npos) << name;
    EXPECT_EQ(s.document().model(), nullptr);
    EXPECT_EQ(s.document().journal().cursor(), 2u);
    EXPECT_EQ(s.document().marks().size(), 1u);
  }
  EXPECT_THROW(drive(s, {"model"}), CommandError);
  drive(s, {"model none", "snap model", "sweep"});
}

class ModelCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gmsh()) GTEST_SKIP() << "built without Gmsh";
    std::ofstream(folder_ / "box.geo") << box;
    std::ofstream(folder_ / "cylinder.geo") << cylinder;
    open_bare_cylinder();
  }
  [[nodiscard]] std::string give(const char* name) const {
    return "model \"" + (folder_ / name).string() + "\"";
  }
  /// Meshed from the model, without a word on what lies where.
  void open_bare_cylinder() {
    MeshData data = mesh_with_gmsh(folder_ / "cylinder.geo", {.size = 0.25});
    data.vertex_classes.clear();
    data.edges = {};
    data.faces.classes.clear();
    session_.show(make_loaded(data, "bare"));
    session_.refresh();
  }
  /// Of the side, and the circles around it; the seam is no part of the mesh.
  [[nodiscard]] double distance() const {
    double largest = 0;
    for (const Vertex v : session_.document().mesh().vertices()) {
      const glm::dvec3 p = session_.document().mesh().position(v);
      if (session_.document().mesh().row<2>(v).empty()) continue;
      const double radius = std::hypot(p.x, p.y);
      const bool inside_a_lid = std::abs(p.z) < 1e-9 || std::abs(p.z - 3) < 1e-9;
      if (!inside_a_lid) largest = std::max(largest, std::abs(radius - 1));
    }
    return largest;
  }

  aomd::test::TemporaryFolder folder_;
  Session session_;
};

TEST_F(ModelCommandTest, ABareMeshIsClassifiedOnItAndStaysOnIt) {
  drive(session_, {give("cylinder.geo")});
  EXPECT_EQ(session_.status, "Model cylinder.geo: 1 region, 3 faces, 3 edges, 2 vertices");
  EXPECT_TRUE(session_.document().lies_on_model());
  const std::int64_t faces = session_.sheet().facts().faces;
  drive(session_, {"expect model-faces = 3", "snap model", "factor 2", "angle 30", "run"});
  EXPECT_LT(session_.sheet().facts().faces, faces);
  EXPECT_LT(distance(), 1e-9);
  drive(session_, {"undo", "undo"});
  EXPECT_FALSE(session_.document().lies_on_model());
  drive(session_, {"feature-angle 5", "smooth"});  // puts it back on the model first
  EXPECT_TRUE(session_.document().lies_on_model());
  EXPECT_LT(distance(), 1e-9);
}

TEST_F(ModelCommandTest, AModelThatDoesNotFitIsRefused) {
  drive(session_, {give("cylinder.geo"), "step 4"});
  const std::size_t cursor = session_.document().journal().cursor();
  const std::string error = error_of(session_, give("box.geo"));
  EXPECT_NE(error.find("box.geo"), std::string::npos) << error;
  EXPECT_EQ(session_.document().model()->file.filename(), "cylinder.geo");
  EXPECT_EQ(session_.document().journal().cursor(), cursor);
  EXPECT_TRUE(session_.document().lies_on_model());
}

TEST_F(ModelCommandTest, AMeshThatLeftItsModelCannotBeSnappedUntilItIsBack) {
  drive(session_, {"smooth"});
  EXPECT_GT(distance(), 1e-6);
  EXPECT_NE(error_of(session_, give("cylinder.geo")), "");
  drive(session_, {"reset", give("cylinder.geo"), "snap model", "reset", "snap none", "smooth",
                   "snap model"});
  EXPECT_NE(error_of(session_, "smooth").find("cylinder.geo"), std::string::npos);
  EXPECT_EQ(session_.document().marks().size(), 1u);
  drive(session_, {"reset", "smooth"});
  EXPECT_LT(distance(), 1e-9);
}

TEST_F(ModelCommandTest, AnotherMeshOrNoneDropsIt) {
  drive(session_, {give("cylinder.geo"), "snap model", "sweep", "model none", "sweep"});
  EXPECT_EQ(session_.document().model(), nullptr);
  drive(session_, {"sample sphere 8"});
  open_bare_cylinder();
  drive(session_, {give("cylinder.geo"), "improve", "sample sphere 8"});
  EXPECT_EQ(session_.document().model(), nullptr);
  EXPECT_TRUE(session_.document().snaps());
  drive(session_, {"improve"});
}

TEST(ModelCounts, AreWords) {
  EXPECT_EQ(counts_text({2, 1, 7, 0}), "7 faces, 1 edge, 2 vertices");
  EXPECT_EQ(counts_text({}), "");
}

}  // namespace
}  // namespace aomd::scene::model_view_test
