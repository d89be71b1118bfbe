// The programs of the paper, as printed. Added are only the declarations that it leaves out, the
// context object behind `mesh`, and the spacing field that section 3 describes in words. In
// fragments (1), (3), (5) and (6) the print runs declarations and calls together: a type in front
// of an argument is a comment here, the name of the variable that receives the result is the
// paper's, and `...` is what the test does in the loop.

#include "core/paper/paper.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>

#include "core/decimate/decimation.h"
#include "core/mesh/geometry.h"
#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/strata.h"
#include "tests/support/zoo.h"

// As printed, assignments are conditions, and a loop's variable hides an outer one.
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"

namespace aomd::paper::paper_test {
namespace {

// A program with its text, to be compared with the paper's.
#define PRINTED_PROGRAM(name, ...) \
  void name(pMesh_ mesh) {         \
    int done, tmp, i;              \
    double elength, s[2];          \
    pEdge_ edge;                   \
    pVertex_ v[2], vertex;         \
    __VA_ARGS__                    \
  }                                \
  constexpr const char* name##_text = #__VA_ARGS__;

// clang-format off
PRINTED_PROGRAM(figure_7,
do{
done=0;tmp=0;
while(edge = M_nextEdge_(mesh,&tmp)){
v[0]=E_vertex_(edge,0);v[1]=E_vertex_(edge,1);
elength =E_length_(edge);
s[0]=L_dataD_(v[0]->list,"spacing");
s[1]=L_dataD_(v[1]->list,"spacing");
for(i=0;i<2;++i)
if(s[i]>elength)
if(E_2Dcollapse_(mesh,edge,v[i])){
done = 1;
break;
}
}
tmp=0;
while(vertex=M_nextVertex_(mesh,&tmp)){
V_swapOpEdges_(mesh,vertex);
V_smooth_(mesh,vertex);
}
}while(done);
)
// clang-format on

std::string without_spaces(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
  return text;
}

TEST(PaperTest, Figure7IsAsPrinted) {
  std::ifstream file(AOMD_SHARED_DATA "/../paper/aomd-decimation.txt");
  if (!file) GTEST_SKIP() << "shared/paper/aomd-decimation.txt is not there";
  const std::string paper{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(without_spaces(paper).find(without_spaces(figure_7_text)), std::string::npos);
}

// "The average edge lengths of the surrounding edges" times half the factor (docs/PAPER.md).
void assign_spacing(pMesh_ mesh, double factor) {
  int tmp = 0;
  while (pVertex_ vertex = M_nextVertex_(mesh, &tmp)) {
    L_putDataD_(vertex->list, "spacing", 0);
    L_putDataD_(vertex->list, "edges", 0);
  }
  tmp = 0;
  while (pEdge_ edge = M_nextEdge_(mesh, &tmp))
    for (int i = 0; i < 2; ++i) {
      const pVertex_ v = E_vertex_(edge, i);
      L_putDataD_(v->list, "spacing", L_dataD_(v->list, "spacing") + E_length_(edge));
      L_putDataD_(v->list, "edges", L_dataD_(v->list, "edges") + 1);
    }
  tmp = 0;
  while (pVertex_ v = M_nextVertex_(mesh, &tmp))
    L_putDataD_(v->list, "spacing",
                0.5 * factor * (L_dataD_(v->list, "spacing") / L_dataD_(v->list, "edges")));
}

// A mesh with what section 3 requests for it.
struct Program {
  Mesh own;
  Session session{own};
  pMesh_ mesh = &session;

  Program() = default;
  explicit Program(const MeshData& data) : own(data) {
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2), std::pair(2, 1)})
      M_setAdjacency_(mesh, i, j, 1);
  }
  pVertex_ vertex(std::uint32_t id) { return {mesh, Vertex(id)}; }
  pEdge_ edge(std::uint32_t a, std::uint32_t b) { return E_exists_(vertex(a), vertex(b)); }
  pFace_ face(std::uint32_t id) { return {mesh, Face(id)}; }
};

