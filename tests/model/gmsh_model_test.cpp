// Models from CAD files. Where the program is built without Gmsh, only its refusal is tested.

#include "core/model/gmsh_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "core/decimate/decimation.h"
#include "core/measure/intersections.h"
#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/classify.h"
#include "core/model/mesh_on_model.h"
#include "tests/support/io_helpers.h"

#ifdef AOMD_TEST_WITH_GMSH
#include <gmsh.h>
#endif

namespace aomd::gmsh_model_test {
namespace {

constexpr const char* drilled_box =
    "SetFactory(\"OpenCASCADE\");\n"
    "Box(1) = {-2, -2, -1, 4, 4, 2};\n"
    "Cylinder(2) = {0, 0, -2, 0, 0, 4, 1};\n"
    "BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n";

class GmshModelTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gmsh()) GTEST_SKIP() << "built without Gmsh";
  }
  std::string put(const std::string& name, const std::string& text) const {
    const std::string path = folder_ / name.c_str();
    std::ofstream(path) << text;
    return path;
  }
  static std::string error_of(const std::string& path) {
    try {
      (void)load_gmsh_model(path);
      return "";
    } catch (const ModelError& e) {
      return e.what();
    }
  }

  test::TemporaryFolder folder_;
};

TEST(WithoutGmsh, CadFilesAreRefusedWithAdvice) {
  if (has_gmsh()) GTEST_SKIP() << "built with Gmsh";
  const test::TemporaryFolder folder;
  const std::string path = folder / "part.step";
  std::ofstream(path) << "x";
  try {
    (void)load_gmsh_model(path);
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_EQ(e.what(),
              path + ": built without Gmsh; install libgmsh-dev and build again to read CAD files");
  }
}

TEST(CadFile, IsKnownByItsName) {
  EXPECT_TRUE(is_cad_file("a.step") && is_cad_file("a.STP") && is_cad_file("a/b.brep") &&
              is_cad_file("b.igs"));
  EXPECT_FALSE(is_cad_file("a.stl") || is_cad_file("step") || is_cad_file("a.step.ply"));
}

TEST_F(GmshModelTest, ADrilledBoxHasItsEntities) {
  const auto model = load_gmsh_model(put("part.geo", drilled_box));
  EXPECT_EQ(model->entities(0).size(), 10u);
  EXPECT_EQ(model->entities(1).size(), 15u);
  EXPECT_EQ(model->entities(2).size(), 7u);
  EXPECT_EQ(model->entities(3).size(), 1u);
  EXPECT_EQ(model->closure({3, 1}).size(), 32u);
  EXPECT_NEAR(model->box().diagonal(), 6, 1e-5);
  int holes = 0;
  for (const ModelRef f : model->entities(2)) {
    if (!model->range(f).periodic[0]) continue;
    ++holes;
    EXPECT_EQ(model->closure(f).size(), 5u);  // two circles, the seam, its two ends
    EXPECT_LT(glm::length(model->snap(f, {0.1, 0, 0.5}) - glm::dvec3(1, 0, 0.5)), 1e-14);
    EXPECT_LT(glm::length(model->normal(f, {0.1, 0, 0.5}) - glm::dvec3(-1, 0, 0)), 1e-14);
  }
  EXPECT_EQ(holes, 1);
}

TEST_F(GmshModelTest, UnknownEntitiesAreNamed) {
  const auto model = load_gmsh_model(put("part.geo", drilled_box));
  EXPECT_THROW((void)model->snap({2, 70}, {}), std::invalid_argument);
  EXPECT_THROW((void)model->range({0, 1}), std::invalid_argument);
}

// Closest points of OpenCASCADE's surfaces against the formulas, also far away and near the poles.
TEST_F(GmshModelTest, ElementarySurfacesAgreeWithTheFormulas) {
  const auto model = load_gmsh_model(put(
      "part.geo",
      "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 2};\nTorus(2) = {20, 0, 0, 2, 0.5};\n"));
  const AnalyticModel exact({{1, SphereShape{Frame(), 2}, {}},
                             {2, TorusShape{Frame::around({20, 0, 0}, {0, 0, 1}), 2, 0.5}, {}}});
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 1.5);
  for (const ModelRef f : {ModelRef(2, 1), ModelRef(2, 2)}) {
    for (int i = 0; i < 3000; ++i) {
      const double small = i % 3 == 0 ? 1e-3 : 1;
      const glm::dvec3 p = glm::dvec3(f.tag() == 1 ? 0 : 20, 0, 0) +
                           glm::dvec3(small * noise(random), small * noise(random), noise(random));
      ASSERT_LT(glm::length(model->snap(f, p) - exact.snap(f, p)), 1e-12 * 20)
          << name_of(f) << ' ' << i;
    }
  }
}

