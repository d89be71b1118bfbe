#include "core/model/classify.h"

#include <gtest/gtest.h>

#include <set>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "tests/support/zoo.h"

namespace aomd::classify_test {
namespace {

ClassifyResult classified(Mesh& mesh, ClassifyOptions options = {}) {
  const ClassifyResult result = classify(mesh, options);
  EXPECT_TRUE(verify(mesh).empty());
  return result;
}

// Reference 1 at every triangle, as many programs write it, says nothing of the twelve edges; two
// references do.
TEST(ClassifyTest, OneModelFaceForAllLeavesTheEdgesToTheAngle) {
  MeshData data = make_sample("box", 4);
  data.edges = {};
  data.vertex_classes.clear();
  for (ModelRef& model : data.faces.classes) model = ModelRef(2, 7);
  Mesh one(data);
  const ClassifyResult found = classify(one);
  EXPECT_FALSE(found.given);
  EXPECT_EQ(found.model_edges, 12);
  EXPECT_EQ(found.model_vertices, 8);
  for (const Face f : one.faces()) ASSERT_EQ(one.classification(f), ModelRef(2, 7));
  data.faces.classes.front() = ModelRef(2, 8);
  Mesh two(data);
  EXPECT_TRUE(classify(two).given);
  data.faces.classes.back() = {};
  Mesh not_all(data);
  EXPECT_FALSE(classify(not_all).given);
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
//   | / |      Whether the edge between 4 and 9 (0 and 2 here) lies on model edge 5 or across the
//   0---1      face cannot be told from them: the same vertices and faces fit both models.
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

// What many files say: every face and each vertex of it lies on one model face, nothing else.
MeshData on_one_face(MeshData data) {
  data.vertex_classes.assign(data.positions.size(), ModelRef(2, 9));
  data.faces.classes.assign(data.faces.size(), ModelRef(2, 9));
  return data;
}

//  6---7---8   Classified as it stands: all on face 9. The border is where faces end, whatever the
//  | \ | \ |   file says of its vertices, and its corners are where it turns.
//  3---4---5
//  | \ | \ |
//  0---1---2
TEST(ClassifyTest, ABorderIsFoundWhereTheFileClassifiesFacesAlone) {
  Mesh mesh(on_one_face(zoo::grid(2)));
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 4);
  EXPECT_EQ(r.model_edges, 4);
  for (const std::uint32_t corner : {0u, 2u, 6u, 8u})
    EXPECT_EQ(mesh.classification(Vertex(corner)).dimension(), 0);
  for (const std::uint32_t side : {1u, 3u, 5u, 7u})
    EXPECT_EQ(mesh.classification(Vertex(side)).dimension(), 1);
  EXPECT_EQ(mesh.classification(Vertex(4)), ModelRef(2, 9));
}

// The left half on face 1, the right half on face 2, no line listed: they meet in a model edge.
TEST(ClassifyTest, AnInterfaceIsFoundWhereTheFileClassifiesFacesAlone) {
  MeshData data = zoo::grid(2);
  data.vertex_classes.assign(9, ModelRef(2, 1));
  for (std::size_t f = 0; f < data.faces.size(); ++f) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += data.positions[data.faces.vertices[3 * f + k]].x / 3;
    data.faces.classes.emplace_back(2, x < 1 ? 1 : 2);
  }
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_faces, 2);
  EXPECT_EQ(r.model_vertices, 6);
  EXPECT_EQ(r.model_edges, 7);
  EXPECT_EQ(mesh.classification(Vertex(1)).dimension(), 0);
  EXPECT_EQ(mesh.classification(Vertex(4)).dimension(), 1);
}

// Vertices on model edges of which the file lists no line: the border takes its edges from them,
// and no vertex is held that lies inside a side.
TEST(ClassifyTest, ABorderLiesOnTheModelEdgesThatItsVerticesName) {
  MeshData data = on_one_face(zoo::grid(3));
  for (const std::uint32_t corner : {0u, 3u, 12u, 15u})
    data.vertex_classes[corner] = ModelRef(0, static_cast<std::int32_t>(corner) + 1);
  for (const std::uint32_t low : {1u, 2u}) data.vertex_classes[low] = ModelRef(1, 40);
  for (const std::uint32_t left : {4u, 8u}) data.vertex_classes[left] = ModelRef(1, 41);
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 4);
  EXPECT_EQ(r.model_edges, 4);
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(1))), ModelRef(1, 40));
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(2), Vertex(3))), ModelRef(1, 40));
  EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(4))), ModelRef(1, 41));
  EXPECT_EQ(mesh.classification(Vertex(3)), ModelRef(0, 4));
}

