// The interface of models, the discrete modeler, and how a mesh is fitted to a model.

#include "core/model/model.h"

#include <gtest/gtest.h>

#include <random>

#include <glm/geometric.hpp>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/discrete_model.h"
#include "core/model/mesh_on_model.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::model_test {
namespace {

std::string message_of(const auto& action) {
  try {
    action();
    return "";
  } catch (const std::exception& e) {
    return e.what();
  }
}

MeshData without_classes(MeshData data) {
  data.vertex_classes.clear();
  data.edges = {};
  data.faces.classes.clear();
  return data;
}

TEST(ModelTest, EntitiesAreSortedAndClosuresReachDown) {
  const AnalyticModel model = drilled_box_model({4, 4, 2}, 1);
  EXPECT_EQ(model.dimension(), 3);
  EXPECT_EQ(model.entities(0).size(), 8u);
  EXPECT_EQ(model.entities(1).size(), 14u);
  EXPECT_EQ(model.entities(2).size(), 7u);
  const std::vector<ModelRef> edges = model.entities(1);
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
  EXPECT_EQ(model.closure({2, 7}), (std::vector{ModelRef(1, 13), ModelRef(1, 14)}));
  EXPECT_EQ(model.closure({2, 5}).size(), 4u + 4u + 1u);
  EXPECT_EQ(model.closure({3, 1}).size(), 8u + 14u + 7u);
  EXPECT_TRUE(model.closure({0, 1}).empty());
}

TEST(ModelTest, UnknownEntitiesAreNamed) {
  const AnalyticModel model = sphere_model(1);
  const std::string message = "the model has no model face 7";
  EXPECT_EQ(message_of([&] { (void)model.closest({2, 7}, {}); }), message);
  EXPECT_EQ(message_of([&] { (void)model.closure({2, 7}); }), message);
  EXPECT_EQ(message_of([&] { (void)model.normal({2, 7}, {}); }), message);
  EXPECT_EQ(message_of([&] { (void)model.range({2, 7}); }), message);
  EXPECT_THROW((void)model.closest(ModelRef(), {}), std::invalid_argument);
  EXPECT_THROW((void)model.normal({3, 1}, {}), std::invalid_argument);
  EXPECT_THROW((void)model.range({3, 1}), std::invalid_argument);
  EXPECT_FALSE(model.contains({2, 7}));
  EXPECT_TRUE(model.contains({2, 1}));
}

TEST(ModelTest, ARegionKeepsPointsWhereTheyAre) {
  EXPECT_EQ(sphere_model(1).snap({3, 1}, {5, 6, 7}), glm::dvec3(5, 6, 7));
}

TEST(ModelTest, ContradictionsAreRefused) {
  EXPECT_THROW(AnalyticModel({{1, PointShape(), {}}, {1, PointShape(), {}}}),
               std::invalid_argument);
  EXPECT_THROW(AnalyticModel({{1, PlaneShape(), {{1, 1}}}}), std::invalid_argument);
  EXPECT_THROW(AnalyticModel({{1, PlaneShape(), {}}, {2, PlaneShape(), {{2, 1}}}}),
               std::invalid_argument);
}

TEST(DiscreteModelTest, ABoxHasTheTopologyOfABox) {
  Mesh mesh(make_sample("box", 3));
  const DiscreteModel model(mesh);
  EXPECT_EQ(model.entities(0).size(), 8u);
  EXPECT_EQ(model.entities(1).size(), 12u);
  EXPECT_EQ(model.entities(2).size(), 6u);
  for (const ModelRef e : model.entities(1)) EXPECT_EQ(model.closure(e).size(), 2u);
  for (const ModelRef f : model.entities(2)) EXPECT_EQ(model.closure(f).size(), 8u);
  EXPECT_EQ(model.box().low, glm::dvec3(0, 0, 0));
  EXPECT_EQ(model.box().high, glm::dvec3(1, 1, 1));
  EXPECT_FALSE(model.has_parameters({2, 1}));
}

TEST(DiscreteModelTest, ARegionIsBoundedByTheFacesAroundIt) {
  MeshData data = zoo::tetrahedron();
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, {3, 5});
  for (std::int32_t tag = 1; tag <= 4; ++tag) data.faces.classes.emplace_back(2, tag);
  Mesh mesh(data);
  const DiscreteModel model(mesh);
  EXPECT_EQ(model.dimension(), 3);
  EXPECT_EQ(model.closure({3, 5}), model.entities(2));
  EXPECT_EQ(model.entities(2).size(), 4u);
}

