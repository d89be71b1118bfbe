#include "core/model/analytic_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace aomd::analytic_model_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr ModelRef face1{2, 1}, edge1{1, 1};

// An odd place, so that no axis is where mistakes cancel.
Frame somewhere() { return Frame::around({3, -2, 5}, {1, 2, -2}, {0, 1, 4}); }

AnalyticModel only(AnalyticShape shape) { return AnalyticModel({{1, std::move(shape), {}}}); }

struct Surface {
  const char* name;
  AnalyticShape shape;
  double size;  ///< how far from the surface its nearest point is surely unique
};

std::vector<Surface> surfaces() {
  return {{"plane", PlaneShape{somewhere()}, 2},
          {"cylinder", CylinderShape{somewhere(), 1.5}, 1.5},
          {"cone", ConeShape{somewhere(), 0.6}, 0.3},
          {"sphere", SphereShape{somewhere(), 2}, 2},
          {"torus", TorusShape{somewhere(), 2, 0.7}, 0.7}};
}

// Parameters inside the range, those of infinite directions between 1 and 3.
glm::dvec2 random_parameters(const ParameterRange& range, std::mt19937& random) {
  glm::dvec2 t;
  for (int k = 0; k < 2; ++k) {
    const double low =
        std::isfinite(range.low[k]) && std::isfinite(range.high[k]) ? range.low[k] : 1;
    const double high = std::isfinite(range.high[k]) ? range.high[k] : 3;
    t[k] = std::uniform_real_distribution<double>(low, high)(random);
  }
  return t;
}

TEST(AnalyticModel, APointMovedAlongTheNormalComesBack) {
  for (const Surface& s : surfaces()) {
    const AnalyticModel model = only(s.shape);
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 p = model.evaluate(face1, random_parameters(model.range(face1), random));
      const double by = std::uniform_real_distribution<double>(-0.9, 0.9)(random) * s.size;
      const ClosestPoint found = model.closest(face1, p + by * model.normal(face1, p));
      EXPECT_LT(glm::length(found.position - p), 1e-12 * 10) << s.name;
      ASSERT_LT(glm::length(model.evaluate(face1, *found.parameters) - found.position), 1e-12 * 10)
          << s.name;
    }
  }
}

TEST(AnalyticModel, NormalsStandOnTheSurfacesAndPointOutward) {
  for (const Surface& s : surfaces()) {
    const AnalyticModel model = only(s.shape);
    std::mt19937 random(8);
    constexpr double h = 1e-6;
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 t = random_parameters(model.range(face1), random);
      const auto at = [&](double du, double dv) {
        return model.evaluate(face1, t + glm::dvec2(du, dv));
      };
      const glm::dvec3 u = at(h, 0) - at(-h, 0), v = at(0, h) - at(0, -h),
                       n = model.normal(face1, at(0, 0));
      EXPECT_NEAR(glm::length(n), 1, 1e-14);
      EXPECT_NEAR(glm::dot(n, u) / glm::length(u), 0, 1e-7) << s.name;
      EXPECT_NEAR(glm::dot(n, v) / glm::length(v), 0, 1e-7) << s.name;
      EXPECT_GT(glm::dot(n, glm::cross(u, v)), 0) << s.name;
    }
  }
}

// No point of a fine net over the surface may be nearer than the closest point.
TEST(AnalyticModel, NoSampleIsNearer) {
  for (const Surface& s : surfaces()) {
    const AnalyticModel model = only(s.shape);
    std::mt19937 random(9);
    std::vector<glm::dvec3> net;
    for (int i = 0; i < 5000; ++i)
      net.push_back(model.evaluate(face1, random_parameters(model.range(face1), random)));
    for (int i = 0; i < 50; ++i) {
      std::normal_distribution<double> noise(0, 3);
      const glm::dvec3 p =
          glm::dvec3(3, -2, 5) + glm::dvec3(noise(random), noise(random), noise(random));
      const double distance = glm::length(model.snap(face1, p) - p);
      for (const glm::dvec3& q : net) ASSERT_LE(distance, glm::length(q - p) + 1e-12) << s.name;
    }
  }
}