//     v2
//    /f0\     as in figure 3
//  v0----v1
//    \f1/
//     v3
TEST(PaperTest, Fragments1And2) {
  Program p;
  pMesh_ mesh = p.mesh;
  M_setAdjacency_(mesh, 1, 2, 1);
  pVertex_ v0 = V_create_(mesh, 0, 0, 0, 2, 7), v1 = V_create_(mesh, 2, 0, 0, 2, 7),
           v2 = V_create_(mesh, 1, 1, 0, 2, 7), v3 = V_create_(mesh, 1, -1, 0, 2, 7);
  int classification = 2;
  int tag = 7;
  // clang-format off
  pFace_ face = F_create_(/*pMesh_*/ mesh,
                          /*pVertex_*/ v0, v1, v2,
                          /*int*/ classification ,
                          /*int*/ tag);
  // clang-format on
  EXPECT_EQ(p.own.classification(face.entity()), ModelRef(2, 7));
  EXPECT_EQ(p.own.count(1), 3u) << "created implicitly";
  const pFace_ f0 = face, f1 = F_create_(mesh, v1, v0, v3, 2, 7);
  EXPECT_EQ(p.own.count(1), 5u) << "one was there already";
  {
    // clang-format off
    pEdge_ edge = E_exists_(v0,v1);
    pList_ faces = E_faces_(edge); // or
    pFace_ face = E_face_(edge,0); // if faces>0.
    // clang-format on
    EXPECT_EQ(E_vertex_(edge, 0), v0);
    EXPECT_EQ(E_vertex_(edge, 1), v1);
    EXPECT_EQ(E_length_(edge), 2);
    ASSERT_EQ(faces.size(), 2u);
    EXPECT_EQ(faces[0], f0);
    EXPECT_EQ(faces[1], f1);
    EXPECT_EQ(face, f0);
    EXPECT_EQ(E_face_(edge, 1), f1);
    EXPECT_THROW((void)E_face_(edge, 2), std::out_of_range);
    M_setAdjacency_(mesh, 2, 1, 1);
    EXPECT_TRUE(p.own.use_direction(f0.entity(), edge.entity()));
    EXPECT_FALSE(p.own.use_direction(f1.entity(), edge.entity()));
  }
  EXPECT_FALSE(E_exists_(v2, v3));
  EXPECT_EQ(F_exists_(v2, v1, v0), f0);
  F_delete_(mesh, f0);
  EXPECT_FALSE(F_exists_(v2, v1, v0));
  EXPECT_EQ(E_face_(E_exists_(v0, v1), 0), f1) << "f0 is gone from the edge's list";
  EXPECT_TRUE(E_faces_(E_exists_(v1, v2)).empty());
  EXPECT_TRUE(verify(p.own).empty());
}

//      3
//     /|\        .
//    / | \      region 0 = 0 1 2 3 and region 1 = 1 2 3 4 share the face 1 2 3; 4 lies behind it
//   0--|--2--4
//    \ | /
//      1
TEST(PaperTest, Fragments3And4) {
  Program p;
  pMesh_ mesh = p.mesh;
  M_setAdjacency_(mesh, 2, 3, 1);
  M_setAdjacency_(mesh, 1, 3, 1);
  int classification = 3, tag = 5;
  pVertex_ v0 = V_create_(mesh, 0, 0, 0, 3, 5), v1 = V_create_(mesh, 1, 0, 0, 3, 5),
           v2 = V_create_(mesh, 0, 1, 0, 3, 5), v3 = V_create_(mesh, 0, 0, 1, 3, 5),
           v4 = V_create_(mesh, 1, 1, 1, 3, 5);
  // clang-format off
  pRegion_ region = R_create_(/*pMesh*/ mesh,
      /*pVertex_*/ v0,v1,v2,v3,
      /*constant RTip_*/ TETRAHEDRON,
      /*int*/ classification, /*int*/ tag);
  // clang-format on
  EXPECT_EQ(p.own.count(2), 4u) << "from the template";
  EXPECT_EQ(p.own.count(1), 6u);
  const pRegion_ second = R_create_(mesh, {v1, v2, v3, v4}, TETRAHEDRON, 3, 6);
  EXPECT_EQ(p.own.count(2), 7u);
  EXPECT_EQ(p.own.count(1), 9u);
  EXPECT_EQ(R_exists_(v4, v3, v2, v1), second);
  EXPECT_FALSE(R_exists_(v0, v2, v3, v4));

  const pFace_ shared = F_exists_(v1, v2, v3);
  {
    pEdge_ edge = E_exists_(v1, v2);
    // clang-format off
    pFace_ face = R_face_(region,0);
    pList_ regions = E_regions_(edge);
    int usedir = R_dirFace_(region,face);
    // clang-format on
    EXPECT_EQ(face, F_exists_(v0, v1, v2));
    EXPECT_EQ(usedir, 1) << "created in the direction of the template";
    ASSERT_EQ(regions.size(), 2u);
    EXPECT_EQ(regions[0], region);
    EXPECT_EQ(regions[1], second);
  }
  EXPECT_EQ(R_dirFace_(region, shared), 1);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(R_dirFace_(second, R_face_(second, i)), R_face_(second, i) == shared ? 0 : 1)
        << "inward";
  for (const auto& [a, b] : {std::pair(v0, v1), std::pair(v0, v2), std::pair(v0, v3)})
    EXPECT_EQ(E_regions_(E_exists_(a, b)).size(), 1u);
  EXPECT_THROW((void)R_dirFace_(second, F_exists_(v0, v1, v2)), std::invalid_argument);
  EXPECT_THROW(F_delete_(mesh, shared), std::logic_error) << "regions use it";
  EXPECT_TRUE(verify(p.own).empty());
}

