// The points of the original surface under a mesh that changes, and the fit to them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "core/decimate/quality/original_surface.h"
#include "core/decimate/quality/point_fit.h"
#include "core/mesh/geometry.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/operators/collapse.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::original_surface_test {
namespace {

// Contracts random edges of a scan, and tells the original so.
struct Decimated {
  explicit Decimated(std::uint32_t faces, int size = 3000) : mesh(make_sample("scan", size)) {
    classify(mesh);
    mesh.set(0, 1);
    mesh.set(0, 2);
    original.emplace(mesh);
    Collapser collapser(mesh);
    CollapsePlan plan;
    std::mt19937 random(8);
    for (int tries = 0; mesh.count(2) > faces && tries < 100000; ++tries) {
      const Edge e(mesh.ids(1).next_alive(random() % mesh.capacity(1)));
      if (e.index >= mesh.capacity(1)) continue;
      const auto [a, b] = mesh.edge_vertices(e);
      const Contraction c{a, b, 0.5 * (mesh.position(a) + mesh.position(b))};
      if (!collapser.judge(mesh, c, {.max_turn = TurnLimit(35)}, plan).accepted()) continue;
      collapser.apply(mesh, plan);
      original->merged(a, b);
    }
  }
  Mesh mesh;
  std::optional<OriginalSurface> original;
};

void expect_lists(const Mesh& mesh, const OriginalSurface& original) {
  std::vector<int> seen(original.points().size(), 0);
  for (const Face f : mesh.faces()) {
    glm::dvec3 sum(0.0);
    double size = 0;
    original.for_points(f, [&](const OriginalPoint& p) {
      ++seen[static_cast<std::size_t>(&p - original.points().data())];
      EXPECT_EQ(p.face, f.index);
      sum += double(p.weight) * glm::dvec3(p.normal);
      size += double(p.weight);
    });
    EXPECT_LE(glm::length(sum - original.normal_under(f)), 1e-5 * size);
  }
  for (const int n : seen) EXPECT_EQ(n, 1) << "a point is on one face";
}

TEST(OriginalSurfaceTest, PointsHaveTheAreaAndNormalsOfTheirSurface) {
  Mesh mesh(zoo::bow_tie());
  mesh.set(0, 2);
  const OriginalSurface original(mesh);
  ASSERT_EQ(original.points().size(), 5u) << "the vertex that nothing uses is none";
  EXPECT_NEAR(original.area(), 2, 1e-12);
  EXPECT_NEAR(original.diagonal(), std::sqrt(8), 1e-12);
  double weights = 0;
  for (const OriginalPoint& p : original.points()) weights += double(p.weight);
  EXPECT_NEAR(weights, 2, 1e-6);
}

// A sheet whose one corner, vertex 0, is the tip of a triangle below it too, which looks down:
// there the nearest place of vertex 12, in the middle of the sheet, lies inside that triangle.
//
//   20--21--22--23--24
//    |   |   |   |   |
//   10--11-[12]-13--14       the sheet has 16 squares of 1 x 1 at z = 0, the triangle below is
//    |   |   |   |   |       0, (0, 8, -0.1), (8, 0, -0.1)
//    0---1---2---3---4
TEST(OriginalSurfaceTest, APointStaysOnTheSideOfAThinPartThatItIsFrom) {
  MeshData data = zoo::grid(4);
  const auto last = static_cast<std::uint32_t>(data.positions.size());
  data.positions.emplace_back(0, 8, -0.1);
  data.positions.emplace_back(8, 0, -0.1);
  data.faces.add(Shape::Triangle, {0, last, last + 1});
  Mesh mesh(data);
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  const Vertex middle(12);
  ASSERT_EQ(mesh.position(middle), glm::dvec3(2, 2, 0));
  original.merged(middle, Vertex(0));
  original.locate(mesh);
  bool found = false;
  for (const OriginalPoint& p : original.points()) {
    if (p.position != mesh.position(middle)) continue;
    found = true;
    EXPECT_EQ(p.distance2, 0);
    for (const Vertex v : mesh.triangle(Face(p.face))) EXPECT_EQ(mesh.position(v).z, 0);
  }
  EXPECT_TRUE(found);
}

// A face that has come to look the other way under its points is left by them.
TEST(OriginalSurfaceTest, PointsLeaveAFaceThatHasTurnedOver) {
  Mesh mesh(zoo::grid(4));
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  mesh.move(Vertex(6), {5, 5, 0});
  original.locate(mesh);
  for (const OriginalPoint& p : original.points()) {
    const auto t = mesh.triangle(Face(p.face));
    EXPECT_GT(area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])).z, 0);
  }
}