// The sample's face 2 is x = 1: a point beyond its border goes to the border, not to the plane.
TEST(DiscreteModelTest, FacesEndAtTheirBorders) {
  Mesh mesh(make_sample("box", 3));
  const DiscreteModel model(mesh);
  EXPECT_EQ(model.snap({2, 2}, {3, 0.5, 0.25}), glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(model.snap({2, 2}, {3, 5, -1}), glm::dvec3(1, 1, 0));
  EXPECT_EQ(model.normal({2, 2}, {3, 0.5, 0.25}), glm::dvec3(1, 0, 0));
}

// Exactly the same distance as when every facet of the entity is tried.
TEST(DiscreteModelTest, NoFacetIsNearer) {
  Mesh mesh(make_sample("bracket", 2));
  const DiscreteModel model(mesh);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.3 * model.box().diagonal());
  const Triangles facets = triangles_of(mesh);
  for (const int dim : {1, 2}) {
    for (const ModelRef e : model.entities(dim)) {
      for (int i = 0; i < 20; ++i) {
        const glm::dvec3 p(noise(random), noise(random), noise(random));
        double least = std::numeric_limits<double>::infinity();
        const auto consider = [&](const Triangle& t) {
          const glm::dvec3 d = nearest_point(t, p) - p;
          least = std::min(least, glm::dot(d, d));
        };
        for (std::size_t k = 0; dim == 2 && k < facets.faces.size(); ++k)
          if (mesh.classification(facets.faces[k]) == e) consider(facets.corners[k]);
        for (const Edge edge : mesh.edges()) {
          const auto [a, b] = mesh.edge_vertices(edge);
          if (mesh.classification(edge) == e)
            consider({mesh.position(a), mesh.position(b), mesh.position(b)});
        }
        const glm::dvec3 d = model.snap(e, p) - p;
        ASSERT_EQ(glm::dot(d, d), least) << name_of(e);
      }
    }
  }
}

TEST(DiscreteModelTest, OutlivesWhatTheMeshWas) {
  Mesh mesh(make_sample("box", 2));
  const DiscreteModel model(mesh);
  for (const Vertex v : mesh.vertices()) mesh.move(v, {9, 9, 9});
  EXPECT_EQ(model.box().high, glm::dvec3(1, 1, 1));
}

TEST(SnapTest, MovesAVertexOntoItsEntityAndCanBeUndone) {
  Mesh mesh(zoo::triangle());
  const AnalyticModel model = sphere_model(2);
  Journal journal;
  mesh.set_classification(Vertex(1), {2, 1});
  mesh.attach(&journal);
  EXPECT_DOUBLE_EQ(snap(model, mesh, Vertex(1)), 1);
  EXPECT_EQ(mesh.position(Vertex(1)), glm::dvec3(2, 0, 0));
  EXPECT_EQ(journal.size(), 1u);
  EXPECT_EQ(snap(model, mesh, Vertex(1)), 0);
  EXPECT_EQ(journal.size(), 1u) << "a vertex that stays is no edit";
  journal.undo(mesh);
  EXPECT_EQ(mesh.position(Vertex(1)), glm::dvec3(1, 0, 0));
  EXPECT_THROW(snap(model, mesh, Vertex(0)), std::invalid_argument);
}

TEST(FitTest, TheClassesOfAMeshMustExist) {
  Mesh mesh(make_sample("cylinder", 4));
  EXPECT_NO_THROW(check_against(mesh, cylinder_model(1, 2)));
  EXPECT_EQ(message_of([&] { check_against(mesh, sphere_model(1)); }),
            "the mesh lies on model edge 1 and 3 more that the model does not have");
}

TEST(FitTest, OtherUnitsAreNoMatterOfClasses) {
  EXPECT_NO_THROW(check_entities(Mesh(make_sample("cylinder", 4)), cylinder_model(1000, 2000)));
  EXPECT_EQ(message_of([&] { check_entities(Mesh(make_sample("cylinder", 4)), sphere_model(1)); }),
            "the mesh lies on model edge 1 and 3 more that the model does not have");
}

TEST(FitTest, OtherUnitsAreNoticed) {
  Mesh mesh(make_sample("cylinder", 4));
  const std::string message = message_of([&] { check_against(mesh, cylinder_model(1000, 2000)); });
  EXPECT_NE(message.find("other units"), std::string::npos) << message;
}