// Gmsh's own search gives the far side of an arc to a point beyond its ends; ours must give the
// nearer end.
TEST_F(GmshModelTest, ArcsEndAtTheirEnds) {
  const auto model = load_gmsh_model(
      put("arc.geo",
          "SetFactory(\"OpenCASCADE\");\nCircle(1) = {0, 0, 0, 1, 0, Pi};\nLine(2) = {1, 2};\n"));
  EXPECT_LT(glm::length(model->snap({1, 1}, {0.3, -1, 0}) - glm::dvec3(1, 0, 0)), 1e-14);
  EXPECT_LT(glm::length(model->snap({1, 1}, {-0.3, -1, 0}) - glm::dvec3(-1, 0, 0)), 1e-14);
  EXPECT_LT(glm::length(model->snap({1, 2}, {7, 1, 0}) - glm::dvec3(1, 0, 0)), 1e-14);
}

// The seam and the poles of a sphere are edges of its model: those without length are a point.
TEST_F(GmshModelTest, EdgesWithoutLengthArePoints) {
  const auto model =
      load_gmsh_model(put("s.geo", "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 2};\n"));
  for (const ModelRef e : model->entities(1))
    EXPECT_NEAR(glm::length(model->snap(e, {0.3, 0.2, 0.1})), 2, 1e-12) << name_of(e);
}

TEST_F(GmshModelTest, TheBuiltInKernelIsRefinedToo) {
  const auto model =
      load_gmsh_model(put("k.geo",
                          "Point(1) = {0, 0, 0};\nPoint(2) = {2, 0, 0};\nPoint(3) = {0, 2, 0};\n"
                          "Circle(1) = {2, 1, 3};\nLine(2) = {3, 1};\nLine(3) = {1, 2};\n"
                          "Curve Loop(1) = {1, 2, 3};\nPlane Surface(1) = {1};\n"));
  for (double angle = 0.05; angle < 1.5; angle += 0.1) {
    const glm::dvec3 p = Frame().on_circle(2, angle);
    const glm::dvec3 found = model->snap({1, 1}, 1.3 * p);
    EXPECT_NEAR(glm::length(found), 2, 1e-14);
    EXPECT_LT(glm::length(found - p), 1e-8);  // this kernel differentiates numerically
    EXPECT_LT(glm::length(model->snap({2, 1}, 0.4 * p + glm::dvec3(0, 0, 1)) - 0.4 * p), 1e-12);
  }
}

TEST_F(GmshModelTest, SeveralModelsStayApart) {
  const std::string small =
      put("a.geo", "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 1};\n");
  const std::string large =
      put("b.geo", "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 3};\n");
  auto a = load_gmsh_model(small);
  const auto b = load_gmsh_model(large);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(glm::length(a->snap({2, 1}, {5, 1, 0})), 1, 1e-12);
    EXPECT_NEAR(glm::length(b->snap({2, 1}, {5, 1, 0})), 3, 1e-12);
  }
  a.reset();
  EXPECT_NEAR(glm::length(b->snap({2, 1}, {5, 1, 0})), 3, 1e-12);
}

TEST_F(GmshModelTest, WhatIsNoModelIsNamed) {
  EXPECT_EQ(error_of("nowhere.step"), "nowhere.step: No such file or directory");
  const std::string script =
      put("bad.geo", "Point(1) = {0, 0, 0};\nPoint(2) = {1,\nLine(1) = {1, 2};\n");
  EXPECT_EQ(error_of(script), script + ":3: syntax error (Line)");
  for (const char* name : {"a.step", "a.brep", "a.iges", "a.geo"}) {
    const std::string path = put(name, std::string(name) == "a.geo" ? "x = 1;\n" : "hello world\n");
    const std::string error = error_of(path);
    EXPECT_EQ(error.rfind(path + ": ", 0), 0u) << error;
  }
  EXPECT_EQ(error_of(put("good.geo", drilled_box)), "")
      << "an error must not spoil what is read after it";
}

TEST_F(GmshModelTest, ScriptsThatReachFurtherAreRefused) {
  const std::string victim = folder_ / "victim";
  const std::string path =
      put("evil.geo", "Point(1) = {0, 0, 0};\nSystemCall \"touch " + victim + "\";\n");
  EXPECT_EQ(
      error_of(path),
      path + ":2: uses SystemCall, which is not run; let Gmsh write the model as .brep or .step");
  EXPECT_FALSE(std::filesystem::exists(victim));
  EXPECT_NE(error_of(put("exit.geo", "Point(1) = {0, 0, 0};\nExit;\n")), "");
}