// With the faces' middles the weighted sum over the points is the integral of any quadratic
// function: here of x^2 over the triangles 0-2-1 (x from 0 to 1, as high as 2x) and 0-3-4, 1/2
// each.
TEST(OriginalSurfaceTest, PointsInFacesMakeTheSumsExact) {
  Mesh mesh(zoo::bow_tie());
  mesh.set(0, 2);
  const OriginalSurface original(mesh, Sampling::VerticesAndFaces);
  ASSERT_EQ(original.points().size(), 7u);
  double area = 0, squares = 0;
  for (const OriginalPoint& p : original.points()) {
    area += double(p.weight);
    squares += double(p.weight) * p.position.x * p.position.x;
    EXPECT_NEAR(std::abs(p.normal.z), 1, 1e-6);
  }
  EXPECT_NEAR(area, 2, 1e-6);
  EXPECT_NEAR(squares, 1, 1e-6);
}

// A tip of four faces: the middle of a third of each is 7/18 of its height below.
TEST(OriginalSurfaceTest, PointsOfASurfaceThatBendsGoInward) {
  const auto height_of_tip = [](double height, double inward, Sampling sampling) {
    const Mesh mesh(zoo::make({{0, 0, height}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
    return OriginalSurface(mesh, sampling, inward).points()[0].position.z;
  };
  EXPECT_NEAR(height_of_tip(0.2, 1, Sampling::Vertices), 0.2 * 11 / 18, 1e-7);
  EXPECT_NEAR(height_of_tip(0.2, 0.5, Sampling::Vertices), 0.2 * 29 / 36, 1e-7);
  EXPECT_EQ(height_of_tip(0.2, 0, Sampling::Vertices), 0.2);
  EXPECT_EQ(height_of_tip(0.2, 1, Sampling::VerticesAndFaces), 0.2);
  EXPECT_EQ(height_of_tip(2, 1, Sampling::Vertices), 2) << "its faces look several ways";
}

TEST(OriginalSurfaceTest, NormalsHaveLengthOneAtAnyScale) {
  for (const double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    MeshData data = zoo::octahedron();
    for (glm::dvec3& p : data.positions) p *= scale;
    Mesh mesh(data);
    mesh.set(0, 2);
    const OriginalSurface original(mesh);
    for (const OriginalPoint& p : original.points())
      EXPECT_NEAR(glm::length(glm::dvec3(p.normal)), 1, 1e-5) << scale;
  }
}

TEST(OriginalSurfaceTest, AtTheStartEveryPointLiesOnAFaceOfItsVertex) {
  Mesh mesh(zoo::torus(12, 9));
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  EXPECT_EQ(original.error(), 0);
  expect_lists(mesh, original);
}

TEST(OriginalSurfaceTest, FollowsCollapsesAsFarAsASearchWould) {
  Decimated d(600);
  ASSERT_LE(d.mesh.count(2), 600u);
  d.original->locate(d.mesh);
  expect_lists(d.mesh, *d.original);
  std::vector<OriginalPoint> walked = d.original->points();
  const double error = d.original->error();
  d.original->locate_anywhere(d.mesh);
  expect_lists(d.mesh, *d.original);
  std::size_t same = 0;
  for (std::size_t i = 0; i < walked.size(); ++i) {
    const double found = double(d.original->points()[i].distance2),
                 stopped = double(walked[i].distance2);
    same += stopped <= found * 1.001 + 1e-12;
  }
  EXPECT_GT(same, walked.size() * 95 / 100) << "of " << walked.size();
  EXPECT_LE(d.original->error(), error * 1.0001);
  EXPECT_LE(error, d.original->error() * 1.2);
}

void expect_distances(const Mesh& mesh, const OriginalSurface& original) {
  for (const OriginalPoint& p : original.points()) {
    const auto t = mesh.triangle(Face(p.face));
    glm::dvec3 at;
    const double d2 = nearest_barycentric(p.position, mesh.position(t[0]), mesh.position(t[1]),
                                          mesh.position(t[2]), at);
    EXPECT_NEAR(double(p.distance2), d2, 1e-6 * d2 + 1e-14);
    EXPECT_LE(glm::length(at - glm::dvec3(p.barycentric)), 1e-4);
  }
}

TEST(OriginalSurfaceTest, DistancesAreThoseToTheNamedPlace) {
  Decimated d(600);
  d.original->locate(d.mesh);
  expect_distances(d.mesh, *d.original);
}

// The sheet slides away under its points: those that it still lies under find their new faces by
// walking.
TEST(OriginalSurfaceTest, PointsWalkToTheirFaces) {
  Mesh mesh(zoo::grid(6));
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  for (const Vertex v : mesh.vertices()) mesh.move(v, mesh.position(v) + glm::dvec3(2.25, 0, 0));
  original.locate(mesh);
  for (const OriginalPoint& p : original.points()) {
    const double beside = std::max(0.0, 2.25 - p.position.x);
    EXPECT_NEAR(double(p.distance2), beside * beside, 1e-6) << p.position.x << ' ' << p.position.y;
  }
}

TEST(OriginalSurfaceTest, RedistributingKeepsTheSet) {
  Decimated d(300);
  d.original->locate(d.mesh);
  const Face f = *d.mesh.faces().begin(), g(d.mesh.ids(2).next_alive(f.index + 1));
  std::size_t before = 0, visited = 0;
  for (const Face face : {f, g})
    d.original->for_points(face, [&](const OriginalPoint&) { ++before; });
  ASSERT_GT(before, 3u);
  d.original->redistribute(f, g, [&](const OriginalPoint&) { return ++visited % 3 == 0; });
  EXPECT_EQ(visited, before);
  std::size_t on_f = 0;
  d.original->for_points(f, [&](const OriginalPoint&) { ++on_f; });
  EXPECT_EQ(on_f, before / 3);
  expect_lists(d.mesh, *d.original);
}

// Two faces back to back, of which the upper one is folded away: the other one lies nearer to the
// point at its tip, but looks down.
TEST(OriginalSurfaceTest, PointsStayOnTheirSideOfAThinWall) {
  Mesh mesh(zoo::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, -0.1}}, {{0, 1, 2}, {1, 0, 3}}));
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  mesh.move(Vertex(2), {0.5, -1, 0.5});
  original.locate(mesh);
  EXPECT_EQ(original.points()[2].face, 0u);
  EXPECT_EQ(original.points()[2].distance2, 1.0f);
}

