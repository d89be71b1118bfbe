#include "core/model/classify.h"

#include <gtest/gtest.h>

#include <set>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "tests/support/zoo.h"

namespace aomd {
namespace {

ClassifyResult classified(Mesh& mesh, ClassifyOptions options = {}) {
  const ClassifyResult result = classify(mesh, options);
  EXPECT_TRUE(verify(mesh).empty());
  return result;
}

TEST(ClassifyTest, ATetrahedronHasFourSixFour) {
  Mesh mesh(zoo::tetrahedron());
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 4);
  EXPECT_EQ(r.model_edges, 6);
  EXPECT_EQ(r.model_faces, 4);
}

//  flat sheet: one model face, its border four model edges between four corners
TEST(ClassifyTest, AFlatSheetIsOneFaceWithFourCorners) {
  Mesh mesh(zoo::grid(6));
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 4);
  EXPECT_EQ(r.model_edges, 4);
  EXPECT_EQ(r.model_faces, 1);
  EXPECT_EQ(mesh.classification(Vertex(0)).dimension(), 0);
  EXPECT_EQ(mesh.classification(Vertex(3)).dimension(), 1);
  EXPECT_EQ(mesh.classification(Vertex(8)).dimension(), 2);
}

TEST(ClassifyTest, ASmoothTorusHasOneFaceAndNothingElse) {
  Mesh mesh(zoo::torus(48, 36));
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 0);
  EXPECT_EQ(r.model_edges, 0);
  EXPECT_EQ(r.model_faces, 1);
}

TEST(ClassifyTest, TheSpineOfABookIsAModelEdge) {
  Mesh mesh(zoo::book());
  classified(mesh);
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(1))).dimension(), 1);
  EXPECT_EQ(mesh.classification(Vertex(0)).dimension(), 0);  // seven model edges meet there
}

TEST(ClassifyTest, UnusedVerticesStayUnclassified) {
  Mesh mesh(zoo::bow_tie());
  classified(mesh);
  EXPECT_FALSE(mesh.classification(Vertex(5)).valid());
}

// Paper, figure 4: the diagonal of a square whose two halves the file puts on one model face may
// still be a model edge, which only the file can know.
TEST(ClassifyTest, WhatTheFileSaysWins) {
  MeshData data = zoo::square();
  Mesh silent(data);
  classified(silent);
  EXPECT_EQ(silent.classification(silent.find_edge(Vertex(0), Vertex(2))).dimension(), 2);
  data.edges.add(Shape::Line, {2, 0}, ModelRef(1, 42));
  Mesh told(data);
  classified(told);
  EXPECT_EQ(told.classification(told.find_edge(Vertex(0), Vertex(2))), ModelRef(1, 42));
  EXPECT_EQ(told.classification(Vertex(0)).dimension(), 0);
}

//   3---2      Paper, figure 4: both faces lie on model face 0, all vertices on model edges.
//   Whether the edge | / |      between 4 and 9 (0 and 2 here) lies on model edge 5 or across the
//   face cannot be told from 0---1      them: the same vertices and faces fit both models.
TEST(ClassifyTest, Figure4IsAmbiguousUntilTheFileListsItsModelEdges) {
  MeshData data = zoo::square();
  data.vertex_classes = {ModelRef(1, 5), ModelRef(1, 1), ModelRef(1, 5), ModelRef(1, 2)};
  data.faces.classes = {ModelRef(2, 0), ModelRef(2, 0)};
  const auto class_of_diagonal = [](const MeshData& d) {
    Mesh mesh(d);
    mesh.set(1, 2);  // edges are made implicitly
    EXPECT_EQ(mesh.count(1), 5u);
    return mesh.classification(mesh.find_edge(Vertex(0), Vertex(2)));
  };
  EXPECT_EQ(class_of_diagonal(data),
            ModelRef(2, 0));  // its creator's class: right for one of the models only
  MeshData other = data;      // the model on which the diagonal is model edge 5
  other.edges.add(Shape::Line, {2, 0}, ModelRef(1, 5));
  EXPECT_EQ(class_of_diagonal(other), ModelRef(1, 5));
}

TEST(ClassifyTest, FacesGivenByTheFileKeepTheirTagsAndMeetInModelEdges) {
  MeshData data = zoo::square();
  data.faces.classes = {ModelRef(2, 10), ModelRef(2, 20)};
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_faces, 2);
  EXPECT_EQ(mesh.classification(Face(1)), ModelRef(2, 20));
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(2))).dimension(), 1);
}

// The border of a sheet, of which the file names two edges: where the named curve ends, a model
// vertex stands.
TEST(ClassifyTest, AGivenCurveEndsInModelVertices) {
  MeshData data = zoo::grid(6);
  data.edges.add(Shape::Line, {2, 3}, ModelRef(1, 7));
  data.edges.add(Shape::Line, {3, 4}, ModelRef(1, 7));
  Mesh mesh(data);
  classified(mesh);
  EXPECT_EQ(mesh.classification(Vertex(2)).dimension(), 0);
  EXPECT_EQ(mesh.classification(Vertex(3)), ModelRef(1, 7));
  EXPECT_EQ(mesh.classification(Vertex(4)).dimension(), 0);
}

TEST(ClassifyTest, IsOneStepToUndo) {
  Mesh mesh(zoo::grid(4));
  mesh.set(1, 0);
  const std::string before = zoo::fingerprint(mesh);
  Journal journal;
  mesh.attach(&journal);
  classified(mesh);
  EXPECT_EQ(journal.size(), 1u);
  journal.undo(mesh);
  EXPECT_EQ(zoo::fingerprint(mesh), before);
}

// A sheet folded by 90 degrees along its middle row, then roughened: the fold is a feature, single
// bumps are not.
MeshData folded_sheet(double bump) {
  MeshData data = zoo::grid(20);
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    glm::dvec3& p = data.positions[i];
    if (i % 7 == 3 && p.x > 1 && p.x < 19 && p.y != 10) p.z += bump;
    if (p.y > 10) p = {p.x, 10 - p.z, p.y - 10};
  }
  return data;
}

TEST(ClassifyTest, AFoldIsAFeature) {
  Mesh mesh(folded_sheet(0));
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.features.sharp, 20u);
  EXPECT_EQ(r.features.rough, 0u);
  EXPECT_EQ(r.model_faces, 2);
}

TEST(ClassifyTest, RoughnessIsNot) {
  Mesh rough(zoo::grid(20));
  for (const Vertex v : rough.vertices())
    rough.move(v, rough.position(v) +
                      glm::dvec3(0, 0, 0.35 * double(EntityHash::mix(v.index) % 1000) / 1000));
  const ClassifyResult r = classified(rough);
  EXPECT_GT(r.features.rough, 100u);
  EXPECT_EQ(r.features.sharp, 0u);
  EXPECT_EQ(r.model_faces, 1);
}

TEST(ClassifyTest, NonManifoldEdgesMayBeLeftAlone) {
  Mesh mesh(zoo::dirty());
  classified(mesh, {.nonmanifold_edges = false});
  for (const Edge e : mesh.edges()) {
    const Request need = mesh.request(1, 2);
    if (mesh.row<2>(e).size() > 2) {
      EXPECT_EQ(mesh.classification(e).dimension(), 2);
    }
  }
}

TEST(ClassifyTest, ABoxSampleIsABox) {
  MeshData data = make_sample("box");
  data.vertex_classes.clear();
  data.edges = {};
  data.faces.classes.clear();
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 8);
  EXPECT_EQ(r.model_edges, 12);
  EXPECT_EQ(r.model_faces, 6);
}

}  // namespace
}  // namespace aomd
