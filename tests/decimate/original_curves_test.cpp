// The points of the original's model edges under curves that change, and what they are for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/decimate/curves/original_curves.h"
#include "core/decimate/decimation.h"
#include "core/decimate/quality/point_fit.h"
#include "core/measure/distance.h"
#include "core/mesh/geometry.h"
#include "core/operators/collapse.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::original_curves_test {
namespace {

using test::classified;
using test::finding;
using test::quality;

// Vertices 0 to 4 are one side of it; 0 and 4 are corners.
Mesh sheet() {
  Mesh mesh = classified(zoo::grid(4));
  mesh.set(0, 1);
  mesh.set(0, 2);
  return mesh;
}

TEST(OriginalCurvesTest, KnowsItsPieces) {
  const Mesh mesh = sheet();
  const OriginalCurves curves(mesh);
  EXPECT_TRUE(curves.inside(Vertex(2)));
  EXPECT_FALSE(curves.inside(Vertex(0))) << "a corner";
  EXPECT_FALSE(curves.inside(Vertex(6))) << "in the middle of the sheet";
  CurvePlace place;
  EXPECT_FALSE(curves.between(Vertex(1), Vertex(3), place));
  ASSERT_TRUE(curves.between(Vertex(1), Vertex(2), place));
  EXPECT_EQ(place.far[0], Vertex(0));
  EXPECT_EQ(place.far[1], Vertex(3));
  ASSERT_TRUE(curves.between(Vertex(0), Vertex(1), place));
  EXPECT_FALSE(place.far[0].valid()) << "the curve ends there";
  EXPECT_EQ(place.far[1], Vertex(2));
}

//    h        a straight curve of length 2 whose vertex is lifted by h: the points at 1/2 and 3/2
//  /   \      are h/2 off across the pieces, the one at 1 is h, all times cos = 1 / sqrt(1 + h^2)
// 0-+-1-+-2
TEST(OriginalCurvesTest, ErrorsAreExact) {
  const Mesh mesh = sheet();
  const OriginalCurves curves(mesh);
  const double h = 0.25, at_points = (2.0 * 2 / 3) * h * h / 4 + (1.0 / 3) * h * h;
  const CurveError error = curves.error(mesh, curves.around(Vertex(2)), {2, h, 0});
  EXPECT_NEAR(error.squares, at_points / (1 + h * h), 1e-15);
  EXPECT_EQ(curves.error(mesh, curves.around(Vertex(2)), {2.25, 0, 0}).squares, 0);
}

// The quadric is that of distances across the pieces, seen from where the vertex is.
TEST(OriginalCurvesTest, TheQuadricLeadsBack) {
  const Mesh mesh = sheet();
  const OriginalCurves curves(mesh);
  const glm::dvec3 at(2, 0.001, 0.002);
  const Quadric error = curves.quadric(mesh, curves.around(Vertex(2)), at);
  glm::dvec3 step;
  ASSERT_TRUE(error.minimum(glm::dvec3(0.0), 1e-9, step));
  EXPECT_NEAR(at.y + step.y, 0, 1e-5);
  EXPECT_NEAR(at.z + step.z, 0, 1e-5);
  EXPECT_NEAR(step.x, 0, 1e-5);
  EXPECT_NEAR(error(glm::dvec3(1, 0, 0) + step), error(step), 1e-5) << "along it nothing is lost";
}

// A disc whose rim has an edge for each half degree; 60 of them become one piece.
TEST(OriginalCurvesTest, APieceOfManyPointsTurnsTheSameWithFewOfThem) {
  constexpr std::uint32_t count = 720;
  MeshData disc;
  disc.positions.emplace_back(0, 0, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    disc.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    disc.faces.add(Shape::Triangle, {0, 1 + i, 1 + (i + 1) % count});
  }
  const Mesh mesh = classified(std::move(disc));
  OriginalCurves all(mesh), few(mesh, 16);
  constexpr std::uint32_t last = 100;
  for (std::uint32_t v = last - 59; v < last; ++v)
    for (OriginalCurves* curves : {&all, &few}) curves->merged(mesh, Vertex(v), Vertex(v + 1));
  const glm::dvec3 at = mesh.position(Vertex(last));
  const double cosine = all.turn_cosine(mesh, all.around(Vertex(last)), at);
  EXPECT_NEAR(cosine, std::cos(15 * std::numbers::pi / 180), 1e-9) << "half of what the arc turns";
  EXPECT_NEAR(few.turn_cosine(mesh, few.around(Vertex(last)), at), cosine, 2e-3);
  const CurveError exact = all.error(mesh, all.around(Vertex(last)), at),
                   nearly = few.error(mesh, few.around(Vertex(last)), at);
  EXPECT_NEAR(nearly.length, exact.length, 1e-12);
  EXPECT_NE(nearly.squares, exact.squares) << "from fewer points";
  EXPECT_NEAR(nearly.squares, exact.squares, exact.squares / 5);
}

TEST(OriginalCurvesTest, PointsFollowCollapses) {
  Mesh mesh = sheet();
  OriginalCurves curves(mesh);
  Collapser collapser(mesh);
  CollapsePlan plan;
  ASSERT_TRUE(
      collapser.judge(mesh, {Vertex(2), Vertex(1), {1, 0, 0}}, CollapseRules{}, plan).accepted());
  collapser.apply(mesh, plan);
  curves.merged(mesh, Vertex(2), Vertex(1));
  EXPECT_EQ(curves.neighbours(Vertex(1)), (std::array{Vertex(0), Vertex(3)}));
  EXPECT_EQ(curves.neighbours(Vertex(3)), (std::array{Vertex(1), Vertex(4)}));
  // Of the piece from 1 to 3 the points at 1.5, 2 and 2.5, of that from 0 to 1 the one at 0.5; with
  // the vertex lifted by h those to its right are h * (3 - x) / 2 off.
  const double h = 0.5, right = 1 + h * h / 4, left = 1 + h * h;
  const double squares =
      2.0 / 3 * h * h / 4 / left + h * h * (2.0 / 3 * 9 / 16 + 1.0 / 3 / 4 + 2.0 / 3 / 16) / right;
  const CurveError error = curves.error(mesh, curves.around(Vertex(1)), {1, h, 0});
  const double own = 1.0 / 3 * h * h / left;  // the point at 1 is nearer to the steep piece
  EXPECT_NEAR(error.squares, squares + own, 1e-12);
}

TEST(OriginalCurvesTest, PointsAreFoundAnywhere) {
  Mesh mesh = sheet();
  OriginalCurves curves(mesh);
  const CurveError before = curves.error(mesh, curves.around(Vertex(2)), {2, 0.25, 0});
  curves.locate_anywhere(mesh);
  const CurveError after = curves.error(mesh, curves.around(Vertex(2)), {2, 0.25, 0});
  EXPECT_NEAR(after.squares, before.squares, 1e-15);
}

// A border vertex that was moved goes back; along the border it keeps to the middle.
TEST(OriginalCurvesTest, AVertexIsFittedToItsCurve) {
  Mesh mesh = sheet();
  OriginalSurface original(mesh);
  const OriginalCurves curves(mesh);
  mesh.move(Vertex(2), {2.1, -0.2, 0});
  original.locate(mesh);
  glm::dvec3 target;
  Star star;
  ASSERT_TRUE(Fitter(mesh, original, curves).judge_move(Vertex(2), {}, star, target).accepted());
  EXPECT_NEAR(target.y, 0, 0.02);
  EXPECT_NEAR(target.z, 0, 1e-12);
  EXPECT_LT(std::abs(target.x - 2), 0.1);
}

// A ball of two materials: 2 n (m - 1) faces, the equator between them.
MeshData ball(std::uint32_t n, std::uint32_t m) {
  using std::numbers::pi;
  std::vector<glm::dvec3> p{{0, 0, 1}};
  zoo::Triangles t;
  const auto id = [n](std::uint32_t ring, std::uint32_t k) { return 1 + (ring - 1) * n + k % n; };
  for (std::uint32_t ring = 1; ring < m; ++ring)
    for (std::uint32_t k = 0; k < n; ++k) {
      const double down = pi * ring / m, around = 2 * pi * k / n;
      p.emplace_back(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around),
                     std::cos(down));
    }
  const auto last = static_cast<std::uint32_t>(p.size());
  p.emplace_back(0, 0, -1);
  for (std::uint32_t k = 0; k < n; ++k) {
    t.push_back({0, id(1, k), id(1, k + 1)});
    for (std::uint32_t ring = 1; ring + 1 < m; ++ring) {
      t.push_back({id(ring, k), id(ring + 1, k), id(ring, k + 1)});
      t.push_back({id(ring, k + 1), id(ring + 1, k), id(ring + 1, k + 1)});
    }
    t.push_back({id(m - 1, k), last, id(m - 1, k + 1)});
  }
  MeshData data = zoo::make(p, t);
  for (const auto& face : t) {
    const double z = p[face[0]].z + p[face[1]].z + p[face[2]].z;
    data.faces.classes.push_back(ModelRef(2, z > 0 ? 1 : 2));
  }
  return data;
}