// All vertices of the border on one model edge, as files without points have them: its four corners
// are where it turns, whatever the file says.
TEST(ClassifyTest, ABorderThatItsVerticesPutOnOneModelEdgeKeepsItsCorners) {
  MeshData data = on_one_face(zoo::grid(4));
  for (std::uint32_t v = 0; v < 25; ++v)
    if (v % 5 == 0 || v % 5 == 4 || v < 5 || v >= 20) data.vertex_classes[v] = ModelRef(1, 3);
  Mesh mesh(data);
  EXPECT_EQ(classified(mesh).model_vertices, 4);
  for (const std::uint32_t corner : {0u, 4u, 20u, 24u})
    EXPECT_EQ(mesh.classification(Vertex(corner)).dimension(), 0);
  EXPECT_EQ(mesh.classification(Vertex(2)), ModelRef(1, 3));
}

// A seam: vertices 7, 12 and 17 of the middle column lie on model edge 5, which ends in model
// vertices 2 and 22 of the border; both sides lie on the same face, and no line is listed.
TEST(ClassifyTest, ACurveInsideAFaceIsFoundWhereItsVerticesHaveTwoNeighboursOnIt) {
  MeshData data = on_one_face(zoo::grid(4));
  data.vertex_classes[2] = ModelRef(0, 1);
  data.vertex_classes[22] = ModelRef(0, 2);
  for (const std::uint32_t v : {7u, 12u, 17u}) data.vertex_classes[v] = ModelRef(1, 5);
  Mesh mesh(data);
  classified(mesh);
  for (const std::uint32_t v : {2u, 7u, 12u, 17u})
    EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(v), Vertex(v + 5))), ModelRef(1, 5));
  EXPECT_EQ(mesh.classification(Vertex(12)), ModelRef(1, 5));
}

// A vertex inside a face that is put on a model edge of which nothing else is left stays where it
// is.
TEST(ClassifyTest, AVertexOnAModelEdgeThatIsNowhereBecomesAModelVertex) {
  MeshData data = on_one_face(zoo::grid(4));
  data.vertex_classes[12] = ModelRef(1, 5);
  Mesh mesh(data);
  classified(mesh);
  EXPECT_EQ(mesh.classification(Vertex(12)).dimension(), 0);
}

// Two tetrahedra on model faces of their own that share vertex 0.
TEST(ClassifyTest, ModelFacesThatTouchInAPointDoSoInAModelVertex) {
  MeshData data = zoo::tetrahedron();
  const glm::dvec3 tip = data.positions[0];
  for (std::uint32_t v = 1; v < 4; ++v) data.positions.push_back(2.0 * tip - data.positions[v]);
  const std::vector<std::uint32_t> first = data.faces.vertices;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto other = [&](std::size_t k) {
      const std::uint32_t v = first[3 * f + k];
      return v == 0 ? 0 : v + 3;
    };
    data.faces.add(Shape::Triangle, {other(2), other(1), other(0)});
  }
  for (int f = 0; f < 8; ++f) data.faces.classes.emplace_back(2, f < 4 ? 1 : 2);
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 1);
  EXPECT_EQ(mesh.classification(Vertex(0)).dimension(), 0);
  EXPECT_EQ(mesh.classification(Vertex(1)), ModelRef(2, 1));
  EXPECT_EQ(mesh.classification(Vertex(4)), ModelRef(2, 2));
}

// Vertex 0 is in the middle of a straight border and, of other faces, of a disc.
TEST(ClassifyTest, ABorderThatTouchesAFaceDoesSoInAModelVertex) {
  Mesh mesh(zoo::make(
      {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, -1, 1}, {0, -1, -1}, {0, 1, -1}},
      {{0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 4}}));
  classified(mesh);
  EXPECT_EQ(mesh.classification(Vertex(0)).dimension(), 0);
}

// Tags end at 2^28 - 1: new ones then fill the gaps.
TEST(ClassifyTest, NewTagsFillTheGapsWhereTheLargestIsTaken) {
  MeshData data = zoo::grid(2);
  data.vertex_classes.resize(9);
  data.vertex_classes[0] = ModelRef(0, ModelRef::max_tag);
  data.vertex_classes[2] = ModelRef(0, 1);
  Mesh mesh(data);
  const ClassifyResult r = classified(mesh);
  EXPECT_EQ(r.model_vertices, 4);
  EXPECT_EQ(mesh.classification(Vertex(0)), ModelRef(0, ModelRef::max_tag));
  EXPECT_EQ(mesh.classification(Vertex(6)), ModelRef(0, 2));
  EXPECT_EQ(mesh.classification(Vertex(8)), ModelRef(0, 3));
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
}  // namespace aomd::classify_test