// The sheet that the points know, with its middle vertex lifted.
TEST(FitterTest, ALiftedVertexGoesBack) {
  Mesh mesh(zoo::grid(4));
  classify(mesh);
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  mesh.move(Vertex(12), {2, 2, 0.2});
  original.locate(mesh);
  const OriginalCurves curves(mesh);
  Fitter fitter(mesh, original, curves);
  glm::dvec3 target;
  Star star;
  ASSERT_TRUE(fitter.judge_move(Vertex(12), {}, star, target).accepted());
  EXPECT_LT(std::abs(target.z), 0.02);
  EXPECT_LT(glm::length(target - glm::dvec3(2, 2, 0)), 0.1);
}

// The whole way would turn faces around it by 23 degrees, half of it by 12.
TEST(FitterTest, AVertexThatMayNotGoAllTheWayGoesHalfOfIt) {
  Mesh mesh(zoo::grid(4));
  classify(mesh);
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  mesh.move(Vertex(12), {2, 2, 0.3});
  original.locate(mesh);
  const OriginalCurves curves(mesh);
  Fitter fitter(mesh, original, curves);
  glm::dvec3 whole, half;
  Star star;
  ASSERT_TRUE(fitter.judge_move(Vertex(12), {}, star, whole).accepted());
  FitRules rules;
  rules.max_turn = TurnLimit(15);
  ASSERT_TRUE(fitter.judge_move(Vertex(12), rules, star, half).accepted());
  EXPECT_LE(glm::length(half - 0.5 * (whole + glm::dvec3(2, 2, 0.3))), 1e-12);
}

TEST(FitterTest, ModelVerticesAndOverTurnedFacesStay) {
  Mesh mesh(zoo::grid(4));
  classify(mesh);
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  const OriginalCurves curves(mesh);
  Fitter fitter(mesh, original, curves);
  glm::dvec3 target;
  Star star;
  const Verdict corner = fitter.judge_move(Vertex(0), {}, star, target);
  EXPECT_EQ(corner.reason, Reason::Classification);
  EXPECT_EQ(corner.entity, EntityRef(Vertex(0)));
  mesh.move(Vertex(12), {2, 2, 3});  // a spike, whose faces would turn by 71 degrees
  original.locate(mesh);
  EXPECT_EQ(fitter.judge_move(Vertex(12), {}, star, target).reason, Reason::Angle);
}

TEST(FitterTest, AVertexWithoutFacesHasNoPlaceToGo) {
  Mesh mesh(zoo::bow_tie());
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  glm::dvec3 target;
  Star star;
  const OriginalCurves curves(mesh);
  const Fitter fitter(mesh, original, curves);
  EXPECT_EQ(fitter.judge_move(Vertex(5), {}, star, target).reason, Reason::Flat);
}