TEST(PaperTest, Fragment5PutsAVertexOntoACylinder) {
  const AnalyticModel cylinder = cylinder_model(1, 2);
  const pModel_ model = &cylinder;
  Program p;
  pVertex_ vertex = V_create_(p.mesh, 3, 4, 0.5, 2, 1);
  G_snapVertex_(/*pModel*/ model, /*pVertex*/ vertex);
  EXPECT_NEAR(glm::distance(p.own.position(vertex.entity()), glm::dvec3(0.6, 0.8, 0.5)), 0, 1e-15);
  EXPECT_THROW(G_snapVertex_(model, V_create_(p.mesh, 3, 4, 0.5, 2, 9)), std::invalid_argument);
}

TEST(PaperTest, Fragment6VisitsTheFacesOfOneModelFaceWhileTheyAreDeleted) {
  Program p(zoo::grid(2));
  pMesh_ mesh = p.mesh;
  for (const Face f : p.own.faces()) p.own.set_classification(f, ModelRef(2, f.index % 3 ? 1 : 2));
  std::vector<std::uint32_t> visited;
  pFace_ face = p.face(7);
  {
    // clang-format off
    pGFace_ model_face = F_modeling_(/*face_*/ face);
    iterator it;
    while(pFace_ face=G_nextFace_(model_face,&it)){ visited.push_back(face.entity().index);
      F_delete_(mesh, face);
      if (visited.size() == 2) F_delete_(mesh, p.face(5));
      if (visited.size() == 3) p.own.set_classification(Face(7), ModelRef(2, 2));
    };
    // clang-format on
    EXPECT_FALSE(G_nextFace_(model_face, &it)) << "still at its end";
  }
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{1, 2, 4}))
      << "5 was deleted ahead, 7 went to model face 2";
  EXPECT_EQ(p.own.count(2), 4u);
  EXPECT_TRUE(verify(p.own).empty());
  for (const ModelRef none : {ModelRef(), ModelRef(3, 1)}) {
    p.own.set_classification(Face(0), none);
    EXPECT_FALSE(F_modeling_(p.face(0)));
  }
}

TEST(PaperTest, IterationSurvivesDeletionAndEndsInNull) {
  Program p(zoo::grid(2));
  int tmp = 0;
  std::vector<std::uint32_t> visited;
  while (pEdge_ edge = M_nextEdge_(p.mesh, &tmp)) {
    visited.push_back(edge.entity().index);
    if (visited.size() == 1)
      for (const std::uint32_t id : {0, 2, 3, 15}) p.own.destroy_with_users(Edge(id));
  }
  EXPECT_EQ(visited, (std::vector<std::uint32_t>{0, 1, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}));
  EXPECT_FALSE(M_nextEdge_(p.mesh, &tmp));
  tmp = 7;
  EXPECT_EQ(M_nextVertex_(p.mesh, &tmp), p.vertex(7));
  EXPECT_EQ(M_nextVertex_(p.mesh, &tmp), p.vertex(8));
  EXPECT_FALSE(M_nextVertex_(p.mesh, &tmp));
}