// What a sample is classified on becomes a model; on that the bare sample must be classified the
// same again.
void expect_same_classes(const MeshData& data, const Model& model) {
  Mesh told(data), bare(without_classes(data));
  told.set(0, 1), bare.set(0, 1);
  classify_on(bare, model);
  EXPECT_TRUE(verify(bare).empty());
  for (const Vertex v : told.vertices())
    ASSERT_EQ(told.classification(v), bare.classification(v)) << v.index;
  for (const Face f : told.faces())
    ASSERT_EQ(told.classification(f), bare.classification(f)) << f.index;
  for (const Edge e : bare.edges()) {
    const auto [a, b] = bare.edge_vertices(e);
    ASSERT_EQ(told.classification(told.find_edge(a, b)), bare.classification(e)) << e.index;
  }
}

TEST(FitTest, BareSamplesAreClassifiedAsTheyWere) {
  for (const char* name : {"box", "bracket", "cylinder", "plane-hole", "nonmanifold"}) {
    SCOPED_TRACE(name);
    const MeshData data = make_sample(name);
    Mesh mesh(data);
    expect_same_classes(data, DiscreteModel(mesh));
  }
}

TEST(FitTest, TheCylinderSampleLiesOnTheCylinderModel) {
  expect_same_classes(make_sample("cylinder", 5), cylinder_model(1, 2));
}

//    2---1        a hexagon cut by chords: its six sides lie on the circle, the chords do not,
//   / `./ \       though both their ends do
//  3-.-/---0
TEST(FitTest, AChordIsNotOnTheCurveOfItsEnds) {
  MeshData data;
  for (int i = 0; i < 6; ++i)
    data.positions.push_back(Frame().on_circle(1, 3.14159265358979 / 3 * i));
  for (const auto& [a, b, c] : {std::array{0u, 1u, 2u}, {0u, 2u, 3u}, {0u, 3u, 4u}, {0u, 4u, 5u}})
    data.faces.add(Shape::Triangle, {a, b, c});
  Mesh mesh(data);
  classify_on(mesh, AnalyticModel({{4, ArcShape(), {}}, {9, PlaneShape(), {{1, 4}}}}));
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(mesh.classification(Vertex(i)), ModelRef(1, 4));
    EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(i), Vertex((i + 1) % 6))), ModelRef(1, 4));
  }
  for (const std::uint32_t i : {2u, 3u, 4u})
    EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(i))), ModelRef(2, 9));
}

// A seam through a corner of the octahedron and between its edges: no edge follows it.
TEST(FitTest, ASeamWithoutEdgesHoldsNoVertices) {
  Mesh mesh(zoo::octahedron());
  const Frame upright = Frame::around({0, 0, 0}, {1, -1, 0}, {0, 0, 1});
  classify_on(mesh, AnalyticModel(
                        {{1, ArcShape{upright, 1, -0.5, 0.5}, {}}, {1, SphereShape(), {{1, 1}}}}));
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(mesh.classification(v), ModelRef(2, 1));
}

TEST(FitTest, AMeshElsewhereIsRefusedWithItsDistance) {
  MeshData data = without_classes(make_sample("sphere", 4));
  Mesh mesh(data);
  const std::string before = zoo::fingerprint(mesh);
  const std::string message = message_of([&] { classify_on(mesh, sphere_model(1.25)); });
  EXPECT_NE(message.find("does not lie on the model: up to 0.25"), std::string::npos) << message;
  EXPECT_NO_THROW(classify_on(mesh, sphere_model(1.25), 0.3));
  Mesh open(zoo::grid(3));
  const std::string border = message_of([&] {
    classify_on(open, AnalyticModel({{1, PlaneShape(), {}}}), 1e-9);
  });
  EXPECT_NE(border.find("lies on no model edge"), std::string::npos) << border;
}

TEST(FitTest, ClassifyingIsOneStepToUndo) {
  Mesh mesh(without_classes(make_sample("cylinder", 3)));
  mesh.set(0, 1);
  const std::string before = zoo::fingerprint(mesh);
  Journal journal;
  mesh.attach(&journal);
  classify_on(mesh, cylinder_model(1, 2));
  EXPECT_EQ(journal.size(), 1u);
  journal.undo(mesh);
  EXPECT_EQ(zoo::fingerprint(mesh), before);
}

}  // namespace
}  // namespace aomd::model_test