//      2
//    / | \      a low roof with its ridge 0-1, known by points all along it; the present mesh has
//   0-----1     the edge 2-3 across the ridge instead
//    \ | /
//      3
struct Roof {
  Roof()
      : fine(points()),
        coarse(zoo::make({{-1, 0, 0.2}, {1, 0, 0.2}, {0, 1, 0}, {0, -1, 0}}, across())) {
    fine.set(0, 2);
    coarse.set(0, 2);
    original.emplace(fine);
    original->locate_anywhere(coarse);
  }
  static zoo::Triangles across() { return {{0, 3, 2}, {3, 1, 2}}; }
  // A fan of thin triangles on either side of the ridge.
  static MeshData points() {
    constexpr std::uint32_t n = 16;
    std::vector<glm::dvec3> p{{0, 1, 0}, {0, -1, 0}};
    zoo::Triangles t;
    for (std::uint32_t i = 0; i <= n; ++i) p.emplace_back(-1 + 2.0 * i / n, 0, 0.2);
    for (std::uint32_t i = 2; i < n + 2; ++i)
      t.push_back({i, i + 1, 0}), t.push_back({i + 1, i, 1});
    return zoo::make(p, t);
  }
  Mesh fine, coarse;
  std::optional<OriginalSurface> original;
};

TEST(FitterTest, ASwapThatCrossesARidgeIsUndone) {
  Roof roof;
  const OriginalCurves curves(roof.coarse);
  Fitter fitter(roof.coarse, *roof.original, curves);
  const FitRules rules{.face_energy = roof.original->error() / 2};
  EXPECT_GT(roof.original->error(), 1e-3);
  EdgePair pair;
  ASSERT_TRUE(fitter.judge_swap(Vertex(2), Vertex(3), rules, pair).accepted());
  fitter.swapped(pair);
  apply_swap(roof.coarse, pair);
  EXPECT_TRUE(joined(roof.coarse, Vertex(0), Vertex(1)));
  EXPECT_TRUE(verify(roof.coarse).empty());
  EXPECT_LT(roof.original->error(), 1e-12);
  expect_lists(roof.coarse, *roof.original);
  expect_distances(roof.coarse, *roof.original);
  EXPECT_EQ(fitter.judge_swap(Vertex(0), Vertex(1), rules, pair).reason, Reason::Quality)
      << "not back again";
}

TEST(FitterTest, RefusalsOfASwap) {
  Roof roof;
  const OriginalCurves curves(roof.coarse);
  Fitter fitter(roof.coarse, *roof.original, curves);
  EdgePair pair;
  FitRules rules{.face_energy = 1e-3};
  rules.max_turn = TurnLimit(5);  // the slopes stand at 11.3 degrees
  EXPECT_EQ(fitter.judge_swap(Vertex(2), Vertex(3), rules, pair).reason, Reason::Angle);
  EXPECT_EQ(fitter.judge_swap(Vertex(0), Vertex(3), {}, pair).reason, Reason::Topology)
      << "one face only";
  roof.coarse.create_face(std::array{Vertex(0), Vertex(1), roof.coarse.create_vertex({0, 0, 9})});
  EXPECT_EQ(fitter.judge_swap(Vertex(2), Vertex(3), {.face_energy = 1e-3}, pair).reason,
            Reason::Topology);
}

// 0-1-3 becomes the needle 0-1-2: without an error to win, shape decides.
TEST(FitterTest, NoSwapMakesANeedleOnAPlane) {
  Mesh mesh(zoo::make({{-1, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, -3, 0}}, {{0, 1, 2}, {1, 0, 3}}));
  mesh.set(0, 2);
  OriginalSurface original(mesh);
  original.locate(mesh);
  const OriginalCurves curves(mesh);
  Fitter fitter(mesh, original, curves);
  EdgePair pair;
  EXPECT_EQ(fitter.judge_swap(Vertex(0), Vertex(1), {.face_energy = 1}, pair).reason,
            Reason::Quality);
}

TEST(TriangleQualityTest, ExactValues) {
  EXPECT_NEAR(triangle_quality({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3) / 2, 0}), 1, 1e-12);
  EXPECT_NEAR(triangle_quality({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), std::sqrt(3) / 2, 1e-12);
  EXPECT_EQ(triangle_quality({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_EQ(triangle_quality({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 0);
}

}  // namespace
}  // namespace aomd::original_surface_test