TEST(PaperTest, CollapseDeletesTheNamedEndOrRefuses) {
  Program p(zoo::grid(2));
  classify(p.own);
  EXPECT_EQ(E_2Dcollapse_(p.mesh, p.edge(3, 4), p.vertex(3)), 0)
      << "a border vertex, an edge in the face";
  EXPECT_EQ(p.own.count(2), 8u);
  EXPECT_EQ(E_2Dcollapse_(p.mesh, p.edge(3, 4), p.vertex(4)), 1);
  EXPECT_FALSE(p.own.alive(Vertex(4)));
  EXPECT_EQ(p.own.count(2), 6u);
  EXPECT_TRUE(verify(p.own).empty());
}

// "This algorithm can decimate both volume and surface meshes."
void figure_7_of_volumes(pMesh_ mesh) {
  bool done = false;
  do {
    done = false;
    int next = 0;
    while (const pEdge_ edge = M_nextEdge_(mesh, &next))
      for (int i = 0; i < 2; ++i)
        if (const pVertex_ v = E_vertex_(edge, i); L_dataD_(v->list, "spacing") > E_length_(edge))
          if (E_3Dcollapse_(mesh, edge, v)) {
            done = true;
            break;
          }
    next = 0;
    while (const pVertex_ vertex = M_nextVertex_(mesh, &next)) {
      V_swapOpEdges_(mesh, vertex);
      V_smooth_(mesh, vertex);
    }
  } while (done);
}

TEST(PaperTest, Figure7DecimatesVolumes) {
  Program p(make_sample("tet-box", 4));
  classify(p.own);
  const std::uint32_t before = p.own.count(3);
  for (const auto& [i, j] : {std::pair(2, 0), std::pair(0, 1), std::pair(0, 2), std::pair(0, 3)})
    M_setAdjacency_(p.mesh, i, j, 1);
  for (const Vertex v : p.own.vertices()) L_putDataD_(pVertex_(p.mesh, v)->list, "spacing", 0.6);
  figure_7_of_volumes(p.mesh);
  EXPECT_LT(p.own.count(3), before / 2);
  EXPECT_TRUE(verify(p.own).empty());
  EXPECT_EQ(test::wrong_with_tets(p.own), "");
}

TEST(PaperTest, TheAngleIsOfTheSession) {
  MeshData data = zoo::grid(2);
  data.positions[4].z = 0.4;
  Program p(data);
  classify(p.own, {.feature_angle_deg = {}});
  EXPECT_EQ(E_2Dcollapse_(p.mesh, p.edge(3, 4), p.vertex(4)), 0);
  p.session.collapse.max_turn = TurnLimit(60);
  EXPECT_EQ(E_2Dcollapse_(p.mesh, p.edge(3, 4), p.vertex(4)), 1);
}

//      2           0-1 is the bad diagonal
//    .' '.
//  0-------1
//    '. .'
//      3
TEST(PaperTest, SwapsTheEdgesOppositeToAVertex) {
  Program p(zoo::make({{-3, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}));
  EXPECT_EQ(V_swapOpEdges_(p.mesh, p.vertex(0)), 0)
      << "the diagonal is not opposite to its own end";
  EXPECT_EQ(V_swapOpEdges_(p.mesh, p.vertex(2)), 1);
  EXPECT_FALSE(p.edge(0, 1));
  EXPECT_TRUE(p.edge(2, 3));
  EXPECT_EQ(V_swapOpEdges_(p.mesh, p.vertex(0)), 0);
  EXPECT_TRUE(verify(p.own).empty());
}

TEST(PaperTest, SmoothingGoesToTheAverageOfTheNeighbours) {
  MeshData data = zoo::grid(2);
  data.positions[4] = {1.3, 0.8, 0};
  Program p(data);
  classify(p.own);
  EXPECT_EQ(V_smooth_(p.mesh, p.vertex(0)), 0) << "on a model vertex";
  EXPECT_EQ(V_smooth_(p.mesh, p.vertex(4)), 1);
  EXPECT_EQ(p.own.position(Vertex(4)), glm::dvec3(1, 1, 0));
}

TEST(PaperTest, SmoothingSnapsToTheModelOfTheSession) {
  MeshData data = zoo::octahedron();
  data.positions[0] = {0.8, 0, 0.6};
  Program p(data);
  for (const Vertex v : p.own.vertices()) p.own.set_classification(v, ModelRef(2, 1));
  const AnalyticModel sphere = sphere_model(1);
  p.session.improve = TurnLimit(80);
  p.session.model = &sphere;
  EXPECT_EQ(V_smooth_(p.mesh, p.vertex(4)), 1);
  EXPECT_NEAR(glm::length(p.own.position(Vertex(4))), 1, 1e-15);
}

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const std::logic_error& e) {
    return e.what();
  }
  return "none";
}