TEST(AnalyticModel, SegmentsEndAtTheirEnds) {
  const AnalyticModel model = only(SegmentShape{{0, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(model.snap(edge1, {0.5, 3, 4}), glm::dvec3(0.5, 0, 0));
  EXPECT_EQ(model.closest(edge1, {0.5, 3, 4}).parameters->x, 0.25);
  EXPECT_EQ(model.snap(edge1, {-1, 1, 0}), glm::dvec3(0, 0, 0));
  EXPECT_EQ(model.snap(edge1, {9, 1, 0}), glm::dvec3(2, 0, 0));
}

//      y
//   ...|  .       the upper half of a circle: points below it belong to the nearer end
//  .   |   .
//  +---+---+ x
TEST(AnalyticModel, ArcsEndAtTheirEnds) {
  const AnalyticModel model = only(ArcShape{Frame(), 2, 0, pi});
  const auto snapped = [&](double x, double y) { return model.snap(edge1, {x, y, 1}); };
  EXPECT_LT(glm::length(snapped(0, 5) - glm::dvec3(0, 2, 0)), 1e-15);
  EXPECT_LT(glm::length(snapped(1, -3) - glm::dvec3(2, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(snapped(-1, -3) - glm::dvec3(-2, 0, 0)), 1e-15);
  EXPECT_DOUBLE_EQ(model.closest(edge1, {-1, -3, 0}).parameters->x, pi);
  EXPECT_FALSE(model.range(edge1).periodic[0]);
}

TEST(AnalyticModel, AnArcMayStartAnywhere) {
  const AnalyticModel model = only(ArcShape{Frame(), 1, 1.5 * pi, 2.5 * pi});  // the right half
  EXPECT_LT(glm::length(model.snap(edge1, {3, 0, 0}) - glm::dvec3(1, 0, 0)), 1e-15);
  EXPECT_NEAR(model.closest(edge1, {3, 0, 0}).parameters->x, 2 * pi, 1e-15);
  EXPECT_LT(glm::length(model.snap(edge1, {-3, 1, 0}) - glm::dvec3(0, 1, 0)), 1e-15);
}

TEST(AnalyticModel, AFullCircleHasNoEnds) {
  const AnalyticModel model = only(ArcShape{somewhere(), 2});
  EXPECT_TRUE(model.range(edge1).periodic[0]);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 p = somewhere().on_circle(2, 0.1 * i);
    EXPECT_LT(glm::length(model.snap(edge1, p + 0.3 * somewhere().z) - p), 1e-14);
  }
}

// Where every point is as near as any other, one of them comes back, and nothing is not a number.
TEST(AnalyticModel, CentresAndAxesHaveSomeClosestPoint) {
  const Frame f = somewhere();
  EXPECT_NEAR(glm::length(only(SphereShape{f, 2}).snap(face1, f.origin) - f.origin), 2, 1e-14);
  EXPECT_NEAR(glm::length(only(CylinderShape{f, 2}).snap(face1, f.origin) - f.origin), 2, 1e-14);
  EXPECT_NEAR(glm::length(only(ArcShape{f, 2}).snap(edge1, f.origin) - f.origin), 2, 1e-14);
  EXPECT_NEAR(glm::length(only(TorusShape{f, 2, 0.5}).snap(face1, f.origin) - f.origin), 1.5,
              1e-14);
  EXPECT_NEAR(glm::length(only(TorusShape{f, 2, 0.5}).snap(face1, f.origin + 2.0 * f.x) - f.origin),
              2.5, 1e-14);
}

TEST(AnalyticModel, BelowItsApexAConeIsItsApex) {
  const Frame f = somewhere();
  const AnalyticModel model = only(ConeShape{f, 0.5});
  EXPECT_LT(glm::length(model.snap(face1, f.origin - 2.0 * f.z + 0.1 * f.x) - f.origin), 1e-14);
  EXPECT_LT(glm::length(model.normal(face1, f.origin - 2.0 * f.z) + f.z), 1e-14);
}

TEST(AnalyticModel, BoxesHoldWhatTheyShould) {
  const Box quarter = only(ArcShape{Frame(), 2, 0, pi / 2}).box();
  EXPECT_LT(glm::length(quarter.low - glm::dvec3(0, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(quarter.high - glm::dvec3(2, 2, 0)), 1e-15);
  const Box half = only(ArcShape{Frame(), 2, 0, pi}).box();
  EXPECT_LT(glm::length(half.low - glm::dvec3(-2, 0, 0)), 1e-15);
  EXPECT_LT(glm::length(half.high - glm::dvec3(2, 2, 0)), 1e-15);
  const Box torus = torus_model(2, 0.5).box();
  EXPECT_EQ(torus.low, glm::dvec3(-2.5, -2.5, -0.5));
  EXPECT_EQ(torus.high, glm::dvec3(2.5, 2.5, 0.5));
  EXPECT_TRUE(only(PlaneShape()).box().empty());
  const Box cylinder = cylinder_model(1, 2).box();
  EXPECT_EQ(cylinder.low, glm::dvec3(-1, -1, 0));
  EXPECT_EQ(cylinder.high, glm::dvec3(1, 1, 2));
}

TEST(AnalyticModel, ImpossibleShapesAreRefused) {
  for (const AnalyticShape& shape : std::initializer_list<AnalyticShape>{
           SegmentShape{{1, 1, 1}, {1, 1, 1}}, ArcShape{Frame(), 0}, ArcShape{Frame(), 1, 1, 1},
           ArcShape{Frame(), 1, 0, 7}, CylinderShape{Frame(), -1}, SphereShape{Frame(), 0},
           ConeShape{Frame(), 0}, ConeShape{Frame(), 1.6}, TorusShape{Frame(), 1, 1},
           TorusShape{Frame(), 1, 0}})
    EXPECT_THROW(only(shape), std::invalid_argument) << shape.index();
}

// The corners, edges and circles of the drilled box lie on all that they bound.
TEST(AnalyticModel, TheDrilledBoxHoldsTogether) {
  const AnalyticModel model = drilled_box_model({4, 3, 2}, 1);
  for (const int dim : {1, 2}) {
    for (const ModelRef upper : model.entities(dim)) {
      for (const ModelRef lower : model.closure(upper)) {
        const bool curve = lower.dimension() == 1;
        for (const double t : {0.0, 0.3, 1.0}) {
          const glm::dvec3 p = curve ? model.evaluate(lower, {t, 0}) : model.snap(lower, {});
          EXPECT_LT(glm::length(model.snap(upper, p) - p), 1e-15)
              << name_of(lower) << " on " << name_of(upper);
        }
      }
    }
  }
  EXPECT_EQ(model.normal({2, 2}, {0, 0, 0}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(model.normal({2, 5}, {0, 0, 0}), glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace aomd::analytic_model_test