TEST_F(GmshModelTest, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  (void)load_gmsh_model(
      put("p.geo", std::string("General.Terminal = 1;\nPrintf(\"hello\");\n") + drilled_box));
  (void)error_of(put("a.step", "hello world\n"));
  (void)error_of(put("a.brep", "hello world\n"));
  (void)mesh_with_gmsh(put("part.geo", drilled_box), {.size = 1});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

#ifdef AOMD_TEST_WITH_GMSH

// A box with a drilled hole, made with Gmsh's kernel and written as STEP.
class StepTest : public GmshModelTest {
 protected:
  void SetUp() override {
    GmshModelTest::SetUp();
    if (IsSkipped()) return;
    path_ = folder_ / "part.step";
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    const int box = gmsh::model::occ::addBox(-2, -2, -1, 4, 4, 2);
    const int drill = gmsh::model::occ::addCylinder(0, 0, -2, 0, 0, 4, 1);
    gmsh::vectorpair left;
    std::vector<gmsh::vectorpair> from;
    gmsh::model::occ::cut({{3, box}}, {{3, drill}}, left, from);
    gmsh::model::occ::synchronize();
    testing::internal::CaptureStdout();
    gmsh::write(path_);
    testing::internal::GetCapturedStdout();
    gmsh::finalize();
    data_ = mesh_with_gmsh(path_, {.size = 0.3});
    model_ = load_gmsh_model(path_);
  }
  [[nodiscard]] bool in_hole(ModelRef m) const {
    return m.dimension() == 2 && model_->range(m).periodic[0];
  }

  std::string path_;
  MeshData data_;
  std::unique_ptr<Model> model_;
};

TEST_F(StepTest, TheMeshIsWhollyClassified) {
  ASSERT_GT(data_.faces.size(), 1000u);
  EXPECT_EQ(data_.faces.classes.size(), data_.faces.size());
  EXPECT_EQ(data_.edges.classes.size(), data_.edges.size());
  EXPECT_EQ(data_.vertex_classes.size(), data_.positions.size());
  Mesh mesh(data_);
  const ClassifyResult found = classify(mesh);
  EXPECT_EQ(found.model_vertices, 10);
  EXPECT_EQ(found.model_edges, 15);
  EXPECT_EQ(found.model_faces, 7);
  EXPECT_NO_THROW(check_against(mesh, *model_));
  EXPECT_TRUE(verify(mesh).empty());
}

TEST_F(StepTest, OurClassificationIsGmshs) {
  Mesh told(data_);
  classify(told);
  MeshData bare = data_;
  bare.vertex_classes.clear(), bare.edges = {}, bare.faces.classes.clear();
  Mesh found(bare);
  found.set(0, 1);
  classify_on(found, *model_);
  for (const Vertex v : told.vertices())
    ASSERT_EQ(found.classification(v), told.classification(v)) << v.index;
  for (const Face f : told.faces())
    ASSERT_EQ(found.classification(f), told.classification(f)) << f.index;
  for (const Edge e : told.edges()) {
    const auto [a, b] = told.edge_vertices(e);
    ASSERT_EQ(found.classification(found.find_edge(a, b)), told.classification(e)) << e.index;
  }
}

TEST_F(StepTest, TheHoleStaysRound) {
  double largest[2] = {0, 0};
  for (const bool snapping : {false, true}) {
    Mesh mesh(data_);
    classify(mesh);
    const std::uint32_t before = mesh.count(2);
    Decimation decimation(
        mesh, {.factor = 2, .angle_deg = 30, .model = snapping ? model_.get() : nullptr});
    decimation.run();
    EXPECT_LT(mesh.count(2), before / 2);
    EXPECT_TRUE(verify(mesh).empty());
    EXPECT_TRUE(measure::self_intersections(mesh).empty());
    int on_hole = 0;
    for (const Vertex v : mesh.vertices()) {
      const glm::dvec3 p = mesh.position(v);
      const ModelRef m = mesh.classification(v);
      const bool on_circle = m.dimension() == 1 && std::hypot(p.x, p.y) < 1.5;
      if (!in_hole(m) && !on_circle) continue;
      ++on_hole;
      largest[snapping] = std::max(largest[snapping], std::abs(std::hypot(p.x, p.y) - 1));
    }
    EXPECT_GT(on_hole, 10);
  }
  EXPECT_LT(largest[true], 1e-9);
  EXPECT_GT(largest[false], 1e-4);
}

TEST_F(StepTest, VolumesAreMeshedToo) {
  const MeshData volume = mesh_with_gmsh(path_, {.size = 1, .dimension = 3});
  EXPECT_GT(volume.regions.size(), 100u);
  EXPECT_EQ(volume.regions.classes.front(), ModelRef(3, 1));
}

#endif

}  // namespace
}  // namespace aomd::gmsh_model_test