TEST(OriginalCurvesTest, TheEquatorOfABallIsAsGoodAsTheSurfaceBesideIt) {
  Mesh mesh = classified(ball(120, 60), test::Edges::OnModelEdges);
  ASSERT_EQ(mesh.count(2), 14160u);
  DecimationOptions options = quality(300);
  options.coarsest = false;
  Decimation(mesh, options).run();
  EXPECT_EQ(mesh.count(2), 300u);
  EXPECT_EQ(finding(mesh), "");
  int on_equator = 0;
  for (const Vertex v : mesh.vertices()) {
    if (mesh.classification(v).dimension() != 1) continue;
    ++on_equator;
    EXPECT_NEAR(glm::length(mesh.position(v)), 1, 0.01);
  }
  EXPECT_GE(on_equator, 20);
}

// Twice the area of the polygon that a rim has become, by its vertices in order.
double rim_area(const Mesh& mesh, double z) {
  std::vector<glm::dvec3> rim;
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 1 && std::abs(mesh.position(v).z - z) < 0.5)
      rim.push_back(mesh.position(v));
  std::sort(rim.begin(), rim.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
  });
  double area = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const glm::dvec3 &a = rim[i], &b = rim[(i + 1) % rim.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

// The vertices of a polygon that is nearest to a circle stand outside of it, as far as its sides
// are inside: what it encloses stays.
TEST(OriginalCurvesTest, TheRimsOfACylinderEncloseWhatTheyDid) {
  for (const std::uint32_t target : {200u, 100u, 60u}) {
    Mesh mesh = classified(make_sample("cylinder", 10));
    const double before = rim_area(mesh, 0);
    DecimationOptions options = quality(target, 0);
    options.coarsest = false;
    Decimation(mesh, options).run();
    for (const double z : {0.0, 2.0})
      EXPECT_NEAR(std::sqrt(rim_area(mesh, z) / before), 1, 0.002) << target << " faces";
  }
}

// Accuracy first, long thin faces along the sides: as close as what Lindstrom and Turk's collapses
// leave of it, in percent of the diagonal.
TEST(OriginalCurvesTest, ACylinderIsAsCloseAsTheNumberOfItsFacesAllows) {
  const Mesh original = classified(make_sample("cylinder", 10));
  const measure::Surface before(original);
  for (const auto& [target, most] : {std::pair{200u, 0.018}, {100u, 0.059}, {60u, 0.153}}) {
    Mesh mesh = classified(make_sample("cylinder", 10));
    DecimationOptions options = quality(target, 0);
    options.coarsest = false;
    Decimation(mesh, options).run();
    const auto distance = measure::mutual_distance(before, measure::Surface(mesh), 100'000);
    EXPECT_LE(100 * distance.rms() / std::sqrt(12), most) << target << " faces";
  }
}

// A disc of n thin triangles around a vertex.
MeshData disc(std::uint32_t n) {
  std::vector<glm::dvec3> p{{0, 0, 0}};
  zoo::Triangles t;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double around = 2 * std::numbers::pi * k / n;
    p.emplace_back(std::cos(around), std::sin(around), 0);
    t.push_back({0, 1 + k, 1 + (k + 1) % n});
  }
  return zoo::make(p, t);
}

// Each collapse turns the border by less than the limit; together they ate it.
TEST(OriginalCurvesTest, ThePaperLoopDoesNotEatADisc) {
  Mesh mesh = classified(disc(200));
  DecimationOptions options;
  options.target_faces = 20;
  Decimation(mesh, options).run();
  double area = 0;
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    area += glm::length(area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
  }
  EXPECT_GT(area / 2, 0.65 * std::numbers::pi);
  EXPECT_EQ(finding(mesh), "");
}

}  // namespace
}  // namespace aomd::original_curves_test