TEST(PaperTest, MistakesAreErrors) {
  Program p(zoo::grid(2)), other(zoo::grid(2)), bare;
  EXPECT_THROW((void)E_exists_(p.vertex(0), pVertex_()), std::invalid_argument);
  EXPECT_THROW((void)E_exists_(p.vertex(0), other.vertex(1)), std::invalid_argument);
  EXPECT_THROW((void)L_dataD_(p.vertex(0)->list, "spacing"), std::invalid_argument);
  EXPECT_THROW((void)L_dataD_(pVertex_()->list, "spacing"), std::invalid_argument);
  EXPECT_THROW(E_2Dcollapse_(p.mesh, p.edge(0, 1), p.vertex(8)), std::invalid_argument);
  EXPECT_THROW(V_create_(bare.mesh, 0, 0, 0, 4, 1), std::invalid_argument);
  M_setAdjacency_(p.mesh, 0, 1, 0);
  EXPECT_EQ(refusal([&] { E_2Dcollapse_(p.mesh, p.edge(0, 1), p.vertex(0)); }),
            "M_setAdjacency_(mesh,0,1,1) first: the operators on surfaces need it");
  Program tets(zoo::two_tets());
  M_setAdjacency_(tets.mesh, 2, 0, 1);
  EXPECT_EQ(refusal([&] { E_2Dcollapse_(tets.mesh, tets.edge(0, 1), tets.vertex(0)); }),
            "this operator is for surfaces of triangles");
  EXPECT_EQ(refusal([&] { V_smooth_(tets.mesh, tets.vertex(0)); }),
            "M_setAdjacency_(mesh,0,3,1) first: the operators on volumes need it");
  EXPECT_EQ(refusal([&] { E_3Dcollapse_(p.mesh, p.edge(3, 4), p.vertex(3)); }),
            "this operator is for volumes of tetrahedra");
}

double mean_smallest_angle(const Mesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.triangle(f);
    sum += smallest_angle_deg(mesh.position(a), mesh.position(b), mesh.position(c));
  }
  return sum / mesh.count(2);
}

// With an improvement that may turn nothing, and so does nothing on a curved surface, the figure is
// the sweeps of core/decimate in the same order.
TEST(PaperTest, Figure7CollapsesWhatTheDriverCollapses) {
  for (const MeshData& data :
       {zoo::torus(40, 30), make_sample("sphere", 8), make_sample("scan", 1000)}) {
    Program p(data), driver(data);
    for (Mesh* m : {&p.own, &driver.own}) classify(*m, {.nonmanifold_edges = false});
    assign_spacing(p.mesh, 4);
    p.session.collapse.max_turn = TurnLimit(25);
    p.session.improve = TurnLimit(0);
    figure_7(p.mesh);
    Decimation decimation(driver.own, {.factor = 4,
                                       .angle_deg = 25,
                                       .topology = TopologyRule::Paper,
                                       .swap = false,
                                       .smooth = false});
    decimation.run();
    EXPECT_LT(p.own.count(2), data.faces.size() / 2);
    EXPECT_EQ(zoo::fingerprint(p.own), zoo::fingerprint(driver.own));
  }
}

TEST(PaperTest, Figure7RunsToItsEnd) {
  const MeshData data = make_sample("sphere", 8);
  Program plain(data), improved(data);
  plain.session.improve = TurnLimit(0);
  for (Program* p : {&plain, &improved}) {
    assign_spacing(p->mesh, 3);
    figure_7(p->mesh);
    EXPECT_TRUE(verify(p->own).empty());
    EXPECT_LT(p->own.count(2), data.faces.size());
    EXPECT_EQ(zoo::euler(p->own), 2);
  }
  EXPECT_GT(mean_smallest_angle(improved.own), mean_smallest_angle(plain.own) + 1);
}

}  // namespace
}  // namespace aomd::paper::paper_test
