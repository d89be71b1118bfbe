// Snapping in smoothing, in the decimation and on the command line.

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/decimate/decimation.h"
#include "core/measure/intersections.h"
#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/discrete_model.h"
#include "core/model/gmsh_model.h"
#include "core/operators/smooth.h"
#include "core/samples/samples.h"
#include "tests/support/cli_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::snap_test {
namespace {

constexpr ModelRef side{2, 1};

double distance_to(const Model& model, const Mesh& mesh, Vertex v) {
  const glm::dvec3 p = mesh.position(v);
  return glm::length(model.snap(mesh.classification(v), p) - p);
}

// The largest distance of a vertex on the cylinder's side and circles from them.
double decimated_cylinder(const Model* model, std::uint32_t& faces) {
  Mesh mesh(make_sample("cylinder", 12));
  Decimation decimation(mesh, {.factor = 3, .model = model});
  decimation.run();
  EXPECT_TRUE(verify(mesh).empty());
  EXPECT_TRUE(measure::self_intersections(mesh).empty());
  faces = mesh.count(2);
  const AnalyticModel cylinder = cylinder_model(1, 2);
  double largest = 0;
  for (const Vertex v : mesh.vertices())
    if (const ModelRef m = mesh.classification(v); m == side || m.dimension() == 1)
      largest = std::max(largest, distance_to(cylinder, mesh, v));
  return largest;
}

TEST(Snap, ADecimatedCylinderStaysOnTheCylinder) {
  const AnalyticModel model = cylinder_model(1, 2);
  std::uint32_t faces = 0;
  EXPECT_LT(decimated_cylinder(&model, faces), 1e-9);
  EXPECT_LT(faces, 2500u);  // of 5184
  EXPECT_GT(decimated_cylinder(nullptr, faces), 1e-4);
}

TEST(Snap, OnTheFacetedOriginalVerticesStayOnItsFacets) {
  Mesh mesh(make_sample("bracket"));
  const DiscreteModel original(mesh);
  Decimation decimation(mesh, {.factor = 2, .model = &original});
  decimation.run();
  EXPECT_TRUE(verify(mesh).empty());
  double largest = 0;
  for (const Vertex v : mesh.vertices())
    largest = std::max(largest, distance_to(original, mesh, v));
  EXPECT_LT(largest, 1e-14 * original.box().diagonal());
  EXPECT_GT(decimation.sweeps().front().smooths, 0u);
}

// The middle of a fan on a sphere is smoothed to a point under the sphere and judged on it.
TEST(Snap, TheVerdictIsOnTheSnappedPosition) {
  MeshData data;
  data.positions.push_back(glm::normalize(glm::dvec3(0.1, 0, 1)));
  data.vertex_classes.push_back(side);
  for (int i = 0; i < 6; ++i) {
    data.positions.push_back(
        glm::normalize(Frame().on_circle(0.5, 1.0471975511965976 * i) + glm::dvec3(0, 0, 1)));
    data.vertex_classes.push_back(side);
  }
  for (std::uint32_t i = 0; i < 6; ++i)
    data.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % 6}, side);
  Mesh mesh(data);
  mesh.set(0, 1), mesh.set(0, 2);
  const AnalyticModel model = sphere_model(1);
  glm::dvec3 target;
  ASSERT_TRUE(judge_smooth(mesh, Vertex(0), TurnLimit(30), target).accepted());
  EXPECT_LT(glm::length(target), 0.95);
  ASSERT_TRUE(judge_smooth(mesh, Vertex(0), {TurnLimit(30), &model}, target).accepted());
  EXPECT_LT(glm::length(target - glm::dvec3(0, 0, 1)), 1e-15);
  EXPECT_EQ(mesh.position(Vertex(0)), data.positions[0]);
  // Flattening the fan would turn its faces far; lifting it back onto the sphere does not.
  EXPECT_EQ(judge_smooth(mesh, Vertex(0), TurnLimit(13), target).reason, Reason::Angle);
  EXPECT_TRUE(judge_smooth(mesh, Vertex(0), {TurnLimit(13), &model}, target).accepted());
}

class SnapCommand : public test::CommandLine {};

TEST_F(SnapCommand, TheModelIsTheInputUnlessNamed) {
  sample("cylinder", "c.ply", 8);
  ASSERT_EQ(aomd("decimate c.ply plain.ply --factor 2 --report plain.json").code, 0);
  ASSERT_EQ(
      aomd("decimate c.ply snapped.ply --factor 2 --snap model --report snapped.json --journal j")
          .code,
      0);
  EXPECT_EQ(json("plain.json")["options"]["snap"], "none");
  EXPECT_EQ(json("snapped.json")["options"]["snap"], "model");
  EXPECT_TRUE(json("snapped.json")["options"]["model"].is_null());
  EXPECT_NE(text("plain.ply"), text("snapped.ply"));
  ASSERT_EQ(aomd("replay c.ply j again.ply").code, 0);
  EXPECT_EQ(text("again.ply"), text("snapped.ply"));
  Mesh original(io::read(at("c.ply")).mesh), result(io::read(at("snapped.ply")).mesh);
  const DiscreteModel model(original);
  for (const Vertex v : result.vertices()) EXPECT_LT(distance_to(model, result, v), 1e-12);
}

TEST_F(SnapCommand, WrongModelsAreNamed) {
  sample("cylinder", "c.ply", 4);
  expect_failure("decimate c.ply o.ply --snap model --model missing.step", 3,
                 "missing.step: No such file");
  expect_failure("decimate c.ply o.ply --model c.ply", 3, "c.ply: no CAD file");
  put("bad.geo", "Point(1) = {0, 0, 0};\nPoint(2) = {1,\nLine(1) = {1, 2};\n");
  expect_failure("decimate c.ply o.ply --model bad.geo", 3,
                 has_gmsh() ? "bad.geo:3: syntax error" : "without Gmsh");
  EXPECT_EQ(aomd("decimate c.ply o.ply --snap cad").code, 2);
  EXPECT_FALSE(exists("o.ply"));
}

TEST_F(SnapCommand, ABareMeshIsClassifiedOnItsModel) {
  if (!has_gmsh()) GTEST_SKIP() << "built without Gmsh";
  put("cylinder.geo", "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 0, 0, 2, 1};\n");
  sample("cylinder", "c.ply", 8);
  ASSERT_EQ(aomd("convert c.ply bare.off").code, 0);
  ASSERT_EQ(aomd("decimate bare.off o.ply --factor 2 --snap model --model cylinder.geo --journal j "
                 "--report r.json")
                .code,
            0);
  EXPECT_EQ(json("r.json")["options"]["model"], "cylinder.geo");
  const MeshData result = io::read(at("o.ply")).mesh;
  for (const glm::dvec3& p : result.positions) {
    if (p.z > 1e-9 && p.z < 2 - 1e-9) {
      EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-9);
    }
  }
  ASSERT_EQ(aomd("replay bare.off j again.ply").code, 0);
  EXPECT_EQ(text("again.ply"), text("o.ply"));
  sample("sphere", "s.ply", 4);
  expect_failure("decimate s.ply o2.ply --model cylinder.geo", 3,
                 "s.ply: the mesh does not lie on the model");
}

}  // namespace
}  // namespace aomd::snap_test
